package wbv.rig.concealed.law;

/** A stretch reflex beside spring and dashpot: what the spindle felt a while ago, low-passed by the muscle that answers. */
public final class Muscle implements LinkPhysics {

    private static final double TWITCH = 0.025;

    private final double k;
    private final double c;
    private final Spindle spindle;

    /**
     * Relaxed.
     *
     * @param k [N/m]
     * @param c [N s/m]
     * @param gain [N/m]
     * @param rateGain [N s/m]
     * @param delay [s]
     * @param h step of the run [s], shorter than the delay
     */
    public Muscle(double k, double c, double gain, double rateGain, double delay, double h) {
        this.k = k;
        this.c = c;
        this.spindle = new Spindle(gain, rateGain, delay, h);
    }

    @Override
    public int states() {
        return 1;
    }

    @Override
    public double force(double t, double r, double v, double[] y, int at) {
        return k * r + c * v + y[at];
    }

    @Override
    public void rates(double t, double r, double v, double[] y, int at, double[] into) {
        into[at] = (spindle.told(t) - y[at]) / TWITCH;
    }

    @Override
    public void commit(double t, double r, double v) {
        spindle.feel(r, v);
    }
}
