package wbv.signal;

/**
 * Raises the rate of a stream by a whole factor, band-limited, block by block: for a simulation or a filter that runs at a
 * multiple of the rate of the data and wants the values between two samples.
 *
 * <p>Sample n comes out as the first of a block when sample {@code n + delay()} goes in. To flush the end, feed the last sample
 * {@code delay()} times more.
 */
public final class Upsampler {

    private final int factor;
    private final BandlimitedResampler resampler;
    private double[] block = new double[0];
    private int filled;

    /**
     * An upsampler that has taken nothing yet.
     *
     * @param factor outputs per input, at least 1
     */
    public Upsampler(int factor) {
        this.factor = factor;
        this.resampler = new BandlimitedResampler(factor, 1, value -> block[filled++] = value);
    }

    /**
     * The smallest factor that brings a rate to at least another.
     *
     * @param rate [Hz]
     * @param wanted [Hz]
     */
    public static Upsampler reaching(double rate, double wanted) {
        if (!(rate > 0) || !(wanted > 0)) {
            throw new IllegalArgumentException("rates must be > 0 Hz: " + rate + " and " + wanted);
        }
        return new Upsampler((int) Math.ceil(Math.max(1, wanted / rate - 1e-9)));
    }

    /** Outputs per input. */
    public int factor() {
        return factor;
    }

    /** Inputs that must follow a sample before its block comes. */
    public int delay() {
        return resampler.delay();
    }

    /**
     * Takes the next sample.
     *
     * @param value of any unit
     * @param block as long as a block, in the unit of the samples: room for {@code factor()} values: from the sample {@code delay()} inputs
     *              ago to just before the next one. Modified only if a block came.
     * @return whether a block came; false for the first {@code delay()} samples
     */
    public boolean accept(double value, double[] block) {
        if (block.length != factor) {
            throw new IllegalArgumentException("a block has " + factor + " values: " + block.length);
        }
        this.block = block;
        this.filled = 0;
        resampler.accept(value);
        return filled == factor;
    }
}
