package wbv.fmi;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * A run of a unit that steps itself. Over a step it takes its inputs for constant, or for straight lines where it can; they are given so
 * that what it takes does what the recorded signal does, to second order of the step. Before outputs are read, the inputs are those of that
 * moment.
 */
final class CoSimulationRun extends Run {

    private final Optional<Instance.Interpolating> interpolating;

    /** @param interpolating the instance, where it takes derivatives of its inputs */
    CoSimulationRun(Instance instance, double rate, List<Variable> wired, List<InputSignal> signals, List<Variable> read,
            Optional<Instance.Interpolating> interpolating) {
        super(instance, rate, wired, signals, read);
        this.interpolating = interpolating;
    }

    @Override
    double[][] outputs(int samples, Fineness fineness) {
        double step = fineness.step();
        int every = Math.max(1, fineness.parts());
        int steps = fineness.steps(samples, rate);
        double[][] grid = new double[outputs.size][steps / every + 1];
        for (int k = 0; k <= steps; k++) {
            double time = k * step;
            if (k % every == 0) {
                set(signal -> signal.at(time));
                if (!read(grid, k / every)) {
                    return cut(grid, k / every);
                }
            }
            if (k < steps) {
                drive(time, step);
                instance.step(time, step);
            }
        }
        return fineness.parts() > 0 ? grid : interpolated(grid, step, samples);
    }

    private void drive(double time, double step) {
        if (interpolating.isPresent()) {
            set(signal -> signal.corner(time, step));
            prepare(signal -> (signal.corner(time + step, step) - signal.corner(time, step)) / step);
            interpolating.get().slopes(inputs);
        } else {
            set(signal -> signal.held(time, step));
        }
    }

    static double[][] cut(double[][] grid, int from) {
        for (double[] series : grid) {
            Arrays.fill(series, from, series.length, Double.NaN);
        }
        return grid;
    }

    /** Outputs between the unit's own steps, by cubics. */
    private double[][] interpolated(double[][] grid, double step, int samples) {
        double[][] out = new double[grid.length][samples];
        for (int s = 0; s < samples; s++) {
            double place = s / rate / step;
            int i = Math.max(1, Math.min(grid[0].length - 3, (int) place));
            for (int o = 0; o < grid.length; o++) {
                double[] y = grid[o];
                out[o][s] = y.length < 4 ? y[Math.min(y.length - 1, (int) Math.rint(place))]
                        : InputSignal.cubic(y[i - 1], y[i], y[i + 1], y[i + 2], place - i);
            }
        }
        return out;
    }
}
