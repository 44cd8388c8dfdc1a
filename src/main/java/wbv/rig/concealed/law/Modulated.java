package wbv.rig.concealed.law;

import java.util.function.DoubleUnaryOperator;

/**
 * A spring and dashpot whose values change with time.
 *
 * @param k of the spring [N/m]
 * @param c of the dashpot [N s/m]
 * @param factor at a time in s
 * @param stiff exponent with which it acts on the stiffness
 * @param damped likewise on the damping
 */
public record Modulated(double k, double c, DoubleUnaryOperator factor, double stiff, double damped) implements LinkPhysics {

    /**
     * Where the factor is that of the stiffness itself.
     *
     * @param k of the spring [N/m]
     * @param c of the dashpot [N s/m]
     * @param factor at a time in s
     * @param damped exponent with which it acts on the damping [1]
     */
    public Modulated(double k, double c, DoubleUnaryOperator factor, double damped) {
        this(k, c, factor, 1, damped);
    }

    @Override
    public double force(double t, double r, double v, double[] y, int at) {
        double f = factor.applyAsDouble(t);
        return k * to(f, stiff) * r + c * to(f, damped) * v;
    }

    private static double to(double factor, double exponent) {
        return exponent == 0 ? 1 : exponent == 1 ? factor : Math.pow(factor, exponent);
    }

    /**
     * A factor from 1 to another along half a cosine.
     *
     * @param start [s]
     * @param seconds &gt; 0
     * @param end the other factor
     */
    public static DoubleUnaryOperator ramp(double start, double seconds, double end) {
        return t -> {
            double share = Math.max(0, Math.min(1, (t - start) / seconds));
            return 1 + (end - 1) * (0.5 - 0.5 * Math.cos(Math.PI * share));
        };
    }

    /**
     * A factor from 1 towards another, fast at first.
     *
     * @param seconds time constant
     * @param end the other factor
     */
    public static DoubleUnaryOperator creep(double seconds, double end) {
        return t -> 1 + (end - 1) * (1 - Math.exp(-Math.max(0, t) / seconds));
    }
}
