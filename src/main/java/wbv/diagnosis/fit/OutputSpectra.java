package wbv.diagnosis.fit;

import java.util.Arrays;
import java.util.stream.IntStream;
import wbv.body.Spectra;
import wbv.body.simulate.Excitation;
import wbv.diagnosis.measured.AboveNoise;
import wbv.diagnosis.measured.Measured;
import wbv.recording.Quantity;

/** What is simulated for all outputs, beside what was measured there or by itself: as series, then as spectra in a window, whitened. */
public final class OutputSpectra {

    private final Measured measured;

    OutputSpectra(Measured measured) {
        this.measured = measured;
    }

    /**
     * Measured minus simulated, whitened.
     *
     * @param from what was simulated
     * @param simulated spectra by output. Not modified.
     */
    double[] residual(Excitation from, double[][] simulated, Whitening whitening) {
        double[][] spectra = new double[simulated.length][];
        for (int o = 0; o < spectra.length; o++) {
            double[] own = measured.series(o);
            double[] series = from.series(simulated[o]);
            for (int i = 0; i < series.length; i++) {
                series[i] = own[i] - series[i];
            }
            spectra[o] = spectrum(o, series, whitening.window());
        }
        return whitening.whiten(spectra);
    }

    /**
     * What an output reads beside what was simulated, by sample in its unit, less its mean; 0 where nothing was measured.
     *
     * @param from what was simulated
     * @param simulated a spectrum, in the output's unit. Not modified.
     */
    public double[] beside(Excitation from, int output, double[] simulated) {
        double[] out = from.series(simulated);
        double[] own = measured.series(output);
        boolean[] valid = measured.valid(output);
        double level = IntStream.range(0, out.length).filter(i -> valid[i]).mapToDouble(i -> own[i] - out[i]).average().orElse(0);
        for (int i = 0; i < out.length; i++) {
            out[i] = valid[i] ? own[i] - out[i] - level : 0;
        }
        return out;
    }

    /**
     * What an output reads but for noise, a spectrum in its unit: what was simulated, and what shows above its noise beside that. A new
     * array.
     *
     * @param from what was simulated
     * @param simulated a spectrum, in the output's unit. Not modified.
     */
    public double[] reading(Excitation from, int output, double[] simulated) {
        double[] out = simulated.clone();
        Spectra.add(out, AboveNoise.integral(from, from.spectrum(beside(from, output, simulated)), measured.noise()[output], 0), 1);
        return out;
    }

    /**
     * Simulated spectra times a factor, whitened like a residual [1], by output and line.
     *
     * @param from what was simulated
     * @param simulated spectra by output, in its unit; all zero where it changes nothing. Not modified.
     */
    public double[] whitened(Excitation from, double[][] simulated, double factor, Whitening whitening) {
        double[][] spectra = new double[simulated.length][0];
        for (int o = 0; o < spectra.length; o++) {
            if (Arrays.stream(simulated[o]).anyMatch(value -> value != 0)) {
                double[] series = from.series(simulated[o]);
                for (int i = 0; i < series.length; i++) {
                    series[i] *= factor;
                }
                spectra[o] = spectrum(o, series, whitening.window());
            }
        }
        return whitening.whiten(spectra);
    }

    /** @param series of an output. Modified. */
    private double[] spectrum(int output, double[] series, Window window) {
        boolean[] valid = measured.valid(output);
        if (isLevelled(output)) {
            level(series, valid, window);
        }
        return window.spectrum(series, valid);
    }

    /**
     * Takes the mean in a window.
     *
     * @param series Modified.
     */
    private static void level(double[] series, boolean[] valid, Window window) {
        double sum = 0;
        int counted = 0;
        for (int i = window.start(); i < window.start() + window.length(); i++) {
            sum += valid[i] ? series[i] : 0;
            counted += valid[i] ? 1 : 0;
        }
        double mean = counted == 0 ? 0 : sum / counted;
        for (int i = 0; i < series.length; i++) {
            series[i] -= mean;
        }
    }

    /**
     * Whether an output's constant part does not count: of a person's rate or place, which no sensor of acceleration knows, and where it
     * began is nobody's error. What bodies that turn by whole angles feel has a mean, too, which is taken from the recorded.
     */
    boolean isLevelled(int output) {
        Quantity quantity = measured.outputs().get(output).quantity();
        boolean isPlaceOrRate = quantity != Quantity.ACCELERATION && quantity != Quantity.FORCE;
        return !measured.onRig() && (isPlaceOrRate || measured.model().base().at().isPresent());
    }
}
