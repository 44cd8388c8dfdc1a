package wbv.diagnosis.fit;

import wbv.signal.ScalarProduct;

/**
 * What a fit leaves, taken for something that enters along one direction: any signal, of which the direction says what it does to each
 * output.
 *
 * @param signal   likeliest spectrum of it in the direction's own unit, at the lines of the fit's window
 * @param variance of the real and of the imaginary part, by line, by the noise, in the square of that unit
 */
public record Entering(double[] signal, double[] variance) {

    /**
     * The signal that explains most.
     *
     * @param direction spectra at the excitation's lines, by output, per unit of what enters. Not modified.
     */
    public static Entering along(Evidence evidence, Fitter.State state, double[][] direction) {
        Window window = state.frame().whitening().window();
        double[] unit = unit(evidence, state, direction);
        double[] r = state.residual();
        double[] signal = new double[2 * window.lines()];
        double[] variance = new double[window.lines()];
        for (int line = 0; line < window.lines(); line++) {
            double size = 0;
            for (int i = 2 * line; i < r.length; i += 2 * window.lines()) {
                size += unit[i] * unit[i] + unit[i + 1] * unit[i + 1];
                signal[2 * line] += unit[i] * r[i] + unit[i + 1] * r[i + 1];
                signal[2 * line + 1] += unit[i] * r[i + 1] - unit[i + 1] * r[i];
            }
            // Where a direction shows in no output nothing is known of what enters along it.
            signal[2 * line] /= size > 0 ? size : 1;
            signal[2 * line + 1] /= size > 0 ? size : 1;
            variance[line] = 1 / size;
        }
        return new Entering(signal, variance);
    }

    /**
     * Mean square of the whitened residual that is left when such a signal is taken out.
     *
     * @param direction as for {@link #along}, spectra by output, per unit of what enters. Not modified.
     */
    public static double left(Evidence evidence, Fitter.State state, double[][] direction) {
        Whitening whitening = state.frame().whitening();
        Entering entering = along(evidence, state, direction);
        double[] r = state.residual();
        double sum = ScalarProduct.of(r, r);
        for (int line = 0; line < entering.variance().length; line++) {
            double re = entering.signal()[2 * line];
            double im = entering.signal()[2 * line + 1];
            sum -= (re * re + im * im) / entering.variance()[line];
        }
        return sum / (whitening.degrees() - 2.0 * whitening.window().lines());
    }

    /**
     * How much more of the whitened residual's sum of squares than noise lies along a direction, at least 0.
     *
     * @param direction as for {@link #along}, spectra by output, per unit of what enters. Not modified.
     */
    public static double beyondNoise(Evidence evidence, Fitter.State state, double[][] direction) {
        Whitening whitening = state.frame().whitening();
        if (evidence.outputs().size() == 1 || evidence.model().driven()) {   // there is but one direction
            return Math.max(0, state.square() - whitening.degrees());
        }
        double lines = 2.0 * whitening.window().lines();
        double rest = left(evidence, state, direction) * (whitening.degrees() - lines);
        return Math.max(0, state.square() - rest - lines);
    }

    /** A direction at the lines of the fit's window, as sensors with the fit's errors read it, whitened. */
    static double[] unit(Evidence evidence, Fitter.State state, double[][] direction) {
        Whitening whitening = state.frame().whitening();
        double[][] way = whitening.window().lines(evidence.excitation().omega(), direction);
        return whitening.whiten(state.frame().nuisances().seen(way, state.errors()));
    }
}
