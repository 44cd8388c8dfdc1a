package wbv.filter;

import java.io.Serializable;
import wbv.filter.model.BodyModel;
import wbv.filter.model.InputWindow;
import wbv.filter.model.ModeStep;
import wbv.filter.model.Spec;

/** Steps and outputs of many particles of one body: made when a particle's parameters change, used at every sample. */
final class ParticleSteps implements Serializable {

    private static final long serialVersionUID = 1;
    private static final int EACH = 4 + 2 * InputWindow.POINTS;

    private final BodyModel model;
    private final int modes;
    private final double[][] step;
    private final double[][] row;

    ParticleSteps(BodyModel model, int count) {
        this.model = model;
        this.modes = model.modes();
        this.step = new double[count][modes * EACH];
        this.row = new double[count][2 * modes];
    }

    /**
     * Confines the parameters of a particle to those of a body, and takes its step.
     *
     * @param xi Modified.
     */
    void take(int particle, double[] xi) {
        for (int m = 0; m < modes; m++) {
            int i = 2 * modes + 2 * m;
            xi[i] = clamp(xi[i], 2 * Math.PI * Spec.LEAST_FREQUENCY, 2 * Math.PI * Spec.MOST_FREQUENCY);
            xi[i + 1] = clamp(xi[i + 1], Spec.LEAST_DAMPING, Spec.MOST_DAMPING);
        }
        model.set(xi);
        model.outputRow(row[particle]);
        double[] to = step[particle];
        for (int m = 0; m < modes; m++) {
            ModeStep exact = model.step(m);
            System.arraycopy(exact.transition(), 0, to, m * EACH, 4);
            System.arraycopy(exact.gains(), 0, to, m * EACH + 4, 2 * InputWindow.POINTS);
        }
    }

    private static double clamp(double log, double least, double most) {
        return Math.max(Math.log(least), Math.min(Math.log(most), log));
    }

    /**
     * Moves a particle over one sampling interval.
     * Thesis: Eq. 5-7, 5-12.
     *
     * @param c     coefficients of the input. Not modified.
     * @param noise of the input over the interval
     * @param xi    Modified.
     * @return the particle's output, offset not counted
     */
    double advance(int particle, double[] c, double noise, double[] xi) {
        double[] s = step[particle];
        double[] h = row[particle];
        double y = 0;
        for (int m = 0; m < modes; m++) {
            int at = m * EACH;
            double v = s[at] * xi[2 * m] + s[at + 1] * xi[2 * m + 1] + s[at + 4] * noise;
            double w = s[at + 2] * xi[2 * m] + s[at + 3] * xi[2 * m + 1] + s[at + 5] * noise;
            for (int j = 0; j < InputWindow.POINTS; j++) {
                v += s[at + 4 + 2 * j] * c[j];
                w += s[at + 5 + 2 * j] * c[j];
            }
            xi[2 * m] = v;
            xi[2 * m + 1] = w;
            y += h[2 * m] * v + h[2 * m + 1] * w;
        }
        return y;
    }
}
