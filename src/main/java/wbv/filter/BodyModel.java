package wbv.filter;

import java.io.Serializable;

/**
 * A linear body on a shaken base, at one set of parameters. The body is a sum of modes, each {@link OneDegree}.
 *
 * <p>An estimate is one vector {@code ξ = [motion, parameters, offset]}: two states a mode, then {@link #parameters} numbers,
 * then the offset between two sensors. A model reads its parameters from ξ when it is {@link #set}, and motion from it
 * otherwise.
 */
sealed interface BodyModel extends Serializable permits OneDegree, SkyhookDegree, TwoDegrees {

    /** Modes of the body. Motion is two states for each. */
    int modes();

    /** Number of parameters: ln ω and ln ζ of each mode, then what else there is. */
    int parameters();

    /** Writes the parameters at the start into ξ. */
    void start(double[] xi);

    /** Takes the parameters of ξ. */
    void set(double[] xi);

    /** The same for the output alone: a step is not asked for before the next {@link #set}. */
    void setOutput(double[] xi);

    /** Transition and gains of a mode over one sampling interval. */
    ExactStep step(int mode);

    /** Output of the body at the motion of ξ. */
    double output(double[] xi);

    /** ∂y/∂state; depends on the parameters alone. @param row as long as the motion. Modified. */
    void outputRow(double[] row);

    /** ∂y/∂parameter, the motion of ξ held. */
    double outputSlope(int parameter, double[] xi);

    /** Whether the parameters of ξ are those of a body. */
    boolean sane(double[] xi);

    /** The share of the slower mode in the static output, 1 where it is alone. */
    double share(double[] xi);

    /** |H(f)| at the parameters of ξ. @param f [Hz] */
    double modulus(double f, double[] xi);

    default int states() {
        return 2 * modes();
    }

    /** Length of ξ. */
    default int size() {
        return states() + parameters() + 1;
    }

    /** Place of the offset in ξ. */
    default int offset() {
        return size() - 1;
    }

    /**
     * Moves the motion of ξ over one sampling interval.
     *
     * @param c coefficients of the input on it. Not modified.
     * @param xi Modified.
     */
    default void advance(double[] c, double[] xi) {
        for (int m = 0; m < modes(); m++) {
            ExactStep step = step(m);
            double[] e = step.transition();
            double v = e[0] * xi[2 * m] + e[1] * xi[2 * m + 1];
            double w = e[2] * xi[2 * m] + e[3] * xi[2 * m + 1];
            for (int j = 0; j < c.length; j++) {
                double[] g = step.gain(j);
                v += g[0] * c[j];
                w += g[1] * c[j];
            }
            xi[2 * m] = v;
            xi[2 * m + 1] = w;
        }
    }

    /** Derivative of a state after the step to a parameter of its mode, ln ω (0) or ln ζ (1), the state before held. */
    default double forced(int state, int parameter, double[] c, double[] xi) {
        int row = state % 2;
        int first = state - row;
        ExactStep step = step(state / 2);
        double[] de = step.transitionSlope(parameter);
        double sum = de[2 * row] * xi[first] + de[2 * row + 1] * xi[first + 1];
        for (int j = 0; j < c.length; j++) {
            sum += step.gainSlope(parameter, j)[row] * c[j];
        }
        return sum;
    }

    /** Natural frequency of a mode [Hz]. */
    default double frequency(int mode, double[] xi) {
        return Math.exp(xi[states() + 2 * mode]) / (2 * Math.PI);
    }

    /** Damping ratio of a mode. */
    default double damping(int mode, double[] xi) {
        return Math.exp(xi[states() + 2 * mode + 1]);
    }

    /** Whether frequency and damping of a mode lie within the bounds of {@link Spec}. */
    default boolean within(int mode, double[] xi) {
        double frequency = frequency(mode, xi);
        double damping = damping(mode, xi);
        return frequency >= Spec.LEAST_FREQUENCY && frequency <= Spec.MOST_FREQUENCY
                && damping >= Spec.LEAST_DAMPING && damping <= Spec.MOST_DAMPING;
    }
}
