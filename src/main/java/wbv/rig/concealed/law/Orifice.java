package wbv.rig.concealed.law;

/**
 * A cushion whose fluid leaves through an orifice and comes back through a flap: p' = K (v - w), p = d w (|w| + w0), d a part of it when it
 * sucks. The volume K holds what does not leave at once; an opening resists with the square of the flow, below w0 in proportion to it.
 *
 * @param volume K [N/m]
 * @param orifice d under pressure [N s²/m²]
 * @param flap d under suction [N s²/m²]
 * @param laminar w0 [m/s]
 */
public record Orifice(double volume, double orifice, double flap, double laminar) implements LinkPhysics {

    @Override
    public int states() {
        return 1;
    }

    @Override
    public double force(double t, double r, double v, double[] y, int at) {
        return y[at];
    }

    @Override
    public void rates(double t, double r, double v, double[] y, int at, double[] into) {
        into[at] = volume * (v - flow(y[at]));
    }

    private double flow(double p) {
        double d = p < 0 ? orifice : flap;
        return Math.signum(p) * (Math.sqrt(laminar * laminar / 4 + Math.abs(p) / d) - laminar / 2);
    }
}
