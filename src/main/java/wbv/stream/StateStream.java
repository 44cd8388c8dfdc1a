package wbv.stream;

import com.github.javacliparser.FloatOption;
import com.github.javacliparser.IntOption;
import com.github.javacliparser.StringOption;
import com.yahoo.labs.samoa.instances.Attribute;
import com.yahoo.labs.samoa.instances.DenseInstance;
import com.yahoo.labs.samoa.instances.Instance;
import com.yahoo.labs.samoa.instances.Instances;
import com.yahoo.labs.samoa.instances.InstancesHeader;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import moa.core.Example;
import moa.core.InstanceExample;
import moa.core.ObjectRepository;
import moa.options.AbstractOptionHandler;
import moa.streams.InstanceStream;
import moa.tasks.TaskMonitor;
import wbv.rig.RigRun;
import wbv.rig.RigSpec;
import wbv.state.FeatureSpec;
import wbv.state.FeatureStream;
import wbv.state.MotionState;
import wbv.state.Thresholds;
import wbv.state.TrueStates;

/**
 * A simulated ride as a MOA stream for classifiers: an instance holds the features of a moment as {@code wbv states} sees it, and its
 * class is the true state of motion. Made row by row, so a ride of years needs no more memory than one of a minute.
 */
public class StateStream extends AbstractOptionHandler implements InstanceStream {

    private static final long serialVersionUID = 1;
    private static final String CHANNELS = " channels=seat.acc.z,head.acc.z,seat.gyr.x,seat.gyr.y";

    public final StringOption experimentOption = new StringOption("experiment", 'e',
            "The ride in words, such as 'subject=2 excitation=ride:4 seconds=120'.", "excitation=ride:1");
    public final IntOption seedOption = new IntOption("seed", 'r',
            "Seed of everything random; goes before a seed in the experiment unless it is 0.", 0, 0, Integer.MAX_VALUE);
    public final FloatOption jerkOption = new FloatOption("jerk", 'j', "Jerk beyond which a place jerks in a jolt [m/s³].",
            Thresholds.USUAL.jerk(), 1e-3, 1e9);

    private RigSpec spec;
    private Thresholds thresholds;
    private InstancesHeader header;
    /** What is being played; it does not serialise: a copy plays it itself, and goes on where the original stood. */
    private transient Played played;
    private long given;

    /** One play: the rows come {@link FeatureSpec#delay} before their features, so true states wait. */
    private static final class Played {
        private final RigRun run;
        private final FeatureStream features;
        private final double[] row = new double[5];
        private final double[] events;
        private final double[][] waiting;
        private long read;

        Played(RigSpec spec) {
            run = spec.run();
            FeatureSpec channels = FeatureSpec.of(spec.rate(), "seat", "head", spec.channels(), spec.toString());
            features = new FeatureStream(channels);
            events = new double[run.events().size()];
            if (events.length == 0) {
                throw new IllegalArgumentException("the experiment must be a ride, such as 'excitation=ride:4': " + spec);
            }
            waiting = new double[channels.delay() + 1][events.length];
        }

        /**
         * Reads until features come.
         *
         * @return what is true of them
         */
        double[] next(double[] into) {
            do {
                if (!run.read(row)) {
                    Arrays.fill(row, Double.NaN);
                } else {
                    run.events(events);
                }
                System.arraycopy(events, 0, waiting[(int) (read % waiting.length)], 0, events.length);
                features.step(Arrays.copyOfRange(row, 1, row.length), into);
                read++;
            } while (read < waiting.length);
            return waiting[(int) (read % waiting.length)];
        }
    }

    @Override
    public String getPurposeString() {
        return "Features of a simulated ride with the true states of motion as classes.";
    }

    @Override
    protected void prepareForUseImpl(TaskMonitor monitor, ObjectRepository repository) {
        spec = RigSpec.parse(experimentOption.getValue() + CHANNELS);
        if (seedOption.getValue() != 0) {
            spec = spec.withSeed(seedOption.getValue());
        }
        Thresholds usual = Thresholds.USUAL;
        thresholds = new Thresholds(jerkOption.getValue(), usual.surge(), usual.rocking(), usual.rest());
        List<Attribute> attributes = new ArrayList<>();
        FeatureSpec.NAMES.forEach(name -> attributes.add(new Attribute(name)));
        attributes.add(new Attribute("state", Arrays.stream(MotionState.values()).map(MotionState::toString).toList()));
        header = new InstancesHeader(new Instances(getCLICreationString(InstanceStream.class), attributes, 0));
        header.setClassIndex(attributes.size() - 1);
        restart();
    }

    @Override
    public InstancesHeader getHeader() {
        return header;
    }

    @Override
    public boolean hasMoreInstances() {
        return given < spec.rows();
    }

    @Override
    public Example<Instance> nextInstance() {
        double[] values = new double[FeatureSpec.NAMES.size() + 1];
        double[] row = new double[FeatureSpec.NAMES.size()];
        if (played == null) {
            played = new Played(spec);
            for (long i = 0; i < given; i++) {
                played.next(row);
            }
        }
        double[] truth = played.next(row);
        System.arraycopy(row, 0, values, 0, row.length);
        values[row.length] = TrueStates.state((int) truth[0], truth[1] > 0, truth[2], truth[3], thresholds).ordinal();
        Instance instance = new DenseInstance(1, values);
        instance.setDataset(header);
        given++;
        return new InstanceExample(instance);
    }

    @Override
    public long estimatedRemainingInstances() {
        return spec.rows() - given;
    }

    @Override
    public boolean isRestartable() {
        return true;
    }

    @Override
    public void restart() {
        played = new Played(spec);
        given = 0;
    }

    @Override
    public void getDescription(StringBuilder out, int indent) {
        out.append(getPurposeString());
    }
}
