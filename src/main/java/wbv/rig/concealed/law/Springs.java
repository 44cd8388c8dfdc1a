package wbv.rig.concealed.law;

/** Link forces without memory: each a spring and dashpot of which one part is no longer linear. */
public final class Springs {

    private Springs() {}

    /** A force of the present extension and rate. */
    @FunctionalInterface
    interface Instant extends LinkPhysics {
        double force(double r, double v);

        @Override
        default double force(double t, double r, double v, double[] y, int at) {
            return force(r, v);
        }
    }

    /**
     * k r + c v.
     *
     * @param k [N/m]
     * @param c [N s/m]
     */
    public static LinkPhysics linear(double k, double c) {
        return (Instant) (r, v) -> k * r + c * v;
    }

    /**
     * k x tanh(r/x).
     *
     * @param k [N/m]
     * @param c [N s/m]
     * @param x where it has lost half its tangent stiffness or so [m]
     */
    public static LinkPhysics tanh(double k, double c, double x) {
        return (Instant) (r, v) -> k * x * Math.tanh(r / x) + c * v;
    }

    /**
     * k r / (1 + |r|/x).
     *
     * @param k [N/m]
     * @param c [N s/m]
     * @param x where the secant has half of k [m]
     */
    public static LinkPhysics rational(double k, double c, double x) {
        return (Instant) (r, v) -> k * r / (1 + Math.abs(r) / x) + c * v;
    }

    /**
     * k r (1 + ρ² / (1 + ρ²/16)), ρ = r/x: cubic at first, then a stiffer straight line.
     *
     * @param k [N/m]
     * @param c [N s/m]
     * @param x [m]
     */
    public static LinkPhysics hardening(double k, double c, double x) {
        return (Instant) (r, v) -> {
            double rho = r / x * (r / x);
            return k * r * (1 + rho / (1 + rho / 16)) + c * v;
        };
    }

    /**
     * More stiffness in compression, by a smooth bend.
     *
     * @param k [N/m]
     * @param c [N s/m]
     * @param share of k
     * @param bend [m]
     */
    public static LinkPhysics asymmetric(double k, double c, double share, double bend) {
        return (Instant) (r, v) -> k * r + c * v + share * k * (r + bend - Math.sqrt(r * r + bend * bend)) / 2;
    }

    /**
     * c v + c2 v |v|, rounded at rest.
     *
     * @param k [N/m]
     * @param c [N s/m]
     * @param c2 [N s²/m²]
     * @param soft [m/s]
     */
    public static LinkPhysics quadratic(double k, double c, double c2, double soft) {
        return (Instant) (r, v) -> k * r + c * v + c2 * v * (Math.sqrt(v * v + soft * soft) - soft);
    }

    /**
     * Pulls no harder than the preload, softly.
     *
     * @param k [N/m]
     * @param c [N s/m]
     * @param preload [N]
     * @param soft [N]
     */
    public static LinkPhysics contactLoss(double k, double c, double preload, double soft) {
        return (Instant) (r, v) -> {
            double over = (k * r + c * v - preload) / soft;
            double excess = over > 30 ? over : Math.log1p(Math.exp(over));
            return k * r + c * v - soft * excess;
        };
    }

    /**
     * A ball on a flat: hertz δ^1.5 once compressed by more than the gap.
     *
     * @param k [N/m]
     * @param c [N s/m]
     * @param contact stiffness of the contact [N/m^1.5]
     * @param gap [m]
     */
    public static LinkPhysics hertz(double k, double c, double contact, double gap) {
        return (Instant) (r, v) -> {
            double depth = Math.max(0, -r - gap);
            return k * r + c * v - contact * depth * Math.sqrt(depth);
        };
    }

    /**
     * Play whose edge is soft: k (r - g tanh(r/g)), with little damping inside.
     *
     * @param k [N/m]
     * @param c [N s/m]
     * @param gap g [m]
     */
    public static LinkPhysics play(double k, double c, double gap) {
        return (Instant) (r, v) -> {
            double u = Math.tanh(r / gap);
            return k * (r - gap * u) + c * v * (0.3 + 0.7 * u * u);
        };
    }
}
