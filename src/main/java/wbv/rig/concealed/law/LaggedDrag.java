package wbv.rig.concealed.law;

/**
 * Drag of a fluid that answers late: f' = (c2 |v| v - f)/τ.
 *
 * @param c2 [N s²/m²]
 * @param lag τ [s]
 */
public record LaggedDrag(double c2, double lag) implements LinkPhysics {

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
        into[at] = (c2 * Math.abs(v) * v - y[at]) / lag;
    }
}
