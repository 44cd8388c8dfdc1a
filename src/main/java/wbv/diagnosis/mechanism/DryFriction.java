package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;
import static wbv.diagnosis.mechanism.Start.fixed;
import static wbv.diagnosis.mechanism.Start.grid;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.DoubleSupplier;
import wbv.body.law.BristleFriction;
import wbv.body.law.CoulombFriction;

/** Dry friction: of which speed tells the sign, or of bristles that bend before they slide. */
record DryFriction() implements Mechanism {

    static final String CREEP = "Record a very low level (0.05 to 0.1 m/s²), where friction sticks, and a slow sine at 0.3 Hz.";

    /**
     * How slow it creeps at least that sticks, in parts of the usual speed: less than a hundredth of a millimetre in a minute for what goes
     * at a tenth of a metre a second.
     */
    static final double STUCK = 1e-6;

    private static final String BRISTLES = "bristles";
    private static final String TRANSITION = "transition_m_per_s";
    /** Which of the two it is. */
    private static final String REGIME = "regime";
    private static final String STICKS = "sticks";
    private static final String YIELDS = "yields";

    @Override
    public Together together() {
        return Together.LOOP;
    }

    @Override
    public Entry entry() {
        return new Entry("friction.coulomb", Family.LOSS, "The link %s sticks: dry friction", CREEP);
    }

    @Override
    public String sentence(Set<String> keys, Map<String, String> form) {
        return YIELDS.equals(form.get(REGIME))
                ? "A damper in %s yields: nothing sticks, and above the transition speed its force hardly grows" : entry().sentence();
    }

    /**
     * Below the transition its force grows with speed as a dashpot's does: where the link's usual speed is no higher than that, there is no
     * time in which it sticks, whatever name friction has.
     */
    @Override
    public Map<String, String> form(Hypothesis found, Map<String, Double> numbers, DoubleSupplier speed) {
        return numbers.containsKey(TRANSITION)
                ? Map.of(REGIME, numbers.get(TRANSITION) < speed.getAsDouble() ? STICKS : YIELDS) : Map.of();
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        return scene.onRig() ? onRig(link) : onPerson(link);
    }

    private List<Hypothesis> onPerson(Scene.Link link) {
        double r = link.deflection();
        double v = link.speed();
        return List.of(Hypothesis.law(this, link, "", new CoulombFriction(1, 1e-3), List.of(sum(1, 0, 300), factor(2e-5, 2e-2)),
                grid(new double[] {0.02, 0.15}, q -> Start.of(new double[] {1, Math.max(3e-4, q * v)}, new int[] {0}))),
                Hypothesis.law(this, link, BRISTLES, new BristleFriction(1, 1.05, 0.01, 1 / (0.2 * r)),
                        List.of(sum(1, 1e-3, 300), sum(1, 1e-3, 400), factor(1e-3, 0.1), factor(0.02 / r, 2e4 / r)),
                        grid(new double[] {0.1, 0.5}, q -> Start.of(new double[] {1, 1.05, 0.01, 1 / (q * r)}, new int[] {0, 1, 3}))));
    }

    private List<Hypothesis> onRig(Scene.Link link) {
        double r = link.deflection();
        double v = link.speed();
        double f = link.force();
        return List.of(Hypothesis.law(this, link, "", new CoulombFriction(f, v), List.of(sum(0.3 * f, 0, 10 * f), factor(STUCK * v, 3 * v)),
                grid(new double[] {1e-4, 0.02, 0.15, 0.6}, q -> Start.of(new double[] {f, q * v}, new int[] {0}))),
                Hypothesis.law(this, link, BRISTLES, new BristleFriction(f, 1.1 * f, 0.3 * v, 10 * f / r),
                        List.of(factor(1e-3 * f, 10 * f), factor(1e-3 * f, 20 * f), factor(1e-2 * v, 30 * v),
                                factor(0.1 * f / r, 1000 * f / r)),
                        bristles(f, r, v)));
    }

    /** What breaks loose may do so at once or hardly before it is fast: between the two a fit finds no way. */
    private static List<Start> bristles(double f, double r, double v) {
        List<Start> starts = new ArrayList<>();
        for (double speed : new double[] {0.3, 0.03}) {
            for (double bend : new double[] {2, 10, 50}) {
                starts.add(fixed(f, 1.1 * f, speed * v, bend * f / r));
            }
        }
        return starts;
    }

    /** With bristles that bend as far under the friction that was found: how strong it is shows in any form. */
    @Override
    public Optional<Hypothesis> begunAt(Hypothesis form, double[] found) {
        return Optional.of(form).filter(bristles -> bristles.form().equals(BRISTLES) && found[0] > 0)
                .map(bristles -> new Hypothesis(this, bristles.where(), BRISTLES, bristles.additions(), bristles.numbers(),
                        bristles.starts().stream().map(start -> as(found[0], start.values())).toList()));
    }

    private static Start as(double friction, double[] bristles) {
        double by = friction / bristles[0];
        return fixed(friction, by * bristles[1], bristles[2], by * bristles[3]);
    }

    @Override
    public Optional<String> against(Mechanism rival) {
        return rival instanceof Hysteresis ? Optional.of(CREEP) : Optional.empty();
    }
}
