package wbv.signal;

/**
 * A taper for spectral estimation, periodic (its next value would be its first): sums over overlapping segments are then flat.
 *
 * <p>Immutable.
 */
public final class Taper {

    private final double[] weights;
    private final double sum;
    private final double power;

    private Taper(double[] weights) {
        this.weights = weights;
        double total = 0;
        double squares = 0;
        for (double weight : weights) {
            total += weight;
            squares += weight * weight;
        }
        this.sum = total;
        this.power = squares;
    }

    /**
     * Hann's window {@code (1 - cos(2πn/N)) / 2}.
     *
     * @param length points N, at least 4
     */
    public static Taper hann(int length) {
        if (length < 4) {
            throw new IllegalArgumentException("a window needs at least 4 points: " + length);
        }
        double[] weights = new double[length];
        for (int n = 0; n < length; n++) {
            weights[n] = (1 - Math.cos(2 * Math.PI * n / length)) / 2;
        }
        return new Taper(weights);
    }

    /**
     * One, but for half a cosine at either end (Tukey 1967).
     *
     * @param length points N, at least 4
     * @param part of the length that each of these takes [1], to 0.5
     */
    public static Taper ends(int length, double part) {
        if (length < 4 || !(part > 0 && part <= 0.5)) {
            throw new IllegalArgumentException("at least 4 points, of which each end takes up to a half: " + length + ", " + part);
        }
        double[] weights = new double[length];
        for (int n = 0; n < length; n++) {
            double u = Math.min(1, Math.min(n, length - n) / (part * length));
            weights[n] = (1 - Math.cos(Math.PI * u)) / 2;
        }
        return new Taper(weights);
    }

    /** Number of points N. */
    public int length() {
        return weights.length;
    }

    /** The weight of point n [1]. */
    public double weight(int n) {
        return weights[n];
    }

    /** Sum of the squared weights: the power that a unit-variance white sequence keeps, times N. */
    public double power() {
        return power;
    }

    /** Equivalent noise bandwidth [bins]: {@code N Σw² / (Σw)²}; 1.5 for Hann. */
    public double noiseBandwidth() {
        return weights.length * power / (sum * sum);
    }

    /** Correlation [1] of the window with itself {@code shift} points later, 1 at shift 0 and 0 from shift N on. */
    public double correlation(int shift) {
        double product = 0;
        for (int n = Math.abs(shift); n < weights.length; n++) {
            product += weights[n] * weights[n - Math.abs(shift)];
        }
        return product / power;
    }

    /**
     * Multiplies a segment by the window.
     *
     * @param segment N long, of any unit. Modified.
     */
    public void apply(double[] segment) {
        for (int n = 0; n < weights.length; n++) {
            segment[n] *= weights[n];
        }
    }
}
