package wbv.rig.concealed;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleFunction;
import wbv.rig.concealed.law.LinkPhysics;
import wbv.rig.concealed.law.Springs;

/** A planar person as he really is: what each component of each joint does, what else pushes, and what the sensors do wrong. */
final class PlanarSetup {

    private final PlanarPerson person;
    private final List<DoubleFunction<LinkPhysics>> physics = new ArrayList<>();
    private final List<Setup.FaultAt> faults = new ArrayList<>();
    private double[] push = new double[0];

    /** The linear person with perfect sensors. */
    PlanarSetup(PlanarPerson person) {
        this.person = person;
        for (PlanarPerson.Joint joint : person.joints()) {
            for (int q = 0; q < PlanarPerson.COMPONENTS; q++) {
                int component = q;
                physics.add(h -> Springs.linear(joint.stiffness()[component], joint.damping()[component]));
            }
        }
    }

    PlanarPerson person() {
        return person;
    }

    /**
     * Replaces the force of a component.
     *
     * @param made for a step of so many seconds, anew for every run
     */
    void joint(int joint, int component, DoubleFunction<LinkPhysics> made) {
        physics.set(PlanarPerson.COMPONENTS * joint + component, made);
    }

    LinkPhysics physics(int joint, int component, double h) {
        return physics.get(PlanarPerson.COMPONENTS * joint + component).apply(h);
    }

    /** A force along z on the trunk's centre of mass, by sample [N]: the person's own. */
    void stir(double[] force) {
        push = force.clone();
    }

    double[] push() {
        return push;
    }

    void fault(String place, Fault fault) {
        faults.add(new Setup.FaultAt(place, fault));
    }

    List<Setup.FaultAt> faults() {
        return faults;
    }
}
