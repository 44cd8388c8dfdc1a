package wbv.diagnosis.fit;

import java.util.function.IntToDoubleFunction;
import wbv.body.Spectra;
import wbv.body.simulate.Simulator;

/**
 * What delays make of spectra.
 *
 * @param factors by output, complex; empty for one that is not late
 */
public record Lateness(double[][] factors) {

    /** The outputs of a run, spectra by output in its unit: what a sensor's other channels make of it was recorded late already. */
    public double[][] of(Simulator.Response response) {
        double[][] out = of(response.outputs());
        for (int o = 0; o < out.length; o++) {
            double[] recorded = response.recorded()[o];
            double[] twice = recorded.length == 0 || factors[o].length == 0 ? new double[0] : Spectra.product(recorded, factors[o]);
            for (int k = 0; k < twice.length; k++) {
                out[o][k] += recorded[k] - twice[k];
            }
        }
        return out;
    }

    /**
     * What late sensors read of it, spectra by output in its unit.
     *
     * @param simulated spectra by output in its unit. Not modified.
     */
    public double[][] of(double[][] simulated) {
        double[][] out = simulated.clone();
        for (int o = 0; o < out.length; o++) {
            out[o] = factors[o].length == 0 ? out[o] : Spectra.product(out[o], factors[o]);
        }
        return out;
    }

    /**
     * What a gain and a delay make of each line, a spectrum.
     *
     * @param omega frequency of a line [rad/s]
     * @param gain [1]
     * @param delay [s]
     */
    static double[] factor(int lines, IntToDoubleFunction omega, double gain, double delay) {
        double[] out = new double[2 * lines];
        for (int k = 0; k < lines; k++) {
            out[2 * k] = gain * Math.cos(omega.applyAsDouble(k) * delay);
            out[2 * k + 1] = -gain * Math.sin(omega.applyAsDouble(k) * delay);
        }
        return out;
    }
}
