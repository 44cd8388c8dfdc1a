package wbv.exposure;

import java.io.Serializable;

/** A second-order section {@code (b0 + b1 s + b2 s²) / (a0 + a1 s + a2 s²)}, s in rad/s. */
record AnalogSection(double b0, double b1, double b2, double a0, double a1, double a2) implements Serializable {
    /**
     * {@code s² / (s² + (ω/Q) s + ω²)}: ISO 8041-1 Formula (1).
     *
     * @param corner [Hz]
     */
    static AnalogSection highPass(double corner, double q) {
        double w = 2 * Math.PI * corner;
        return new AnalogSection(0, 0, 1, w * w, w / q, 1);
    }

    /**
     * {@code 1 / (1 + s/(Qω) + (s/ω)²)}: ISO 8041-1 Formula (2).
     *
     * @param corner [Hz]
     */
    static AnalogSection lowPass(double corner, double q) {
        double w = 2 * Math.PI * corner;
        return new AnalogSection(1, 0, 0, 1, 1 / (q * w), 1 / (w * w));
    }

    /**
     * {@code (1 + 2ζs/ω + (s/ω)²) / (the same of the pole)}.
     *
     * @param zero [rad/s]
     * @param pole [rad/s]
     */
    static AnalogSection resonance(double zero, double zeroDamping, double pole, double poleDamping) {
        return new AnalogSection(1, 2 * zeroDamping / zero, 1 / (zero * zero), 1, 2 * poleDamping / pole, 1 / (pole * pole));
    }

    /** The same section times s; its numerator must be a number. */
    AnalogSection differentiated() {
        return new AnalogSection(0, b0, 0, a0, a1, a2);
    }

    /** True if the numerator is a number. */
    boolean plain() {
        return b1 == 0 && b2 == 0;
    }

    /**
     * Multiplies a complex number by the response at ω [rad/s].
     *
     * @param value real and imaginary part. Modified.
     */
    void apply(double w, double[] value) {
        double nRe = b0 - b2 * w * w;
        double nIm = b1 * w;
        double dRe = a0 - a2 * w * w;
        double dIm = a1 * w;
        double size = dRe * dRe + dIm * dIm;
        double hRe = (nRe * dRe + nIm * dIm) / size;
        double hIm = (nIm * dRe - nRe * dIm) / size;
        double re = value[0] * hRe - value[1] * hIm;
        value[1] = value[0] * hIm + value[1] * hRe;
        value[0] = re;
    }

    /**
     * The bilinear transform {@code s = 2 rate (1 - z⁻¹) / (1 + z⁻¹)}: b0 b1 b2 a1 a2 with a0 = 1.
     *
     * @param rate [Hz]
     */
    double[] bilinear(double rate) {
        double c = 2 * rate;
        double scale = a0 + a1 * c + a2 * c * c;
        return new double[] {(b0 + b1 * c + b2 * c * c) / scale, 2 * (b0 - b2 * c * c) / scale,
            (b0 - b1 * c + b2 * c * c) / scale, 2 * (a0 - a2 * c * c) / scale, (a0 - a1 * c + a2 * c * c) / scale};
    }

    /**
     * The matched transform: zeros and poles s become {@code e^(s/rate)}: b0 b1 b2 a1 a2 with a0 = 1, the modulus true at a frequency. What
     * it lacks of the analog section changes with frequency as slowly as the rate is high, wherever the corners lie.
     *
     * @param rate [Hz]
     * @param frequency [Hz]
     */
    double[] matched(double rate, double frequency) {
        double[] zeros = roots(b0, b1, b2, rate);
        double[] poles = roots(a0, a1, a2, rate);
        double[] analog = {1, 0};
        apply(2 * Math.PI * frequency, analog);
        double w = 2 * Math.PI * frequency / rate;
        double gain = Math.hypot(analog[0], analog[1]) * modulus(poles, w) / modulus(zeros, w);
        return new double[] {gain, gain * zeros[0], gain * zeros[1], poles[0], poles[1]};
    }

    /**
     * What is left of the slowest part of its memory after a sample.
     *
     * @param rate [Hz]
     */
    double remembers(double rate) {
        double[] poles = roots(a0, a1, a2, rate);
        double square = poles[0] * poles[0] / 4 - poles[1];
        return square < 0 ? Math.sqrt(poles[1]) : Math.abs(poles[0]) / 2 + Math.sqrt(square);
    }

    /** {@code 1 + c₁ z⁻¹ + c₂ z⁻²} with the roots e^(s/rate) of those of {@code d0 + d1 s + d2 s²}. */
    private static double[] roots(double d0, double d1, double d2, double rate) {
        if (d2 == 0) {
            return new double[] {d1 == 0 ? 0 : -Math.exp(-d0 / d1 / rate), 0};
        }
        double middle = -d1 / (2 * d2) / rate;
        double square = d1 * d1 / (4 * d2 * d2) - d0 / d2;
        double apart = Math.sqrt(Math.abs(square)) / rate;
        double sum = 2 * Math.exp(middle) * (square < 0 ? Math.cos(apart) : Math.cosh(apart));
        return new double[] {-sum, Math.exp(2 * middle)};
    }

    private static double modulus(double[] c, double w) {
        return Math.hypot(1 + c[0] * Math.cos(w) + c[1] * Math.cos(2 * w), c[0] * Math.sin(w) + c[1] * Math.sin(2 * w));
    }
}
