package wbv.diagnosis.convention;

import java.util.Arrays;
import java.util.stream.IntStream;
import wbv.body.simulate.Excitation;
import wbv.signal.LostSamples;
import wbv.signal.RealDft;

/**
 * What of a recording is looked at, as spectra under a Hann window: all outputs where all of them were read, slow drift left out, which
 * integrated noise makes.
 */
final class Stretch {

    /** Periods of the slowest line that counts. */
    private static final int FIRST = 8;
    /** Highest frequency over the rate, as that of an {@link Excitation}. */
    private static final double HIGH = 0.44;

    private final double[] taper;
    private final RealDft transform;
    private final int last;

    /** @param present samples at which all channels were read. Not modified. */
    Stretch(boolean[] present) {
        int n = RealDft.fitting(present.length);
        transform = new RealDft(n);
        taper = IntStream.range(0, n).mapToDouble(i -> present[i] ? 0.5 - 0.5 * Math.cos(2 * Math.PI * (i + 0.5) / n) : 0).toArray();
        last = (int) (HIGH * n);
    }

    /** Number of lines that count. */
    int lines() {
        return last - FIRST + 1;
    }

    /**
     * Spectrum of a series in its unit but for a factor that is the same for all, real and imaginary part of each line in turn.
     *
     * @param series at least as long as the window, gaps bridged. Not modified.
     */
    double[] spectrum(double[] series) {
        double[] x = Arrays.copyOf(LostSamples.filled(series), taper.length);
        double mean = IntStream.range(0, x.length).filter(i -> taper[i] > 0).mapToDouble(i -> x[i]).average().orElse(0);
        for (int i = 0; i < x.length; i++) {
            x[i] = taper[i] * (x[i] - mean);
        }
        return Arrays.copyOfRange(transform.forward(x, last + 1), 2 * FIRST, 2 * (last + 1));
    }

    /**
     * How many lines hold a spectrum's power: (Σ P)²/Σ P² of its lines' powers, twice since they scatter themselves.
     *
     * @param spectrum of any unit. Not modified.
     */
    static double parts(double[] spectrum) {
        double sum = 0;
        double square = 0;
        for (int k = 0; k < spectrum.length; k += 2) {
            double power = spectrum[k] * spectrum[k] + spectrum[k + 1] * spectrum[k + 1];
            sum += power;
            square += power * power;
        }
        return square > 0 ? 2 * sum * sum / square : 0;
    }
}
