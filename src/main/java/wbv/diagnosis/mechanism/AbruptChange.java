package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;

import java.util.ArrayList;
import java.util.List;
import wbv.body.law.StepChange;
import wbv.diagnosis.mechanism.Hypothesis.Start;

/** Stiffness and damping that change at a moment. Not looked for on a rig. */
record AbruptChange() implements Mechanism {

    /** At most so many moments at which a link may change are tried. */
    private static final int MOMENTS = 60;
    /** Part by which it changes, as it is looked at to first order. */
    private static final double SIZE = 0.1;

    @Override
    public Entry entry() {
        return new Entry("drift.step", Family.DRIFT, "The link %s changed at one moment");
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        if (scene.onRig()) {
            return List.of();
        }
        List<Start> moments = new ArrayList<>();
        for (double t = 5; t < scene.end() - 4; t += Math.max(2.5, scene.end() / MOMENTS)) {
            // A fit that is not led there starts from a link that all but goes.
            moments.add(new Start(new double[] {t, 0.1, 0.1}, new double[] {t, SIZE, SIZE}, List.of(new int[] {1, 2})));
        }
        return List.of(Hypothesis.law(this, link, "", new StepChange(scene.end() / 2, 1.1, 1.1),
                List.of(sum(1, 4, scene.end() - 3), sum(0.1, 0.05, 6).about(1), sum(0.1, 0.05, 6).about(1)), moments));
    }

    @Override
    public Doubt doubt(String key) {
        return key.equals("time_s") ? Doubt.MOMENT : Doubt.SHARE;
    }
}
