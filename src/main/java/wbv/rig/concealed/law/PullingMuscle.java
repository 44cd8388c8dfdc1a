package wbv.rig.concealed.law;

/**
 * A stretch reflex beside spring and dashpot whose muscle answers as a critically damped twitch and only pulls: what lengthens the link
 * calls it, what shortens it does not.
 */
public final class PullingMuscle implements LinkPhysics {

    private final double k;
    private final double c;
    private final double omega;
    private final Spindle spindle;

    /**
     * Relaxed.
     *
     * @param k [N/m]
     * @param c [N s/m]
     * @param gain [N/m]
     * @param rateGain [N s/m]
     * @param delay [s]
     * @param twitch natural frequency [Hz]
     * @param h step of the run [s], shorter than the delay
     */
    public PullingMuscle(double k, double c, double gain, double rateGain, double delay, double twitch, double h) {
        this.k = k;
        this.c = c;
        this.omega = 2 * Math.PI * twitch;
        this.spindle = new Spindle(gain, rateGain, delay, h);
    }

    @Override
    public int states() {
        return 2;
    }

    @Override
    public double force(double t, double r, double v, double[] y, int at) {
        return k * r + c * v + Math.max(0, y[at]);
    }

    @Override
    public void rates(double t, double r, double v, double[] y, int at, double[] into) {
        into[at] = y[at + 1];
        into[at + 1] = omega * (omega * (spindle.told(t) - y[at]) - 2 * y[at + 1]);
    }

    @Override
    public void commit(double t, double r, double v) {
        spindle.feel(r, v);
    }
}
