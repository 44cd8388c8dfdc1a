package wbv.identify;

import java.io.Serializable;

/**
 * A pole of the s-plane; of a conjugate pair, the one above the real axis.
 *
 * @param re decay [rad/s], negative where the motion dies away
 * @param im pulsation of the motion [rad/s], &gt;= 0; 0 where it does not oscillate
 */
public record Pole(double re, double im) implements Serializable {

    public Pole {
        if (!Double.isFinite(re) || !(im >= 0) || Double.isInfinite(im)) {
            throw new IllegalArgumentException("a pole must be finite and not below the real axis: " + re + " + " + im + "j");
        }
    }

    /**
     * The pole of a body.
     *
     * @param frequency natural frequency [Hz], &gt; 0
     * @param damping ratio, 0 to 1
     */
    public static Pole of(double frequency, double damping) {
        double omega = 2 * Math.PI * frequency;
        return new Pole(-damping * omega, omega * Math.sqrt(1 - damping * damping));
    }

    /** Whether it belongs to a mode: motion that oscillates and dies away. */
    public boolean mode() {
        return im > 0 && re < 0;
    }

    /** Natural (undamped) frequency |s|/2π [Hz]. */
    public double frequency() {
        return Math.hypot(re, im) / (2 * Math.PI);
    }

    /** Damping ratio [1], -Re s/|s|. */
    public double damping() {
        return -re / Math.hypot(re, im);
    }
}
