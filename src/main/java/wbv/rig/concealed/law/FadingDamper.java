package wbv.rig.concealed.law;

/**
 * A damper that fades with the motion of the last seconds, as foaming oil does, and recovers: c v / (1 + m/m0), m the mean square rate over
 * a memory.
 *
 * @param c of the rested damper [N s/m]
 * @param level m0 [m²/s²]
 * @param memory [s]
 */
public record FadingDamper(double c, double level, double memory) implements LinkPhysics {

    @Override
    public int states() {
        return 1;
    }

    @Override
    public double force(double t, double r, double v, double[] y, int at) {
        return c * v / (1 + y[at] / level);
    }

    @Override
    public void rates(double t, double r, double v, double[] y, int at, double[] into) {
        into[at] = (v * v - y[at]) / memory;
    }
}
