package wbv.rig.concealed;

/** From what moves, at a fine rate, to rows: the linear-phase low-pass before the converter and the converter's clock. */
final class Acquisition {

    /** Corner of the low-pass over the rate of the rows. */
    private static final double CORNER = 0.42;
    /** Half the length of its kernel, in rows. */
    private static final int HALF = 12;

    private final double rate;
    private final int ticks;
    private final double[] kernel;

    /**
     * @param rate of the rows [Hz]
     * @param ticks fine samples a row
     */
    Acquisition(double rate, int ticks) {
        this.rate = rate;
        this.ticks = ticks;
        this.kernel = Kernel.lowPass(CORNER * rate, rate * ticks, HALF * ticks);
    }

    double rate() {
        return rate;
    }

    /** Fine samples in a second [Hz]. */
    double fine() {
        return rate * ticks;
    }

    /** @param series at the fine rate. Not modified. */
    double[] rows(double[] series) {
        double[] out = new double[series.length / ticks];
        int half = kernel.length / 2;
        for (int i = 0; i < out.length; i++) {
            int at = i * ticks;
            double sum = 0;
            for (int j = -half; j <= half; j++) {
                sum += kernel[j + half] * series[Math.max(0, Math.min(series.length - 1, at + j))];
            }
            out[i] = sum;
        }
        return out;
    }

    /**
     * The series so much later; held at its ends.
     *
     * @param seconds of either sign
     */
    double[] late(double[] series, double seconds) {
        double[] out = new double[series.length];
        for (int i = 0; i < out.length; i++) {
            out[i] = UniformSeries.at(series, i - seconds * fine());
        }
        return out;
    }
}
