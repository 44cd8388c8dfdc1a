package wbv.filter.model;

import java.io.Serializable;

/**
 * A linear body on a shaken base, at one set of parameters. The body is a sum of modes, each {@link OneDegree}.
 *
 * <p>An estimate is one vector {@code ξ = [motion, parameters, offset]}: two states a mode, then {@link #parameters} numbers, then the
 * offset between two sensors: n numbers, each in a unit of its own. A model reads its parameters from ξ when it is {@link #set}, and motion
 * from it otherwise.
 */
public sealed interface BodyModel extends Serializable permits OneDegree, SkyhookDegree, TwoDegrees {

    /** Least ln ω and ln ζ, ω in rad/s. */
    double[] LEAST = {Math.log(2 * Math.PI * Spec.LEAST_FREQUENCY), Math.log(Spec.LEAST_DAMPING)};
    /** Greatest ln ω and ln ζ. */
    double[] MOST = {Math.log(2 * Math.PI * Spec.MOST_FREQUENCY), Math.log(Spec.MOST_DAMPING)};

    /** Modes of the body. Motion is two states for each. */
    int modes();

    /** Number of parameters: ln ω and ln ζ of each mode, then what else there is. */
    int parameters();

    /**
     * Writes the parameters at the start into ξ.
     *
     * @param xi ξ in its own units, n long. Modified.
     */
    void start(double[] xi);

    /**
     * Takes the parameters of ξ.
     *
     * @param xi ξ in its own units, n long. Not modified.
     */
    void set(double[] xi);

    /**
     * The same for the output alone: a step is not asked for before the next {@link #set}.
     *
     * @param xi ξ in its own units, n long. Not modified.
     */
    void setOutput(double[] xi);

    /** Transition and gains of a mode over one sampling interval. */
    ModeStep step(int mode);

    /**
     * Output of the body at the motion of ξ [m/s² or rad/s].
     *
     * @param xi ξ in its own units, n long. Not modified.
     */
    double output(double[] xi);

    /**
     * ∂y/∂state [1/s]; depends on the parameters alone.
     *
     * @param row [1/s], as long as the motion. Modified.
     */
    void outputRow(double[] row);

    /**
     * ∂y/∂parameter, the motion of ξ held, in the output's unit.
     *
     * @param xi ξ in its own units, n long. Not modified.
     */
    double outputSlope(int parameter, double[] xi);

    /**
     * Whether the parameters of ξ are those of a body.
     *
     * @param xi ξ in its own units, n long. Not modified.
     */
    boolean sane(double[] xi);

    /**
     * The share of the slower mode in the static output, 1 where it is alone.
     *
     * @param xi ξ in its own units, n long. Not modified.
     */
    double share(double[] xi);

    /**
     * |H(f)| at the parameters of ξ [1].
     *
     * @param f [Hz]
     * @param xi ξ in its own units, n long. Not modified.
     */
    double modulus(double f, double[] xi);

    /** Length of the motion: two states a mode. */
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
     * Thesis: Eq. 4-1.
     *
     * @param c      coefficients of the input on it, in the input's unit, {@link InputWindow#POINTS} long. Not modified.
     * @param points how many of them are not zero
     * @param xi     ξ in its own units, n long. Modified.
     */
    default void advance(double[] c, int points, double[] xi) {
        for (int m = 0; m < modes(); m++) {
            step(m).move(c, points, xi, 2 * m);
        }
    }

    /**
     * Derivatives of the motion after the step to ln ω and ln ζ of its own mode, the motion before held.
     *
     * @param c    coefficients of the input, in its own unit, {@link InputWindow#POINTS} long. Not modified.
     * @param xi   ξ before the step, in its own units, n long. Not modified.
     * @param into in the states' unit, twice as long as the motion: two for each state. Modified.
     */
    default void forced(double[] c, double[] xi, double[] into) {
        for (int m = 0; m < modes(); m++) {
            step(m).forced(c, xi, 2 * m, into, 4 * m);
        }
    }

    /**
     * Natural frequency of a mode [Hz].
     *
     * @param xi ξ in its own units, n long. Not modified.
     */
    default double frequency(int mode, double[] xi) {
        return Math.exp(xi[states() + 2 * mode]) / (2 * Math.PI);
    }

    /**
     * Damping ratio of a mode.
     *
     * @param xi ξ in its own units, n long. Not modified.
     */
    default double damping(int mode, double[] xi) {
        return Math.exp(xi[states() + 2 * mode + 1]);
    }

    /**
     * Whether frequency and damping of a mode lie within the bounds of {@link Spec}.
     *
     * @param xi ξ in its own units, n long. Not modified.
     */
    default boolean within(int mode, double[] xi) {
        double frequency = xi[states() + 2 * mode];
        double damping = xi[states() + 2 * mode + 1];
        return frequency >= LEAST[0] && frequency <= MOST[0] && damping >= LEAST[1] && damping <= MOST[1];
    }
}
