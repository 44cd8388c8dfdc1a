package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;
import static wbv.diagnosis.mechanism.Start.fixed;
import static wbv.diagnosis.mechanism.Start.grid;
import static wbv.diagnosis.mechanism.Start.scaled;

import java.util.ArrayList;
import java.util.List;
import wbv.body.law.CubicSpring;
import wbv.body.law.GasSpring;
import wbv.body.law.PolynomialSpring;
import wbv.body.law.ProgressiveSpring;

/**
 * A spring whose force grows faster than its deflection: with the cube, with square and cube, from a knee on, or as a column of air that is
 * compressed.
 */
record Hardening() implements Mechanism {

    @Override
    public Entry entry() {
        return new Entry("stiffness.hardening", Family.SPRING, "The link %s stiffens with deflection");
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        double r = link.deflection();
        double k = link.stiffness();
        double odd = 0.1 * k / (r * r);
        double even = 0.1 * k / r;
        List<Hypothesis> out = new ArrayList<>(List.of(
                Hypothesis.law(this, link, "", new CubicSpring(odd), List.of(sum(odd, 0, 1000 * odd)), List.of(scaled(odd))),
                Hypothesis.law(this, link, "polynomial", new PolynomialSpring(even, odd),
                        List.of(sum(even, -1000 * even, 1000 * even), sum(odd, 0, 1000 * odd)),
                        List.of(Start.of(new double[] {even, odd}, new int[] {0}, new int[] {1}))),
                Hypothesis.law(this, link, "knee", new ProgressiveSpring(0.2 * k, r),
                        List.of(sum(0.2 * k, 0, 60 * k), factor(0.02 * r, 20 * r)),
                        grid(new double[] {0.3, 1, 3}, q -> Start.of(new double[] {0.2 * k, q * r}, new int[] {0})))));
        if (link.own() > 0) {
            out.add(Hypothesis.law(this, link, "gas", new GasSpring(10 * r), List.of(factor(1.5 * r, 300 * r)),
                    grid(new double[] {4, 12, 40}, q -> fixed(q * r))));
        }
        return out;
    }
}
