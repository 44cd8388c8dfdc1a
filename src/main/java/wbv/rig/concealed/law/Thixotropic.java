package wbv.rig.concealed.law;

/**
 * A spring that loosens with the power it has lately felt and recovers slowly: k (1 - loss m/(m + m0)), m the mean square rate
 * over a memory of seconds.
 *
 * @param k of the spring [N/m]
 * @param c of the dashpot [N s/m]
 * @param loss share of k lost at most
 * @param level m0 [m²/s²]
 * @param memory [s]
 */
public record Thixotropic(double k, double c, double loss, double level, double memory) implements LinkPhysics {

    @Override
    public int states() {
        return 1;
    }

    @Override
    public double force(double t, double r, double v, double[] y, int at) {
        return k * (1 - loss * y[at] / (y[at] + level)) * r + c * v;
    }

    @Override
    public void rates(double t, double r, double v, double[] y, int at, double[] into) {
        into[at] = (v * v - y[at]) / memory;
    }
}
