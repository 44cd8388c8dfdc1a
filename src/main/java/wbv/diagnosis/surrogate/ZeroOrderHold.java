package wbv.diagnosis.surrogate;

import java.util.Map;
import wbv.body.simulate.Excitation;
import wbv.signal.LostSamples;

/** An input that is constant over each sample, as some simulations take it: half a sample late, nearly. */
final class ZeroOrderHold {

    private ZeroOrderHold() {}

    /**
     * The series that does the same without being held. Its steps' higher frequencies are left out.
     *
     * @param values by sample, NaN where missing. Not modified.
     * @param rate   of samples [Hz]
     */
    static double[] of(double[] values, double rate) {
        Excitation whole = new Excitation(rate, LostSamples.filled(values), Map.of());
        double[] spectrum = whole.baseSpectrum().clone();
        for (int k = 0; k < whole.omega().length; k++) {
            double angle = whole.omega()[k] / (2 * rate);
            double re = spectrum[2 * k];
            double im = spectrum[2 * k + 1];
            spectrum[2 * k] = re * Math.cos(angle) + im * Math.sin(angle);
            spectrum[2 * k + 1] = im * Math.cos(angle) - re * Math.sin(angle);
        }
        return whole.series(spectrum);
    }
}
