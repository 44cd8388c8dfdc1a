package wbv.pole;

import java.io.Serializable;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import wbv.identify.ArmaxFit;
import wbv.identify.Orders;
import wbv.identify.Pole;
import wbv.identify.PredictionError;
import wbv.identify.Samples;
import wbv.recording.DataFault;
import wbv.signal.GapBridge;

/**
 * Windows of a recording and what ARMAX says of each: the poles between a base and a place.
 *
 * @param length of a window [s], &gt; 0
 * @param hop    from one window to the next [s], &gt; 0
 * @param poles  order of A, of C, and of every numerator, &gt;= 2
 */
public record PoleWindows(double length, double hop, int poles) implements Serializable {

    /** Half a minute, every five seconds, two modes: long for the softest mode, short for a sitter who changes. */
    public static final PoleWindows USUAL = new PoleWindows(25, 5, 4);

    /** Natural frequencies [Hz] and damping ratios that a seated body's poles have; what lies outside fits noise. */
    static final double LEAST_FREQUENCY = 0.7;
    static final double MOST_FREQUENCY = 20;
    static final double MOST_DAMPING = 0.95;
    private static final int LONGEST_GAP = 5;
    private static final int MOST_POLES = 20;

    /** An hour [s]: over longer windows no sitter stays the same. */
    private static final double LONGEST = 3600;

    public PoleWindows {
        if (!(length > 0 && length <= LONGEST && hop > 0 && hop <= LONGEST) || poles < 2 || poles > MOST_POLES) {
            throw new IllegalArgumentException(
                    "window and hop must be > 0 to " + LONGEST + " s and poles 2 to " + MOST_POLES + ": " + length
                            + ", " + hop + ", " + poles);
        }
    }

    /** Samples from one window to the next. */
    int hopSamples(double rate) {
        return Math.max(1, (int) Math.round(hop * rate));
    }

    Orders orders() {
        return Orders.body(poles);
    }

    /**
     * Samples of a window.
     *
     * @param name   of the recording, for messages
     * @param inputs that move the body
     * @throws DataFault if a window has too few for its poles
     */
    int samples(String name, double rate, int inputs) {
        double samples = Math.rint(length * rate);
        int fewest = new PredictionError(orders()).fewest(inputs);
        if (samples < fewest) {
            throw DataFault.in(name, String.format(Locale.ROOT, "a window of %.4g s has %.0f samples at %.4g Hz; %d poles need %d",
                    length, samples, rate, poles, fewest));
        }
        return (int) samples;
    }

    /**
     * Modes of a stretch of samples; empty if a sample is missing.
     *
     * @param u inputs. Not modified.
     * @param y output. Not modified.
     */
    Optional<List<Pole>> window(double[][] u, double[] y, int from, int samples, double rate) {
        double[][] inputs = new double[u.length][];
        for (int i = 0; i < u.length; i++) {
            inputs[i] = centred(u[i], from, samples);
        }
        double[] output = centred(y, from, samples);
        boolean whole = finite(output);
        for (double[] input : inputs) {
            whole &= finite(input);
        }
        if (!whole) {
            return Optional.empty();
        }
        ArmaxFit fit = new PredictionError(orders()).fit(new Samples(rate, inputs, output));
        return Optional.of(fit.model().poles().modes().stream().filter(PoleWindows::plausible).toList());
    }

    static boolean plausible(Pole pole) {
        return plausible(pole.frequency(), pole.damping());
    }

    static boolean plausible(double frequency, double damping) {
        return frequency >= LEAST_FREQUENCY && frequency <= MOST_FREQUENCY && damping <= MOST_DAMPING;
    }

    static double[] centred(double[] values, int from, int samples) {
        double[] cut = Arrays.copyOfRange(values, from, from + samples);
        double mean = Arrays.stream(cut).average().orElse(0);
        for (int i = 0; i < cut.length; i++) {
            cut[i] -= mean;
        }
        return cut;
    }

    private static boolean finite(double[] values) {
        for (double value : values) {
            if (!Double.isFinite(value)) {
                return false;
            }
        }
        return true;
    }

    /** Short gaps filled in, and 0 where samples are missing for longer. */
    static double[] quiet(double[] values) {
        double[] out = bridged(values);
        for (int i = 0; i < out.length; i++) {
            out[i] = Double.isFinite(out[i]) ? out[i] : 0;
        }
        return out;
    }

    /** Short gaps filled in. */
    static double[] bridged(double[] values) {
        return GapBridge.over(values, LONGEST_GAP);
    }
}
