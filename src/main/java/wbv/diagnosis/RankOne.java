package wbv.diagnosis;

/**
 * One more process in the noise, as whitened vectors see it. Where S was whitened to I and the process comes along u with power Φ, the
 * covariance is {@code I + Φ u uᴴ} at each line, of which the inverse root is {@code I - β u uᴴ} with {@code β = (1 - (1 + Φ|u|²)^-½) / |u|²}
 * and the determinant {@code 1 + Φ|u|²}.
 */
final class RankOne {

    private final double[] way;
    private final double[] factor;
    private final int outputs;
    private final double logDeterminant;

    /**
     * @param way   a unit of the process in each output, whitened, by line and output as {@link Whitening#whiten} gives it. Not modified.
     * @param power variance of the real and of the imaginary part of each line of the process
     */
    RankOne(double[] way, double[] power, int outputs) {
        this.way = way;
        this.outputs = outputs;
        factor = new double[power.length];
        double sum = 0;
        for (int line = 0; line < power.length; line++) {
            double size = size(way, line, outputs);
            double grown = power[line] * size;
            factor[line] = size > 0 ? (1 - 1 / Math.sqrt(1 + grown)) / size : 0;
            sum += Math.log1p(grown);
        }
        logDeterminant = sum;
    }

    /** By how much log det S grows over all lines. */
    double logDeterminant() {
        return logDeterminant;
    }

    /** A whitened vector as it is with this process in the noise. A new array. */
    double[] of(double[] vector) {
        double[] along = along(way, vector, outputs);
        double[] out = vector.clone();
        for (int i = 0; i < out.length; i += 2) {
            int line = i / (2 * outputs);
            double re = factor[line] * along[2 * line];
            double im = factor[line] * along[2 * line + 1];
            out[i] -= way[i] * re - way[i + 1] * im;
            out[i + 1] -= way[i] * im + way[i + 1] * re;
        }
        return out;
    }

    /** uᴴ v at each line. A new array. */
    static double[] along(double[] way, double[] vector, int outputs) {
        double[] out = new double[way.length / outputs];
        for (int i = 0; i < way.length; i += 2) {
            int at = 2 * (i / (2 * outputs));
            out[at] += way[i] * vector[i] + way[i + 1] * vector[i + 1];
            out[at + 1] += way[i] * vector[i + 1] - way[i + 1] * vector[i];
        }
        return out;
    }

    /** |u|² at each line. A new array. */
    static double[] sizes(double[] way, int outputs) {
        double[] out = new double[way.length / (2 * outputs)];
        for (int line = 0; line < out.length; line++) {
            out[line] = size(way, line, outputs);
        }
        return out;
    }

    private static double size(double[] way, int line, int outputs) {
        int from = 2 * outputs * line;
        return Fitter.dot(way, way, from, from + 2 * outputs);
    }
}
