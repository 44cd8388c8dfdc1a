package wbv.task;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.lang.reflect.Modifier;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Properties;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import moa.classifiers.core.driftdetection.ChangeDetector;
import moa.core.AutoClassDiscovery;
import moa.evaluation.preview.LearningCurve;
import moa.learners.Learner;
import moa.options.ClassOption;
import moa.options.OptionHandler;
import moa.streams.InstanceStream;
import moa.tasks.AuxiliarMainTask;
import moa.tasks.MainTask;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import weka.clusterers.Clusterer;
import weka.core.ClassDiscovery;

/** What the windows of MOA and Weka list of wbv, found by their own discovery, without a display. */
class HostListsTest {

    private static final List<Class<?>> LISTED = List.of(InstanceStream.class, Learner.class, ChangeDetector.class, AuxiliarMainTask.class);

    /** The names in MOA's lists. */
    private static Set<String> listed() {
        return Arrays.stream(AutoClassDiscovery.findClassNames("moa"))
                .filter(name -> name.contains(".wbv.") && !name.endsWith("package-info"))
                .collect(Collectors.toCollection(TreeSet::new));
    }

    private static Class<?> named(String name) {
        try {
            return Class.forName(name);
        } catch (ClassNotFoundException missing) {
            throw new AssertionError(missing);
        }
    }

    /** Classes of a package of ours that MOA can list; a stand-in that hears nothing is none. */
    private static Stream<Class<?>> listable(String room) {
        try (Stream<Path> files = Files.list(Path.of("src/main/java/wbv", room))) {
            return files.map(file -> file.getFileName().toString().replace(".java", ""))
                    .filter(name -> !name.equals("package-info") && !name.equals("Deaf"))
                    .<Class<?>>map(name -> named("wbv." + room + "." + name)).toList().stream()
                    .filter(type -> Modifier.isPublic(type.getModifiers()) && !Modifier.isAbstract(type.getModifiers()))
                    .filter(type -> LISTED.stream().anyMatch(kind -> kind.isAssignableFrom(type)));
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"stream", "learn", "task"})
    void moaListsAllThatCanBeListed(String room) {
        Set<Class<?>> behind = listed().stream().<Class<?>>map(name -> named(name).getSuperclass()).collect(Collectors.toSet());
        List<Class<?>> ours = listable(room).toList();
        assertTrue(ours.size() >= 3, ours.toString());
        ours.forEach(type -> assertTrue(behind.contains(type), () -> type + " has no name in the package moa; add one beside " + listed()));
    }

    @Test
    void namesInTheListsAreNamesAndNothingElse() throws Exception {
        assertEquals(20, listed().size(), listed().toString());
        for (String name : listed()) {
            Class<?> type = named(name);
            assertEquals(type.getSuperclass().getSimpleName(), type.getSimpleName());
            assertEquals(0, type.getDeclaredMethods().length, name);
            OptionHandler made = (OptionHandler) type.getDeclaredConstructor().newInstance();
            OptionHandler meant = (OptionHandler) type.getSuperclass().getDeclaredConstructor().newInstance();
            assertEquals(meant.getOptions().getAsCLIString(), made.getOptions().getAsCLIString(), name);
        }
    }

    @Test
    void theShortNamesOfTheWindowRun() throws Exception {
        MainTask task = (MainTask) ClassOption.cliStringToObject("EvaluatePrequentialRegression -l (wbv.AdwinKalman -a wbv.TwoSidedAdwin)"
                + " -s (wbv.RecordingStream -f data/arff/one-dof-linear.arff) -i 7200 -f 7200", MainTask.class, null);
        task.prepareForUse();
        LearningCurve curve = (LearningCurve) task.doTask();
        assertEquals("coefficient of determination", curve.getMeasurementName(8));
        assertTrue(curve.getMeasurement(0, 8) > 0.999, curve.toString());
    }

    @Test
    void wekasPackageNamesThePackagesThatHoldOurClasses() throws Exception {
        Properties places = new Properties();
        try (InputStream in = Files.newInputStream(Path.of("src/weka/GenericPropertiesCreator.props"))) {
            places.load(in);
        }
        assertEquals(List.of("wbv.state.DirichletClusterer", "wbv.state.MessageLengthClusterer"),
                List.copyOf(new TreeSet<>(ClassDiscovery.find(Clusterer.class, places.getProperty(Clusterer.class.getName())))));
        assertEquals(List.of("wbv.state.SequenceClassifier"),
                ClassDiscovery.find(weka.classifiers.Classifier.class, places.getProperty(weka.classifiers.Classifier.class.getName())));
    }
}
