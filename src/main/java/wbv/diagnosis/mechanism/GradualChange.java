package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;
import static wbv.diagnosis.mechanism.Hypothesis.Start.grid;

import java.util.List;
import wbv.body.law.Settling;
import wbv.body.law.SlowDrift;
import wbv.diagnosis.mechanism.Hypothesis.Start;

/** Stiffness and damping that drift, without end or until they settle. Not looked for on a rig. */
record GradualChange() implements Mechanism {

    /** The least time in which a slow drift settles [s]: what a link loses in the first moments of motion is no drift. */
    private static final double SLOWLY = 12;
    private static final String SETTLING = "settling";

    @Override
    public Entry entry() {
        return new Entry("drift.slow", Family.DRIFT, "The link %s changed over time");
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        if (scene.onRig()) {
            return List.of();
        }
        return List.of(Hypothesis.law(this, link, "", new SlowDrift(0.1, 0, 1), List.of(sum(0.1, -3, 12), sum(0.1, -4, 12), sum(0.2, 0, 2)),
                List.of(Start.of(new double[] {0.1, 0, 1}, new int[] {0}))),
                Hypothesis.law(this, link, SETTLING, new Settling(0.1, 30, 1),
                        List.of(sum(0.1, -0.97, 12), factor(SLOWLY, 500), sum(0.2, 0, 2)),
                        grid(new double[] {15, 35, 80}, q -> Start.of(new double[] {0.1, q, 1}, new int[] {0}))));
    }

    /** A form that goes nowhere beyond the data, where the other may run away. */
    @Override
    public boolean yieldsTo(Hypothesis rival) {
        return rival.kind() instanceof GradualChange && rival.form().equals(SETTLING);
    }

    @Override
    public boolean imitatesAt(String key, boolean low) {
        return low && key.equals("settling_s");
    }
}
