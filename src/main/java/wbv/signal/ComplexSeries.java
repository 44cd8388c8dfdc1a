package wbv.signal;

/**
 * Complex values, one a bin. Arrays are not copied, neither in nor out: treat them as read-only.
 *
 * @param re real parts by bin, in a unit that the user knows
 * @param im imaginary parts, as many, in the same unit
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

    /** |z_i|, in the unit of the values. */
    public double magnitude(int i) {
        return Math.hypot(re[i], im[i]);
    }

    /** Angle of z_i [rad], -π to π. */
    public double phase(int i) {
        return Math.atan2(im[i], re[i]);
    }

    /** All |z_i| by bin, in the unit of the values. A new array. */
    public double[] magnitudes() {
        double[] magnitudes = new double[re.length];
        for (int i = 0; i < magnitudes.length; i++) {
            magnitudes[i] = magnitude(i);
        }
        return magnitudes;
    }

    /** All angles by bin [rad], -π to π. A new array. */
    public double[] phases() {
        double[] phases = new double[re.length];
        for (int i = 0; i < phases.length; i++) {
            phases[i] = phase(i);
        }
        return phases;
    }
}
