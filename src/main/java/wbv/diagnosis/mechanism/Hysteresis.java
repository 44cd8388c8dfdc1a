package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;
import static wbv.diagnosis.mechanism.Hypothesis.Start.fixed;
import static wbv.diagnosis.mechanism.Hypothesis.Start.grid;

import java.util.ArrayList;
import java.util.List;
import wbv.body.law.BoucWen;
import wbv.body.law.Slider;
import wbv.diagnosis.mechanism.Hypothesis.Addition;
import wbv.diagnosis.mechanism.Hypothesis.Number;
import wbv.diagnosis.mechanism.Hypothesis.Start;

/** A spring of which a share yields, in one stage or little by little. */
public record Hysteresis() implements Mechanism {

    /** Sliders of a spring that yields little by little: more make no loop rounder than noise shows. */
    private static final int SLIDERS = 6;
    /** Deflection at which the last of them yields over that of the first [1], assumed: a decade. */
    private static final double SPAN = 10;
    /** That of the one in the middle. */
    private static final double MIDDLE = Math.sqrt(SPAN);
    private static final String EACH = "share_of_each";

    @Override
    public Entry entry() {
        return new Entry("hysteresis", Family.LOSS, "The spring of %s yields and loses energy in every loop", DryFriction.CREEP);
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        double r = link.deflection();
        if (scene.onRig()) {
            return link.own() > 0 ? List.of(law(link, factor(1e-3 * r, 30 * r), r, 0.1, 0.5, 2),
                    gradual(link.index(), link.name(), factor(1e-3 * r, 30 * r),
                            grid(new double[] {0.1, 0.5, 2}, q -> Start.of(new double[] {0.1 / SLIDERS, q * r / MIDDLE}, new int[] {0}))))
                    : List.of();
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
     * A spring that yields little by little.
     *
     * @param where  the link's name
     * @param share  of its stiffness that yields in all, from which to start
     * @param yield  deflection at which half of that does [m], likewise
     */
    public Hypothesis gradual(int link, String where, double share, double yield) {
        return gradual(link, where, factor(3e-5 / MIDDLE, 2e-2 / MIDDLE),
                grid(new double[] {1, 0.5, 2}, q -> fixed(share / SLIDERS, q * yield / MIDDLE)));
    }

    /**
     * Equal shares of a spring that slide one after the other, from a least deflection to ten times that, as alike in the logarithm (Iwan
     * 1966; the power law of Segalman 2005 with the exponent -1).
     */
    private Hypothesis gradual(int link, String where, Number first, List<Start> starts) {
        List<Addition> additions = new ArrayList<>(List.of(new Addition.InLink(link, new Slider(0.1 / SLIDERS, 1e-3))));
        for (int i = 1; i < SLIDERS; i++) {
            double factor = Math.pow(SPAN, i / (SLIDERS - 1.0));
            additions.add(new Addition.AlikeInLink(link, new Slider(0.1 / SLIDERS, factor * 1e-3), List.of(1.0, factor)));
        }
        return new Hypothesis(this, where, "gradual", additions,
                List.of(sum(0.1, 0, 1.0 / SLIDERS).named(EACH), first.named("first_slip_m")),
                starts);
    }

    /** Of many sliders what yields in all, and where half of it does. */
    @Override
    public List<Told> told(List<Number> numbers) {
        return numbers.get(0).key().equals(EACH)
                ? List.of(Told.scaled("share", 0, SLIDERS), Told.scaled("yield_m", 1, MIDDLE))
                : Mechanism.super.told(numbers);
    }

    @Override
    public boolean yieldsTo(Hypothesis rival) {
        return rival.kind() instanceof DryFriction;
    }
}
