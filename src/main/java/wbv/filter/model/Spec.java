package wbv.filter.model;

import java.io.Serializable;

/**
 * What an {@link wbv.filter.Estimator} is told before the first sample.
 *
 * @param rate        sampling rate [Hz], &gt; 0
 * @param frequency   natural frequency to start from [Hz], {@value #LEAST_FREQUENCY} to {@value #MOST_FREQUENCY}
 * @param damping     damping ratio to start from [1], {@value #LEAST_DAMPING} to {@value #MOST_DAMPING}
 * @param inputNoise  standard deviation of the input sensor's noise in one sample [m/s² or rad/s], &gt; 0
 * @param outputNoise standard deviation of the output sensor's noise in one sample [m/s² or rad/s], &gt; 0
 * @param drift       how far both parameters may wander in one second, as a share of their value [1/√s], &gt;= 0
 * @param adaptation  the numbers by which it adapts to what it meets
 */
public record Spec(double rate, double frequency, double damping, double inputNoise, double outputNoise, double drift,
        Adaptation adaptation) implements Serializable {

    /** Bounds of the natural frequency [Hz] and of the damping ratio [1]; an estimate outside has diverged. */
    public static final double LEAST_FREQUENCY = 0.3;
    /** Highest natural frequency [Hz]. */
    public static final double MOST_FREQUENCY = 25;
    /** Lowest damping ratio [1]. */
    public static final double LEAST_DAMPING = 0.01;
    /** Highest damping ratio [1]. */
    public static final double MOST_DAMPING = 3;

    /** Noise density of a MEMS accelerometer for motion capture [m/s²/√Hz]: 200 µg/√Hz. */
    public static final double NOISE_DENSITY = 200e-6 * 9.80665;

    /** Noise density of a gyroscope for motion capture [rad/s/√Hz]: 0.01 °/s/√Hz. */
    public static final double RATE_NOISE_DENSITY = Math.toRadians(0.01);

    /** Usual wandering of a sitter's parameters [1/√s]. */
    public static final double DRIFT = 0.003;

    public Spec {
        if (!(rate > 0) || Double.isInfinite(rate)) {
            throw new IllegalArgumentException("sampling rate must be > 0 Hz: " + rate);
        }
        if (!(frequency >= LEAST_FREQUENCY && frequency <= MOST_FREQUENCY)) {
            throw new IllegalArgumentException("natural frequency must be " + LEAST_FREQUENCY + " to " + MOST_FREQUENCY
                    + " Hz: " + frequency);
        }
        if (!(damping >= LEAST_DAMPING && damping <= MOST_DAMPING)) {
            throw new IllegalArgumentException("damping ratio must be " + LEAST_DAMPING + " to " + MOST_DAMPING
                    + ": " + damping);
        }
        if (!(inputNoise > 0 && outputNoise > 0)) {
            throw new IllegalArgumentException("sensor noise must be > 0: " + inputNoise + ", " + outputNoise);
        }
        if (!(drift >= 0)) {
            throw new IllegalArgumentException("drift must be >= 0 1/√s: " + drift);
        }
    }

    /**
     * With the usual adaptation.
     *
     * @param rate        [Hz]
     * @param frequency   [Hz]
     * @param damping     [1]
     * @param inputNoise  [m/s² or rad/s]
     * @param outputNoise [m/s² or rad/s]
     * @param drift       [1/√s]
     */
    public Spec(double rate, double frequency, double damping, double inputNoise, double outputNoise, double drift) {
        this(rate, frequency, damping, inputNoise, outputNoise, drift, Adaptation.USUAL);
    }

    /**
     * Whether an estimator may start there.
     *
     * @param frequency [Hz]
     * @param damping [1]
     */
    public static boolean isStart(double frequency, double damping) {
        return frequency >= LEAST_FREQUENCY && frequency <= MOST_FREQUENCY && damping >= LEAST_DAMPING && damping <= MOST_DAMPING;
    }

    /** Start at 5 Hz and damping ratio 0.4 with the noise of usual sensors. */
    public static Spec at(double rate) {
        return new Spec(rate, 5, 0.4, noise(rate), noise(rate), DRIFT);
    }

    /** The same for angular rates, with the noise of usual gyroscopes [rad/s]. Thesis: Eq. 5-6. */
    public static Spec rotary(double rate) {
        double noise = RATE_NOISE_DENSITY * Math.sqrt(rate / 2);
        return new Spec(rate, 5, 0.4, noise, noise, DRIFT);
    }

    /**
     * The same but for the noise.
     *
     * @param deviation of one sample of either sensor [m/s² or rad/s]
     */
    public Spec withNoise(double deviation) {
        return new Spec(rate, frequency, damping, deviation, deviation, drift, adaptation);
    }

    /**
     * The same but for the start.
     *
     * @param frequency [Hz]
     * @param damping [1]
     */
    public Spec startingAt(double frequency, double damping) {
        return new Spec(rate, frequency, damping, inputNoise, outputNoise, drift, adaptation);
    }

    /** The same but for the numbers by which it adapts. */
    public Spec adapting(Adaptation other) {
        return new Spec(rate, frequency, damping, inputNoise, outputNoise, drift, other);
    }

    /**
     * Noise in one sample [m/s²] of a usual sensor that averages over the sampling interval: density times √(rate/2).
     *
     * @param rate [Hz]
     */
    public static double noise(double rate) {
        return NOISE_DENSITY * Math.sqrt(rate / 2);
    }
}
