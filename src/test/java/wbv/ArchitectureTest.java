package wbv;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaField;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.library.dependencies.SlicesRuleDefinition;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

/** Who may import whom. The order of the packages is the order in which data flows. */
class ArchitectureTest {

    private static final List<String> ORDER = List.of("recording", "snapshot", "signal", "sensing", "exposure", "body", "fmi", "rig", "filter",
            "identify",
            "pole", "state", "seat", "fleet", "network", "diagnosis", "export", "learn", "stream", "task", "live", "report", "proof", "cli");

    /** Host libraries by the packages that may import them. */
    private static final Map<String, List<String>> HOSTS = Map.ofEntries(
            Map.entry("org.apache.commons.math3..", List.of("signal", "sensing", "exposure", "body", "rig", "filter", "identify",
                    "pole", "state",
                    "diagnosis", "proof", "learn", "stream")),
            Map.entry("org.ejml..", List.of("signal", "sensing", "exposure", "body", "fmi", "rig", "filter", "identify", "pole", "state",
                    "network", "diagnosis")),
            Map.entry("elki..", List.of("pole")),
            Map.entry("org.locationtech.jts..", List.of("pole")),
            Map.entry("weka..", List.of("pole", "state")),
            Map.entry("ai.djl..", List.of("network")),
            Map.entry("moa..", List.of("learn", "stream", "task")),
            Map.entry("com.yahoo.labs.samoa..", List.of("learn", "stream", "task")),
            Map.entry("com.github.javacliparser..", List.of("learn", "stream", "task")),
            Map.entry("com.fasterxml.jackson..", List.of("recording", "body", "rig", "pole", "state", "network", "diagnosis",
                    "live", "report",
                    "proof", "cli")),
            Map.entry("com.sun.jna..", List.of("fmi")),
            Map.entry("org.eclipse.paho..", List.of("live")),
            Map.entry("picocli..", List.of("cli")));

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
        SlicesRuleDefinition.slices().matching("wbv.(*)..").should().beFreeOfCycles().check(MAIN);
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
