package wbv;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

/**
 * What the documents link to is there, as a file and as a heading, and every page of docs/ stands once in the contents of the site
 * (mkdocs.yml).
 */
class SiteTest {

    private static final Path ROOT = Path.of("").toAbsolutePath();
    private static final Pattern CODE = Pattern.compile("^```.*?^```|^    \\S.*?$|`[^`\\n]*`", Pattern.MULTILINE | Pattern.DOTALL);
    private static final Pattern LINK = Pattern.compile("]\\(([^)\\s]+)\\)");
    private static final Pattern HEADING = Pattern.compile("^#{1,6} (.+)$", Pattern.MULTILINE);
    private static final Pattern FENCED = Pattern.compile("^```.*?^```", Pattern.MULTILINE | Pattern.DOTALL);

    private static List<Path> pages() throws IOException {
        try (Stream<Path> files = Files.walk(ROOT.resolve("docs"))) {
            return files.filter(file -> file.toString().endsWith(".md")).sorted().toList();
        }
    }

    @TestFactory
    Stream<DynamicTest> everyLinkLeadsSomewhere() throws IOException {
        List<Path> documents = new ArrayList<>(pages());
        for (String other : List.of("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "python/README.md", "deploy/README.md")) {
            documents.add(ROOT.resolve(other));
        }
        return documents.stream().map(document -> DynamicTest.dynamicTest(ROOT.relativize(document).toString(), () -> {
            List<String> wrong = new ArrayList<>();
            for (MatchResult link : LINK.matcher(CODE.matcher(Files.readString(document)).replaceAll("")).results().toList()) {
                if (!link.group(1).matches("[a-z]+:.*") && !leads(document, link.group(1))) {
                    wrong.add(link.group(1));
                }
            }
            assertEquals(List.of(), wrong, "links of " + document + " that lead nowhere");
        }));
    }

    private static boolean leads(Path from, String link) throws IOException {
        String[] parts = link.split("#", 2);
        Path file = parts[0].isEmpty() ? from : from.resolveSibling(parts[0]).normalize();
        return file.startsWith(ROOT) && Files.exists(file) && (parts.length == 1 || anchors(Files.readString(file)).contains(parts[1]));
    }

    /** Of headings, as GitHub makes them. A second heading of the same words has none here: GitHub and MkDocs number it differently. */
    private static TreeSet<String> anchors(String markdown) {
        TreeSet<String> anchors = new TreeSet<>();
        HEADING.matcher(FENCED.matcher(markdown).replaceAll("")).results()
                .map(heading -> heading.group(1).replaceAll("\\[([^]]*)]\\([^)]*\\)", "$1"))
                .forEach(words -> anchors.add(words.toLowerCase(Locale.ROOT).replaceAll("[^\\p{L}\\p{N}_\\- ]", "").replace(' ', '-')));
        return anchors;
    }

    @Test
    void everyPageStandsOnceInTheContents() throws IOException {
        String settings = Files.readString(Path.of("mkdocs.yml"));
        List<String> contents = Pattern.compile(": (\\S+\\.md)$", Pattern.MULTILINE).matcher(settings.substring(settings.indexOf("\nnav:")))
                .results()
                .map(page -> page.group(1)).toList();
        for (String page : contents) {
            Path file = page.startsWith("repository/") ? Path.of(page.substring("repository/".length())) : Path.of("docs", page);
            assertTrue(Files.exists(file), page + " is not there");
        }
        List<String> ours = contents.stream().filter(page -> !page.startsWith("repository/")).sorted().toList();
        assertEquals(pages().stream().map(page -> ROOT.resolve("docs").relativize(page).toString().replace('\\', '/')).sorted().toList(),
                ours);
    }
}
