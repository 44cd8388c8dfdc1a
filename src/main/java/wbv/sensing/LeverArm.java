package wbv.sensing;

import wbv.signal.Differentiator;

/**
 * Acceleration of one point of a rigid segment from that of another: {@code a_P = a_O + ω' × r + ω × (ω × r)}, all in the axes
 * of the
 * segment. Late by {@link #delay()} samples, which the derivative of the angular rate takes.
 *
 * <p>It serves free acceleration and specific force alike, since gravity is the same at both points. A gyroscope's noise becomes
 * acceleration by {@code 2πf r}: at 20 Hz and 0.1 m, 0.001 rad/s is 0.013 m/s².
 */
public final class LeverArm {

    private final double[] arm;
    private final Differentiator[] derivative = new Differentiator[3];
    private final double[][] waiting;
    private final double[] turning = new double[3];
    private int head;

    /**
     * From one point of a segment to another.
     *
     * @param rate samples per second [Hz]
     * @param arm  from the point that is measured to the one that is wanted [m], in the segment's axes, three long. Not modified.
     */
    public LeverArm(double rate, double[] arm) {
        if (arm.length != 3 || !Double.isFinite(arm[0] + arm[1] + arm[2])) {
            throw new IllegalArgumentException("a lever arm is three lengths in m: " + java.util.Arrays.toString(arm));
        }
        this.arm = arm.clone();
        for (int i = 0; i < 3; i++) {
            derivative[i] = new Differentiator(rate);
        }
        waiting = new double[derivative[0].delay() + 1][6];
        for (double[] row : waiting) {
            java.util.Arrays.fill(row, Double.NaN);
        }
    }

    /** Samples by which the acceleration comes late. */
    public int delay() {
        return waiting.length - 1;
    }

    /**
     * Takes a sample and gives the acceleration of {@link #delay()} samples ago; NaN before the first and near missing ones.
     *
     * @param acceleration [m/s²], three long
     * @param rate [rad/s], both in the segment's axes, three long. Not modified.
     * @param out [m/s²], three long. Modified.
     */
    public void accept(double[] acceleration, double[] rate, double[] out) {
        for (int i = 0; i < 3; i++) {
            turning[i] = derivative[i].accept(rate[i]);
            waiting[head][i] = acceleration[i];
            waiting[head][3 + i] = rate[i];
        }
        head = head + 1 == waiting.length ? 0 : head + 1;
        double[] then = waiting[head];   // the oldest
        double dot = then[3] * arm[0] + then[4] * arm[1] + then[5] * arm[2];
        double square = then[3] * then[3] + then[4] * then[4] + then[5] * then[5];
        for (int i = 0; i < 3; i++) {
            int j = (i + 1) % 3;
            int k = (i + 2) % 3;
            // ω × (ω × r) = ω (ω·r) - r |ω|²
            out[i] = then[i] + turning[j] * arm[k] - turning[k] * arm[j] + then[3 + i] * dot - arm[i] * square;
        }
    }
}
