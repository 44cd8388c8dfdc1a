package wbv.rig.concealed.law;

/**
 * A spring, a dashpot and dry friction as bristles that bend and slip (Canudas de Wit, Olsson, Åström, Lischinsky 1995):
 * z' = v - s |v| z / g(v), force s z, g between breakaway and sliding friction.
 *
 * @param k         of the spring [N/m]
 * @param c of the dashpot [N s/m]
 * @param sliding   friction while it slides [N]
 * @param breakaway [N]
 * @param stribeck speed between them [m/s]
 * @param bristle   stiffness s [N/m]
 */
public record Lugre(double k, double c, double sliding, double breakaway, double stribeck, double bristle) implements LinkPhysics {

    @Override
    public int states() {
        return 1;
    }

    @Override
    public double force(double t, double r, double v, double[] y, int at) {
        return k * r + c * v + bristle * y[at];
    }

    @Override
    public void rates(double t, double r, double v, double[] y, int at, double[] into) {
        double u = v / stribeck;
        double g = sliding + (breakaway - sliding) * Math.exp(-u * u);
        into[at] = v - bristle * Math.abs(v) * y[at] / g;
    }
}
