package wbv.pole;

import java.util.Optional;
import org.apache.commons.math3.fitting.PolynomialCurveFitter;
import org.apache.commons.math3.fitting.WeightedObservedPoints;
import wbv.signal.CrossSpectrum;
import wbv.signal.Detrend;
import wbv.signal.FrequencyResponse;
import wbv.signal.Segmentation;

/**
 * The peak of a measured transmissibility.
 *
 * @param frequency [Hz]
 * @param magnitude ratio
 */
public record TransmissibilityPeak(double frequency, double magnitude) {

    private static final double LOW = 2;
    private static final double HIGH = 9;
    private static final int SEGMENT = 512;
    private static final double REACH = 1.5;
    private static final double STEP = 0.25;
    private static final int FEWEST = 6;
    private static final int ROUNDS = 5;

    /**
     * H1 from one signal to another, after so many samples, at a rate [Hz]. Signals are as long as each other; NaN is missing. Neither is
     * modified.
     *
     * @param u by sample, of any unit
     * @param y as long, of any unit
     */
    public static FrequencyResponse response(double[] u, double[] y, int from, double rate) {
        CrossSpectrum spectrum = new CrossSpectrum(new Segmentation(rate, SEGMENT, 0.75), Detrend.MEAN, 1);
        for (int k = from; k < u.length; k++) {
            spectrum.accept(u[k], y[k]);
        }
        return spectrum.response(0, FrequencyResponse.Excited.USUAL);
    }

    /**
     * The vertex of the parabola that fits |H1| best over {@value #REACH} Hz to both sides of its highest place from 2 to 9 Hz: a
     * sitter's resonance is so flat that its highest bin is chance. Bins that are not excited or not coherent do not count;
     * empty if too few are left, or they do not bend down.
     */
    public static Optional<TransmissibilityPeak> of(FrequencyResponse response) {
        double[] f = response.frequency();
        double centre = Double.NaN;
        double best = 0;
        for (double at = LOW; at <= HIGH; at += STEP) {
            double[] fit = parabola(response, at, REACH / 2);
            if (fit.length > 0 && fit[0] > best) {
                best = fit[0];
                centre = at;
            }
        }
        for (int again = 0; again < ROUNDS && Double.isFinite(centre); again++) {
            double[] fit = parabola(response, centre, REACH);
            if (fit.length == 0 || !(fit[2] < 0)) {
                return Optional.empty();
            }
            double shift = Math.max(-REACH / 2, Math.min(REACH / 2, -fit[1] / (2 * fit[2])));
            centre = Math.max(f[1], centre + shift);
            best = fit[0] + shift * (fit[1] + shift * fit[2]);
        }
        return Double.isFinite(centre) ? Optional.of(new TransmissibilityPeak(centre, best)) : Optional.empty();
    }

    /** Coefficients of 1, x and x², x = f - at, of |H1| within a reach; none if too few bins are usable. */
    private static double[] parabola(FrequencyResponse response, double at, double reach) {
        WeightedObservedPoints points = new WeightedObservedPoints();
        int count = 0;
        for (int k = 0; k < response.frequency().length; k++) {
            double x = response.frequency()[k] - at;
            if (Math.abs(x) <= reach && response.usable()[k]) {
                points.add(x, response.h1().magnitude(k));
                count++;
            }
        }
        return count < FEWEST ? new double[0] : PolynomialCurveFitter.create(2).fit(points.toList());
    }
}
