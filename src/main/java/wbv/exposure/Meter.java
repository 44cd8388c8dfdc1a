package wbv.exposure;

import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/** A weighting and what comes of it: samples in, {@link Vibration} out. */
public final class Meter implements Snapshot {

    private final WeightedStatistics statistics;
    private final Weigher weigher;

    private Meter(Weigher weigher, WeightedStatistics statistics) {
        this.weigher = weigher;
        this.statistics = statistics;
    }

    /**
     * A meter for a stream: no delay beyond a second at the beginning, nothing allocated.
     *
     * @param rate [Hz] @see StreamWeigher
     */
    public static Meter stream(AnalogFilter filter, double rate, boolean boxcar) {
        int factor = StreamWeigher.factor(rate);
        WeightedStatistics statistics = new WeightedStatistics(rate * factor, factor, StreamWeigher.between(rate));
        return new Meter(new StreamWeigher(filter, rate, boxcar, statistics), statistics);
    }

    /** Another meter of a stream, that has heard nothing; the filters' coefficients, which it takes time to find, are shared. */
    public Meter fresh() {
        if (!(weigher instanceof StreamWeigher stream)) {
            throw new IllegalStateException("only the meter of a stream can begin anew");
        }
        WeightedStatistics other = statistics.fresh();
        return new Meter(stream.fresh(other), other);
    }

    /**
     * A meter for a recording whose mean is known.
     *
     * @param rate [Hz]
     * @param mean in the samples' unit @see ExactWeigher
     */
    public static Meter exact(AnalogFilter filter, double rate, double mean, boolean boxcar) {
        return exact(filter, rate, mean, boxcar, (value, running) -> {});
    }

    /** The same, with someone who looks on. */
    static Meter exact(AnalogFilter filter, double rate, double mean, boolean boxcar, Onlooker onlooker) {
        WeightedStatistics statistics = new WeightedStatistics(rate * ExactWeigher.factor(filter, rate));
        return new Meter(new ExactWeigher(filter, rate, mean, boxcar, value -> {
            statistics.accept(value);
            onlooker.see(value, statistics.runningLinear());
        }), statistics);
    }

    /** Sees every weighted value and the running r.m.s. that it makes. */
    interface Onlooker {
        void see(double weighted, double running);
    }

    /** Takes the next sample of what is measured, [m/s²], or [rad/s] of a rotation; NaN is missing. */
    public void accept(double value) {
        weigher.accept(value);
    }

    /** Ends the stream. Feed nothing afterwards. */
    public void finish() {
        weigher.finish();
    }

    /** What is known up to now. */
    public Vibration vibration() {
        return statistics.vibration();
    }

    /** Running r.m.s. of the last second, linear [m/s²]. */
    public double running() {
        return statistics.runningLinear();
    }

    @Override
    public void save(StateWriter out) {
        if (!(weigher instanceof StreamWeigher stream)) {
            throw new IllegalStateException("only the meter of a stream can be kept");
        }
        out.put(stream);
        out.put(statistics);
    }

    @Override
    public void load(StateReader in) {
        if (!(weigher instanceof StreamWeigher stream)) {
            throw new IllegalStateException("only the meter of a stream can be kept");
        }
        in.part(stream);
        in.part(statistics);
        stream.giveOwed();
    }
}
