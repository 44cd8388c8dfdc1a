package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;
import static wbv.diagnosis.mechanism.Hypothesis.Start.scaled;

import java.util.List;
import wbv.body.law.QuadraticDamping;

/** Damping with the square of the velocity. */
record SpeedDamping() implements Mechanism {

    /** A usual velocity of a sitter's links [m/s]. */
    private static final double USUAL_SPEED = 0.03;

    @Override
    public Entry entry() {
        return new Entry("damping.quadratic", Family.LOSS, "The damping of %s grows with speed");
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        if (scene.onRig()) {
            double most = 100 * link.force() / (link.speed() * link.speed());
            return List.of(law(link, 0.1 * link.force() / (link.speed() * link.speed()), most));
        }
        double c2 = 0.1 * link.damping() / USUAL_SPEED;
        return List.of(law(link, c2, 300 * c2));
    }

    private Hypothesis law(Scene.Link link, double c2, double most) {
        return Hypothesis.law(this, link, "", new QuadraticDamping(c2), List.of(sum(c2, 0, most)), List.of(scaled(c2)));
    }
}
