package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Hypothesis.Number.none;
import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;
import static wbv.diagnosis.mechanism.Start.grid;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import wbv.body.law.Law;
import wbv.body.law.MuscleReflex;
import wbv.body.law.Reflex;
import wbv.diagnosis.mechanism.Hypothesis.Number;

/**
 * A force that follows deflection, velocity or both late, as that of a stretch reflex does; and one that a muscle makes of it, which
 * answers slowly and pulls one way only. None on a rig.
 */
record StretchReflex() implements Mechanism {

    /** Time constant with which a twitch rises [s], some tens of milliseconds (assumed), and what it may be. */
    private static final double TWITCH = 0.05;
    private static final double SHORTEST = 0.01;
    private static final double LONGEST = 0.2;
    /** Forms with one command. */
    private static final String STRETCH = "stretch";
    private static final String SPEED = "speed";
    /** A step of a command, as a part of the link's stiffness or damping [1], and how many of them it may be: three times as strong. */
    private static final double STEP = 0.05;
    private static final double MOST = 60;
    /** Delay that hypotheses are measured against, and those that are begun with [s]. */
    private static final double LATE = 0.1;
    private static final double[] DELAYS = {0.05, 0.1, 0.18};
    /** How many times as strong as the link a command may be: of what is fast, the twitch lets pass a part. */
    private static final double STRONGEST = 30;

    @Override
    public Entry entry() {
        return new Entry("muscle.reflex", Family.DYNAMIC, "Something at %s answers late, as a muscle does");
    }

    @Override
    public String sentence(Set<String> keys, Map<String, String> form) {
        return switch (form.getOrDefault(EndStop.SIDE, "")) {
            case "compression" -> "Something at %s answers late and pushes only, as it is compressed, as a muscle of the other side does";
            case "extension" -> "Something at %s answers late and pulls only, as it is extended, as a muscle does";
            default -> entry().sentence();
        };
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        if (scene.onRig()) {
            return List.of();
        }
        double k = link.stiffness();
        double c = link.damping();
        List<Hypothesis> out = new ArrayList<>();
        Number delay = factor(0.02, 0.4);
        out.add(Hypothesis.law(this, link, STRETCH, new Reflex(STEP * k, 0, LATE), List.of(open(none(STEP * k)), none(STEP * c), delay),
                grid(DELAYS, t -> Start.of(new double[] {STEP * k, 0, t}, new int[] {0}))));
        out.add(Hypothesis.law(this, link, SPEED, new Reflex(0, STEP * c, LATE), List.of(none(STEP * k), open(none(STEP * c)), delay),
                grid(DELAYS, t -> Start.of(new double[] {0, STEP * c, t}, new int[] {1}))));
        for (Law.Side side : List.of(Law.Side.EXTENSION, Law.Side.COMPRESSION)) {
            out.add(Hypothesis.law(this, link, side.name().toLowerCase(Locale.ROOT), new MuscleReflex(0.1 * k, 0.1 * c, 0.05, TWITCH, side),
                    List.of(sum(0.1 * k, 0, STRONGEST * k), sum(0.1 * c, 0, STRONGEST * c), factor(0.01, 0.4), factor(SHORTEST, LONGEST)),
                    grid(new double[] {0.02, 0.06, 0.12},
                            t -> Start.of(new double[] {0.1 * k, 0.1 * c, t, TWITCH}, new int[] {0}, new int[] {1}))));
        }
        return out;
    }

    /**
     * An amplitude that may go either way.
     *
     * @param number whose unit is a step of it
     */
    private static Number open(Number number) {
        return sum(number.unit(), -MOST * number.unit(), MOST * number.unit()).named(number.key());
    }

    /** Of stretch and of its speed. */
    @Override
    public Optional<Hypothesis> further(Hypothesis plain, double[] found) {
        if (!plain.form().equals(STRETCH) && !plain.form().equals(SPEED)) {
            return Optional.empty();
        }
        List<Number> numbers = List.of(open(plain.numbers().get(0)), open(plain.numbers().get(1)), plain.numbers().get(2));
        return Optional.of(new Hypothesis(this, plain.where(), "", plain.additions(), numbers, List.of(Start.fixed(found))));
    }

    @Override
    public boolean yieldsTo(Hypothesis rival) {
        return rival.kind() instanceof Viscoelasticity || rival.kind() instanceof LearnedForce;
    }

    @Override
    public Doubt doubt(String key) {
        return key.equals("reflex_Ns_per_m") ? Doubt.LEAD : Doubt.SHARE;
    }

    /** A muscle may follow stretch alone, or its speed alone. */
    @Override
    public boolean imitatesAt(String key, boolean low) {
        return !low || !key.startsWith("reflex_");
    }
}
