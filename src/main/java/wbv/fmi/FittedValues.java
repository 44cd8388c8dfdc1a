package wbv.fmi;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.interfaces.decomposition.EigenDecomposition_F64;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;

/**
 * Tunable parameters with which a unit comes nearest to a recording, by Gauss and Newton's method with Marquardt's damping, of the
 * likelihood of white residuals whose levels are not known. The first tenth, five seconds at most, does not count, since the unit begins at
 * rest and the recording in motion; a constant of each output does not count either. Each parameter is held to its start value as by a
 * measurement that is off by half of it. What the recording does not tell (accelerations: a factor on all masses, stiffness and damping) is
 * chosen so that few parameters change, and counts as known.
 *
 * <p>Standard deviations are those of blocks of the gradient (White 1980), so that what the residuals have of colour is counted.
 *
 * @param given  start values
 * @param values fitted
 * @param std standard deviations
 * @param before root mean square of recorded less simulated over that of recorded, by channel, on the data of the fit, with start values
 * @param after  the same with fitted values
 */
public record FittedValues(Map<String, Double> given, Map<String, Double> values, Map<String, Double> std, Map<Channel, Double> before,
        Map<Channel, Double> after) {

    private static final double KNOWN = 0.5;
    private static final int ROUNDS = 8;
    private static final int TRIALS = 6;
    private static final double SETTLED = 1e-4;
    private static final double LEAST = 0.05;
    private static final double WARMING = 5;
    private static final int BLOCKS = 24;
    /** How much more than what is known beforehand a recording must say of a combination of parameters to tell it. */
    private static final double TOLD = 10;
    private static final int PASSES = 3;

    /**
     * Fits all tunable parameters.
     *
     * @param samples of the recording, from its start, that are fitted
     * @param progress told the step and its share
     * @throws DataFault if there is no tunable parameter, or no output was recorded
     */
    public static FittedValues of(FmuSimulation simulation, Recording recording, int samples, BiConsumer<String, Double> progress) {
        return new Fit(simulation, recording, samples).fitted(progress);
    }

    /** Parameters that were moved by more than twice what they may be off. */
    public List<String> moved() {
        return values.keySet().stream().filter(each -> Math.abs(values.get(each) - given.get(each)) > 2 * std.get(each)).toList();
    }

    /** A fit under way; parameters are counted in their start values. */
    private static final class Fit {

        private final FmuSimulation simulation;
        private final List<String> names;
        private final double[] scale;
        private final double[] given;
        private final int[] outputs;
        private final double[][] recorded;
        private final List<Channel> channels;
        private final int first;
        private final int samples;

        Fit(FmuSimulation simulation, Recording recording, int samples) {
            this.simulation = simulation;
            this.samples = samples;
            names = List.copyOf(simulation.parameters().keySet());
            outputs = IntStream.range(0, simulation.outputs().size()).filter(o -> recording.has(simulation.outputs().get(o))).toArray();
            channels = Arrays.stream(outputs).mapToObj(o -> simulation.outputs().get(o)).toList();
            if (names.isEmpty() || outputs.length == 0) {
                throw new DataFault(names.isEmpty() ? "the simulation has no tunable parameter"
                        : "none of the simulation's outputs " + simulation.outputs()
                                + " was recorded");
            }
            scale = names.stream().mapToDouble(simulation::scale).toArray();
            given = names.stream().mapToDouble(simulation.parameters()::get).toArray();
            recorded = channels.stream().map(recording::values).toArray(double[][]::new);
            first = (int) Math.min(samples / 10, WARMING * recording.clock().rate());
        }

        /**
         * Where a fit stands.
         *
         * @param x changes in units of the scale
         * @param residual by channel, recorded less simulated, its mean taken away; NaN where missing
         */
        private record Stand(double[] x, double[][] simulated, double[][] residual, double cost) {}

        private Map<String, Double> values(double[] x) {
            Map<String, Double> out = new LinkedHashMap<>();
            IntStream.range(0, x.length).forEach(p -> out.put(names.get(p), given[p] + scale[p] * x[p]));
            return out;
        }

        private Stand stand(double[] x) {
            Recording run = simulation.run(values(x), samples);
            double[][] simulated = simulation.outputs().stream().map(run::values).toArray(double[][]::new);
            double[][] residual = new double[outputs.length][];
            double cost = 0;
            for (int c = 0; c < outputs.length; c++) {
                double[] model = simulated[outputs[c]];
                double[] truth = recorded[c];
                residual[c] = levelled(IntStream.range(first, samples).mapToDouble(i -> truth[i] - model[i]).toArray());
                cost += count(residual[c]) * Math.log(rms(residual[c]));
            }
            for (double each : x) {
                cost += each * each / (2 * KNOWN * KNOWN);
            }
            return new Stand(x, simulated, residual, cost);
        }

        private static double[] levelled(double[] x) {
            double mean = Arrays.stream(x).filter(value -> !Double.isNaN(value)).average().orElse(0);
            return Arrays.stream(x).map(value -> value - mean).toArray();
        }

        private static long count(double[] x) {
            return Arrays.stream(x).filter(value -> !Double.isNaN(value)).count();
        }

        private static double rms(double[] x) {
            return Math.sqrt(Arrays.stream(x).filter(value -> !Double.isNaN(value)).map(value -> value * value).average().orElse(0))
                    + Double.MIN_NORMAL;
        }

        FittedValues fitted(BiConsumer<String, Double> progress) {
            Stand start = stand(new double[names.size()]);
            Stand now = start;
            double damping = 1e-3;
            DMatrixRMaj[][] parts = parts(now, false);
            for (int round = 0; round < ROUNDS; round++) {
                progress.accept("fitting the simulation", (double) round / ROUNDS);
                Stand next = now;
                for (int trial = 0; trial < TRIALS && next == now; trial++) {
                    Stand tried = tried(now, parts, damping);
                    if (tried.cost() < now.cost()) {
                        next = tried;
                        damping /= 10;
                    } else {
                        damping *= 10;
                    }
                }
                boolean settled = now.cost() - next.cost() < Math.max(SETTLED * names.size(), 1e-12 * Math.abs(now.cost()));
                if (next != now) {
                    now = next;
                    parts = parts(now, false);
                }
                if (settled) {
                    break;
                }
            }
            // Differences to one side would seem to tell what only the curvature does.
            parts = parts(now, true);
            Told told = told(parts);
            Stand last = stand(told.sparsest(now.x()));
            return new FittedValues(values(start.x()), values(last.x()), std(parts, told), errors(start), errors(last));
        }

        /** A damped step; one that the unit cannot simulate is as bad as can be. */
        private Stand tried(Stand now, DMatrixRMaj[][] parts, double damping) {
            DMatrixRMaj normal = sum(parts, 0);
            DMatrixRMaj gradient = sum(parts, 1);
            int n = names.size();
            for (int p = 0; p < n; p++) {
                normal.add(p, p, damping * normal.get(p, p) + 1 / (KNOWN * KNOWN));
                gradient.add(p, 0, -now.x()[p] / (KNOWN * KNOWN));
            }
            DMatrixRMaj step = new DMatrixRMaj(n, 1);
            if (!CommonOps_DDRM.solve(normal, gradient, step)) {
                return new Stand(now.x(), now.simulated(), now.residual(), Double.POSITIVE_INFINITY);
            }
            double[] x = new double[n];
            for (int p = 0; p < n; p++) {
                x[p] = now.x()[p] + Math.max(-KNOWN, Math.min(KNOWN, step.get(p, 0)));
                // Masses, springs and dampers have the sign that they were given.
                x[p] = given[p] == 0 ? x[p] : Math.signum(given[p]) > 0 ? Math.max(x[p], LEAST - 1) : Math.min(x[p], 1 - LEAST);
            }
            try {
                return stand(x);
            } catch (DataFault impossible) {
                return new Stand(now.x(), now.simulated(), now.residual(), Double.POSITIVE_INFINITY);
            }
        }

        /** By block of time, the normal matrix and the gradient, weighed by the levels of the residuals. */
        private DMatrixRMaj[][] parts(Stand now, boolean exact) {
            int n = names.size();
            double[][][] slopes = exact ? simulation.sensitivities(values(now.x()), names, samples)
                    : simulation.slopes(values(now.x()), now.simulated(), names, samples);
            int length = samples - first;
            DMatrixRMaj[][] out = new DMatrixRMaj[BLOCKS][];
            for (int b = 0; b < BLOCKS; b++) {
                out[b] = new DMatrixRMaj[] {new DMatrixRMaj(n, n), new DMatrixRMaj(n, 1)};
            }
            for (int c = 0; c < outputs.length; c++) {
                double[] residual = now.residual()[c];
                double weight = 1 / Math.pow(rms(residual), 2);
                double[][] columns = new double[n][];
                for (int p = 0; p < n; p++) {
                    double[] own = slopes[p][outputs[c]];
                    double by = scale[p];
                    columns[p] = levelled(IntStream.range(first, samples).mapToDouble(i -> by * own[i]).toArray());
                }
                for (int i = 0; i < length; i++) {
                    if (Double.isNaN(residual[i])) {
                        continue;
                    }
                    DMatrixRMaj[] block = out[(int) ((long) i * BLOCKS / length)];
                    for (int p = 0; p < n; p++) {
                        double own = weight * columns[p][i];
                        block[1].data[p] += own * residual[i];
                        for (int q = 0; q < n; q++) {
                            block[0].data[p * n + q] += own * columns[q][i];
                        }
                    }
                }
            }
            return out;
        }

        private static DMatrixRMaj sum(DMatrixRMaj[][] parts, int which) {
            DMatrixRMaj out = parts[0][which].copy();
            for (int b = 1; b < parts.length; b++) {
                CommonOps_DDRM.addEquals(out, parts[b][which]);
            }
            return out;
        }

        /**
         * Which combinations of parameters the recording tells.
         *
         * @param inverse of the normal matrix in these, 0 in the others
         * @param others directions that it does not tell, of length 1
         */
        private record Told(DMatrixRMaj inverse, List<double[]> others) {

            /**
             * Moved along what is not told, so that the sum of all changes is least: then few parameters have changed, not all a little.
             */
            double[] sparsest(double[] x) {
                double[] out = x.clone();
                for (int pass = 0; pass < PASSES; pass++) {
                    for (double[] direction : others) {
                        int[] order = IntStream.range(0, out.length).filter(p -> Math.abs(direction[p]) > 1e-6).boxed()
                                .sorted(Comparator.comparingDouble(p -> -out[p] / direction[p])).mapToInt(p -> p).toArray();
                        double half = Arrays.stream(order).mapToDouble(p -> Math.abs(direction[p])).sum() / 2;
                        int at = 0;
                        for (double sum = Math.abs(direction[order[0]]); sum < half; sum += Math.abs(direction[order[at]])) {
                            at++;
                        }
                        double shift = -out[order[at]] / direction[order[at]];
                        IntStream.range(0, out.length).forEach(p -> out[p] += shift * direction[p]);
                    }
                }
                return out;
            }
        }

        private Told told(DMatrixRMaj[][] parts) {
            int n = names.size();
            EigenDecomposition_F64<DMatrixRMaj> eigen = DecompositionFactory_DDRM.eig(n, true, true);
            eigen.decompose(sum(parts, 0));
            DMatrixRMaj inverse = new DMatrixRMaj(n, n);
            List<double[]> others = new ArrayList<>();
            for (int k = 0; k < n; k++) {
                double information = eigen.getEigenvalue(k).getReal();
                DMatrixRMaj direction = eigen.getEigenVector(k);
                if (information > TOLD / (KNOWN * KNOWN)) {
                    CommonOps_DDRM.multAddTransB(1 / information, direction, direction, inverse);
                } else {
                    others.add(direction.data.clone());
                }
            }
            return new Told(inverse, others);
        }

        /** H⁻¹ (Σ g gᵀ) H⁻¹, and no less than the curvature says, of what the recording tells; the rest is as given. */
        private Map<String, Double> std(DMatrixRMaj[][] parts, Told told) {
            int n = names.size();
            DMatrixRMaj mean = sum(parts, 1);
            CommonOps_DDRM.scale(1.0 / BLOCKS, mean);
            DMatrixRMaj scatter = new DMatrixRMaj(n, n);
            for (DMatrixRMaj[] part : parts) {
                DMatrixRMaj g = new DMatrixRMaj(n, 1);
                CommonOps_DDRM.subtract(part[1], mean, g);
                CommonOps_DDRM.multAddTransB(g, g, scatter);
            }
            DMatrixRMaj half = new DMatrixRMaj(n, n);
            DMatrixRMaj whole = new DMatrixRMaj(n, n);
            CommonOps_DDRM.mult(told.inverse(), scatter, half);
            CommonOps_DDRM.mult(half, told.inverse(), whole);
            Map<String, Double> out = new LinkedHashMap<>();
            for (int p = 0; p < n; p++) {
                out.put(names.get(p), scale[p] * Math.sqrt(Math.max(whole.get(p, p), told.inverse().get(p, p))));
            }
            return out;
        }

        private Map<Channel, Double> errors(Stand stand) {
            Map<Channel, Double> out = new LinkedHashMap<>();
            for (int c = 0; c < outputs.length; c++) {
                out.put(channels.get(c), rms(stand.residual()[c]) / rms(levelled(Arrays.copyOfRange(recorded[c], first, samples))));
            }
            return out;
        }
    }
}
