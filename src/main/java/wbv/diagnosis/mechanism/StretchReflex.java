package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;
import static wbv.diagnosis.mechanism.Hypothesis.Start.grid;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import wbv.body.law.Law;
import wbv.body.law.MuscleReflex;
import wbv.body.law.Reflex;
import wbv.diagnosis.mechanism.Hypothesis.Start;

/**
 * A force that follows deflection and velocity late, as that of a stretch reflex does; and one that a muscle makes of it, which answers
 * slowly and pulls one way only. None on a rig.
 */
record StretchReflex() implements Mechanism {

    /** Time constant with which a twitch rises [s], some tens of milliseconds (assumed), and what it may be. */
    private static final double TWITCH = 0.05;
    private static final double SHORTEST = 0.01;
    private static final double LONGEST = 0.2;
    /** How many times as strong as the link a command may be: of what is fast, the twitch lets pass a part. */
    private static final double STRONGEST = 30;

    @Override
    public Entry entry() {
        return new Entry("muscle.reflex", Family.DYNAMIC, "Something at %s answers late, as a muscle does");
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        if (scene.onRig()) {
            return List.of();
        }
        double k = link.stiffness();
        double c = link.damping();
        List<Hypothesis> out = new ArrayList<>(List.of(Hypothesis.law(this, link, "", new Reflex(0.05 * k, 0.05 * c, 0.1),
                List.of(sum(0.05 * k, -3 * k, 3 * k), sum(0.05 * c, -3 * c, 3 * c), factor(0.02, 0.4)),
                grid(new double[] {0.05, 0.1, 0.18}, t -> Start.of(new double[] {0.05 * k, 0.05 * c, t}, new int[] {0}, new int[] {1})))));
        for (Law.Side side : List.of(Law.Side.EXTENSION, Law.Side.COMPRESSION)) {
            out.add(Hypothesis.law(this, link, side.name().toLowerCase(Locale.ROOT), new MuscleReflex(0.1 * k, 0.1 * c, 0.05, TWITCH, side),
                    List.of(sum(0.1 * k, 0, STRONGEST * k), sum(0.1 * c, 0, STRONGEST * c), factor(0.01, 0.4), factor(SHORTEST, LONGEST)),
                    grid(new double[] {0.02, 0.06, 0.12},
                            t -> Start.of(new double[] {0.1 * k, 0.1 * c, t, TWITCH}, new int[] {0}, new int[] {1}))));
        }
        return out;
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
