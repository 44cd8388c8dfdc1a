package wbv.rig.concealed.law;

/** Jenkins elements beside a spring: parts of the stiffness hang on sliders that give way one after another (Iwan 1966). */
public final class Sliders implements LinkPhysics {

    private final double k;
    private final double c;
    private final double share;
    private final double[] yield;
    private final double[] bent;
    private double last;

    /**
     * Nothing has slid.
     *
     * @param k [N/m]
     * @param c [N s/m]
     * @param share of k on sliders, 0 to 1
     * @param yield extension at which each gives way [m], as long as there are sliders. Not modified.
     */
    public Sliders(double k, double c, double share, double[] yield) {
        this.k = k;
        this.c = c;
        this.share = share;
        this.yield = yield;
        this.bent = new double[yield.length];
    }

    @Override
    public double force(double t, double r, double v, double[] y, int at) {
        double sum = 0;
        for (int i = 0; i < yield.length; i++) {
            sum += clamp(bent[i] + r - last, yield[i]);
        }
        return k * (1 - share) * r + k * share * sum / yield.length + c * v;
    }

    @Override
    public void commit(double t, double r, double v) {
        for (int i = 0; i < yield.length; i++) {
            bent[i] = clamp(bent[i] + r - last, yield[i]);
        }
        last = r;
    }

    private static double clamp(double x, double limit) {
        return Math.max(-limit, Math.min(limit, x));
    }
}
