package wbv.state;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import weka.core.Instances;
import weka.core.Option;
import weka.core.OptionHandler;
import weka.core.converters.ArffLoader;
import weka.core.converters.ConverterUtils.DataSource;
import weka.experiment.DensityBasedClustererSplitEvaluator;
import weka.experiment.InstancesResultListener;
import weka.experiment.RandomSplitResultProducer;
import weka.knowledgeflow.Data;
import weka.knowledgeflow.Flow;
import weka.knowledgeflow.FlowRunner;
import weka.knowledgeflow.LoggingLevel;
import weka.knowledgeflow.StepManager;
import weka.knowledgeflow.StepManagerImpl;
import weka.knowledgeflow.steps.BaseStep;
import weka.knowledgeflow.steps.Clusterer;
import weka.knowledgeflow.steps.KFStep;
import weka.knowledgeflow.steps.Loader;
import weka.knowledgeflow.steps.TrainingSetMaker;

/** wbv's learners in Weka's Experimenter and Knowledge Flow, by the code behind their windows. */
class WekaHostsTest {

    @TempDir
    private Path folder;

    /** Ten seconds of a ride, which a mixture of two components is fitted to. */
    private File ride() throws IOException {
        Path file = folder.resolve("ride.arff");
        try (Stream<String> lines = Files.lines(Path.of("data/arff/one-dof-linear.arff"))) {
            Files.write(file, (Iterable<String>) lines.limit(620)::iterator);
        }
        return file.toFile();
    }

    private static MessageLengthClusterer few() throws Exception {
        MessageLengthClusterer clusterer = new MessageLengthClusterer();
        clusterer.setOptions(new String[] {"-max", "2"});
        return clusterer;
    }

    @ParameterizedTest
    @ValueSource(strings = {"MessageLengthClusterer", "DirichletClusterer", "SequenceClassifier"})
    void everyOptionIsListedOnceAndReadsBack(String name) throws Exception {
        OptionHandler learner = (OptionHandler) Class.forName("wbv.state." + name).getDeclaredConstructor().newInstance();
        List<String> names = new ArrayList<>();
        for (Option option : Collections.list(learner.listOptions())) {
            names.add(option.name());
        }
        assertEquals(new HashSet<>(names).size(), names.size(), names.toString());
        String first = name.startsWith("M") ? "-min" : name.startsWith("D") ? "-sweeps" : "-states";
        assertTrue(names.contains(first.substring(1)), names.toString());
        learner.setOptions(new String[] {first, "7", "-S", "5"});
        String[] words = learner.getOptions();
        assertEquals(1, Collections.frequency(List.of(words), first));
        OptionHandler other = (OptionHandler) Class.forName("wbv.state." + name).getDeclaredConstructor().newInstance();
        other.setOptions(words.clone());
        assertArrayEquals(words, other.getOptions());
        assertEquals("7", words[List.of(words).indexOf(first) + 1]);
    }

    /**
     * Two runs of what the Experimenter runs (its own window reads files by libraries of Weka's that are not ours): a row of results each,
     * with a likelihood of what was not learned from.
     */
    @Test
    void theExperimenterRunsAClusterer() throws Exception {
        File results = folder.resolve("results.arff").toFile();
        DensityBasedClustererSplitEvaluator evaluator = new DensityBasedClustererSplitEvaluator();
        evaluator.setRemoveClassColumn(true);
        RandomSplitResultProducer producer = new RandomSplitResultProducer();
        producer.setSplitEvaluator(evaluator);
        producer.setTrainPercent(50);
        InstancesResultListener listener = new InstancesResultListener();
        listener.setOutputFile(results);
        producer.setResultListener(listener);
        try (Reader ride = Files.newBufferedReader(ride().toPath())) {
            Instances data = new Instances(ride);
            data.setClassIndex(data.numAttributes() - 1); // as the Experimenter does; a clusterer does not see it
            producer.setInstances(data);
        }
        evaluator.setClusterer(few());
        producer.preProcess();
        producer.doRun(1);
        producer.doRun(2);
        producer.postProcess();
        Instances rows;
        try (Reader written = Files.newBufferedReader(results.toPath())) {
            rows = new Instances(written);
        }
        assertEquals(2, rows.numInstances());
        double likelihood = rows.instance(0).value(rows.attribute("Log_likelihood"));
        assertTrue(Double.isFinite(likelihood) && likelihood != 0, rows.toString());
        assertTrue(rows.instance(0).stringValue(rows.attribute("Key_Scheme")).contains("MessageLengthClusterer"));
    }

    /** Takes what a clusterer of a flow has learned. */
    @KFStep(name = "Keeper", category = "Test", toolTipText = "", iconPath = "")
    public static final class Keeper extends BaseStep {

        private static final long serialVersionUID = 1;

        private final transient AtomicReference<Object> kept = new AtomicReference<>();

        @Override
        public void stepInit() {}

        @Override
        public void processIncoming(Data data) {
            kept.set(data.getPrimaryPayload());
            getStepManager().finished();
        }

        @Override
        public List<String> getIncomingConnectionTypes() {
            return List.of(StepManager.CON_BATCH_CLUSTERER);
        }

        @Override
        public List<String> getOutgoingConnectionTypes() {
            return List.of();
        }
    }

    @Test
    void theKnowledgeFlowLearnsAMixture() throws Exception {
        ArffLoader ride = new ArffLoader();
        File ten = ride();
        ride.setSource(ten);
        Loader load = new Loader();
        load.setLoader(ride);
        Clusterer learn = new Clusterer();
        learn.setClusterer(few());
        Keeper keeper = new Keeper();
        StepManagerImpl[] steps = {new StepManagerImpl(load), new StepManagerImpl(new TrainingSetMaker()), new StepManagerImpl(learn),
            new StepManagerImpl(keeper)};
        String[] connections = {StepManager.CON_DATASET, StepManager.CON_TRAININGSET, StepManager.CON_BATCH_CLUSTERER};
        Flow flow = new Flow();
        for (StepManagerImpl step : steps) {
            flow.addStep(step);
        }
        for (int i = 0; i < connections.length; i++) {
            assertTrue(flow.connectSteps(steps[i], steps[i + 1], connections[i]), connections[i]);
        }
        FlowRunner runner = new FlowRunner();
        runner.getExecutionEnvironment().setLoggingLevel(LoggingLevel.NONE);
        runner.setFlow(flow);
        runner.run();
        runner.waitUntilFinished();
        MessageLengthClusterer learned = (MessageLengthClusterer) keeper.kept.get();
        MessageLengthClusterer alone = few();
        alone.buildClusterer(DataSource.read(ten.toString()));
        assertEquals(alone.toString(), learned.toString());
    }
}
