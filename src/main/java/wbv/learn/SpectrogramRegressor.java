package wbv.learn;

import com.github.javacliparser.FileOption;
import com.github.javacliparser.IntOption;
import com.github.javacliparser.MultiChoiceOption;
import com.github.javacliparser.StringOption;
import com.yahoo.labs.samoa.instances.Instance;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Locale;
import moa.classifiers.AbstractClassifier;
import moa.classifiers.Regressor;
import moa.core.Measurement;
import moa.core.StringUtils;
import wbv.network.Imaging;
import wbv.network.Reader;
import wbv.network.Reading;
import wbv.network.Sliding;
import wbv.network.TrainedNetwork;
import wbv.recording.DataFault;

/**
 * A trained network as MOA's regressor over a sliding window: each instance is a sample at 60 Hz of the excitation and of the
 * answer, and what is predicted is the body's natural frequency or damping ratio as the last 3.65 s show them: what the network
 * says, fitted to the window. It learns nothing from instances; until the first window is full it says the mean of the bodies
 * that the network was trained on.
 */
public class SpectrogramRegressor extends AbstractClassifier implements Regressor {

    private static final long serialVersionUID = 1;
    private static final String CLASS = "class";
    private static final String TIME = "t";
    private static final double TAU = 2 * Math.PI;
    private static final int NONE = -1;

    public final FileOption modelOption = new FileOption("model", 'm', "Model of 'wbv net train'; the one that comes with wbv if "
            + "none.", null, "safetensors", false);
    public final IntOption modesOption = new IntOption("modes", 'g', "Modes of the body where no model is named.", 1, 1, 2);
    public final StringOption inputOption = new StringOption("input", 'i',
            "Attribute with the excitation: its name, or 'first' for the first that is neither t nor the class.",
            InstanceFeed.FIRST);
    public final StringOption outputOption = new StringOption("output", 'o',
            "Attribute with the answer: its name, or 'class' for the class attribute.", CLASS);
    public final MultiChoiceOption targetOption = new MultiChoiceOption("target", 't', "What is predicted.",
            new String[] {"frequency", "damping"}, new String[] {"natural frequency of the slowest mode [Hz]",
                "its damping ratio"},
            0);
    public final IntOption hopOption = new IntOption("hop", 'h', "Samples from one look to the next.", 30, 1, 100000);

    private Sliding sliding = new Sliding(2);
    private SampleTiming timing = new SampleTiming(Imaging.RATE);
    private double[] value = new double[0];
    private double[] deviation = new double[0];
    private double misfit;
    private boolean sighted;
    private byte[] model = new byte[0];
    private long sinceLook;
    private long looks;
    private transient Reader reader;

    @Override
    public String getPurposeString() {
        return "Natural frequency or damping ratio of a body as a network reads them from the last 3.65 s of a stream at 60 Hz.";
    }

    @Override
    public void resetLearningImpl() {
        sliding = new Sliding(2);
        timing = new SampleTiming(Imaging.RATE);
        sinceLook = 0;
        looks = 0;
        TrainedNetwork loaded = load();
        model = loaded.bytes();
        value = loaded.scaling().mean().clone();
        deviation = loaded.scaling().deviation().clone();
        misfit = 0;
        sighted = loaded.architecture().excited();
        close();
    }

    private TrainedNetwork load() {
        try {
            TrainedNetwork loaded = modelOption.getValue() == null ? TrainedNetwork.shipped(modesOption.getValue())
                    : TrainedNetwork.read(Path.of(modelOption.getValue()));
            if (loaded.channels().size() > 2) {
                throw DataFault.in(modelOption.getValue(), "is a model of " + loaded.channels()
                        + "; this learner takes models of one input and one output");
            }
            return loaded;
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    private void close() {
        if (reader != null) {
            reader.close();
            reader = null;
        }
    }

    @Override
    public void trainOnInstanceImpl(Instance instance) {
        int time = index(instance, TIME, NONE);
        double t = time == NONE ? Double.NaN : instance.value(time);
        if (timing.learnsRate(t) && Math.abs(timing.rate() / Imaging.RATE - 1) > 0.01) {
            throw new IllegalArgumentException("networks know " + Imaging.RATE + " Hz alone: " + timing.rate());
        }
        long missing = Math.min(timing.missingBefore(t), Imaging.SAMPLES);
        for (long i = 0; i < missing; i++) {
            take(Double.NaN, Double.NaN);
        }
        String input = inputOption.getValue();
        int from = input.equals(InstanceFeed.FIRST) ? first(instance) : index(instance, input, NONE);
        int to = outputOption.getValue().equals(CLASS) ? instance.classIndex() : index(instance, outputOption.getValue(), NONE);
        if (to != NONE && !sighted) {
            from = to;
        }
        if (from == NONE || to == NONE) {
            throw new IllegalArgumentException("no attribute '" + (from == NONE ? input : outputOption.getValue()) + "' in "
                    + instance.dataset().getRelationName());
        }
        take(instance.value(from), instance.value(to));
    }

    private void take(double excitation, double answer) {
        sliding.accept(excitation, answer);
        sinceLook++;
        if (sinceLook >= hopOption.getValue() && sliding.whole()) {
            sinceLook = 0;
            looks++;
            if (reader == null) {
                reader = new Reader(TrainedNetwork.parse("the learner's model", model));
            }
            Reading reading = reader.read(sliding.motion());
            value = reading.fitted().value();
            deviation = reading.fitted().deviation();
            misfit = reading.misfit();
        }
    }

    private static int first(Instance instance) {
        for (int i = 0; i < instance.numAttributes(); i++) {
            if (i != instance.classIndex() && !instance.attribute(i).name().equals(TIME)) {
                return i;
            }
        }
        return NONE;
    }

    private static int index(Instance instance, String name, int otherwise) {
        for (int i = 0; i < instance.numAttributes(); i++) {
            if (instance.attribute(i).name().equals(name)) {
                return i;
            }
        }
        return otherwise;
    }

    /** What the last look saw, of the slowest mode. */
    @Override
    public double[] getVotesForInstance(Instance instance) {
        return new double[] {targetOption.getChosenIndex() == 0 ? value[1] / TAU : value[0]};
    }

    /** Looks taken at whole windows. */
    public long looks() {
        return looks;
    }

    @Override
    protected Measurement[] getModelMeasurementsImpl() {
        return new Measurement[] {
            new Measurement("natural frequency [Hz]", value[1] / TAU),
            new Measurement("natural frequency sd [Hz]", deviation[1] / TAU),
            new Measurement("damping ratio [1]", value[0]),
            new Measurement("damping ratio sd [1]", deviation[0]),
            new Measurement("misfit over that of trained windows [1]", misfit),
            new Measurement("looks", looks),
        };
    }

    @Override
    public void getModelDescription(StringBuilder out, int indent) {
        StringUtils.appendIndented(out, indent, String.format(Locale.ROOT,
                "%d looks; natural frequency %.3f Hz, damping ratio %.3f "
                        + "at the last%s.",
                looks, value[1] / TAU, value[0],
                misfit > 1 ? ", which is unlike all that was trained on" : ""));
    }

    @Override
    public boolean isRandomizable() {
        return false;
    }
}
