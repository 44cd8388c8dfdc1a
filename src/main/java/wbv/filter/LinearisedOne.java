package wbv.filter;

import wbv.filter.model.OneDegree;

/**
 * {@link Linearised} of one degree of freedom, written out: ξ = [v, w, ln ω, ln ζ, d]. The same sums in the same order, and so the
 * same numbers to the last bit (under test), without a loop over five and without a call that could be another model's.
 */
final class LinearisedOne implements Moments {

    private static final long serialVersionUID = 1;
    private static final int N = 5;

    private final OneDegree model;
    private final double decay;
    /** Slopes of the output to the parameters, and covariances of ξ with it. */
    private double slope;
    private double damped;
    private double cv;
    private double cw;
    private double co;
    private double cz;
    private double cd;
    private double variance;

    /**
     * @param model the filter's own, with slopes, set at the mean when called
     * @param decay of the offset over one sample
     */
    LinearisedOne(OneDegree model, double decay) {
        this.model = model;
        this.decay = decay;
    }

    @Override
    public void advance(double[] c, double[] forced, double[] xi, double[] p) {
        model.advance(c, c.length, xi);
        xi[4] *= decay;
        double[] e = model.step(0).transition();
        double e0 = e[0];
        double e1 = e[1];
        double e2 = e[2];
        double e3 = e[3];
        double vo = forced[0];
        double vz = forced[1];
        double wo = forced[2];
        double wz = forced[3];
        double p00 = p[0];
        double p10 = p[N];
        double p11 = p[N + 1];
        double p20 = p[2 * N];
        double p21 = p[2 * N + 1];
        double p22 = p[2 * N + 2];
        double p30 = p[3 * N];
        double p31 = p[3 * N + 1];
        double p32 = p[3 * N + 2];
        double p33 = p[3 * N + 3];
        double p40 = p[4 * N];
        double p41 = p[4 * N + 1];
        double p42 = p[4 * N + 2];
        double p43 = p[4 * N + 3];
        // rows of F P, of the motion
        double v0 = e0 * p00 + e1 * p10 + vo * p20 + vz * p30;
        double v1 = e0 * p10 + e1 * p11 + vo * p21 + vz * p31;
        double v2 = e0 * p20 + e1 * p21 + vo * p22 + vz * p32;
        double v3 = e0 * p30 + e1 * p31 + vo * p32 + vz * p33;
        double v4 = e0 * p40 + e1 * p41 + vo * p42 + vz * p43;
        double w0 = e2 * p00 + e3 * p10 + wo * p20 + wz * p30;
        double w1 = e2 * p10 + e3 * p11 + wo * p21 + wz * p31;
        double w2 = e2 * p20 + e3 * p21 + wo * p22 + wz * p32;
        double w3 = e2 * p30 + e3 * p31 + wo * p32 + wz * p33;
        double w4 = e2 * p40 + e3 * p41 + wo * p42 + wz * p43;
        p[0] = v0 * e0 + v1 * e1 + v2 * vo + v3 * vz;
        set(p, 1, 0, w0 * e0 + w1 * e1 + w2 * vo + w3 * vz);
        p[N + 1] = w0 * e2 + w1 * e3 + w2 * wo + w3 * wz;
        set(p, 2, 0, v2);
        set(p, 2, 1, w2);
        set(p, 3, 0, v3);
        set(p, 3, 1, w3);
        set(p, 4, 0, decay * v4);
        set(p, 4, 1, decay * w4);
        set(p, 4, 2, decay * p42);
        set(p, 4, 3, decay * p43);
        p[4 * N + 4] *= decay * decay;
    }

    private static void set(double[] p, int row, int column, double value) {
        p[row * N + column] = value;
        p[column * N + row] = value;
    }

    @Override
    public double measure(double[] xi, double[] p, double[] cross) {
        double damper = model.damper();
        double spring = model.spring();
        slope = model.outputSlope(0, xi[0], xi[1]);
        damped = model.outputSlope(1, xi[0], xi[1]);
        cv = crossed(p, 0, damper, spring);
        cw = crossed(p, N, damper, spring);
        co = crossed(p, 2 * N, damper, spring);
        cz = crossed(p, 3 * N, damper, spring);
        cd = crossed(p, 4 * N, damper, spring);
        cross[0] = cv;
        cross[1] = cw;
        cross[2] = co;
        cross[3] = cz;
        cross[4] = cd;
        variance = Math.max(0, damper * cv + spring * cw + slope * co + damped * cz + cd);
        return model.output(xi[0], xi[1]) + xi[4];
    }

    private double crossed(double[] p, int at, double damper, double spring) {
        return p[at] * damper + p[at + 1] * spring + p[at + 2] * slope + p[at + 3] * damped + p[at + 4];
    }

    @Override
    public double variance() {
        return variance;
    }

    @Override
    public void reduce(double[] gain, double r, double[] p) {
        double k0 = gain[0];
        double k1 = gain[1];
        double k2 = gain[2];
        double k3 = gain[3];
        double k4 = gain[4];
        double l0 = left(p, 0, k0, r);
        double l1 = left(p, N, k1, r);
        double l2 = left(p, 2 * N, k2, r);
        double l3 = left(p, 3 * N, k3, r);
        double l4 = left(p, 4 * N, k4, r);
        p[0] = p[0] - k0 * cv + l0 * k0;
        set(p, 1, 0, p[N] - k1 * cv + l1 * k0);
        p[N + 1] = p[N + 1] - k1 * cw + l1 * k1;
        set(p, 2, 0, p[2 * N] - k2 * cv + l2 * k0);
        set(p, 2, 1, p[2 * N + 1] - k2 * cw + l2 * k1);
        p[2 * N + 2] = p[2 * N + 2] - k2 * co + l2 * k2;
        set(p, 3, 0, p[3 * N] - k3 * cv + l3 * k0);
        set(p, 3, 1, p[3 * N + 1] - k3 * cw + l3 * k1);
        set(p, 3, 2, p[3 * N + 2] - k3 * co + l3 * k2);
        p[3 * N + 3] = p[3 * N + 3] - k3 * cz + l3 * k3;
        set(p, 4, 0, p[4 * N] - k4 * cv + l4 * k0);
        set(p, 4, 1, p[4 * N + 1] - k4 * cw + l4 * k1);
        set(p, 4, 2, p[4 * N + 2] - k4 * co + l4 * k2);
        set(p, 4, 3, p[4 * N + 3] - k4 * cz + l4 * k3);
        p[4 * N + 4] = p[4 * N + 4] - k4 * cd + l4 * k4;
    }

    /** What is left to add to a row of {@code A = P - K (P Hᵀ)ᵀ} for each of the gain: {@code K R - A Hᵀ}. */
    private double left(double[] p, int at, double k, double r) {
        return r * k - ((p[at] - k * cv) * model.damper() + (p[at + 1] - k * cw) * model.spring() + (p[at + 2] - k * co) * slope
                + (p[at + 3] - k * cz) * damped + (p[at + 4] - k * cd));
    }
}
