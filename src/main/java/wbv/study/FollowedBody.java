package wbv.study;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import wbv.filter.AccompaniedEstimator;
import wbv.filter.BodyEstimate;
import wbv.filter.Estimator;
import wbv.filter.EstimatorDesign;
import wbv.filter.Method;
import wbv.filter.drift.Alarm;
import wbv.filter.drift.ChangeTest;
import wbv.filter.model.Spec;
import wbv.identify.EquivalentBody;
import wbv.learn.AdwinAlarm;
import wbv.recording.Channel;
import wbv.result.Digits;
import wbv.signal.Envelope;

/**
 * The body between the base and one output as one estimator follows it: its track in outline, what was last known of it, and how
 * well it foresaw the output.
 */
public final class FollowedBody {

    private static final int MOST_POINTS = 2000;
    private static final int MOST_CHANGES = 500;
    private static final int MOST_CUTS = 500;
    /** Probability of a false cut at one look, as the MOA learner has it by default. */
    private static final double DELTA = 0.002;
    /** Predictions count from then on [s]: before, the body is not known. */
    private static final double WARM_UP = 10;
    /** Output and input move as one if their difference is no larger than the prediction's error, or hardly. */
    private static final double AS_ONE = 1.1;

    /** Frequency, its deviation, damping, its deviation, of a mode. */
    public record Outline(Envelope frequency, Envelope frequencyDeviation, Envelope damping, Envelope dampingDeviation) {

        static Outline empty() {
            return new Outline(new Envelope(MOST_POINTS), new Envelope(MOST_POINTS), new Envelope(MOST_POINTS),
                    new Envelope(MOST_POINTS));
        }
    }

    /**
     * What was known of the body at one moment.
     *
     * @param time from the first sample [s]
     * @param frequency natural frequency [Hz]
     * @param frequencyDeviation its standard deviation [Hz]
     * @param damping damping ratio
     * @param dampingDeviation standard deviation of that ratio
     */
    public record Estimate(double time, double frequency, double frequencyDeviation, double damping, double dampingDeviation) {}

    private final Channel channel;
    private final EstimatorDesign design;
    private final boolean follows;
    private final AccompaniedEstimator estimator;
    private final List<Outline> outlines = new ArrayList<>();
    private final Envelope residual = new Envelope(MOST_POINTS);
    private final double[] changes = new double[MOST_CHANGES];
    private final ChangeTest[] heard = new ChangeTest[MOST_CHANGES];
    private int changeCount;
    private long samples;
    private long scored;
    private long excited;
    private double errors;
    private double sum;
    private double squares;
    private final Variance apart = new Variance();
    private double nisSum;
    private long nisCount;
    private final double[] cuts = new double[MOST_CUTS];
    private int cutCount;
    private boolean moves;
    private Optional<Estimate> known = Optional.empty();

    private FollowedBody(Channel channel, EstimatorDesign design, boolean follows, Spec spec, Supplier<? extends Alarm> alarms,
            int others) {
        this.channel = channel;
        this.design = design;
        this.follows = follows;
        this.estimator = new AccompaniedEstimator(design.estimator(spec, alarms), others);
        for (int m = 0; m < design.degrees(); m++) {
            outlines.add(Outline.empty());
        }
    }

    /**
     * @param alarms makes an alarm for each filter
     * @param others number of motions of the base beside the input
     */
    FollowedBody(Channel channel, EstimatorDesign design, Spec spec, Supplier<Alarm> alarms, int others) {
        this(channel, design, true, spec, alarms, others);
    }

    /**
     * By the usual estimator.
     *
     * @param follows whether input and output are accelerations, which is what it follows
     */
    static FollowedBody usual(Channel channel, Spec spec, boolean follows) {
        return new FollowedBody(channel, EstimatorDesign.of(Method.EKF_ADWIN), follows, spec, () -> new AdwinAlarm(DELTA), 0);
    }

    /**
     * Takes a sample; NaN is missing. Returns the track after it.
     *
     * @param others of the base's other motions. Not modified.
     */
    BodyEstimate accept(double u, double[] others, double y) {
        moves |= y != 0 && !Double.isNaN(y);
        BodyEstimate track = follows ? estimator.step(u, others, y) : track();
        // Kept about once a second: what was known last counts where the estimate is lost later.
        if (track.found() && samples % (long) Math.max(1, rate()) == 0) {
            known = Optional.of(estimate(track));
        }
        for (int m = 0; m < outlines.size(); m++) {
            Outline outline = outlines.get(m);
            outline.frequency.accept(track.frequency(m));
            outline.frequencyDeviation.accept(track.frequencyDeviation(m));
            outline.damping.accept(track.damping(m));
            outline.dampingDeviation.accept(track.dampingDeviation(m));
        }
        double error = y - track.prediction();
        residual.accept(error);
        double time = samples++ / rate();
        if (track.cut() && cutCount < MOST_CUTS) {
            cuts[cutCount++] = time;
        }
        if (track.changed() && changeCount < MOST_CHANGES) {
            heard[changeCount] = track.heardBy();
            changes[changeCount++] = time;
        }
        excited += track.excited() ? 1 : 0;
        if (Double.isFinite(track.nis())) {
            nisSum += track.nis();
            nisCount++;
        }
        if (time >= WARM_UP && Double.isFinite(error)) {
            scored++;
            errors += error * error;
            sum += y;
            squares += y * y;
            if (Double.isFinite(u)) {
                apart.add(y - u);
            }
        }
        return track;
    }

    private double rate() {
        return estimator().spec().rate();
    }

    private Estimate estimate(BodyEstimate track) {
        return new Estimate(samples / rate(), track.frequency(), track.frequencyDeviation(), track.damping(), track.dampingDeviation());
    }

    /** The estimate after the last sample, or the last one before it was lost; empty if there never was one. */
    Optional<Estimate> known() {
        return track().found() ? Optional.of(estimate(track())) : known;
    }

    /** Why nothing is known after the last sample; empty if something is. */
    String lost() {
        BodyEstimate track = track();
        if (track.found()) {
            return "";
        }
        if (!follows) {
            return "the estimator follows accelerations, from acceleration";
        }
        String why = !moves
                ? "nothing moves" : track.divergences() > 0
                        ? "the input does not explain its motion as that of one degree of freedom (diverged "
                                + track.divergences() + (track.divergences() == 1 ? " time)" : " times)")
                        : "too little motion, or too short";
        return known.map(last -> String.format(Locale.ROOT, "as known at %.0f s, lost since: ", last.time()) + why).orElse(why);
    }

    /** Times of the alarm's cuts from the first sample [s], as many as there are, at most the first 500. */
    public double[] cuts() {
        return Arrays.copyOf(cuts, cutCount);
    }

    /** The output. */
    public Channel channel() {
        return channel;
    }

    /** Of the estimator. */
    public EstimatorDesign design() {
        return design;
    }

    Estimator estimator() {
        return estimator.estimator();
    }

    /** Modulus [1] of the response of the body as known after the last sample, at a frequency [Hz]. */
    public double modulus(double frequency) {
        return estimator().modulus(frequency);
    }

    /** What is known after the last sample. One object: each sample changes it. */
    public BodyEstimate track() {
        return estimator().track();
    }

    /** Frequency and damping over time, one for each mode. */
    public List<Outline> outlines() {
        return outlines;
    }

    /** Output less prediction. */
    public Envelope residual() {
        return residual;
    }

    /** Name of estimator and output together, as columns have it. */
    public String name() {
        return channel + "." + design.method().word();
    }

    /** Times of changes from the first sample [s], as many as there are, at most the first 500. */
    public double[] changes() {
        return Arrays.copyOf(changes, changeCount);
    }

    /** The tests that heard each of these changes, by their words. */
    List<String> heardBy() {
        return Arrays.stream(heard, 0, changeCount).map(ChangeTest::word).toList();
    }

    /** How many changes, and by which tests they were heard; empty if there was none. */
    private String changesLine() {
        if (changeCount == 0) {
            return "";
        }
        String tests = Arrays.stream(ChangeTest.values()).filter(test -> count(test) > 0).map(test -> count(test) + " by " + test.word())
                .collect(Collectors.joining(", "));
        return "; " + track().changes() + (track().changes() == 1 ? " change" : " changes") + " heard, " + tests;
    }

    private long count(ChangeTest test) {
        return Arrays.stream(heard, 0, changeCount).filter(test::equals).count();
    }

    /** Mean square of output less prediction, in the output's unit squared, from ten seconds on; NaN if there is none. */
    public double meanSquareError() {
        return errors / scored;
    }

    /** The same over the output's variance [1]. */
    public double relativeError() {
        double mean = sum / scored;
        return meanSquareError() / (squares / scored - mean * mean);
    }

    /** Mean of the normalised innovations squared [1]; 1 where the noise is as believed, NaN where none was counted. */
    public double meanNis() {
        return nisSum / nisCount;
    }

    /** Share of the samples that told about the parameters. */
    double excited() {
        return samples == 0 ? 0 : excited / (double) samples;
    }

    /** What is known after the last sample and how well it foresaw the output, or why nothing stands; one line. */
    public String line() {
        BodyEstimate track = track();
        String foresees = Double.isNaN(relativeError()) ? "" : "; foresees " + PathBody.percent(Math.max(0, 1 - relativeError()));
        if (!stands()) {
            return "no natural frequency: " + caution() + foresees;
        }
        List<String> modes = new ArrayList<>();
        for (int m = 0; m < track.modes(); m++) {
            if (!mode(m).oscillates() || !mode(m).determined()) {
                continue;
            }
            modes.add(PathBody.within(track.frequency(m), 2 * track.frequencyDeviation(m), 2) + " Hz, ζ "
                    + PathBody.within(track.damping(m), 2 * track.dampingDeviation(m), 3));
        }
        return String.join("; ", modes) + foresees + changesLine() + (caution().isEmpty() ? "" : " (" + caution() + ")");
    }

    /** Whether the numbers may be printed: a mode swings and is determined, and the body foresees at least half of the output. */
    public boolean stands() {
        return track().found() && carries() && IntStream.range(0, track().modes()).mapToObj(this::mode)
                .anyMatch(mode -> mode.oscillates() && mode.determined());
    }

    private boolean carries() {
        return relativeError() <= 1 - EquivalentBody.LEAST_SHARE;
    }

    private EquivalentBody.Mode mode(int m) {
        BodyEstimate track = track();
        return new EquivalentBody.Mode(track.frequency(m), track.frequencyDeviation(m), track.damping(m), track.dampingDeviation(m));
    }

    /** What the reader must know about this track; empty if nothing. */
    public String caution() {
        BodyEstimate track = track();
        if (excited == 0) {
            return "nothing excited the body: the parameters are those it started with";
        }
        if (!track.found() && apart.value() < AS_ONE * meanSquareError()) {
            return "moves as one with its base: a body, if there is one, is too stiff to be seen in this motion";
        }
        if (!track.found()) {
            return "no body found" + (track.divergences() > 0 ? ", diverged " + track.divergences() + " times" : "");
        }
        if (!carries()) {
            return "its motion is for the most part something else's";
        }
        if (!stands()) {
            return track.damping() < 1 ? "the last samples do not determine it"
                    : String.format(Locale.ROOT, "follows its base without a resonance of its own (damping ratio %.2f)", track.damping());
        }
        return excited() < 0.1 ? "excited for " + Digits.significant(100 * excited(), 2) + " % of the time only" : "";
    }
}
