package wbv.report;

import java.util.Arrays;

/**
 * A long signal kept for drawing, in bounded memory: every sample while there is room for them, then the smallest and the largest
 * of every two, four and so on. Missing samples (NaN) stay missing.
 */
final class Waveform {

    private static final int FIRST = 4096;

    private final int most;
    private double[] smallest;
    private double[] largest;
    private int width = 1;
    private int size;
    private int inLast;

    /** @param most values kept at most, even, at least 2 */
    Waveform(int most) {
        if (most < 2 || most % 2 != 0) {
            throw new IllegalArgumentException("number of values must be even and >= 2: " + most);
        }
        this.most = most;
        smallest = new double[Math.min(most, FIRST)];
        largest = smallest;
    }

    /** Takes the next sample; NaN is missing. */
    void accept(double value) {
        if (size > 0 && inLast < width) {
            inLast++;
            add(size - 1, value);
            return;
        }
        if (size == most) {
            merge();
            accept(value);
            return;
        }
        if (size == smallest.length) {
            boolean one = smallest == largest;
            smallest = Arrays.copyOf(smallest, Math.min(most, 2 * size));
            largest = one ? smallest : Arrays.copyOf(largest, smallest.length);
        }
        smallest[size] = value;
        largest[size] = value;
        size++;
        inLast = 1;
    }

    private void add(int at, double value) {
        smallest[at] = Double.isNaN(smallest[at]) || value < smallest[at] ? value : smallest[at];
        largest[at] = Double.isNaN(largest[at]) || value > largest[at] ? value : largest[at];
    }

    private void merge() {
        if (smallest == largest) {
            largest = smallest.clone();
        }
        for (int i = 0; i < size / 2; i++) {
            double low = smallest[2 * i];
            double high = largest[2 * i];
            smallest[i] = Double.isNaN(low) || smallest[2 * i + 1] < low ? smallest[2 * i + 1] : low;
            largest[i] = Double.isNaN(high) || largest[2 * i + 1] > high ? largest[2 * i + 1] : high;
        }
        size /= 2;
        width *= 2;
        inLast = width;
    }

    /** Samples that a value stands for, but for the last; 1 while every sample is kept. */
    int width() {
        return width;
    }

    /**
     * The signal as a curve: its samples, or the middle of their range with the range about it.
     *
     * @param start time of the first sample [s] @param step between samples [s]
     */
    Series series(String name, double start, double step) {
        double[] low = Arrays.copyOf(smallest, size);
        double[] time = new double[size];
        for (int i = 0; i < size; i++) {
            time[i] = start + (i * (double) width + (width - 1) / 2.0) * step;
        }
        if (width == 1) {
            return Series.line(name, time, low);
        }
        double[] high = Arrays.copyOf(largest, size);
        double[] middle = new double[size];
        Arrays.setAll(middle, i -> (low[i] + high[i]) / 2);
        return Series.line(name, time, middle).with(Band.extremes(low, high));
    }
}
