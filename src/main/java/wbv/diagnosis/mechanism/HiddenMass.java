package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Hypothesis.Start.grid;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import wbv.body.Model;
import wbv.diagnosis.mechanism.Hypothesis.Addition;
import wbv.diagnosis.mechanism.Hypothesis.Number;
import wbv.diagnosis.mechanism.Hypothesis.Start;

/** A mass on a spring and a dashpot on a body. Told by its frequency and damping ratio. */
record HiddenMass() implements Mechanism {

    /** A hidden part of a sitter to start from, in parts of the model's mass, and its damping ratio. */
    private static final double SHARE = 0.006;
    private static final double DAMPED = 0.12;
    /** The same on a rig. */
    private static final double RIG_SHARE = 0.02;
    private static final double RIG_DAMPED = 0.1;

    @Override
    public Entry entry() {
        return new Entry("mode.hidden", Family.DYNAMIC, "A mass that no sensor sees swings on %s",
                "Put a third sensor on the torso (abdomen beside sternum), or record relaxed and tensed.");
    }

    @Override
    public List<Hypothesis> onBody(Scene scene, int body) {
        return scene.onRig() ? onRig(scene, body) : onPerson(scene, body);
    }

    private List<Hypothesis> onPerson(Scene scene, int body) {
        double mass = SHARE * Arrays.stream(scene.structure().mass()).sum();
        double[] low = numbers(new Model.HiddenMode(0.05, 1.2, 0.005));
        double[] high = numbers(new Model.HiddenMode(40, 22, 1.2));
        return List.of(hypothesis(scene, body, new Model.HiddenMode(mass, 5, DAMPED), low, high,
                grid(new double[] {3, 4.5, 6, 8, 11}, f -> start(new Model.HiddenMode(mass, f, DAMPED)))));
    }

    private List<Hypothesis> onRig(Scene scene, int body) {
        double mass = Arrays.stream(scene.structure().mass()).sum();
        double stiffness = Arrays.stream(scene.structure().stiffness()).max().orElse(0);
        if (scene.model().driven() || !(stiffness > 0)) {
            return List.of();
        }
        double natural = Math.sqrt(stiffness / mass) / (2 * Math.PI);
        Model.HiddenMode mode = new Model.HiddenMode(RIG_SHARE * mass, natural, RIG_DAMPED);
        double[] low = {1e-4 * mass, 1e-6 * stiffness, 1e-4 * mode.damping()};
        double[] high = {3 * mass, 30 * stiffness, 1e4 * mode.damping()};
        return List.of(hypothesis(scene, body, mode, low, high,
                grid(new double[] {0.5, 1, 2}, q -> start(new Model.HiddenMode(RIG_SHARE * mass, q * natural, RIG_DAMPED)))));
    }

    private Hypothesis hypothesis(Scene scene, int body, Model.HiddenMode mode, double[] low, double[] high, List<Start> starts) {
        return new Hypothesis(this, scene.model().bodies().get(body).name(), "", List.of(new Addition.Hidden(body, mode)),
                List.of(factor(low[0], high[0]).named("mass_kg"), factor(low[1], high[1]).named("stiffness_N_per_m"),
                        factor(low[2], high[2]).named("damping_Ns_per_m")),
                starts);
    }

    private static Start start(Model.HiddenMode mode) {
        return Start.of(numbers(mode), new int[] {0, 1, 2});
    }

    private static double[] numbers(Model.HiddenMode mode) {
        return new double[] {mode.mass(), mode.stiffness(), mode.damping()};
    }

    @Override
    public List<Told> told(List<Number> numbers) {
        return List.of(Told.plain(numbers.get(0).key(), 0),
                Told.product("frequency_hz", new int[] {0, 1}, new double[] {-0.5, 0.5}, x -> Math.sqrt(x[1] / x[0]) / (2 * Math.PI)),
                Told.product("damping_ratio", new int[] {0, 1, 2}, new double[] {-0.5, -0.5, 1}, x -> x[2] / (2 * Math.sqrt(x[1] * x[0]))));
    }

    @Override
    public Optional<String> against(Mechanism rival) {
        if (rival instanceof Viscoelasticity) {
            return Optional.of("Load the link with a step and hold it for minutes: a memory creeps, a mass does not. Or "
                    + "put a third sensor on the torso (abdomen beside sternum).");
        }
        return rival instanceof StretchReflex ? Optional.of(entry().experiment()) : Optional.empty();
    }

    @Override
    public boolean isAlwaysRefitted() {
        return true;
    }

    /** A mass of half a person. */
    @Override
    public boolean imitatesAt(String key, boolean low) {
        return true;
    }
}
