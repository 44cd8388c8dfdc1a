package wbv.report;

import wbv.filter.BodyEstimator;
import wbv.filter.Spec;
import wbv.filter.Track;
import wbv.learn.AdwinAlarm;
import wbv.recording.Channel;
import wbv.signal.Envelope;

/** One output as an analysis follows it: its samples in outline, and the streaming estimate of the body between input and it. */
final class Response {

    private static final int MOST_POINTS = 2000;
    private static final int MOST_CUTS = 500;
    /** Probability of a false cut at one look, as the MOA learner has it by default. */
    private static final double DELTA = 0.002;

    private final Channel channel;
    private final double rate;
    private final Envelope samples = new Envelope(MOST_POINTS);
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

    Response(Channel channel, double rate, double startFrequency, double startDamping) {
        this.channel = channel;
        this.rate = rate;
        this.estimator = new BodyEstimator(Spec.at(rate).startingAt(startFrequency, startDamping), new AdwinAlarm(DELTA));
    }

    /** Takes a sample of input and output; NaN is missing. Returns the estimate after it. */
    Track accept(double u, double y) {
        samples.accept(y);
        Track track = estimator.step(u, y);
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

    Channel channel() {
        return channel;
    }

    Envelope samples() {
        return samples;
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
