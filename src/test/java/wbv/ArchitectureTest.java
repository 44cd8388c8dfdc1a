package wbv;

import static com.tngtech.archunit.core.domain.JavaCall.Predicates.target;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.assignableTo;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.core.domain.properties.HasOwner.Predicates.With.owner;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaField;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.library.dependencies.SlicesRuleDefinition;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

/** Who may import whom. The order of the packages is the order in which data flows. */
class ArchitectureTest {

    private static final List<
            String> ORDER = List.of("recording", "result", "snapshot", "signal", "sensing", "exposure", "body", "fmi", "rig", "filter",
                    "control", "identify",
                    "pole", "state", "seat", "fleet", "network", "diagnosis", "export", "learn", "stream", "task", "live", "study",
                    "report", "proof", "cli");

    /** Host libraries by the packages that may import them. */
    private static final Map<String, List<String>> HOSTS = Map.ofEntries(
            Map.entry("org.apache.commons.math3..", List.of("signal", "sensing", "exposure", "body", "rig", "filter", "control", "identify",
                    "pole", "state",
                    "diagnosis", "proof", "learn", "stream")),
            Map.entry("org.ejml..",
                    List.of("signal", "sensing", "exposure", "body", "fmi", "rig", "filter", "control", "identify", "pole", "state",
                            "network", "diagnosis")),
            Map.entry("elki..", List.of("pole")),
            Map.entry("org.locationtech.jts..", List.of("pole")),
            Map.entry("weka..", List.of("pole", "state")),
            Map.entry("ai.djl..", List.of("network")),
            Map.entry("moa..", List.of("learn", "stream", "task")),
            Map.entry("com.yahoo.labs.samoa..", List.of("learn", "stream", "task")),
            Map.entry("com.github.javacliparser..", List.of("learn", "stream", "task")),
            Map.entry("com.fasterxml.jackson..", List.of("recording", "result", "body", "rig", "pole", "state", "network", "diagnosis",
                    "live", "study", "report",
                    "proof", "cli")),
            Map.entry("com.sun.jna..", List.of("fmi")),
            Map.entry("org.eclipse.paho..", List.of("live")),
            Map.entry("us.hebi.matlab..", List.of("recording.signals")),
            Map.entry("io.jhdf..", List.of("recording.signals")),
            Map.entry("org.apache.parquet..", List.of("recording.signals")),
            Map.entry("io.airlift..", List.of("recording.signals")),
            Map.entry("picocli..", List.of("cli")));

    /** Rooms of several packages, in the order in which they may know each other: the first knows none of the others. */
    private static final Map<String, List<String>> INNER = Map.of(
            "wbv.recording", List.of("", ".inspect", ".signals", ".format"),
            "wbv.body", List.of(".number", ".law", "", ".simulate"),
            "wbv.control", List.of("", ".trial"),
            "wbv.diagnosis",
            List.of(".algebra", ".mechanism", ".measured", ".fit", ".search", ".convention", ".learn", "", ".picture", ".surrogate"),
            "wbv.filter", List.of(".model", ".drift", ""),
            "wbv.state", List.of(".mixture", ".markov", ""),
            "wbv.rig", List.of(".platform", "", ".concealed.law", ".concealed"),
            "wbv.report", List.of(".page", ".recording", ".analysis"));

    private static final long MOST_FILES = 40;

    /** As in src/build/formatter.xml. */
    private static final int MOST_COLUMNS = 140;

    /** Lines of a class of the diagnosis. */
    private static final int MOST_LINES = 250;

    private static final JavaClasses MAIN = new ClassFileImporter()
            .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS).importPackages("wbv");

    @TestFactory
    Stream<DynamicTest> packagesImportOnlyWhatComesBeforeThem() {
        return ORDER.stream().map(name -> DynamicTest.dynamicTest(name, () -> {
            String[] later = ORDER.subList(ORDER.indexOf(name) + 1, ORDER.size()).stream()
                    .map(other -> "wbv." + other + "..").toArray(String[]::new);
            noClasses().that().resideInAPackage("wbv." + name + "..")
                    .should().dependOnClassesThat().resideInAnyPackage(later).allowEmptyShould(true).check(MAIN);
        }));
    }

    @TestFactory
    Stream<DynamicTest> hostLibrariesStayWhereTheyBelong() {
        return HOSTS.entrySet().stream().map(entry -> DynamicTest.dynamicTest(entry.getKey(), () -> {
            String[] allowed = entry.getValue().stream().map(name -> "wbv." + name + "..").toArray(String[]::new);
            noClasses().that().resideOutsideOfPackages(allowed)
                    .should().dependOnClassesThat().resideInAPackage(entry.getKey()).check(MAIN);
        }));
    }

    @Test
    void whatConcealsIsNotWhatFinds() {
        noClasses().that().resideInAPackage("wbv.rig..")
                .should().dependOnClassesThat().resideInAnyPackage("wbv.body..", "wbv.diagnosis..", "wbv.identify..").check(MAIN);
        noClasses().that().resideInAnyPackage("wbv.body..", "wbv.diagnosis..")
                .should().dependOnClassesThat().resideInAPackage("wbv.rig..").allowEmptyShould(true).check(MAIN);
    }

    /** A controller tried on the model that it was designed with would do well on anything. */
    @Test
    void controllersKnowNothingOfTheSeatThatTheyAreTriedOn() {
        noClasses().that().resideInAPackage("wbv.control").should().dependOnClassesThat().resideInAPackage("wbv.rig..").check(MAIN);
        noClasses().that().resideInAPackage("wbv.rig..").should().dependOnClassesThat().resideInAPackage("wbv.control..").check(MAIN);
    }

    /** A replay is to say what the first run said, and a state or a packet may come from anybody. */
    @Test
    void seatsKnowNoClockOnTheWallAndReadNoJavaObjects() {
        noClasses().that().resideInAnyPackage("wbv.snapshot..", "wbv.filter..", "wbv.exposure..", "wbv.state..", "wbv.seat..")
                .should().callMethod(System.class, "nanoTime").orShould().callMethod(System.class, "currentTimeMillis")
                .orShould().dependOnClassesThat().haveFullyQualifiedName("java.time.Clock")
                .orShould().dependOnClassesThat().haveFullyQualifiedName("java.time.Instant").check(MAIN);
        noClasses().that().resideInAnyPackage("wbv.snapshot..", "wbv.seat..", "wbv.fleet..", "wbv.live..")
                .should().dependOnClassesThat().haveFullyQualifiedName("java.io.ObjectInputStream").check(MAIN);
    }

    @Test
    void everyClassLivesInAKnownPackage() {
        String[] known = ORDER.stream().map(name -> "wbv." + name + "..").toArray(String[]::new);
        classes().should().resideInAnyPackage(known).check(MAIN);
    }

    @Test
    void noPackageDependsOnItselfThroughAnother() {
        SlicesRuleDefinition.slices().matching("wbv.(**)").should().beFreeOfCycles().check(MAIN);
    }

    /** Within a room of several packages: what comes first knows nothing of what comes later. */
    @TestFactory
    Stream<DynamicTest> roomsWithinARoomHaveAnOrder() {
        return INNER.entrySet().stream()
                .flatMap(room -> room.getValue().stream().map(name -> DynamicTest.dynamicTest(room.getKey() + name, () -> {
                    List<String> names = room.getValue();
                    String[] later = names.subList(names.indexOf(name) + 1, names.size()).stream().map(other -> room.getKey() + other)
                            .toArray(String[]::new);
                    noClasses().that().resideInAPackage(room.getKey() + name)
                            .should().dependOnClassesThat().resideInAnyPackage(later).allowEmptyShould(true).check(MAIN);
                })));
    }

    /** A page shows what a study found: it drives no estimator, and makes nothing that one is made of. */
    @Test
    void reportsComputeNothing() {
        noClasses().that().resideInAPackage("wbv.report..").should().dependOnClassesThat().resideInAnyPackage("wbv.learn..", "wbv.stream..",
                "wbv.task..", "wbv.rig..", "wbv.seat..", "wbv.fleet..", "wbv.live..", "wbv.proof..", "wbv.body.simulate..").check(MAIN);
        noClasses().that().resideInAPackage("wbv.report..").should().dependOnClassesThat(assignableTo("wbv.filter.Estimator")).check(MAIN);
        noClasses().that().resideInAPackage("wbv.report..").should().callConstructorWhere(target(owner(resideInAnyPackage("wbv.signal..",
                "wbv.filter..", "wbv.identify..", "wbv.exposure..", "wbv.pole..", "wbv.state..", "wbv.network..", "wbv.diagnosis.."))))
                .check(MAIN);
        noClasses().that().resideInAPackage("wbv.report.page..").should().dependOnClassesThat()
                .resideInAnyPackage("wbv.study..", "wbv.filter..",
                        "wbv.identify..", "wbv.exposure..", "wbv.pole..", "wbv.state..", "wbv.network..", "wbv.diagnosis..")
                .check(MAIN);
    }

    /** What is asked and found is not how it looks. */
    @Test
    void studiesWriteNoPages() {
        noClasses().that().resideOutsideOfPackages("wbv.report..", "wbv.cli..", "wbv.live..")
                .should().dependOnClassesThat().resideInAPackage("wbv.report..").check(MAIN);
    }

    /** A room that one can see at a glance. */
    @Test
    void noPackageHoldsMoreThanFortyFiles() throws IOException {
        Map<String, Long> sizes;
        try (Stream<Path> files = Files.walk(Path.of("src/main/java"))) {
            sizes = files.filter(file -> file.toString().endsWith(".java") && !file.endsWith("package-info.java"))
                    .collect(Collectors.groupingBy(
                            file -> Path.of("src/main/java").relativize(file.getParent()).toString().replace(File.separatorChar, '.'),
                            Collectors.counting()));
        }
        sizes.forEach((name, size) -> assertTrue(size <= MOST_FILES, name + " has " + size + " files, more than " + MOST_FILES
                + ": split it by what its classes are about"));
    }

    /** What decides is read class by class. */
    @Test
    void noClassOfTheDiagnosisIsLongerThanAFewScreens() throws IOException {
        try (Stream<Path> files = Files.walk(Path.of("src/main/java/wbv/diagnosis"))) {
            for (Path file : files.filter(each -> each.toString().endsWith(".java")).toList()) {
                int lines = Files.readAllLines(file).size();
                assertTrue(lines <= MOST_LINES, file + " has " + lines + " lines, more than " + MOST_LINES + ": split it by what it says");
            }
        }
    }

    /** What the formatter cannot wrap: comments, literals, text blocks. */
    @Test
    void noLineIsLongerThanTheFormatterMakesOne() throws IOException {
        for (String folder : List.of("src/main/java", "src/test/java", "src/fleet", "examples")) {
            try (Stream<Path> files = Files.walk(Path.of(folder))) {
                for (Path file : files.filter(each -> each.toString().endsWith(".java")).toList()) {
                    List<String> lines = Files.readAllLines(file);
                    for (int i = 0; i < lines.size(); i++) {
                        assertTrue(lines.get(i).length() <= MOST_COLUMNS,
                                file + ":" + (i + 1) + " has more than " + MOST_COLUMNS + " columns");
                    }
                }
            }
        }
    }

    /** A name means one thing. Hosts find our classes in a package of theirs under the names that ours have. */
    @Test
    void noNameStandsInTwoRooms() {
        Map<String,
                List<String>> twice = MAIN.stream().filter(type -> type.isTopLevelClass() && !type.getSimpleName().equals("package-info"))
                        .collect(Collectors.groupingBy(JavaClass::getSimpleName,
                                Collectors.mapping(JavaClass::getPackageName, Collectors.toList())));
        twice.values().removeIf(rooms -> rooms.size() == 1);
        assertEquals(Map.of(), twice);
    }

    @Test
    void thereIsNoMutableStaticState() {
        fields().that().areStatic().and(notSynthetic()).should().beFinal().check(MAIN);
    }

    @Test
    void everyPackageExplainsItself() {
        List<String> silent = MAIN.stream().filter(type -> !type.getPackageName().equals("wbv"))
                .map(JavaClass::getPackageName).distinct()
                .filter(name -> !Files.exists(Path.of("src/main/java", name.replace('.', '/'), "package-info.java")))
                .toList();
        assertEquals(List.of(), silent);
    }

    private static DescribedPredicate<JavaField> notSynthetic() {
        return DescribedPredicate.describe("not made by the compiler",
                field -> !field.getModifiers().contains(JavaModifier.SYNTHETIC));
    }
}
