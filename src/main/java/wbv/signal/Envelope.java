package wbv.signal;

/**
 * The smallest, largest and mean value of a long signal in a bounded number of equal buckets, for drawing it.
 *
 * <p>A bucket holds one sample at first. When the buckets are used up, neighbours are merged two by two and later buckets hold
 * twice as many samples. Missing samples (NaN) are left out; a bucket of nothing else is NaN.
 */
public final class Envelope {

    private final double[] smallest;
    private final double[] largest;
    private final double[] sum;
    private final int[] present;
    private int width = 1;
    private int bucket;
    private int inBucket;

    /**
     * An envelope of no sample yet.
     *
     * @param mostBuckets buckets kept at most, even, at least 2
     */
    public Envelope(int mostBuckets) {
        if (mostBuckets < 2 || mostBuckets % 2 != 0) {
            throw new IllegalArgumentException("number of buckets must be even and >= 2: " + mostBuckets);
        }
        this.smallest = new double[mostBuckets];
        this.largest = new double[mostBuckets];
        this.sum = new double[mostBuckets];
        this.present = new int[mostBuckets];
        clear(0);
    }

    /** Takes the next sample, of any unit; NaN is missing. */
    public void accept(double value) {
        if (inBucket == width) {
            inBucket = 0;
            bucket++;
            if (bucket == sum.length) {
                merge();
            }
        }
        if (Double.isFinite(value)) {
            smallest[bucket] = Math.min(smallest[bucket], value);
            largest[bucket] = Math.max(largest[bucket], value);
            sum[bucket] += value;
            present[bucket]++;
        }
        inBucket++;
    }

    private void merge() {
        int half = sum.length / 2;
        for (int i = 0; i < half; i++) {
            smallest[i] = Math.min(smallest[2 * i], smallest[2 * i + 1]);
            largest[i] = Math.max(largest[2 * i], largest[2 * i + 1]);
            sum[i] = sum[2 * i] + sum[2 * i + 1];
            present[i] = present[2 * i] + present[2 * i + 1];
        }
        clear(half);
        width *= 2;
        bucket = half;
    }

    private void clear(int from) {
        for (int i = from; i < sum.length; i++) {
            smallest[i] = Double.POSITIVE_INFINITY;
            largest[i] = Double.NEGATIVE_INFINITY;
            sum[i] = 0;
            present[i] = 0;
        }
    }

    /** Number of buckets begun. */
    public int size() {
        return inBucket == 0 ? 0 : bucket + 1;
    }

    /** Samples a bucket holds, but for the last; 1 while every sample has its own. */
    public int width() {
        return width;
    }

    /** Centre of a bucket, from the first sample [samples]: bucket 0 of width 1 is at 0, of width 2 at 0.5. */
    public double centre(int i) {
        int held = i == bucket ? inBucket : width;
        return (double) i * width + (held - 1) / 2.0;
    }

    /** Smallest value in a bucket, in the samples' unit; NaN if all are missing. */
    public double smallest(int i) {
        return present[i] == 0 ? Double.NaN : smallest[i];
    }

    /** Largest value in a bucket, in the samples' unit; NaN if all are missing. */
    public double largest(int i) {
        return present[i] == 0 ? Double.NaN : largest[i];
    }

    /** Mean of a bucket, in the samples' unit; NaN if all are missing. */
    public double mean(int i) {
        return sum[i] / present[i];
    }
}
