package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;
import static wbv.diagnosis.mechanism.Start.scaled;

import java.util.List;
import wbv.body.law.QuadraticDamping;

/** Damping with the square of the velocity. */
record SpeedDamping() implements Mechanism {

    @Override
    public Entry entry() {
        return new Entry("damping.quadratic", Family.LOSS, "The damping of %s grows with speed");
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        double c2 = 0.1 * link.force() / (link.speed() * link.speed());
        return List.of(Hypothesis.law(this, link, "", new QuadraticDamping(c2), List.of(sum(c2, 0, 1000 * c2)), List.of(scaled(c2))));
    }
}
