package wbv.diagnosis.learn;

import java.util.Arrays;
import java.util.stream.IntStream;
import wbv.body.law.Law;
import wbv.diagnosis.fit.Motion;
import wbv.recording.Clock;

/** What the force of a law depends on, found by asking it: deflection alone, velocity alone, time. */
public final class LawShape {

    private static final int CURVE = 241;
    private static final double RARE = 0.001;

    private final Law law;
    private final double stiffness;
    private final double damping;
    private final double[] r;
    private final double[] v;
    private final double rate;
    private final int samples;

    /** What a force is drawn over. */
    public enum Side { DEFLECTION, VELOCITY }

    /**
     * Asks a law about the motion that it was found in.
     *
     * @param stiffness of the link [N/m]
     * @param damping of the link [N s/m]
     * @param r deflections that occurred, by sample [m]. Not modified.
     * @param v velocities that occurred, by sample [m/s]. Not modified.
     * @param samples of the record
     */
    public LawShape(Law law, double stiffness, double damping, double[] r, double[] v, Clock clock, int samples) {
        this.law = law;
        this.stiffness = stiffness;
        this.damping = damping;
        this.r = r;
        this.v = v;
        this.rate = clock.rate();
        this.samples = samples;
    }

    /** Whether a law without memory gives another force at another time of the same motion; false of one with memory. */
    public boolean dependsOnTime() {
        double[] all = series(repeated(CURVE, most(r)), repeated(CURVE, 0.3 * most(v)), samples / rate / CURVE);
        double least = Arrays.stream(all, 1, CURVE).min().orElse(0);
        double largest = Arrays.stream(all, 1, CURVE).max().orElse(0);
        return !law.hasMemory() && largest - least > 1e-6 * (Math.abs(largest) + Math.abs(least));
    }

    /** Whether a law without memory goes by one side alone; false of one with memory. */
    public boolean dependsOnly(Side side) {
        double[] ramp = ramp(side);
        double[] still = forced(side, ramp, repeated(CURVE, 0));
        double[] moving = forced(side, ramp, repeated(CURVE, most(side == Side.DEFLECTION ? v : r)));
        return !law.hasMemory()
                && IntStream.range(1, CURVE).allMatch(i -> Math.abs(still[i] - moving[i]) <= 1e-9 * (1 + Math.abs(still[i])));
    }

    /** Two series: deflection or velocity, and the force there [N]. */
    public double[][] curve(Side side) {
        double[] ramp = ramp(side);
        double[] out = forced(side, ramp, repeated(CURVE, 0));
        return new double[][] {Arrays.copyOfRange(ramp, 1, CURVE), Arrays.copyOfRange(out, 1, CURVE)};
    }

    /** Three series: time [s], stiffness [N/m] and damping [N s/m] of link and law together. */
    public double[][] overTime() {
        double step = 1 / rate;
        double[] k = law.series(repeated(samples, 1), repeated(samples, 0), stiffness, damping, step, new double[0]);
        double[] c = law.series(repeated(samples, 0), repeated(samples, 1), stiffness, damping, step, new double[0]);
        int every = Math.max(1, samples / 1000);
        int[] shown = IntStream.range(1, samples).filter(i -> i % every == 0).toArray();
        return new double[][] {IntStream.of(shown).mapToDouble(i -> i * step).toArray(),
            IntStream.of(shown).mapToDouble(i -> stiffness + k[i]).toArray(),
            IntStream.of(shown).mapToDouble(i -> damping + c[i]).toArray()};
    }

    /** As far as all but the rarest samples reached, denser about zero, where laws bend. */
    private double[] ramp(Side side) {
        double[] x = side == Side.DEFLECTION ? r : v;
        double[] sorted = Motion.sorted(x, x.length);
        double low = Motion.quantile(sorted, RARE);
        double high = Motion.quantile(sorted, 1 - RARE);
        return IntStream.range(0, CURVE).mapToDouble(i -> 2.0 * i / (CURVE - 1) - 1)
                .map(u -> u < 0 ? low * u * u : high * u * u).toArray();
    }

    private double[] forced(Side side, double[] along, double[] other) {
        return side == Side.DEFLECTION ? series(along, other, 1e-3) : series(other, along, 1e-3);
    }

    private double[] series(double[] displacement, double[] velocity, double step) {
        return law.series(displacement, velocity, stiffness, damping, step, new double[0]);
    }

    private static double most(double[] x) {
        return Arrays.stream(x).map(Math::abs).max().orElse(1);
    }

    private static double[] repeated(int n, double value) {
        double[] out = new double[n];
        Arrays.fill(out, value);
        return out;
    }
}
