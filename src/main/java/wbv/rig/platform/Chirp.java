package wbv.rig.platform;

/** A sine whose frequency and amplitude run linearly in time, and begin again at the end of a run; the phase never jumps. */
final class Chirp implements PlatformCommand {

    private final int axis;
    private final double h;
    private final double f0;
    private final double f1;
    private final double a0;
    private final double a1;
    private final long steps;
    private double phaseOfRun;
    private long step;

    /**
     * @param h step [s]
     * @param f0
     * @param f1 frequencies [Hz]
     * @param a0
     * @param a1 amplitudes
     * @param seconds time of a run [s]
     */
    Chirp(Axis axis, double h, double f0, double f1, double a0, double a1, double seconds) {
        this.axis = axis.ordinal();
        this.h = h;
        this.f0 = f0;
        this.f1 = f1;
        this.a0 = a0;
        this.a1 = a1;
        this.steps = Math.max(1, Math.round(seconds / h));
    }

    @Override
    public void next(double gain, double[] command) {
        double share = (double) step / steps;
        // cycles = integral of f0 + (f1 - f0) t / T
        double cycles = cyclesAt(share);
        double amplitude = a0 + (a1 - a0) * share;
        command[axis] += gain * amplitude * StrictMath.sin(2 * Math.PI * (phaseOfRun + cycles - Math.floor(cycles)));
        if (++step == steps) {
            double end = phaseOfRun + cyclesAt(1);
            phaseOfRun = end - Math.floor(end);
            step = 0;
        }
    }

    private double cyclesAt(double share) {
        return steps * h * share * (f0 + (f1 - f0) * share / 2);
    }
}
