package wbv.pole;

import java.util.Optional;
import wbv.signal.CrossSpectrum;
import wbv.signal.Detrend;
import wbv.signal.FrequencyResponse;
import wbv.signal.Segmentation;

/**
 * The peak of a measured transmissibility.
 *
 * @param frequency [Hz] @param magnitude ratio
 */
public record Peak(double frequency, double magnitude) {

    private static final double LOW = 2;
    private static final double HIGH = 9;
    private static final int SEGMENT = 512;

    /** H1 from one signal to another, which starts after so many samples. Signals are as long as each other; NaN is missing. */
    public static FrequencyResponse response(double[] u, double[] y, int from, double rate) {
        CrossSpectrum spectrum = new CrossSpectrum(new Segmentation(rate, SEGMENT, 0.75), Detrend.MEAN, 1);
        for (int k = from; k < u.length; k++) {
            spectrum.accept(u[k], y[k]);
        }
        return spectrum.response(0, FrequencyResponse.Excited.USUAL);
    }

    /** The highest bin of |H1| from 2 to 9 Hz that is excited, refined by the parabola through it and its neighbours. */
    public static Optional<Peak> of(FrequencyResponse response) {
        int best = -1;
        for (int k = 1; k + 1 < response.frequency().length; k++) {
            double f = response.frequency()[k];
            if (f >= LOW && f <= HIGH && response.usable()[k]
                    && (best < 0 || response.h1().magnitude(k) > response.h1().magnitude(best))) {
                best = k;
            }
        }
        if (best < 1) {
            return Optional.empty();
        }
        double a = response.h1().magnitude(best - 1);
        double b = response.h1().magnitude(best);
        double c = response.h1().magnitude(best + 1);
        double bend = a - 2 * b + c;
        double shift = bend < 0 ? Math.max(-0.5, Math.min(0.5, (a - c) / (2 * bend))) : 0;
        return Optional.of(new Peak(response.frequency()[best] + shift * (response.frequency()[1] - response.frequency()[0]),
                b - (a - c) * shift / 4));
    }
}
