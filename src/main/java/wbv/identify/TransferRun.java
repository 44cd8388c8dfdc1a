package wbv.identify;

import java.io.Serializable;

/**
 * A {@link TransferModel} running sample by sample, at rest at first, every input straight between its samples. It can be tuned
 * anew while it runs.
 */
public final class TransferRun implements Serializable {

    private static final long serialVersionUID = 1;

    private final double rate;
    private final int inputs;
    private final int n;
    private final double[][] z;
    private final double[][] weights;
    private final double[] direct;
    private final double[] before;
    private final double[] next;
    private CompanionForm filter;
    private boolean begun;

    /**
     * A run from rest.
     *
     * @param rate [Hz]
     */
    public TransferRun(TransferModel model, double rate) {
        this.rate = rate;
        this.inputs = model.b().length;
        this.n = model.a().length;
        this.z = new double[inputs][n];
        this.weights = new double[inputs][n];
        this.direct = new double[inputs];
        this.before = new double[inputs];
        this.next = new double[n];
        set(model);
    }

    /**
     * Goes on with another model of the same orders, whose time runs faster.
     *
     * @param factor new over old pulsation: the motion so far is kept in the model's own time
     */
    public void retune(TransferModel model, double factor) {
        set(model);
        for (double[] states : z) {
            for (int k = 0; k < n; k++) {
                states[k] *= Math.pow(factor, k - n);
            }
        }
    }

    private void set(TransferModel model) {
        if (model.a().length != n || model.b().length != inputs) {
            throw new IllegalArgumentException("the model must have " + n + " poles and " + inputs + " inputs: " + model.a().length + ", "
                    + model.b().length);
        }
        filter = new CompanionForm(model.a(), 1 / rate);
        for (int i = 0; i < inputs; i++) {
            double[] b = model.b()[i];
            direct[i] = b.length == n + 1 ? b[0] : 0;
            for (int k = 0; k < n; k++) {
                int at = b.length - 1 - k;
                weights[i][k] = (at >= 0 ? b[at] : 0) - direct[i] * model.a()[n - 1 - k];
            }
        }
    }

    /**
     * The output, in its unit, that goes with the next sample of the inputs. Changes nothing.
     *
     * @param u one an input, in its own unit. Not modified.
     */
    public double foresee(double[] u) {
        double y = 0;
        for (int i = 0; i < inputs; i++) {
            y += direct[i] * u[i];
            if (begun) {
                filter.advance(z[i], before[i], u[i], next);
                for (int k = 0; k < n; k++) {
                    y += weights[i][k] * next[k];
                }
            }
        }
        return y;
    }

    /**
     * The output, in its unit, that goes with the next sample of the inputs.
     *
     * @param u one an input, in its own unit. Not modified.
     */
    public double step(double[] u) {
        double y = 0;
        for (int i = 0; i < inputs; i++) {
            if (begun) {
                filter.advance(z[i], before[i], u[i], next);
                System.arraycopy(next, 0, z[i], 0, n);
            }
            y += direct[i] * u[i];
            for (int k = 0; k < n; k++) {
                y += weights[i][k] * z[i][k];
            }
            before[i] = u[i];
        }
        begun = true;
        return y;
    }
}
