package wbv.task;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InvalidClassException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import moa.classifiers.AbstractClassifier;
import moa.core.SerializeUtils;
import moa.options.ClassOption;
import moa.streams.ExampleStream;
import moa.tasks.MainTask;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class AdmittedClassesTest {

    @ParameterizedTest
    @ValueSource(strings = {"wbv.learn.AdwinKalman", "wbv.learn.BodyTracker -m particle -p 50", "wbv.learn.BodyTracker -m fused",
        "wbv.learn.StateLearner", "trees.FIMTDD", "rules.AMRulesRegressor", "functions.Perceptron"})
    void learnersComeBack(String cli) throws Exception {
        AbstractClassifier learner = (AbstractClassifier) ClassOption.cliStringToObject(cli, AbstractClassifier.class, null);
        ExampleStream<?> stream = (ExampleStream<?>) ClassOption.cliStringToObject(
                "wbv.stream.RigStream -r 3 -e 'sitter=one-dof seconds=5'", ExampleStream.class, null);
        ((moa.options.AbstractOptionHandler) stream).prepareForUse();
        learner.setModelContext(stream.getHeader());
        learner.prepareForUse();
        if (!cli.contains("StateLearner") && !cli.contains("Perceptron")) {
            for (int i = 0; i < 200; i++) {
                learner.trainOnInstance((com.yahoo.labs.samoa.instances.Instance) stream.nextInstance().getData());
            }
        }
        assertEquals(learner.getCLICreationString(AbstractClassifier.class),
                ((AbstractClassifier) read(learner)).getCLICreationString(AbstractClassifier.class));
    }

    @Test
    void tasksAndWekasLearnersComeBack() throws Exception {
        MainTask task = (MainTask) ClassOption.cliStringToObject(
                "EvaluatePrequentialRegression -l wbv.learn.AdwinKalman -s (wbv.stream.RigStream -r 7) -i 720", MainTask.class, null);
        assertEquals(task.getCLICreationString(MainTask.class), ((MainTask) read(task)).getCLICreationString(MainTask.class));
        weka.core.Instances rows = new weka.core.converters.ConverterUtils.DataSource("data/arff/one-dof-linear.arff").getDataSet();
        rows = new weka.core.Instances(rows, 0, 300);
        rows.setClassIndex(rows.numAttributes() - 1);
        for (weka.classifiers.Classifier each : List.of(new weka.classifiers.trees.REPTree(), new weka.classifiers.lazy.IBk(),
                new weka.classifiers.trees.RandomForest())) {
            each.buildClassifier(rows);
            assertEquals(each.classifyInstance(rows.get(7)), ((weka.classifiers.Classifier) read(each)).classifyInstance(rows.get(7)));
        }
    }

    static List<Object> refused() {
        Comparator<String> lambda = (Comparator<String> & Serializable) String::compareTo;
        InvocationHandler handler = (InvocationHandler & Serializable) (proxy, method, arguments) -> null;
        return List.of(new ArrayRealVector(3), new TreeMap<>(lambda),
                new ArrayList<>(Collections.singletonList(new java.net.InetAddress[0])),
                Proxy.newProxyInstance(Comparator.class.getClassLoader(), new Class<?>[] {Comparator.class}, handler));
    }

    @ParameterizedTest
    @MethodSource("refused")
    void whatIsNoneOfOursIsRefused(Object other) {
        assertThrows(InvalidClassException.class, () -> read(other));
    }

    @Test
    void valuesOfJavaComeBack() throws Exception {
        Map<String, Object> values = new TreeMap<>(Map.of("a", List.of(1, 2.5), "b", new double[] {1}, "c", new java.util.Random(1),
                "d", new java.math.BigDecimal("1.5"), "e", new java.util.BitSet()));
        assertEquals(values.keySet(), ((Map<?, ?>) read(values)).keySet());
    }

    /** In a Java of its own: the rule holds for all that the process reads, and stays. */
    @Test
    void aTaskStringReadsNoForeignClass(@TempDir Path folder) throws Exception {
        Path foreign = folder.resolve("foreign.moa");
        SerializeUtils.writeToFile(foreign.toFile(), new ArrayRealVector(3));
        Path ours = folder.resolve("ours.moa");
        SerializeUtils.writeToFile(ours.toFile(), (Serializable) ClassOption.cliStringToObject("wbv.learn.AdwinKalman",
                wbv.learn.BodyLearner.class, null));
        String refused = output(1, "wbv.task.TrackBody -l file:" + foreign);
        assertTrue(refused.contains("ArrayRealVector may not come from a file"), refused);
        String read = output(0, "wbv.task.TrackBody -l file:" + ours + " -s (wbv.stream.RigStream -e 'sitter=one-dof seconds=5')");
        assertTrue(read.contains("natural frequency [Hz]"), read);
    }

    private static String output(int least, String task) throws Exception {
        Process process = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
                System.getProperty("java.class.path"), "wbv.cli.Main", "task", task).redirectErrorStream(true).start();
        String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertTrue(process.waitFor(60, TimeUnit.SECONDS));
        assertTrue(least == 0 ? process.exitValue() == 0 : process.exitValue() == 1 || process.exitValue() == 2, text);
        return text;
    }

    private static Object read(Object object) throws IOException, ClassNotFoundException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(object);
        }
        try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
            in.setObjectInputFilter(AdmittedClasses.filter());
            return in.readObject();
        }
    }
}
