package wbv.rig.concealed;

import java.util.Map;

/**
 * How places move across: each swings against the platform as one mass on a spring, and rides on the platform's rotation at its
 * height. One axis.
 *
 * @param displacement against the middle of the platform, what its rotation does at this height included [m]
 * @param acceleration absolute [m/s²]
 */
record Sway(double[] displacement, double[] acceleration) {

    private static final double ZETA = 0.35;
    /** Frequency across [Hz] and height over the platform [m]. */
    private static final Map<String, double[]> PLACES = Map.of("seat", new double[] {9, 0.4}, "pelvis", new double[] {5, 0.55},
            "sternum", new double[] {3, 0.85}, "head", new double[] {2.4, 1.25});

    /**
     * @param push acceleration of the platform across
     * @param angle whose rotation carries the place along, at its height
     */
    static Sway of(String place, double[] push, double[] angle) {
        if (!PLACES.containsKey(place)) {
            return new Sway(new double[push.length], push);
        }
        double omega = 2 * Math.PI * PLACES.get(place)[0];
        double height = PLACES.get(place)[1];
        double[] spin = UniformSeries.rate(UniformSeries.rate(angle));
        double[] u = new double[push.length];
        double[] a = new double[push.length];
        double v = 0;
        double h = 1 / UniformSeries.RATE;
        for (int i = 0; i < push.length; i++) {
            double carried = push[i] + height * spin[i];
            double pull = -omega * omega * u[i] - 2 * ZETA * omega * v;
            a[i] = pull;
            v += h * (pull - carried);
            if (i + 1 < push.length) {
                u[i + 1] = u[i] + h * v;
            }
        }
        for (int i = 0; i < u.length; i++) {
            u[i] += height * angle[i];
        }
        return new Sway(u, a);
    }
}
