package wbv.proof;

import java.util.Arrays;
import wbv.signal.RealDft;

/**
 * The force that was concealed, and how an answer's compares with it.
 *
 * @param rate rows per second [Hz]
 * @param force [N]
 * @param extension of its link [m]
 * @param speed of that [m/s], all by row. Not copied.
 */
record ForceMatch(double rate, double[] force, double[] extension, double[] speed) {

    /** Band in which forces are compared of sitters [Hz]: below, none can be told from rest; above, sensors and noise have their say. */
    static final double LOW = 1;
    static final double HIGH = 20;

    /** @param csv as the generator writes it: time, force, extension, rate */
    static ForceMatch parse(String csv) {
        double[][] rows = csv.lines().skip(1).map(line -> Arrays.stream(line.split(",")).mapToDouble(Double::parseDouble).toArray())
                .toArray(double[][]::new);
        double rate = (rows.length - 1) / (rows[rows.length - 1][0] - rows[0][0]);
        return new ForceMatch(rate, column(rows, 1), column(rows, 2), column(rows, 3));
    }

    private static double[] column(double[][] rows, int q) {
        return Arrays.stream(rows).mapToDouble(row -> row[q]).toArray();
    }

    /**
     * Pearson's correlation of the two forces on the held-out stretch, both limited to {@value #LOW} to {@value #HIGH} Hz and without what
     * the true extension and rate of the link explain there: a stiffness or damping that the answer has otherwise is no part of either. NaN
     * where one of the two is then nothing.
     */
    double correlation(LawForce answer) {
        return correlation(answer, LOW, HIGH);
    }

    /**
     * @param low
     * @param high edges of the band [Hz]
     */
    double correlation(LawForce answer, double low, double high) {
        int from = (int) Math.max(0, Math.ceil(answer.from() * rate));
        int to = (int) Math.min(Math.min(force.length, answer.newtons().size()), Math.floor(answer.to() * rate) + 1);
        if (to - from < rate / low) {
            return Double.NaN;
        }
        double[] r = stretch(extension, from, to, low, high);
        double[] v = stretch(speed, from, to, low, high);
        double[] a = without(r, v, stretch(force, from, to, low, high));
        double[] b = without(r, v, stretch(answer.newtons().stream().mapToDouble(x -> x).toArray(), from, to, low, high));
        return dot(a, b) / Math.sqrt(dot(a, a) * dot(b, b));
    }

    /** The band of a series, and of that a stretch without its mean. */
    private double[] stretch(double[] x, int from, int to, double low, double high) {
        RealDft dft = new RealDft(RealDft.covering(x.length));
        double[] lines = dft.forward(Arrays.copyOf(x, dft.length()));
        for (int k = 0; k < lines.length / 2; k++) {
            double hertz = k * rate / dft.length();
            if (hertz < low || hertz > high) {
                lines[2 * k] = 0;
                lines[2 * k + 1] = 0;
            }
        }
        double[] out = Arrays.copyOfRange(dft.inverse(lines), from, to);
        double mean = Arrays.stream(out).average().orElse(0);
        return Arrays.stream(out).map(value -> value - mean).toArray();
    }

    /** What is left of a force after its least-squares fit by two others. */
    private static double[] without(double[] r, double[] v, double[] f) {
        double rr = dot(r, r);
        double vv = dot(v, v);
        double rv = dot(r, v);
        double determinant = rr * vv - rv * rv;
        double k = (dot(r, f) * vv - dot(v, f) * rv) / determinant;
        double c = (dot(v, f) * rr - dot(r, f) * rv) / determinant;
        double[] out = new double[f.length];
        Arrays.setAll(out, i -> f[i] - k * r[i] - c * v[i]);
        return out;
    }

    private static double dot(double[] a, double[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += a[i] * b[i];
        }
        return sum;
    }
}
