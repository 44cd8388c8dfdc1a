package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;
import static wbv.diagnosis.mechanism.Start.fixed;
import static wbv.diagnosis.mechanism.Start.grid;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import wbv.body.law.BoucWen;
import wbv.body.law.JenkinsElement;
import wbv.body.law.Law;
import wbv.body.law.Slider;
import wbv.body.number.Numbers;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis.Number;

/** A spring of which a share yields, in one stage or little by little. */
public record Hysteresis() implements Mechanism {

    /** Sliders of a spring that yields little by little: more make no loop rounder than noise shows. */
    private static final int SLIDERS = 6;
    /** Deflection at which the last of them yields over that of the first [1], assumed: a decade. */
    private static final double SPAN = 10;
    /** That of the one in the middle. */
    private static final double MIDDLE = Math.sqrt(SPAN);
    private static final String EACH = "share_of_each";
    private static final String STICKING = "each_sticking_N_per_m";
    /** Stiffness of each beside a spring, over that of the spring [1]: from what no ride shows to what hardly moves before it slides. */
    private static final double SOFTEST = 1e-4;
    private static final double STIFFEST = 100;

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
     * The same beside a spring that keeps its stiffness.
     *
     * @param where  the link's name
     * @param own stiffness of the spring [N/m]
     * @param sticking what is added to it in all while nothing slides [N/m], from which to start
     * @param yield deflection at which half of that slides [m], likewise
     */
    public Hypothesis beside(int link, String where, double own, double sticking, double yield) {
        return new Hypothesis(this, where, "gradual beside", sliders(link, new JenkinsElement(own / SLIDERS, 1e-3)),
                List.of(factor(SOFTEST * own, STIFFEST * own).named(STICKING), factor(3e-5 / MIDDLE, 2e-2 / MIDDLE).named("first_slip_m")),
                grid(new double[] {1, 0.5, 2}, q -> fixed(sticking / SLIDERS, q * yield / MIDDLE)));
    }

    private Hypothesis gradual(int link, String where, Number first, List<Start> starts) {
        return new Hypothesis(this, where, "gradual", sliders(link, new Slider(0.1 / SLIDERS, 1e-3)),
                List.of(sum(0.1, 0, 1.0 / SLIDERS).named(EACH), first.named("first_slip_m")), starts);
    }

    /**
     * Springs alike that slide one after the other, from a least deflection to ten times that, as alike in the logarithm (Iwan 1966; the
     * power law of Segalman 2005 with the exponent -1).
     *
     * @param first whose second number is the deflection at which it slides
     */
    private static List<Addition> sliders(int link, Law first) {
        List<Addition> out = new ArrayList<>(List.of(new Addition.InLink(link, first)));
        for (int i = 1; i < SLIDERS; i++) {
            List<Double> factors = List.of(1.0, Math.pow(SPAN, i / (SLIDERS - 1.0)));
            double[] numbers = Numbers.values((Record) first);
            Arrays.setAll(numbers, n -> factors.get(n) * numbers[n]);
            out.add(new Addition.AlikeInLink(link, (Law) Numbers.with((Record) first, numbers), factors));
        }
        return out;
    }

    /** Of many sliders what yields in all, and where half of it does. */
    @Override
    public List<Told> told(List<Number> numbers) {
        Told yield = Told.scaled("yield_m", 1, MIDDLE);
        return switch (numbers.get(0).key()) {
            case EACH -> List.of(Told.scaled("share", 0, SLIDERS), yield);
            case STICKING -> List.of(Told.scaled("sticking_N_per_m", 0, SLIDERS), yield);
            default -> Mechanism.super.told(numbers);
        };
    }

    @Override
    public Together together() {
        return Together.LOOP;
    }

    @Override
    public boolean yieldsTo(Hypothesis rival) {
        return rival.kind() instanceof DryFriction;
    }
}
