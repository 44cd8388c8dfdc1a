package wbv.signal;

/**
 * Complex values, one a bin. Arrays are not copied, neither in nor out: treat them as read-only.
 *
 * @param re real parts
 * @param im imaginary parts, as many
 */
public record ComplexSeries(double[] re, double[] im) {

    public ComplexSeries {
        if (re.length != im.length) {
            throw new IllegalArgumentException("as many imaginary as real parts: " + im.length + " and " + re.length);
        }
    }

    /** Number of values. */
    public int length() {
        return re.length;
    }

    /** |z_i|. */
    public double magnitude(int i) {
        return Math.hypot(re[i], im[i]);
    }

    /** Angle of z_i [rad], -π to π. */
    public double phase(int i) {
        return Math.atan2(im[i], re[i]);
    }

    /** All |z_i|. */
    public double[] magnitudes() {
        double[] magnitudes = new double[re.length];
        for (int i = 0; i < magnitudes.length; i++) {
            magnitudes[i] = magnitude(i);
        }
        return magnitudes;
    }

    /** All angles [rad], -π to π. */
    public double[] phases() {
        double[] phases = new double[re.length];
        for (int i = 0; i < phases.length; i++) {
            phases[i] = phase(i);
        }
        return phases;
    }
}
