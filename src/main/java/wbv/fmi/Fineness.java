package wbv.fmi;

/**
 * How finely a run steps.
 *
 * @param step  [s]
 * @param parts of a sample that a step is; 0 where the unit's own step does not divide a sample, so that outputs are interpolated
 */
record Fineness(double step, int parts) {

    /**
     * So many steps a sample.
     *
     * @param rate [Hz]
     */
    static Fineness of(double rate, int parts) {
        return new Fineness(1 / (rate * parts), parts);
    }

    /**
     * Whole steps that cover so many samples.
     *
     * @param rate [Hz]
     */
    int steps(int samples, double rate) {
        return parts > 0 ? (samples - 1) * parts : (int) Math.ceil((samples - 1) / rate / step) + 1;
    }
}
