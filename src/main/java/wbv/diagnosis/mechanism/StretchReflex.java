package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;
import static wbv.diagnosis.mechanism.Hypothesis.Start.grid;

import java.util.List;
import wbv.body.law.Reflex;
import wbv.diagnosis.mechanism.Hypothesis.Start;

/** A force that follows deflection and velocity late, as that of a stretch reflex does. None on a rig. */
record StretchReflex() implements Mechanism {

    @Override
    public Entry entry() {
        return new Entry("muscle.reflex", Family.DYNAMIC, "Something at %s answers late, as a muscle does");
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        double k = link.stiffness();
        double c = link.damping();
        return scene.onRig() ? List.of() : List.of(Hypothesis.law(this, link, "", new Reflex(0.05 * k, 0.05 * c, 0.1),
                List.of(sum(0.05 * k, -3 * k, 3 * k), sum(0.05 * c, -3 * c, 3 * c), factor(0.02, 0.4)),
                grid(new double[] {0.05, 0.1, 0.18}, t -> Start.of(new double[] {0.05 * k, 0.05 * c, t}, new int[] {0}, new int[] {1}))));
    }

    @Override
    public boolean yieldsTo(Hypothesis rival) {
        return rival.kind() instanceof Viscoelasticity || rival.kind() instanceof LearnedForce;
    }

    @Override
    public boolean imitatesAt(String key, boolean low) {
        return true;
    }
}
