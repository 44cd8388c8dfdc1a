package wbv.filter.model;

import java.io.Serializable;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * How the motion since the start, and with it the output, depends on each parameter of a body: {@code s = ∂x/∂θ} follows
 * {@code s ← E s + ∂g/∂θ}. What the output is not sensitive to just now, nothing can be learned about; nor from an input that
 * is mostly its sensor's noise, to which the output is sensitive too.
 */
public final class Sensitivity implements Serializable, Snapshot {

    private static final long serialVersionUID = 1;

    private final BodyModel model;
    private final double forgetting;
    /** Of the power. */
    private final double least;
    private final double[] v;
    private final double[] w;
    private final double[] power;
    private final double[] slopes;
    private final double[] row;
    private final boolean[] free;

    /**
     * Nothing felt yet.
     *
     * @param model with slopes; the caller sets and moves it
     * @param spec rate, noise of the sensors and adaptation
     */
    public Sensitivity(BodyModel model, Spec spec) {
        int n = model.parameters();
        this.model = model;
        Adaptation.Information information = spec.adaptation().information();
        this.forgetting = 1 / (information.sensitivityMemory() * spec.rate());
        this.least = information.sensitive() * information.sensitive() * spec.outputNoise() * spec.outputNoise();
        this.v = new double[n];
        this.w = new double[n];
        this.power = new double[n];
        this.slopes = new double[n];
        this.row = new double[model.states()];
        this.free = new boolean[n];
    }

    /** As new. */
    public void reset() {
        for (int i = 0; i < v.length; i++) {
            v[i] = 0;
            w[i] = 0;
            power[i] = 0;
            slopes[i] = 0;
            free[i] = false;
        }
    }

    /**
     * Follows the motion over a step.
     *
     * @param forced as {@link BodyModel#forced} of it, as long, in the states' unit. Not modified.
     */
    public void advance(double[] forced) {
        for (int i = 0; i < row.length; i++) {
            int at = 2 * i - i % 2; // the parameter's derivatives of v and of w lie two apart
            double[] e = model.step(i / 2).transition();
            double next = e[0] * v[i] + e[1] * w[i] + forced[at];
            w[i] = e[2] * v[i] + e[3] * w[i] + forced[at + 2];
            v[i] = next;
        }
    }

    /**
     * Hears the output after the step.
     *
     * @param xi ξ after the step, in its own units, n long. Not modified.
     * @param hold whether nothing is to be estimated just now, or nothing excites the body
     */
    public void hear(double[] xi, boolean hold) {
        model.outputRow(row);
        for (int i = 0; i < v.length; i++) {
            double slope = model.outputSlope(i, xi);
            if (i < row.length) {
                int first = i - i % 2;
                slope = row[first] * v[i] + row[first + 1] * w[i] + slope;
            }
            slopes[i] = slope;
            power[i] += forgetting * (slope * slope - power[i]);
            free[i] = !hold && power[i] > least;
        }
    }

    /** Whether the last second could tell about a parameter. */
    public boolean free(int parameter) {
        return free[parameter];
    }

    /** How much the last output depends on a parameter, the motion since the start included, in the output's unit. */
    public double slope(int parameter) {
        return slopes[parameter];
    }

    /** Whether the last second could tell about any parameter. */
    public boolean informed() {
        for (boolean f : free) {
            if (f) {
                return true;
            }
        }
        return false;
    }

    /** ∂v/∂θ of the parameter's mode, in the states' unit; 0 where a parameter belongs to none. */
    public double v(int parameter) {
        return v[parameter];
    }

    /** ∂w/∂θ, in the states' unit. */
    public double w(int parameter) {
        return w[parameter];
    }

    @Override
    public void save(StateWriter out) {
        out.put(v);
        out.put(w);
        out.put(power);
        out.put(free);
    }

    @Override
    public void load(StateReader in) {
        in.numbers(v);
        in.numbers(w);
        in.numbers(power);
        in.flags(free);
    }
}
