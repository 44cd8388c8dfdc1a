package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import wbv.body.Assembly;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.InputWay;
import wbv.diagnosis.fit.Place;

/**
 * The noise of all outputs at the lines of an excitation, {@code S = diag(σ²) + Σ P g gᴴ} as {@link wbv.diagnosis.fit.Whitening} has it,
 * and products {@code xᴴ S⁻¹ y}, by the formula of Sherman and Morrison (1950) for one source after the other.
 */
public final class NoiseMetric {

    private final double[] variance;
    private final List<Source> sources = new ArrayList<>();

    /**
     * @param power by line
     * @param way to each output, spectra
     */
    private record Source(double[] power, double[][] way) {}

    /**
     * The metric of the noise that the evidence has found.
     *
     * @param assembly through which it reaches the outputs
     */
    public NoiseMetric(Evidence evidence, Excitation from, Assembly assembly) {
        variance = Arrays.stream(evidence.noise()).map(s -> s * s).toArray();
        double[] omega = from.omega();
        InputWay.of(evidence, from, assembly).stream().filter(input -> input.noise().deviation() > 0).forEach(input -> {
            double[] power = new double[omega.length];
            Arrays.setAll(power, k -> input.noise().power(omega[k]));
            sources.add(new Source(power, input.transfer().get()));
        });
        evidence.acting().all().forEach(force -> {
            double[] power = new double[omega.length];
            Arrays.setAll(power, k -> force.power(omega[k] / (2 * Math.PI)));
            sources.add(new Source(power, new Simulator(from).linearised(assembly).ofBodyForce(force.body())));
        });
    }

    /**
     * The metric that sees nothing of what enters at some places.
     *
     * @param places no devices, see {@link Place#each}
     */
    static NoiseMetric ignoring(Evidence evidence, Excitation from, Assembly assembly, List<Place> places) {
        NoiseMetric out = new NoiseMetric(evidence, from, assembly);
        double[] any = new double[from.omega().length];
        Arrays.fill(any, Double.POSITIVE_INFINITY);
        places.forEach(place -> out.sources.add(new Source(any, place.direction(from, assembly))));
        return out;
    }

    /** S at one line for one output: the variance of a sample of white noise as strong, in the square of the output's unit. */
    public double variance(int output, int line) {
        double sum = variance[output];
        for (Source source : sources) {
            double re = source.way()[output][2 * line];
            double im = source.way()[output][2 * line + 1];
            sum += source.power()[line] * (re * re + im * im);
        }
        return sum;
    }

    /**
     * xᴴ S⁻¹ y at one line [1].
     *
     * @param x spectra by output, in its unit
     * @param y likewise. Neither is modified.
     * @return two numbers, real and imaginary part
     */
    public double[] product(double[][] x, double[][] y, int line) {
        return product(x, y, line, sources.size());
    }

    private double[] product(double[][] x, double[][] y, int line, int count) {
        double[] out = new double[2];
        if (count == 0) {
            for (int o = 0; o < variance.length; o++) {
                double xr = x[o][2 * line];
                double xi = x[o][2 * line + 1];
                out[0] += (xr * y[o][2 * line] + xi * y[o][2 * line + 1]) / variance[o];
                out[1] += (xr * y[o][2 * line + 1] - xi * y[o][2 * line]) / variance[o];
            }
            return out;
        }
        Source last = sources.get(count - 1);
        double[] xy = product(x, y, line, count - 1);
        double[] xg = product(x, last.way(), line, count - 1);
        double[] gy = product(last.way(), y, line, count - 1);
        double known = 1 / last.power()[line] + product(last.way(), last.way(), line, count - 1)[0];
        double scale = known > 0 ? 1 / known : 0;
        out[0] = xy[0] - scale * (xg[0] * gy[0] - xg[1] * gy[1]);
        out[1] = xy[1] - scale * (xg[0] * gy[1] + xg[1] * gy[0]);
        return out;
    }
}
