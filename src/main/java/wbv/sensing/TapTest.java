package wbv.sensing;

import java.util.Locale;
import org.apache.commons.math3.analysis.ParametricUnivariateFunction;
import org.apache.commons.math3.exception.MathIllegalStateException;
import org.apache.commons.math3.fitting.leastsquares.LeastSquaresBuilder;
import org.apache.commons.math3.fitting.leastsquares.LeastSquaresOptimizer;
import org.apache.commons.math3.fitting.leastsquares.LevenbergMarquardtOptimizer;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.apache.commons.math3.util.Pair;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;
import wbv.recording.Recording;

/**
 * Natural frequency and damping of a sensor on the skin from how it rings after a tap beside it (the free-vibration test of
 * Kitazaki
 * and Griffin 1995): {@code a e^(-ζωt) cos(ω√(1-ζ²) t) + b e^(-ζωt) sin(ω√(1-ζ²) t) + c} fitted by least squares.
 */
public final class TapTest implements ParametricUnivariateFunction {

    private static final int PERIODS = 6;
    private static final double HIGHEST = 0.4;
    private static final double FAINT = 0.05;

    private TapTest() {}

    /**
     * What a tap shows.
     *
     * @param mount              frequency and damping
     * @param frequencyDeviation standard deviation of the frequency [Hz]
     * @param dampingDeviation that of the damping ratio
     * @param unexplained        rms of what the fit leaves over that of the ringing [1]
     */
    public record Rung(SkinMount mount, double frequencyDeviation, double dampingDeviation, double unexplained) {}

    /**
     * Fits the ringing after the greatest sample of a record.
     *
     * @param samples series of the sensor along the axis of the tap [m/s²], finite. Not modified.
     * @param rate    samples per second [Hz]
     * @throws DataFault if nothing rings, it rings faster than 0.4 of the rate, or it is damped too strongly to ring
     */
    public static Rung fit(double[] samples, double rate) {
        int onset = greatest(samples);
        double[] start = guess(samples, onset, rate);
        double period = 2 * Math.PI / start[0];
        int length = Math.min(samples.length - onset, (int) Math.ceil(PERIODS * period * rate));
        if (length < 10) {
            throw new DataFault(String.format(Locale.ROOT, "a tap needs 10 samples of ringing after its greatest: there are %d",
                    length));
        }
        TapTest shape = new TapTest();
        RealVector target = new ArrayRealVector(length);
        for (int n = 0; n < length; n++) {
            target.setEntry(n, samples[onset + n]);
        }
        LeastSquaresOptimizer.Optimum best;
        try {
            best = new LevenbergMarquardtOptimizer().optimize(new LeastSquaresBuilder()
                    .start(new double[] {Math.log(start[0]), Math.log(start[1]), samples[onset], 0, 0})
                    .model(point -> {
                        double[] p = point.toArray();
                        RealVector value = new ArrayRealVector(length);
                        RealMatrix slopes = new Array2DRowRealMatrix(length, 5);
                        for (int n = 0; n < length; n++) {
                            value.setEntry(n, shape.value(n / rate, p));
                            slopes.setRow(n, shape.gradient(n / rate, p));
                        }
                        return new Pair<>(value, slopes);
                    }).target(target).maxEvaluations(500).maxIterations(500).build());
        } catch (MathIllegalStateException lost) {
            throw new DataFault("the ringing after the tap fits no damped oscillation: " + lost.getMessage(), lost);
        }
        double omega = Math.exp(best.getPoint().getEntry(0));
        double damping = Math.exp(best.getPoint().getEntry(1));
        double frequency = omega / (2 * Math.PI);
        if (!(damping < 1) || frequency > HIGHEST * rate) {
            throw new DataFault(String.format(Locale.ROOT,
                    "the tap shows %.3g Hz with a damping ratio of %.2g, which %.4g samples a "
                            + "second cannot: below %.3g Hz and 1 would be right",
                    frequency, damping, rate, HIGHEST * rate));
        }
        double variance = best.getCost() * best.getCost() / Math.max(1, length - 5);
        RealMatrix covariance = best.getCovariances(1e-14);
        double rms = Math.sqrt(target.dotProduct(target) / length);
        return new Rung(new SkinMount(frequency, damping), frequency * Math.sqrt(variance * covariance.getEntry(0, 0)),
                damping * Math.sqrt(variance * covariance.getEntry(1, 1)),
                Math.sqrt(best.getCost() * best.getCost() / length) / rms);
    }

    /**
     * Fits the ringing that a recording of a tap holds, along the axis of the place that rings most.
     *
     * @throws DataFault if the place has no acceleration there, or as {@link #fit(double[], double)} says
     */
    public static Rung fit(Recording tap, String place) {
        double[] most = new double[0];
        double range = -1;
        for (Channel channel : tap.channels()) {
            boolean acceleration = channel.quantity() == Quantity.ACCELERATION || channel.quantity() == Quantity.SPECIFIC_FORCE;
            if (channel.location().equals(place) && acceleration) {
                double[] samples = tap.values(channel).clone();
                double[] sorted = samples.clone();
                java.util.Arrays.sort(sorted);
                double rest = sorted[sorted.length / 2];
                double farthest = 0;
                for (int n = 0; n < samples.length; n++) {
                    samples[n] -= rest;   // gravity, where it was left in
                    farthest = Math.max(farthest, Math.abs(samples[n]));
                }
                most = farthest > range ? samples : most;
                range = Math.max(range, farthest);
            }
        }
        if (most.length == 0) {
            throw new DataFault("the recording of the tap has no acceleration of " + place + "; it has " + tap.channels());
        }
        return fit(most, tap.clock().rate());
    }

    private static int greatest(double[] samples) {
        int onset = 0;
        for (int n = 0; n < samples.length; n++) {
            if (!Double.isFinite(samples[n])) {
                throw new DataFault("a tap's record must have every sample: " + n + " is " + samples[n]);
            }
            onset = Math.abs(samples[n]) > Math.abs(samples[onset]) ? n : onset;
        }
        if (samples.length == 0 || samples[onset] == 0) {
            throw new DataFault("nothing rings in the record of the tap");
        }
        return onset;
    }

    /** Angular frequency and damping ratio from the first zero crossings and swings after the greatest sample. */
    private static double[] guess(double[] samples, int onset, double rate) {
        double first = Double.NaN;
        double last = Double.NaN;
        int crossings = 0;
        double swing = Math.abs(samples[onset]);
        for (int n = onset + 1; n < samples.length && crossings < 5; n++) {
            if (samples[n] * samples[n - 1] < 0) {
                if (swing < FAINT * Math.abs(samples[onset])) {
                    break;   // what crosses zero now is noise
                }
                last = n - samples[n] / (samples[n] - samples[n - 1]);
                first = crossings == 0 ? last : first;
                crossings++;
                swing = 0;
            }
            swing = Math.max(swing, Math.abs(samples[n]));
        }
        if (crossings < 2) {
            throw new DataFault("the record of the tap does not swing: it is damped too strongly, or too short");
        }
        double damped = Math.PI * rate * (crossings - 1) / (last - first);
        double damping = 0.2;
        return new double[] {damped / Math.sqrt(1 - damping * damping), damping};
    }

    /**
     * @param t [s]
     * @param p ln ω, ln ζ, a, b, c
     */
    @Override
    public double value(double t, double... p) {
        double omega = Math.exp(p[0]);
        double damping = Math.min(0.999, Math.exp(p[1]));
        double decay = Math.exp(-damping * omega * t);
        double phase = omega * Math.sqrt(1 - damping * damping) * t;
        return decay * (p[2] * Math.cos(phase) + p[3] * Math.sin(phase)) + p[4];
    }

    @Override
    public double[] gradient(double t, double... p) {
        double omega = Math.exp(p[0]);
        double damping = Math.min(0.999, Math.exp(p[1]));
        double root = Math.sqrt(1 - damping * damping);
        double decay = Math.exp(-damping * omega * t);
        double phase = omega * root * t;
        double c = Math.cos(phase);
        double s = Math.sin(phase);
        double swing = p[2] * c + p[3] * s;
        double turned = -p[2] * s + p[3] * c;
        return new double[] {decay * (-damping * omega * t * swing + phase * turned),
            decay * (-damping * omega * t * swing - damping * damping / (root * root) * phase * turned), decay * c, decay * s, 1};
    }
}
