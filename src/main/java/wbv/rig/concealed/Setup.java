package wbv.rig.concealed;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleFunction;
import wbv.rig.concealed.law.LinkPhysics;
import wbv.rig.concealed.law.Springs;

/**
 * A chain as it really is: what each link does, what else pushes, and what the sensors do wrong. Filled by omissions, then run.
 */
final class Setup {

    /**
     * A mass nobody sees.
     *
     * @param body it rides on
     * @param drag force over the square of its speed against the body [N s²/m²]
     */
    record Rider(int body, double mass, double stiffness, double damping, double drag) {
        Rider(int body, double mass, double stiffness, double damping) {
            this(body, mass, stiffness, damping, 0);
        }

        LinkPhysics physics() {
            return drag == 0 ? Springs.linear(stiffness, damping) : Springs.quadratic(stiffness, damping, drag, 0);
        }
    }

    /** A fault of the sensor at a place. */
    record FaultAt(String place, Fault fault) {}

    private final Chain chain;
    private final List<DoubleFunction<LinkPhysics>> physics = new ArrayList<>();
    private final List<Rider> riders = new ArrayList<>();
    private final double[][] linkForces;
    private final double[][] bodyForces;
    private final List<FaultAt> faults = new ArrayList<>();
    private boolean linear = true;

    /** The linear chain with perfect sensors. */
    Setup(Chain chain) {
        this.chain = chain;
        for (int i = 0; i < chain.size(); i++) {
            int link = i;
            physics.add(h -> Springs.linear(chain.stiffness()[link], chain.damping()[link]));
        }
        linkForces = new double[chain.size()][0];
        bodyForces = new double[chain.size()][0];
    }

    Chain chain() {
        return chain;
    }

    /**
     * Replaces a link's force.
     *
     * @param made for a step of so many seconds, anew for every run
     */
    void link(int i, DoubleFunction<LinkPhysics> made) {
        physics.set(i, made);
        linear = false;
    }

    void ride(Rider rider) {
        riders.add(rider);
        linear = false;
    }

    /** Adds a force in a link, by sample [N]. */
    void pull(int link, double[] force) {
        linkForces[link] = sum(linkForces[link], force);
        linear = false;
    }

    /** Adds a force on a body, by sample [N]. */
    void push(int body, double[] force) {
        bodyForces[body] = sum(bodyForces[body], force);
        linear = false;
    }

    void fault(String place, Fault fault) {
        faults.add(new FaultAt(place, fault));
    }

    LinkPhysics physics(int link, double h) {
        return physics.get(link).apply(h);
    }

    /** Bodies of the chain and those that nobody sees. */
    int bodies() {
        return chain.size() + riders.size();
    }

    List<Rider> riders() {
        return riders;
    }

    double[][] linkForces() {
        return linkForces;
    }

    double[][] bodyForces() {
        return bodyForces;
    }

    List<FaultAt> faults() {
        return faults;
    }

    /** Whether the chain itself is the linear one. */
    boolean isLinear() {
        return linear;
    }

    private static double[] sum(double[] a, double[] b) {
        if (a.length == 0) {
            return b.clone();
        }
        double[] out = a.clone();
        for (int i = 0; i < out.length; i++) {
            out[i] += b[i];
        }
        return out;
    }
}
