package wbv.rig.concealed.law;

/** A stretch reflex beside spring and dashpot: what the spindle felt a while ago, low-passed by the muscle that answers. */
public final class Muscle implements LinkPhysics {

    private static final double TWITCH = 0.025;

    private final double k;
    private final double c;
    private final double gain;
    private final double rateGain;
    private final double h;
    private final double delay;
    private final double[] past;
    private long steps;

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
        this.gain = gain;
        this.rateGain = rateGain;
        this.h = h;
        this.delay = delay;
        this.past = new double[(int) Math.ceil(delay / h) + 3];
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
        into[at] = (late(t) - y[at]) / TWITCH;
    }

    @Override
    public void commit(double t, double r, double v) {
        steps++;
        past[(int) (steps % past.length)] = gain * r + rateGain * v;
    }

    /** What was felt a delay ago; steps end at whole multiples of h. */
    private double late(double t) {
        double at = (t - delay) / h;
        if (at <= 0) {
            return 0;
        }
        long before = (long) Math.floor(at);
        double share = at - before;
        return (1 - share) * past[(int) (before % past.length)] + share * past[(int) ((before + 1) % past.length)];
    }
}
