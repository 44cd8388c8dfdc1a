package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;
import static wbv.diagnosis.mechanism.Start.grid;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import wbv.body.law.BumpStop;
import wbv.body.law.HertzStop;
import wbv.body.law.Law;

/** A stop to one side or to both, straight or round as a ball is. */
record EndStop() implements Mechanism {

    /** Key of what side it is on. */
    static final String SIDE = "side";
    /** The least gap to start from, in parts of the deflection. */
    private static final double LEAST_PART = 2e-3;

    @Override
    public Entry entry() {
        return new Entry("contact.bumpstop", Family.CONTACT, "The link %s hits a stop");
    }

    @Override
    public String sentence(Set<String> keys, Map<String, String> form) {
        return switch (form.getOrDefault(SIDE, "")) {
            case "compression" -> "The link %s hits a stop in compression";
            case "extension" -> "The link %s hits a stop in extension";
            case "both" -> "The link %s hits a stop in compression and in extension";
            default -> entry().sentence();
        };
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        double r = link.deflection();
        double k = link.stiffness();
        List<Hypothesis> out = new ArrayList<>();
        double hertz = 0.5 * k / Math.sqrt(r);
        for (Law.Side side : Law.Side.values()) {
            String name = side.name().toLowerCase(Locale.ROOT);
            out.add(Hypothesis.law(this, link, name, new BumpStop(k, r, side),
                    List.of(sum(k, 1e-6 * k, 1000 * k), factor(1e-3 * r, 20 * r)),
                    starts(link, side, k,
                            side == Law.Side.BOTH ? new double[] {0.3, 0.6, 0.85, 0.97} : new double[] {0.55, 0.75, 0.9, 0.98})));
            out.add(Hypothesis.law(this, link, side == Law.Side.COMPRESSION ? "hertz" : "hertz " + name, new HertzStop(hertz, r, side),
                    List.of(sum(hertz, 1e-6 * hertz, 1000 * hertz), factor(1e-3 * r, 20 * r)), starts(link, side, hertz, 0.5, 0.8)));
        }
        return out;
    }

    /**
     * @param k its stiffness to start from, as its law has it
     * @param shares of the time in which it is not touched
     */
    private static List<Start> starts(Scene.Link link, Law.Side side, double k, double... shares) {
        double least = LEAST_PART * link.deflection();
        return grid(shares, q -> Start.of(new double[] {k, Math.max(least, link.reached(side, q))}, new int[] {0}));
    }

    @Override
    public boolean yieldsTo(Hypothesis rival) {
        return rival.kind() instanceof Asymmetry || rival.kind() instanceof Separation || rival.kind() instanceof Hardening;
    }
}
