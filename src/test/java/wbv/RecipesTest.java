package wbv;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/**
 * The recipes of CONTRIBUTING.md are those that their examples followed: every file that a step names has the word that stands
 * for the example there, and no file of the program names the example without being a step.
 */
class RecipesTest {

    private static final Path GUIDE = Path.of("CONTRIBUTING.md");
    private static final Pattern STEP = Pattern.compile("`([^` ]+)` has `([^`]+)`");
    private static final int RECIPES = 6;

    /** @param steps file and word */
    private record Recipe(String name, String example, List<MatchResult> steps) {}

    private static List<Recipe> recipes() throws IOException {
        String text = Files.readString(GUIDE);
        String part = text.substring(text.indexOf("## How to add"), text.indexOf("## How to prove"));
        List<Recipe> recipes = new ArrayList<>();
        for (String each : part.split("\n### ")) {
            if (each.contains("\nExample: `")) {
                String example = each.split("\nExample: `")[1].split("`")[0];
                recipes.add(new Recipe(each.lines().findFirst().orElseThrow(), example, STEP.matcher(each).results().toList()));
            }
        }
        return recipes;
    }

    @TestFactory
    Stream<DynamicTest> everyStepIsWhereTheRecipeSays() throws IOException {
        List<Recipe> recipes = recipes();
        assertEquals(RECIPES, recipes.size());
        return recipes.stream().map(recipe -> DynamicTest.dynamicTest(recipe.name(), () -> {
            assertTrue(recipe.steps().size() >= 2, "a recipe of one step");
            for (MatchResult step : recipe.steps()) {
                assertTrue(Files.readString(Path.of(step.group(1))).contains(step.group(2)),
                        step.group(1) + " has no '" + step.group(2) + "'");
            }
        }));
    }

    @TestFactory
    Stream<DynamicTest> noStepIsLeftOut() throws IOException {
        return recipes().stream().map(recipe -> DynamicTest.dynamicTest(recipe.name(), () -> {
            Pattern example = Pattern.compile(
                    "(?<![\\w.])" + Pattern.quote(recipe.example()) + "(?!\\w)|\\w\\." + Pattern.quote(recipe.example()) + "(?!\\w)");
            TreeSet<String> left = new TreeSet<>();
            try (Stream<Path> files = Files.walk(Path.of("src/main"))) {
                for (Path file : files.filter(path -> path.toString().matches(".*\\.(java|py|c)")).toList()) {
                    String name = file.toString().replace('\\', '/');
                    if (example.matcher(Files.readString(file)).find()
                            && recipe.steps().stream().noneMatch(step -> step.group(1).equals(name))) {
                        left.add(name);
                    }
                }
            }
            assertEquals(new TreeSet<>(), left, "name " + recipe.example() + " and are no step of its recipe");
        }));
    }
}
