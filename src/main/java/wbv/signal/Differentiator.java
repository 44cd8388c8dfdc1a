package wbv.signal;

import java.util.Arrays;

/**
 * The derivative of a stream, late by {@link #delay()} samples: the ideal differentiator {@code Σ (-1)^(n+1) (x[k+n] -
 * x[k-n])/n},
 * tapered by Kaiser's window. True within 0.1 % up to 0.4 of the sampling rate, where a plain central difference has lost 3/4.
 *
 * <p>Whatever is missing (NaN) within its reach makes the derivative NaN. Nothing is allocated for a sample.
 */
public final class Differentiator {

    private static final int REACH = 20;
    private static final double BETA = 10;

    private final double[] taps = new double[REACH];
    private final double[] ring = new double[2 * REACH + 1];
    private int head;

    /**
     * A differentiator to which all samples before the first are missing.
     *
     * @param rate samples per second [Hz], &gt; 0
     */
    public Differentiator(double rate) {
        if (!(rate > 0) || Double.isInfinite(rate)) {
            throw new IllegalArgumentException("sampling rate must be > 0 Hz: " + rate);
        }
        for (int n = 1; n <= REACH; n++) {
            double place = n / (REACH + 1.0);
            double taper = KaiserSinc.besselI0(BETA * Math.sqrt(1 - place * place)) / KaiserSinc.besselI0(BETA);
            taps[n - 1] = (n % 2 == 0 ? -1 : 1) * taper / n * rate;
        }
        Arrays.fill(ring, Double.NaN);
    }

    /** Samples by which the derivative comes late. */
    public int delay() {
        return REACH;
    }

    /** Takes a sample and gives the derivative [unit/s] of {@link #delay()} samples ago; NaN before the first. */
    public double accept(double value) {
        ring[head] = value;
        head = head + 1 == ring.length ? 0 : head + 1;
        // The ring's oldest sample stands at the head, the middle one REACH further on.
        double sum = 0;
        for (int n = 1; n <= REACH; n++) {
            sum += taps[n - 1] * (ring[(head + REACH + n) % ring.length] - ring[(head + REACH - n) % ring.length]);
        }
        return sum;
    }
}
