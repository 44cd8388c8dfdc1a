package wbv.network;

import java.util.Arrays;
import java.util.List;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;

/**
 * Ridge regression on whole images (Hoerl and Kennard 1970): the least network, without a hidden layer. Solved in the
 * space of the trials, {@code w = Xᵀ (X Xᵀ + λI)⁻¹ y}, for there are more pixels than trials; λ is the one of a few that does best on
 * trials held back.
 */
public final class Ridge {

    private static final double[] PENALTIES = {1e1, 1e2, 1e3, 1e4, 1e5};

    private final Imaging imaging;
    private final Scaling scaling;
    private final double[][] weights;

    private Ridge(Imaging imaging, Scaling scaling, double[][] weights) {
        this.imaging = imaging;
        this.scaling = scaling;
        this.weights = weights;
    }

    /**
     * Fits damping ratio and frequency of every mode.
     *
     * @param held trials by which λ is chosen
     */
    public static Ridge fit(Imaging imaging, List<LabelledMotion> trials, List<LabelledMotion> held) {
        List<float[]> images = trials.stream().map(trial -> imaging.image(trial.motion())).toList();
        Scaling scaling = Scaling.of(images, trials);
        images.forEach(scaling::standardise);
        int n = images.size();
        int pixels = imaging.size();
        DMatrixRMaj x = new DMatrixRMaj(n, pixels);
        DMatrixRMaj y = new DMatrixRMaj(n, scaling.targets());
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < pixels; j++) {
                x.data[i * pixels + j] = images.get(i)[j];
            }
            for (int j = 0; j < scaling.targets(); j++) {
                y.set(i, j, (trials.get(i).truth()[j] - scaling.mean()[j]) / scaling.deviation()[j]);
            }
        }
        DMatrixRMaj gram = new DMatrixRMaj(n, n);
        CommonOps_DDRM.multOuter(x, gram);
        Ridge best = new Ridge(imaging, scaling, new double[0][]);
        double least = Double.POSITIVE_INFINITY;
        for (double penalty : PENALTIES) {
            DMatrixRMaj penalised = gram.copy();
            for (int i = 0; i < n; i++) {
                penalised.add(i, i, penalty);
            }
            LinearSolverDense<DMatrixRMaj> solver = LinearSolverFactory_DDRM.symmPosDef(n);
            DMatrixRMaj dual = new DMatrixRMaj(n, scaling.targets());
            if (!solver.setA(penalised)) {
                continue;
            }
            solver.solve(y, dual);
            DMatrixRMaj w = new DMatrixRMaj(pixels, scaling.targets());
            CommonOps_DDRM.multTransA(x, dual, w);
            double[][] weights = new double[scaling.targets()][pixels];
            for (int j = 0; j < scaling.targets(); j++) {
                for (int i = 0; i < pixels; i++) {
                    weights[j][i] = w.get(i, j);
                }
            }
            Ridge candidate = new Ridge(imaging, scaling, weights);
            double error = candidate.error(held);
            if (error < least) {
                least = error;
                best = candidate;
            }
        }
        return best;
    }

    private double error(List<LabelledMotion> trials) {
        double sum = 0;
        for (LabelledMotion trial : trials) {
            double[] value = read(trial.motion()).value();
            for (int j = 0; j < value.length; j++) {
                sum += Math.pow((value[j] - trial.truth()[j]) / scaling.deviation()[j], 2);
            }
        }
        return sum;
    }

    /**
     * The body of one window, without deviations: they are NaN.
     *
     * @param motion channels as those learned from, by channel and sample, each in its own unit, {@value Imaging#SAMPLES} samples. Not
     *               modified.
     */
    public Estimate read(double[][] motion) {
        float[] image = imaging.image(motion);
        scaling.standardise(image);
        double[] value = new double[weights.length];
        double[] unknown = new double[weights.length];
        Arrays.fill(unknown, Double.NaN);
        for (int j = 0; j < weights.length; j++) {
            for (int i = 0; i < image.length; i++) {
                value[j] += weights[j][i] * image[i];
            }
            value[j] = scaling.mean()[j] + scaling.deviation()[j] * value[j];
        }
        return new Estimate(value, unknown);
    }
}
