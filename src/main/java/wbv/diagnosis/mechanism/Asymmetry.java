package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;
import static wbv.diagnosis.mechanism.Start.grid;
import static wbv.diagnosis.mechanism.Start.scaled;

import java.util.List;
import wbv.body.law.AsymmetricSpring;
import wbv.body.law.BendingSpring;
import wbv.body.law.QuadraticSpring;

/**
 * A spring that is stiffer to one side than to the other: with a bend at rest, with a round one, or with the square of its deflection.
 */
record Asymmetry() implements Mechanism {

    @Override
    public Entry entry() {
        return new Entry("stiffness.asymmetric", Family.SPRING, "The link %s is not as stiff in compression as in extension");
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        double r = link.deflection();
        double even = 0.1 * link.stiffness() / r;
        Hypothesis square = Hypothesis.law(this, link, "bent", new QuadraticSpring(even), List.of(sum(even, -1000 * even, 1000 * even)),
                List.of(scaled(even)));
        return link.own() > 0
                ? List.of(Hypothesis.law(this, link, "", new AsymmetricSpring(0.1), List.of(sum(0.1, -0.97, 12)), List.of(scaled(0.1))),
                        Hypothesis.law(this, link, "round", new BendingSpring(0.1, r),
                                List.of(sum(0.1, -0.97, 12), factor(0.01 * r, 20 * r)),
                                grid(new double[] {0.3, 1}, q -> Start.of(new double[] {0.1, q * r}, new int[] {0}))),
                        square)
                : List.of(square);
    }
}
