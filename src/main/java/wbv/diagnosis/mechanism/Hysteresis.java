package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;
import static wbv.diagnosis.mechanism.Hypothesis.Start.fixed;
import static wbv.diagnosis.mechanism.Hypothesis.Start.grid;

import java.util.ArrayList;
import java.util.List;
import wbv.body.law.BoucWen;
import wbv.diagnosis.mechanism.Hypothesis.Addition;
import wbv.diagnosis.mechanism.Hypothesis.Number;
import wbv.diagnosis.mechanism.Hypothesis.Start;

/** A spring of which a share yields, in one stage or in two. */
public record Hysteresis() implements Mechanism {

    @Override
    public Entry entry() {
        return new Entry("hysteresis", Family.LOSS, "The spring of %s yields and loses energy in every loop", DryFriction.CREEP);
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        double r = link.deflection();
        if (scene.onRig()) {
            return link.own() > 0 ? List.of(law(link, factor(1e-3 * r, 30 * r), r, 0.1, 0.5, 2)) : List.of();
        }
        return List.of(law(link, factor(3e-5, 2e-2), r, 0.2, 0.7, 2));
    }

    /**
     * @param r unit of the yield deflection [m]
     * @param yields to start from, in that unit
     */
    private Hypothesis law(Scene.Link link, Number yield, double r, double... yields) {
        return Hypothesis.law(this, link, "", new BoucWen(0.1, r), List.of(sum(0.1, 0, 1), yield),
                grid(yields, q -> Start.of(new double[] {0.1, q * r}, new int[] {0})));
    }

    /**
     * A spring that gives way in two stages, for one of which a stage is known.
     *
     * @param where  the link's name
     * @param share  of its stiffness that yields
     * @param yield  deflection at which [m]
     */
    public Hypothesis twoStages(int link, String where, double share, double yield) {
        List<Number> numbers = new ArrayList<>();
        for (String stage : List.of("first", "second")) {
            numbers.add(sum(0.1, 0, 1).named(stage + "_share"));
            numbers.add(factor(3e-5, 2e-2).named(stage + "_yield_m"));
        }
        return new Hypothesis(this, where, "two stages",
                List.of(new Addition.InLink(link, new BoucWen(0.1, yield)), new Addition.InLink(link, new BoucWen(0.1, yield))), numbers,
                List.of(fixed(share / 2, yield / 2, share / 2, 2 * yield), fixed(0.7 * share, yield, 0.3 * share, 5 * yield),
                        fixed(0.3 * share, 0.3 * yield, 0.7 * share, 1.5 * yield)));
    }

    /** Of two stages first what yields in all. */
    @Override
    public List<Told> told(List<Number> numbers) {
        List<Told> out = new ArrayList<>(Mechanism.super.told(numbers));
        if (numbers.size() > 2) {
            out.add(0, Told.sum("share", 0, 2));
        }
        return out;
    }

    @Override
    public boolean yieldsTo(Hypothesis rival) {
        return rival.kind() instanceof DryFriction;
    }
}
