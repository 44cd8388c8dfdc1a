package wbv;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.fail;

import com.sun.source.doctree.DocCommentTree;
import com.sun.source.doctree.ReturnTree;
import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.ModifiersTree;
import com.sun.source.tree.NewClassTree;
import com.sun.source.tree.Tree;
import com.sun.source.tree.VariableTree;
import com.sun.source.util.DocTrees;
import com.sun.source.util.JavacTask;
import com.sun.source.util.TreePathScanner;
import java.io.IOException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.lang.model.element.Modifier;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;

/**
 * Whoever may call it finds said what it is: every public or protected type, method, constructor and field has a sentence (or a
 * {@code @return} that is one), and whoever is given an array says whether it is modified. Every {@code double} that is taken, returned
 * or a record's component has its unit or kind beside it, every array of them what it is indexed by or how long it is; what has no words
 * of its own leaves it to the summary, which then has to speak of as many numbers. Whether what is said is true no test can tell. Not
 * asked: what overrides, a record's accessors and canonical constructor, an enum's constants, {@code main}, and options of MOA, whose
 * purpose stands in their constructor call.
 */
class PublicDocumentationTest {

    private static final Pattern SAYS_WHAT_BECOMES_OF_ARRAYS = Pattern.compile("\\bmodified\\b", Pattern.CASE_INSENSITIVE);
    private static final Pattern SAYS_NO_MORE_THAN_THAT = Pattern.compile("((not|none|neither|modified|copied|a copy)\\b.*)?",
            Pattern.CASE_INSENSITIVE);

    /** In brackets: 1, or units, each to a power perhaps. */
    private static final Pattern UNIT = Pattern.compile("\\[[^\\]]*(?<!\\p{L})"
            + "(1|m|s|min|h|km|kg|N|Hz|rad|W|MPa|dB|°|years|days|samples|bins|bytes|nats?|spreads|unit\\w*)(?!\\p{L})[^\\]]*\\]");

    /**
     * Words of numbers that have no unit, or that of whatever was handed in. A list, because no rule tells "share" from "load"; a word
     * belongs here if a reader who finds it with a number does not ask for the unit any more.
     */
    private static final String KIND = "units?|ratio|share|factor|number of|probabilit(y|ies)|logarithm|coherence|confidence"
            + "|exponent|whitened|relative|seconds|minutes|hours";
    private static final Pattern SAYS_KIND = Pattern.compile("\\b(" + KIND + "|chances?|0 to (less than )?1)s?\\b|%",
            Pattern.CASE_INSENSITIVE);
    /** Names that say it themselves: {@code dampingRatio}, {@code share}, {@code a8_m_s2}. */
    private static final Pattern NAMES_KIND = Pattern
            .compile("(?i:.*(" + KIND + ")s?(_sd)?|minutes.*|.*_(s|hz|m|kg|n|rad|w|m_s2|m_s1_75|percent|minutes)(_.*)?)");

    /** What arrays are indexed by, or how long they are. A spectrum is one of {@code wbv.body.Spectra}, a series goes by sample. */
    private static final Pattern SHAPE = Pattern.compile("\\b(by (axis|bin|body|channel|column|component|coordinate|dimension|direction"
            + "|error|frequency|group|input|label|law|line|link|model|motion|number|output|parameter|place|plane|point|pole|row"
            + "|sample|state|target|time|vector)s?|\\w{1,2} by \\w{1,2}|row by row|line by line|long|length|spectr(um|a)|series|bins?"
            + "|as (many|long)|one( \\w+)? an? \\w+|one (for|of|per) each|(two|three|four|six) numbers)\\b",
            Pattern.CASE_INSENSITIVE);

    /** A block tag that does not begin its line: the javadoc tool takes it for text. */
    private static final Pattern TAG_WITHIN_A_LINE = Pattern.compile("^\\s*(/\\*\\*|\\*)\\s*\\S.*?\\s@(param|return|throws)\\s.*");

    /** A text that leans on the one before it. */
    private static final Pattern LEANS = Pattern.compile("^the same\\b|\\b(likewise|as there)\\b", Pattern.CASE_INSENSITIVE);

    @Test
    void whatIsPublicIsDocumented() throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        try (Stream<Path> tree = Files.walk(Path.of("src/main/java"));
                StandardJavaFileManager files = compiler.getStandardFileManager(null, null, StandardCharsets.UTF_8)) {
            List<Path> sources = tree.filter(file -> file.toString().endsWith(".java") && !file.endsWith("package-info.java")).sorted()
                    .toList();
            List<String> gaps = gaps(files.getJavaFileObjectsFromPaths(sources));
            if (!gaps.isEmpty()) {
                fail(gaps.size() + " public members without the Javadoc that CONTRIBUTING.md asks for:\n" + String.join("\n", gaps));
            }
        }
    }

    @Test
    void everyTagBeginsALine() throws IOException {
        assertEquals(List.of(true, true, false, false), Stream.of("    /** A seat. @param mass [kg] */", "     * @param a of it @return b",
                "     * @param mass [kg]", "    /** @return mass [kg] */").map(line -> TAG_WITHIN_A_LINE.matcher(line).matches()).toList());
        try (Stream<Path> tree = Files.walk(Path.of("src/main/java"))) {
            for (Path file : tree.filter(each -> each.toString().endsWith(".java")).toList()) {
                assertEquals(List.of(),
                        Files.readAllLines(file).stream().filter(line -> TAG_WITHIN_A_LINE.matcher(line).matches()).toList(),
                        file::toString);
            }
        }
    }

    @Test
    void whatIsMissingIsFound() throws IOException {
        String source = """
                /** A seat. @param mass [kg] */
                public record Seat(double mass) {
                    public Seat {
                    }

                    public Seat(String mass) {
                        this(Double.parseDouble(mass));
                    }

                    /** @param load [N] */
                    public double sinks(double load) {
                        return load;
                    }

                    /** @return depth [m] */
                    public double depth() {
                        return 0;
                    }

                    /** Takes a load by sample [N]. */
                    public void take(double[] load, String... names) {
                    }

                    /** Takes a series [N], or several [N]. Neither is modified. */
                    public void take(double[] load, double[][] loads) {
                    }

                    @Override
                    public String toString() {
                        return "";
                    }

                    double weight() {
                        return 9.81 * mass;
                    }

                    public static final double RATE = 1;
                    public static final FloatOption GAIN = new FloatOption("gain", 'g', "A factor.", 1);

                    public interface Sitter {
                        /** Sits. */
                        void sit();

                        void rise();
                    }

                    /** How. */
                    public enum Way {
                        UP, DOWN
                    }

                    interface Inner {
                        void inner();
                    }
                }
                """;
        assertEquals(List.of("/Seat.java:6 constructor Seat(mass): no summary", "/Seat.java:11 sinks(load): no summary",
                "/Seat.java:11 sinks(load): say the unit of what it returns",
                "/Seat.java:21 take(load, names): say whether the array is modified", "/Seat.java:37 RATE: no summary",
                "/Seat.java:40 Sitter: no summary", "/Seat.java:44 rise(): no summary"), gaps(List.of(seat(source))));
    }

    @Test
    void numbersWithoutUnitOrShapeAreFound() throws IOException {
        String source = """
                /** A seat. @param mass [kg] @param share of it that moves @param width across @param load_N on it */
                public record Seat(double mass, double share, double width, double load_N) {

                    /** How deep it sinks. */
                    public double sinks(double load) {
                        return load;
                    }

                    /** Depth [m] under a load. */
                    public double depth(double load) {
                        return load;
                    }

                    /** Depth [m] under a load [N]. */
                    public double depth(double load, int place) {
                        return load;
                    }

                    /** The same. @param load likewise @param factor on it @param bend of it */
                    public double depth(double load, double factor, double bend) {
                        return load;
                    }

                    /** The real part of something. @param [N] @param mess of it */
                    public double part(double load) {
                        return load;
                    }

                    /** Takes loads [N]. @param loads not modified */
                    public void take(double[] loads) {
                    }

                    /** Takes loads by sample. @param loads not modified */
                    public void carry(double[] loads) {
                    }

                    /** Takes loads by sample [N]. @param loads not modified @param scale their unit in newtons */
                    public void hold(double[] loads, double scale) {
                    }

                    /** Takes loads one by one [N], and times by which they come [s]. @param times not modified */
                    public void count(double[] times, double... loads) {
                    }

                    @Override
                    public double height(double load) {
                        return load;
                    }
                }
                """;
        assertEquals(List.of("2 Seat: say the unit of width", "5 sinks(load): say the unit of what it returns",
                "5 sinks(load): say the unit of load", "10 depth(load): say the unit of what it returns",
                "10 depth(load): say the unit of load", "20 depth(load, factor, bend): say the unit of bend",
                "25 part(load): there is no parameter [N]", "25 part(load): there is no parameter mess",
                "25 part(load): say the unit of what it returns", "25 part(load): say the unit of load",
                "30 take(loads): say the shape of loads", "34 carry(loads): say the unit of loads",
                "42 count(times, loads): say the shape of times").stream().map(gap -> "/Seat.java:" + gap).toList(),
                gaps(List.of(seat(source))));
    }

    private static JavaFileObject seat(String source) {
        return new SimpleJavaFileObject(URI.create("string:/Seat.java"), JavaFileObject.Kind.SOURCE) {
            @Override
            public CharSequence getCharContent(boolean ignoreEncodingErrors) {
                return source;
            }
        };
    }

    private static List<String> gaps(Iterable<? extends JavaFileObject> sources) throws IOException {
        JavacTask task = (JavacTask) ToolProvider.getSystemJavaCompiler().getTask(null, null, null, List.of("-proc:none"), null, sources);
        List<String> gaps = new ArrayList<>();
        for (CompilationUnitTree unit : task.parse()) {
            new Reader(unit, DocTrees.instance(task), gaps).scan(unit, null);
        }
        return gaps;
    }

    /** Reads one file; goes into visible types and into no body. */
    private static final class Reader extends TreePathScanner<Void, Void> {
        private final CompilationUnitTree unit;
        private final DocTrees docs;
        private final List<String> gaps;
        /** All that was said of the member before. */
        private String before = "";

        Reader(CompilationUnitTree unit, DocTrees docs, List<String> gaps) {
            this.unit = unit;
            this.docs = docs;
            this.gaps = gaps;
        }

        @Override
        public Void visitClass(ClassTree type, Void nothing) {
            if (isVisible(type.getModifiers())) {
                askForSummary(type, type.getSimpleName().toString());
                if (type.getKind() == Tree.Kind.RECORD) {
                    askForUnits(type, type.getSimpleName().toString(), components(type), Optional.empty());
                }
                super.visitClass(type, nothing);
            }
            return null;
        }

        @Override
        public Void visitVariable(VariableTree field, Void nothing) {
            boolean option = field.getInitializer() instanceof NewClassTree made && made.getIdentifier().toString().endsWith("Option");
            if (isVisible(field.getModifiers()) && !option && !isComponent(field) && !isConstantOfEnum(field)) {
                askForSummary(field, field.getName().toString());
            }
            return null;
        }

        @Override
        public Void visitMethod(MethodTree method, Void nothing) {
            if (!isVisible(method.getModifiers()) || overrides(method) || isMadeByTheRecord(method)
                    || method.getName().contentEquals("main")) {
                return null;
            }
            String name = (method.getReturnType() == null ? "constructor " + enclosing().getSimpleName() : method.getName())
                    + "(" + String.join(", ", method.getParameters().stream().map(each -> each.getName().toString()).toList()) + ")";
            askForSummary(method, name);
            String said = docs.getDocComment(getCurrentPath());
            if (said != null && method.getParameters().stream().anyMatch(Reader::takesArray)
                    && !SAYS_WHAT_BECOMES_OF_ARRAYS.matcher(said).find()) {
                gaps.add(place(method) + " " + name + ": say whether the array is modified");
            }
            askForUnits(method, name, method.getParameters(), Optional.ofNullable(method.getReturnType()));
            return null;
        }

        private void askForUnits(Tree member, String name, List<? extends VariableTree> given, Optional<Tree> result) {
            String comment = docs.getDocComment(getCurrentPath());
            if (comment == null) {
                return;
            }
            Said said = Said.in(comment);
            said.own().keySet().stream()
                    .filter(each -> !each.startsWith("<") && given.stream().noneMatch(one -> one.getName().contentEquals(each)))
                    .forEach(each -> gaps.add(place(member) + " " + name + ": there is no parameter " + each));
            List<Asked> numbers = new ArrayList<>();
            result.map(Tree::toString).filter(Reader::isNumber)
                    .ifPresent(type -> numbers.add(new Asked("what it returns", name.replaceFirst("\\(.*", ""), type, "")));
            for (VariableTree each : given) {
                String type = takesArray(each) ? each.getType().toString() : each.getType().toString().replaceFirst("\\[]$", "");
                if (isNumber(type)) {
                    numbers.add(new Asked(each.getName().toString(), each.getName().toString(), type, said.of(each.getName().toString())));
                }
            }
            long leftToSummary = numbers.stream().filter(each -> each.own().isEmpty() && !each.isNamed()).count();
            for (Asked each : numbers) {
                String text = each.own().isEmpty() ? said.summary() : each.own();
                String leaning = LEANS.matcher(text).find() ? text + " " + said.all() + " " + before : text;
                if (!each.isNamed() && mentions(leaning) < (each.own().isEmpty() ? leftToSummary : 1)) {
                    gaps.add(place(member) + " " + name + ": say the unit of " + each.shown());
                }
                if (each.type().contains("[]") && !SHAPE.matcher(each.name() + " " + leaning).find()) {
                    gaps.add(place(member) + " " + name + ": say the shape of " + each.shown());
                }
            }
            before = said.all();
        }

        private static boolean isNumber(String type) {
            return type.startsWith("double");
        }

        private static long mentions(String text) {
            return UNIT.matcher(text).results().count() + SAYS_KIND.matcher(text).results().count();
        }

        /** A number of a member. @param own what is said of it alone; empty where the summary has to say it */
        private record Asked(String shown, String name, String type, String own) {
            boolean isNamed() {
                return NAMES_KIND.matcher(name).matches();
            }
        }

        private void askForSummary(Tree member, String name) {
            DocCommentTree said = docs.getDocCommentTree(getCurrentPath());
            if (said == null || said.getFullBody().isEmpty()
                    && said.getBlockTags().stream()
                            .noneMatch(tag -> tag instanceof ReturnTree result && !result.getDescription().isEmpty())) {
                gaps.add(place(member) + " " + name + ": no summary");
            }
        }

        private String place(Tree member) {
            Tree from = member instanceof MethodTree method && method.getReturnType() != null ? method.getReturnType() : member;
            long position = docs.getSourcePositions().getStartPosition(unit, from);
            return unit.getSourceFile().getName() + ":" + unit.getLineMap().getLineNumber(position);
        }

        /** @return the type around the member that is looked at; what is a type itself by its own outer one, if any */
        private ClassTree enclosing() {
            return getCurrentPath().getParentPath().getLeaf() instanceof ClassTree type ? type : null;
        }

        private boolean isVisible(ModifiersTree modifiers) {
            Set<Modifier> flags = modifiers.getFlags();
            boolean open = enclosing() != null && !flags.contains(Modifier.PRIVATE)
                    && (enclosing().getKind() == Tree.Kind.INTERFACE || enclosing().getKind() == Tree.Kind.ANNOTATION_TYPE);
            return open || flags.contains(Modifier.PUBLIC) || flags.contains(Modifier.PROTECTED);
        }

        private boolean isComponent(VariableTree field) {
            return enclosing().getKind() == Tree.Kind.RECORD && !field.getModifiers().getFlags().contains(Modifier.STATIC);
        }

        private boolean isConstantOfEnum(VariableTree field) {
            return enclosing().getKind() == Tree.Kind.ENUM && enclosing().getSimpleName().contentEquals(field.getType().toString());
        }

        private boolean isMadeByTheRecord(MethodTree method) {
            if (enclosing().getKind() != Tree.Kind.RECORD) {
                return false;
            }
            List<VariableTree> components = components(enclosing());
            boolean accessor = method.getParameters().isEmpty()
                    && components.stream().anyMatch(field -> field.getName().equals(method.getName()));
            boolean canonical = method.getReturnType() == null && types(method.getParameters()).equals(types(components));
            return accessor || canonical;
        }

        private static List<VariableTree> components(ClassTree type) {
            return type.getMembers().stream().filter(VariableTree.class::isInstance).map(VariableTree.class::cast)
                    .filter(field -> !field.getModifiers().getFlags().contains(Modifier.STATIC)).toList();
        }

        private static List<String> types(List<? extends VariableTree> variables) {
            return variables.stream().map(each -> each.getType().toString()).toList();
        }

        private static boolean overrides(MethodTree method) {
            return method.getModifiers().getAnnotations().stream().anyMatch(each -> each.getAnnotationType().toString().equals("Override"));
        }

        /** Values given one by one are no array to anybody. */
        private static boolean takesArray(VariableTree parameter) {
            return parameter.getType().getKind() == Tree.Kind.ARRAY_TYPE && !parameter.toString().contains("...");
        }
    }

    /**
     * What stands in a comment, tags within a line included.
     *
     * @param summary with what is said of the result
     * @param own     by parameter; where nothing is said of one, what is said of the next
     */
    private record Said(String all, String summary, Map<String, String> own) {
        static Said in(String comment) {
            String all = comment.strip().replaceAll("\\s+", " ");
            String summary = "";
            String next = "";
            Map<String, String> own = new TreeMap<>();
            List<String> parts = Arrays.asList(all.split("(?=@(?:param|return|throws) )"));
            Collections.reverse(parts);
            for (String part : parts) {
                String[] words = part.strip().split(" ", 3);
                if (part.startsWith("@param")) {
                    next = words.length < 3 ? next : words[2];
                    own.put(words[1], next);
                } else if (!part.startsWith("@throws")) {
                    summary = part + summary;
                }
            }
            return new Said(all, summary, own);
        }

        /** What is said of a parameter alone; empty where that is no more than what becomes of it. */
        String of(String parameter) {
            String text = own.getOrDefault(parameter, "").strip();
            return SAYS_NO_MORE_THAN_THAT.matcher(text).matches() ? "" : text;
        }
    }
}
