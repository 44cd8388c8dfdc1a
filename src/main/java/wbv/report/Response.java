package wbv.report;

import java.util.Locale;
import java.util.Optional;
import wbv.filter.BodyEstimator;
import wbv.filter.Spec;
import wbv.filter.Track;
import wbv.learn.AdwinAlarm;
import wbv.recording.Channel;
import wbv.signal.Envelope;

/** One output as an analysis follows it: the streaming estimate of the body between input and it. */
final class Response {

    private static final int MOST_POINTS = 2000;
    private static final int MOST_CUTS = 500;
    /** Probability of a false cut at one look, as the MOA learner has it by default. */
    private static final double DELTA = 0.002;

    private final Channel channel;
    private final double rate;
    private final Envelope frequency = new Envelope(MOST_POINTS);
    private final Envelope frequencyDeviation = new Envelope(MOST_POINTS);
    private final Envelope damping = new Envelope(MOST_POINTS);
    private final Envelope dampingDeviation = new Envelope(MOST_POINTS);
    private final BodyEstimator estimator;
    private final double[] cuts = new double[MOST_CUTS];
    private int cutCount;
    private long count;
    private double nisSum;
    private long nisCount;

    /**
     * What was known of the body at one moment.
     *
     * @param time from the first sample [s] @param frequency natural frequency [Hz] @param frequencyDeviation its standard deviation
     * @param damping damping ratio @param dampingDeviation its standard deviation
     */
    record Estimate(double time, double frequency, double frequencyDeviation, double damping, double dampingDeviation) { }

    private final boolean followed;
    private boolean moves;
    private Optional<Estimate> known = Optional.empty();

    /** @param followed whether input and output are accelerations, which is what the estimator follows */
    Response(Channel channel, double rate, double startFrequency, double startDamping, boolean followed) {
        this.channel = channel;
        this.rate = rate;
        this.followed = followed;
        this.estimator = new BodyEstimator(Spec.at(rate).startingAt(startFrequency, startDamping), new AdwinAlarm(DELTA));
    }

    /** Takes a sample of input and output; NaN is missing. Returns the estimate after it. */
    Track accept(double u, double y) {
        moves |= y != 0 && !Double.isNaN(y);
        Track track = followed ? estimator.step(u, y) : estimator.track();
        // Kept about once a second: what was known last counts where the estimate is lost later.
        if (track.found() && (count % (long) Math.max(1, rate) == 0)) {
            known = Optional.of(estimate(track));
        }
        frequency.accept(track.frequency());
        frequencyDeviation.accept(track.frequencyDeviation());
        damping.accept(track.damping());
        dampingDeviation.accept(track.dampingDeviation());
        if (track.cut() && cutCount < MOST_CUTS) {
            cuts[cutCount++] = count / rate;
        }
        if (!Double.isNaN(track.nis())) {
            nisSum += track.nis();
            nisCount++;
        }
        count++;
        return track;
    }

    private Estimate estimate(Track track) {
        return new Estimate(count / rate, track.frequency(), track.frequencyDeviation(), track.damping(), track.dampingDeviation());
    }

    /** The estimate after the last sample, or the last one before it was lost; empty if there never was one. */
    Optional<Estimate> known() {
        return estimator.track().found() ? Optional.of(estimate(estimator.track())) : known;
    }

    /** Why nothing is known after the last sample; empty if something is. */
    String lost() {
        Track track = estimator.track();
        if (track.found()) {
            return "";
        }
        if (!followed) {
            return "the estimator follows accelerations, from acceleration";
        }
        String why = !moves ? "nothing moves" : track.divergences() > 0 ? "the input does not explain its motion as that of one degree of freedom (diverged "
                + track.divergences() + (track.divergences() == 1 ? " time)" : " times)") : "too little motion, or too short";
        return known.map(last -> String.format(Locale.ROOT, "as known at %.0f s, lost since: ", last.time()) + why).orElse(why);
    }

    Channel channel() {
        return channel;
    }

    Envelope frequency() {
        return frequency;
    }

    Envelope frequencyDeviation() {
        return frequencyDeviation;
    }

    Envelope damping() {
        return damping;
    }

    Envelope dampingDeviation() {
        return dampingDeviation;
    }

    BodyEstimator estimator() {
        return estimator;
    }

    /** Times of the alarm's cuts from the first sample [s], at most the first 500. */
    double[] cuts() {
        return java.util.Arrays.copyOf(cuts, cutCount);
    }

    double meanNis() {
        return nisSum / nisCount;
    }
}
