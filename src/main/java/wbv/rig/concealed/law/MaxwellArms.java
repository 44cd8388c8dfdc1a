package wbv.rig.concealed.law;

/**
 * A spring, a dashpot and two arms of spring and dashpot in series.
 *
 * @param k of the spring [N/m]
 * @param c of the dashpot [N s/m]
 * @param arm1
 * @param arm2 stiffness of the arms [N/m]
 * @param tau1
 * @param tau2 their relaxation times [s]
 */
public record MaxwellArms(double k, double c, double arm1, double tau1, double arm2, double tau2) implements LinkPhysics {

    @Override
    public int states() {
        return 2;
    }

    @Override
    public double force(double t, double r, double v, double[] y, int at) {
        return k * r + c * v + arm1 * (r - y[at]) + arm2 * (r - y[at + 1]);
    }

    @Override
    public void rates(double t, double r, double v, double[] y, int at, double[] into) {
        into[at] = (r - y[at]) / tau1;
        into[at + 1] = (r - y[at + 1]) / tau2;
    }
}
