package wbv.exposure;

import java.util.function.DoubleConsumer;

/**
 * What the standards ask of a weighted acceleration, value by value: means, doses, running means over one second (ISO 2631-1
 * 6.3.1) and their greatest. Missing values (NaN) count neither as vibration nor as time. Allocates nothing per value.
 */
public final class WeightedStatistics implements DoubleConsumer {

    /** Integration time of the running means [s]. */
    public static final double INTEGRATION = 1;
    /** Length of the blocks whose scatter tells how sure the mean is [s]. */
    private static final double BLOCK = 10;
    private static final int LEAST_BLOCKS = 6;

    private final double rate;
    private final double[] squares;
    private final double decay;
    private int head;
    private double linear;
    private double exponential;
    private double greatestLinear;
    private double greatestExponential;
    private long greatestAt;
    private long values;
    private long present;
    private double second;
    private double fourth;
    private double peak;
    private final long blockLength;
    private long inBlock;
    private double blockSum;
    private long blocks;
    private double blockMean;
    private double blockScatter;

    /** @param rate of the values [Hz] */
    public WeightedStatistics(double rate) {
        this.rate = rate;
        squares = new double[(int) Math.max(1, Math.round(INTEGRATION * rate))];
        decay = -Math.expm1(-1 / (INTEGRATION * rate));
        blockLength = Math.max(1, Math.round(BLOCK * rate));
    }

    @Override
    public void accept(double value) {
        boolean absent = Double.isNaN(value);
        double square = absent ? 0 : value * value;
        runningMeans(square);
        values++;
        if (absent) {
            return;
        }
        present++;
        second += square;
        fourth += square * square;
        peak = Math.max(peak, Math.abs(value));
        block(square);
    }

    private void runningMeans(double square) {
        linear += square - squares[head];
        squares[head] = square;
        if (++head == squares.length) {
            head = 0;
            linear = 0; // rounding must not pile up over hours
            for (double each : squares) {
                linear += each;
            }
        }
        exponential += decay * (square - exponential);
        if (linear > greatestLinear) {
            greatestLinear = linear;
            greatestAt = values;
        }
        greatestExponential = Math.max(greatestExponential, exponential);
    }

    private void block(double square) {
        blockSum += square;
        if (++inBlock == blockLength) {
            double mean = blockSum / blockLength;
            blocks++;
            double off = mean - blockMean;
            blockMean += off / blocks;
            blockScatter += off * (mean - blockMean);
            inBlock = 0;
            blockSum = 0;
        }
    }

    /** Running r.m.s. over the last second, linear [unit]. */
    public double runningLinear() {
        return Math.sqrt(Math.max(0, linear) / squares.length);
    }

    /** Running r.m.s. with a time constant of one second, exponential [unit]. */
    public double runningExponential() {
        return Math.sqrt(exponential);
    }

    /** What all values up to now amount to. */
    public Vibration vibration() {
        double mean = second / present;
        // Blocks that scatter independently: var(mean) = s² / n, and half of it relatively in the root.
        double deviation = blocks < LEAST_BLOCKS || !(blockMean > 0) ? Double.NaN
                : Math.sqrt(blockScatter / (blocks - 1.0) / blocks) / blockMean / 2;
        return new Vibration(present / rate, (values - present) / rate, present == 0 ? 0 : Math.sqrt(mean), deviation, peak,
                Math.sqrt(Math.sqrt(fourth / rate)), Math.sqrt(greatestLinear / squares.length), greatestAt / rate,
                Math.sqrt(greatestExponential));
    }
}
