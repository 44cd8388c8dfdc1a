package wbv.study;

import java.util.Arrays;

/**
 * A long signal kept for drawing, in bounded memory: every sample while there is room for them, then the smallest and the largest
 * of every two, four and so on. Missing samples (NaN) stay missing.
 */
public final class Waveform {

    private static final int FIRST = 4096;

    private final int most;
    private double[] smallest;
    private double[] largest;
    private int width = 1;
    private int size;
    private int inLast;

    /**
     * A waveform of no sample yet.
     *
     * @param most values kept at most, even, at least 2
     */
    public Waveform(int most) {
        if (most < 2 || most % 2 != 0) {
            throw new IllegalArgumentException("number of values must be even and >= 2: " + most);
        }
        this.most = most;
        smallest = new double[Math.min(most, FIRST)];
        largest = smallest;
    }

    /** Takes the next sample, of any unit; NaN is missing. */
    public void accept(double value) {
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
    public int width() {
        return width;
    }

    /** How many values are kept. */
    public int size() {
        return size;
    }

    /** The sample, in its unit, or the smallest of those that a value stands for; NaN where all are missing. */
    public double smallest(int value) {
        return smallest[value];
    }

    /** The sample, in its unit, or the largest of those that a value stands for; NaN where all are missing. */
    public double largest(int value) {
        return largest[value];
    }
}
