package wbv.exposure;

import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * What the standards ask of a weighted acceleration, value by value: means, doses, running means over one second (ISO 2631-1
 * 6.3.1) and their greatest. Missing values (NaN) count neither as vibration nor as time. Allocates nothing per value.
 */
public final class WeightedStatistics implements Weigher.Sink, Snapshot {

    /** Integration time of the running means [s]. */
    public static final double INTEGRATION = 1;
    /** Length of the blocks whose scatter tells how sure the mean is [s]. */
    private static final double BLOCK = 10;
    private static final int LEAST_BLOCKS = 6;
    /** A value of a signal that ends at a quarter of its rate lies no higher between two values than they do over this. */
    private static final double NEAR_PEAK = 0.7;

    private final double rate;
    private final int step;
    private final int dense;
    private final double[] squares;
    private final double decay;
    private int head;
    private int inStep;
    private double stepSum;
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

    /**
     * Statistics of no value yet, of values as they were sampled.
     *
     * @param rate of the values [Hz]
     */
    public WeightedStatistics(double rate) {
        this(rate, 1, 1);
    }

    /**
     * @param rate of the values [Hz]
     * @param step values by which the second of the linear running mean moves on: as many as a sample of the recording has become
     *             make it move from sample to sample, for which it need not keep every value
     * @param dense values that the first form of a saved state had where there is one now
     */
    WeightedStatistics(double rate, int step, int dense) {
        this.rate = rate;
        this.step = step;
        this.dense = dense;
        squares = new double[(int) Math.max(1, Math.round(INTEGRATION * rate / step))];
        decay = -Math.expm1(-1 / (INTEGRATION * rate));
        blockLength = Math.max(1, Math.round(BLOCK * rate));
    }

    /** Another for the same values, that has heard none. */
    WeightedStatistics fresh() {
        return new WeightedStatistics(rate, step, dense);
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

    @Override
    public double leastBetween() {
        return NEAR_PEAK * peak;
    }

    @Override
    public void between(double value) {
        double amount = Math.abs(value);
        peak = amount > peak ? amount : peak;
    }

    private void runningMeans(double square) {
        exponential += decay * (square - exponential);
        greatestExponential = Math.max(greatestExponential, exponential);
        stepSum += square;
        if (++inStep == step) {
            moveOn();
        }
    }

    private void moveOn() {
        linear += stepSum - squares[head];
        squares[head] = stepSum;
        inStep = 0;
        stepSum = 0;
        if (++head == squares.length) {
            head = 0;
            linear = 0; // rounding must not pile up over hours
            for (double each : squares) {
                linear += each;
            }
        }
        if (linear > greatestLinear) {
            greatestLinear = linear;
            greatestAt = values;
        }
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
        return Math.sqrt(Math.max(0, linear) / (squares.length * step));
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
                Math.sqrt(Math.sqrt(fourth / rate)), Math.sqrt(greatestLinear / (squares.length * step)), greatestAt / rate,
                Math.sqrt(greatestExponential));
    }

    @Override
    public void save(StateWriter out) {
        out.put(squares);
        out.put(head);
        out.put(inStep);
        out.put(stepSum);
        out.put(linear);
        out.put(exponential);
        out.put(greatestLinear);
        out.put(greatestExponential);
        out.put(greatestAt);
        out.put(values);
        out.put(present);
        out.put(second);
        out.put(fourth);
        out.put(peak);
        out.put(inBlock);
        out.put(blockSum);
        out.put(blocks);
        out.put(blockMean);
        out.put(blockScatter);
    }

    @Override
    public void load(StateReader in) {
        in.numbers(squares);
        head = in.integer(0, squares.length - 1, "a place in a second");
        inStep = in.integer();
        stepSum = in.number();
        linear = in.number();
        exponential = in.number();
        greatestLinear = in.number();
        greatestExponential = in.number();
        greatestAt = in.count();
        values = in.count();
        present = in.count();
        second = in.number();
        fourth = in.number();
        peak = in.number();
        inBlock = in.count();
        blockSum = in.number();
        blocks = in.count();
        blockMean = in.number();
        blockScatter = in.number();
        if (in.version() == 1) {
            thin();
        }
    }

    /** The first form counted more values to a sample. */
    private void thin() {
        for (int i = 0; i < squares.length; i++) {
            squares[i] /= dense;
        }
        inStep /= dense;
        stepSum /= dense;
        linear /= dense;
        greatestLinear /= dense;
        greatestAt /= dense;
        values /= dense;
        present /= dense;
        second /= dense;
        fourth /= dense;
        inBlock /= dense;
        blockSum /= dense;
    }
}
