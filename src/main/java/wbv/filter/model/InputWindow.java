package wbv.filter.model;

import java.io.Serializable;
import java.util.Arrays;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * The latest input samples, as polynomials between samples. A sample that is missing counts as zero with the variance that
 * the input has.
 */
public final class InputWindow implements Serializable, Snapshot {

    private static final long serialVersionUID = 1;
    /** Samples that the input between two samples is read from. */
    public static final int POINTS = 8;
    /** Samples after an interval that its polynomial needs: how far behind the present the filter corrects. */
    public static final int LATENCY = 3;

    /** By samples known after the interval: 0 joins them by a straight line, LATENCY has all. */
    private static final Interpolant[] BY_LOOK_AHEAD = {
        new Interpolant(1), new Interpolant(2), new Interpolant(3), new Interpolant(4)};

    private final double forgetting;
    private final double[] samples = new double[POINTS];
    private final boolean[] missing = new boolean[POINTS];
    private final double[] ahead = new double[POINTS];
    /** Of the first interval after what is known, which the next sample asks for again if it is what was looked ahead to. */
    private final double[] foreseen = new double[POINTS];
    private boolean foresaw;
    private boolean cameTrue;
    private double power;

    /**
     * At rest.
     *
     * @param spec rate and adaptation
     */
    public InputWindow(Spec spec) {
        this.forgetting = 1 / (spec.adaptation().information().inputMemory() * spec.rate());
    }

    /** As new. */
    public void reset() {
        restart();
        power = 0;
    }

    /** Starts again from rest; what the input's power was stays known. */
    public void restart() {
        Arrays.fill(samples, 0);
        Arrays.fill(missing, false);
        foresaw = false;
        cameTrue = false;
    }

    /**
     * Takes a sample.
     *
     * @param u [m/s² or rad/s]
     * @param present whether it was measured; 0 stands for it where not
     */
    public void push(double u, boolean present) {
        System.arraycopy(samples, 1, samples, 0, POINTS - 1);
        System.arraycopy(missing, 1, missing, 0, POINTS - 1);
        samples[POINTS - 1] = present ? u : 0;
        missing[POINTS - 1] = !present;
        cameTrue = foresaw && samples[POINTS - 1] == ahead[POINTS - 1];
        foresaw = false;
        if (present) {
            power += forgetting * (u * u - power);
        }
    }

    /**
     * Coefficients of the input over the interval that ends LATENCY samples ago.
     *
     * @param c POINTS long, in the input's unit. Modified.
     */
    public void coefficients(double[] c) {
        if (cameTrue) {
            System.arraycopy(foreseen, 0, c, 0, POINTS);
            return;
        }
        BY_LOOK_AHEAD[LATENCY].coefficients(samples, 0, c);
    }

    /** Asks for coefficients of later intervals, if the next sample were u [m/s² or rad/s]. */
    public void lookAhead(double u) {
        System.arraycopy(samples, 1, ahead, 0, POINTS - 1);
        ahead[POINTS - 1] = u;
        foresaw = false;
    }

    /**
     * Coefficients over a later interval, after {@link #lookAhead(double)}.
     *
     * @param known samples after the interval, 0 to LATENCY
     * @param c     POINTS long, in the input's unit. Modified.
     * @return how many of them there are; the others are zero, and are not written
     */
    public int coefficientsBefore(int known, double[] c) {
        Interpolant interpolant = BY_LOOK_AHEAD[known];
        interpolant.coefficients(ahead, 2 * (LATENCY - known), c);
        if (known == LATENCY) {
            System.arraycopy(c, 0, foreseen, 0, POINTS);
            foresaw = true;
        }
        return interpolant.points();
    }

    /** Whether the interval that ends LATENCY samples ago rests on a missing sample. */
    public boolean gapped() {
        for (boolean m : missing) {
            if (m) {
                return true;
            }
        }
        return false;
    }

    /** Variance [m²/s⁴] that missing samples at the ends of the interval add to the input's. */
    public double varianceOfMissing() {
        return missing[POINTS / 2 - 1] || missing[POINTS / 2] ? power : 0;
    }

    @Override
    public void save(StateWriter out) {
        out.put(samples);
        out.put(missing);
        out.put(power);
    }

    @Override
    public void load(StateReader in) {
        in.numbers(samples);
        in.flags(missing);
        power = in.number();
        foresaw = false;
        cameTrue = false;
    }
}
