package wbv.rig.concealed.law;

import java.util.Arrays;

/** Jenkins elements beside a spring: springs that hang on sliders which give way one after another (Iwan 1966). */
public final class Sliders implements LinkPhysics {

    /** Extensions at which those of a spring give way that a ride hardly moves, and of one that it moves far, over the usual travel [1]. */
    private static final double[] LATE = {0.3, 0.7, 1.2, 2, 3};
    private static final double[] SOON = {0.03, 0.07, 0.15, 0.35, 0.8};

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

    /**
     * The same, five that give way about where the link usually travels and beyond.
     *
     * @param k of all of it [N/m]
     * @param c [N s/m]
     * @param share of k on sliders, 0 to 1
     * @param travel usual extension [m]
     */
    public static Sliders late(double k, double c, double share, double travel) {
        return partOf(k, c, share, over(LATE, travel));
    }

    /**
     * Five beside a spring that give way before the link has travelled far.
     *
     * @param k of the spring [N/m]
     * @param c [N s/m]
     * @param sticking what they add to it while none has given way [N/m]
     * @param travel usual extension [m]
     */
    public static Sliders soon(double k, double c, double sticking, double travel) {
        return new Sliders(k, c, sticking, over(SOON, travel));
    }

    private static double[] over(double[] parts, double travel) {
        return Arrays.stream(parts).map(part -> part * travel).toArray();
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
