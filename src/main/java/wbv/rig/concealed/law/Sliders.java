package wbv.rig.concealed.law;

/** Jenkins elements beside a spring: springs that hang on sliders which give way one after another (Iwan 1966). */
public final class Sliders implements LinkPhysics {

    private final double k;
    private final double c;
    private final double sticking;
    private final double[] yield;
    private final double[] bent;
    private double last;

    /**
     * Nothing has slid.
     *
     * @param k of what never slides [N/m]
     * @param c [N s/m]
     * @param sticking what those on sliders add to it while none has given way [N/m]
     * @param yield extension at which each gives way [m], as long as there are sliders. Not modified.
     */
    public Sliders(double k, double c, double sticking, double[] yield) {
        this.k = k;
        this.c = c;
        this.sticking = sticking;
        this.yield = yield;
        this.bent = new double[yield.length];
    }

    /**
     * Parts of a spring hang on sliders.
     *
     * @param k of all of it [N/m]
     * @param c [N s/m]
     * @param share of k on sliders, 0 to 1
     * @param yield extension at which each gives way [m], as long as there are sliders. Not modified.
     */
    public static Sliders partOf(double k, double c, double share, double[] yield) {
        return new Sliders((1 - share) * k, c, share * k, yield);
    }

    @Override
    public double force(double t, double r, double v, double[] y, int at) {
        double sum = 0;
        for (int i = 0; i < yield.length; i++) {
            sum += clamp(bent[i] + r - last, yield[i]);
        }
        return k * r + sticking * sum / yield.length + c * v;
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
