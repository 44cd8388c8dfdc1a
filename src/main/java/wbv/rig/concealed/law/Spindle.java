package wbv.rig.concealed.law;

/** What a muscle is told of a link's motion, a delay later. */
final class Spindle {

    private final double gain;
    private final double rateGain;
    private final double delay;
    private final double h;
    private final double[] past;
    private long steps;

    /**
     * At rest.
     *
     * @param gain [N/m]
     * @param rateGain [N s/m]
     * @param delay [s]
     * @param h step of the run [s], shorter than the delay
     */
    Spindle(double gain, double rateGain, double delay, double h) {
        this.gain = gain;
        this.rateGain = rateGain;
        this.delay = delay;
        this.h = h;
        this.past = new double[(int) Math.ceil(delay / h) + 3];
    }

    /** Feels the motion at the end of a step [m, m/s]. */
    void feel(double r, double v) {
        steps++;
        past[(int) (steps % past.length)] = gain * r + rateGain * v;
    }

    /** What was felt a delay before [N]; steps end at whole multiples of h. */
    double told(double t) {
        double at = (t - delay) / h;
        if (at <= 0) {
            return 0;
        }
        long before = (long) Math.floor(at);
        double share = at - before;
        return (1 - share) * past[(int) (before % past.length)] + share * past[(int) ((before + 1) % past.length)];
    }
}
