package wbv.learn;

import com.github.javacliparser.FileOption;
import com.github.javacliparser.FloatOption;
import com.github.javacliparser.IntOption;
import com.github.javacliparser.MultiChoiceOption;
import com.github.javacliparser.StringOption;
import com.yahoo.labs.samoa.instances.Instance;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import moa.classifiers.AbstractClassifier;
import moa.classifiers.Regressor;
import moa.classifiers.SemiSupervisedLearner;
import moa.core.Measurement;
import moa.core.StringUtils;
import wbv.pole.Chord;
import wbv.pole.Layout;
import wbv.pole.OnlineRemoval;
import wbv.pole.PoleWindows;
import wbv.pole.PolygonFile;
import wbv.pole.TrainedPoles;
import wbv.recording.Channel;

/**
 * Predicts a place as if it had no sensor, from a base and a place that stays measured: ARMAX windows, their poles, polygons, and
 * the estimator within them. The class attribute is the place's acceleration; as long as it is there polygons are learned from
 * it, and no prediction uses it otherwise. Attributes are named as channels. With {@code -p} it follows polygons of
 * {@code wbv poles} and learns nothing. Semi-supervised to MOA, which else keeps instances without a class away from a learner.
 */
public class SensorRemover extends AbstractClassifier implements Regressor, SemiSupervisedLearner {

    private static final long serialVersionUID = 1;
    private static final String TIME = "t";
    private static final double USUAL_RATE = 60;
    /** Missing samples past this many tell nothing more [s]. */
    private static final double LONGEST_FILL = 60;

    public final StringOption measuredOption = new StringOption("measured", 'm', "Channel of the place that stays measured.", "seat.acc.z");
    public final FileOption polygonsOption = new FileOption("polygons", 'p', "polygons.json of 'wbv poles', to follow instead of "
            + "learning.", null, "json", false);
    public final MultiChoiceOption predictOption = new MultiChoiceOption("predict", 'g', "What predicts the motion.",
            new String[] {"body", "response"}, new String[] {"the body of one mode that the polygons bound, moved by the base alone",
                "the response to all inputs, tuned by the pole measured"},
            0);
    public final FloatOption windowOption = new FloatOption("window", 'w', "Length of a window [s].", PoleWindows.USUAL.length(), 10, 600);
    public final FloatOption hopOption = new FloatOption("hop", 'h', "Time from one window to the next [s].", PoleWindows.USUAL.hop(), 0.1,
            600);
    public final IntOption keptOption = new IntOption("kept", 'k', "Newest windows that polygons are drawn around.", 120, 12, 100000);
    public final IntOption betweenOption = new IntOption("between", 'b', "Windows from one training to the next.", 12, 1, 100000);

    private SampleTiming timing = new SampleTiming(USUAL_RATE);
    private final List<OnlineRemoval> chain = new ArrayList<>();
    private int time = -1;
    private int measured = -1;
    private int[] inputs = new int[0];
    private double[] u = new double[0];
    private double[] before = new double[0];
    private double measuredBefore;
    private double classBefore;
    private long lost;

    @Override
    public String getPurposeString() {
        return "Predicts a place without its sensor from the poles of a place with one: windows, poles, polygons, bounded body.";
    }

    @Override
    public void resetLearningImpl() {
        timing = new SampleTiming(USUAL_RATE);
        chain.clear();
        inputs = new int[0];
        lost = 0;
    }

    private OnlineRemoval chain(Instance instance) {
        if (chain.isEmpty()) {
            chain.add(locate(instance, USUAL_RATE));
        }
        return chain.get(0);
    }

    private OnlineRemoval locate(Instance instance, double rate) {
        time = -1;
        List<Channel> channels = new ArrayList<>();
        List<Integer> at = new ArrayList<>();
        for (int i = 0; i < instance.numAttributes(); i++) {
            String name = instance.attribute(i).name();
            if (name.equals(TIME)) {
                time = i;
            } else {
                channels.add(channel(name));
                at.add(i);
            }
        }
        Channel absent = channel(instance.attribute(instance.classIndex()).name());
        OnlineRemoval made;
        if (polygonsOption.getValue() == null || polygonsOption.getValue().isEmpty()) {
            Channel stays = channel(measuredOption.getValue());
            List<Channel> moving = new ArrayList<>(channels);
            moving.remove(absent);
            moving.remove(stays);
            // The base's motion along the axis of the absent place leads.
            Channel base = moving.stream().filter(each -> each.axis() == absent.axis() && each.quantity() == absent.quantity()).findFirst()
                    .orElseThrow(() -> new IllegalArgumentException(
                            "no attribute besides " + stays + " moves " + absent + "; there are " + channels));
            moving.remove(base);
            moving.add(0, base);
            made = new OnlineRemoval(new Layout(moving, stays, List.of(absent)), new PoleWindows(windowOption.getValue(),
                    hopOption.getValue(), PoleWindows.USUAL.poles()), rate, keptOption.getValue(), betweenOption.getValue());
        } else {
            try {
                TrainedPoles all = PolygonFile.read(Path.of(polygonsOption.getValue()));
                made = new OnlineRemoval(all.forOnly(absent), rate);
            } catch (IOException failed) {
                throw new UncheckedIOException(failed);
            }
        }
        List<Channel> wanted = made.layout().inputs();
        inputs = wanted.stream().mapToInt(each -> place(each, channels, at)).toArray();
        measured = place(made.layout().measured(), channels, at);
        u = new double[inputs.length];
        before = new double[inputs.length];
        return made;
    }

    private static Channel channel(String name) {
        try {
            return Channel.parse(name);
        } catch (IllegalArgumentException wrong) {
            throw new IllegalArgumentException("attributes are t and channels such as platform.acc.z, not '" + name + "'", wrong);
        }
    }

    private static int place(Channel channel, List<Channel> channels, List<Integer> at) {
        int index = channels.indexOf(channel);
        if (index < 0) {
            throw new IllegalArgumentException("no attribute " + channel + "; there are " + channels);
        }
        return at.get(index);
    }

    private void read(Instance instance) {
        for (int i = 0; i < inputs.length; i++) {
            u[i] = instance.value(inputs[i]);
        }
    }

    @Override
    public void trainOnInstanceImpl(Instance instance) {
        OnlineRemoval now = chain(instance);
        double t = time < 0 ? Double.NaN : instance.value(time);
        if (timing.learnsRate(t)) {
            chain.set(0, locate(instance, timing.rate()));
            now = chain.get(0);
            now.step(before, measuredBefore, classBefore);
        }
        long missing = Math.min(timing.missingBefore(t), (long) (LONGEST_FILL * timing.rate()));
        for (long i = 0; i < missing; i++) {
            java.util.Arrays.fill(u, Double.NaN);
            now.step(u, Double.NaN, Double.NaN);
            lost++;
        }
        read(instance);
        double stays = instance.value(measured);
        double absent = instance.classIsMissing() ? Double.NaN : instance.classValue();
        now.step(u, stays, absent);
        System.arraycopy(u, 0, before, 0, u.length);
        measuredBefore = stays;
        classBefore = absent;
    }

    /** The place's motion as foreseen from this instance's inputs and everything before it. */
    @Override
    public double[] getVotesForInstance(Instance instance) {
        OnlineRemoval now = chain(instance);
        read(instance);
        return new double[] {now.foresee(u, predictOption.getChosenIndex() == 0)};
    }

    @Override
    protected Measurement[] getModelMeasurementsImpl() {
        boolean known = !chain.isEmpty() && chain.get(0).trained();
        List<Chord> bounds = known ? chain.get(0).bounds() : List.of();
        return new Measurement[] {
            new Measurement("windows learned", chain.isEmpty() ? 0 : chain.get(0).windows()),
            new Measurement("trainings", chain.isEmpty() ? 0 : chain.get(0).trainings()),
            new Measurement("pole frequency [Hz]", known ? chain.get(0).poleFrequency() : Double.NaN),
            new Measurement("pole damping ratio [1]", known ? chain.get(0).poleDamping() : Double.NaN),
            new Measurement("natural frequency [Hz]", known ? chain.get(0).bodyFrequency() : Double.NaN),
            new Measurement("natural frequency from [Hz]", known ? bounds.get(0).lower() : Double.NaN),
            new Measurement("natural frequency to [Hz]", known ? bounds.get(0).upper() : Double.NaN),
            new Measurement("damping ratio [1]", known ? chain.get(0).bodyDamping() : Double.NaN),
            new Measurement("damping ratio from [1]", known ? bounds.get(1).lower() : Double.NaN),
            new Measurement("damping ratio to [1]", known ? bounds.get(1).upper() : Double.NaN),
            new Measurement("windows lost", known ? chain.get(0).lost() : 0),
            new Measurement("lost samples", lost),
        };
    }

    @Override
    public void getModelDescription(StringBuilder out, int indent) {
        StringUtils.appendIndented(out, indent, chain.isEmpty() || !chain.get(0).trained() ? "no polygons yet" : String.format(Locale.ROOT,
                "%d windows learned; a pole of %.2f Hz at the measured place says %.2f Hz, damping ratio %.3f of the absent one",
                chain.get(0).windows(), chain.get(0).poleFrequency(), chain.get(0).bodyFrequency(), chain.get(0).bodyDamping()));
    }

    @Override
    public boolean isRandomizable() {
        return false;
    }
}
