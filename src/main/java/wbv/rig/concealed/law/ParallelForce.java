package wbv.rig.concealed.law;

/**
 * A spring, a dashpot and another force beside them.
 *
 * @param k of the spring [N/m]
 * @param c of the dashpot [N s/m]
 * @param other the force beside k r + c v, its states and its inertance
 */
public record ParallelForce(double k, double c, LinkPhysics other) implements LinkPhysics {

    @Override
    public int states() {
        return other.states();
    }

    @Override
    public double inertance() {
        return other.inertance();
    }

    @Override
    public double force(double t, double r, double v, double[] y, int at) {
        return k * r + c * v + other.force(t, r, v, y, at);
    }

    @Override
    public void rates(double t, double r, double v, double[] y, int at, double[] into) {
        other.rates(t, r, v, y, at, into);
    }

    @Override
    public void commit(double t, double r, double v) {
        other.commit(t, r, v);
    }
}
