package wbv.filter;

import java.io.Serializable;

/**
 * How the motion since the start, and with it the output, depends on one parameter: {@code s = ∂x/∂θ} follows
 * {@code s ← E s + ∂g/∂θ}.
 */
final class Sensitivity implements Serializable {

    private static final long serialVersionUID = 1;
    private static final double MEMORY = 1;

    private final double forgetting;
    private double v;
    private double w;
    private double power;

    /** @param rate [Hz] */
    Sensitivity(double rate) {
        this.forgetting = 1 / (MEMORY * rate);
    }

    void reset() {
        v = 0;
        w = 0;
        power = 0;
    }

    /** @param e transition, 2 by 2. Not modified. @param dv ∂g/∂θ of v, x held @param dw of w */
    void advance(double[] e, double dv, double dw) {
        double next = e[0] * v + e[1] * w + dv;
        w = e[2] * v + e[3] * w + dw;
        v = next;
    }

    /** @param slope ∂y/∂θ of this sample */
    void hear(double slope) {
        power += forgetting * (slope * slope - power);
    }

    double v() {
        return v;
    }

    double w() {
        return w;
    }

    /** Root mean square of ∂y/∂θ over the last second. */
    double rms() {
        return Math.sqrt(power);
    }
}
