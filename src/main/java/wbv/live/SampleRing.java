package wbv.live;

/** The last samples of what is drawn. Allocates nothing after its making. */
final class SampleRing {

    private final double[] times;
    private final float[][] values;
    private long next;

    /**
     * @param length samples held
     * @param curves values of a sample
     */
    SampleRing(int length, int curves) {
        times = new double[length];
        values = new float[curves][length];
    }

    /**
     * Begins a sample.
     *
     * @param time [s]
     */
    void add(double time) {
        int at = (int) (next++ % times.length);
        times[at] = time;
        for (float[] curve : values) {
            curve[at] = Float.NaN;
        }
    }

    /** Sets a value of the last sample. */
    void set(int curve, double value) {
        values[curve][(int) ((next - 1) % times.length)] = (float) value;
    }

    /** Number of the sample to come; the first was 0. */
    long next() {
        return next;
    }

    /** Number of the oldest sample held. */
    long oldest() {
        return Math.max(0, next - times.length);
    }

    double time(long sample) {
        return times[(int) (sample % times.length)];
    }

    float value(int curve, long sample) {
        return values[curve][(int) (sample % times.length)];
    }

    int curves() {
        return values.length;
    }
}
