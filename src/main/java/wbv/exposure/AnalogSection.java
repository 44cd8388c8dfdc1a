package wbv.exposure;

import java.io.Serializable;

/** A second-order section {@code (b0 + b1 s + b2 s²) / (a0 + a1 s + a2 s²)}, s in rad/s. */
record AnalogSection(double b0, double b1, double b2, double a0, double a1, double a2) implements Serializable {

    /** {@code s² / (s² + (ω/Q) s + ω²)}: ISO 8041-1 Formula (1). @param corner [Hz] */
    static AnalogSection highPass(double corner, double q) {
        double w = 2 * Math.PI * corner;
        return new AnalogSection(0, 0, 1, w * w, w / q, 1);
    }

    /** {@code 1 / (1 + s/(Qω) + (s/ω)²)}: ISO 8041-1 Formula (2). @param corner [Hz] */
    static AnalogSection lowPass(double corner, double q) {
        double w = 2 * Math.PI * corner;
        return new AnalogSection(1, 0, 0, 1, 1 / (q * w), 1 / (w * w));
    }

    /** {@code (1 + 2ζs/ω + (s/ω)²) / (the same of the pole)}. @param zero [rad/s] @param pole [rad/s] */
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

    /** Multiplies a complex number by the response at ω [rad/s]. @param value real and imaginary part. Modified. */
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
}
