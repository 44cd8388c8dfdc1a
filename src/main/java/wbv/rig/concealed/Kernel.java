package wbv.rig.concealed;

/** Weights of linear-phase filters: a sinc under a Blackman window, of unit gain at rest. */
final class Kernel {

    private Kernel() {}

    /**
     * @param corner frequency of half amplitude
     * @param rate of the samples, in the same unit
     * @param half samples on each side of the middle
     */
    static double[] lowPass(double corner, double rate, int half) {
        double[] out = new double[2 * half + 1];
        double sum = 0;
        for (int j = -half; j <= half; j++) {
            out[j + half] = value(corner, rate, half, j);
            sum += out[j + half];
        }
        for (int j = 0; j < out.length; j++) {
            out[j] /= sum;
        }
        return out;
    }

    /**
     * Before it is scaled.
     *
     * @param j distance from the middle in samples, at most half + 1
     */
    static double value(double corner, double rate, int half, double j) {
        double angle = 2 * Math.PI * corner * j / rate;
        double w = Math.PI * j / (half + 1);
        return (j == 0 ? 1 : Math.sin(angle) / angle) * (0.42 + 0.5 * Math.cos(w) + 0.08 * Math.cos(2 * w));
    }
}
