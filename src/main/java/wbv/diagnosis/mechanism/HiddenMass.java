package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Start.grid;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import wbv.body.Model;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis.Number;

/** A mass on a spring, linear or stiffening, and a dashpot on a body. Told by its frequency and damping ratio. */
record HiddenMass() implements Mechanism {

    /** A hidden part of a sitter to start from, in parts of the model's mass, and its damping ratio. */
    private static final double SHARE = 0.006;
    private static final double DAMPED = 0.12;
    /** The same on a rig. */
    private static final double RIG_SHARE = 0.02;
    private static final double RIG_DAMPED = 0.1;
    /** How much a spring stiffens [1/m²], to start from: by a tenth at 10 mm, 3 mm and 1 mm. */
    private static final double[] STIFFENING = {1e3, 1e4, 1e5};
    /** By a thousandth at 10 mm, and by as much as it is stiff at a third of a millimetre [1/m²]. */
    private static final double LINEAR = 10;
    private static final double STIFFEST = 1e7;

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

    /** The same mass on a spring that stiffens, as what hangs on tissue does. */
    @Override
    public Optional<Hypothesis> further(Hypothesis plain, double[] found) {
        Addition.Hidden hidden = (Addition.Hidden) plain.additions().get(0);
        return hidden.mode().stiffening().isPresent() ? Optional.empty() : Optional.of(stiffening(plain, hidden, found));
    }

    private Hypothesis stiffening(Hypothesis linear, Addition.Hidden hidden, double[] found) {
        double omega = Math.sqrt(found[1] / found[0]);
        List<Number> numbers = new ArrayList<>(linear.numbers());
        numbers.add(factor(LINEAR * found[1], STIFFEST * found[1]).named("k3_N_per_m3"));
        Model.HiddenMode mode = new Model.HiddenMode(found[0], omega / (2 * Math.PI), found[2] / (2 * found[0] * omega), STIFFENING[0]);
        return new Hypothesis(this, linear.where(), "stiffening", List.of(new Addition.Hidden(hidden.body(), mode)), numbers,
                grid(STIFFENING, cubic -> Start.fixed(found[0], found[1], found[2], cubic * found[1])));
    }

    private static Start start(Model.HiddenMode mode) {
        return Start.of(numbers(mode), new int[] {0, 1, 2});
    }

    private static double[] numbers(Model.HiddenMode mode) {
        return new double[] {mode.mass(), mode.stiffness(), mode.damping()};
    }

    @Override
    public List<Told> told(List<Number> numbers) {
        List<Told> told = new ArrayList<>(List.of(Told.plain(numbers.get(0).key(), 0),
                Told.product("frequency_hz", new int[] {0, 1}, new double[] {-0.5, 0.5}, x -> Math.sqrt(x[1] / x[0]) / (2 * Math.PI)),
                Told.product("damping_ratio", new int[] {0, 1, 2}, new double[] {-0.5, -0.5, 1},
                        x -> x[2] / (2 * Math.sqrt(x[1] * x[0])))));
        if (numbers.size() > 3) {
            told.add(Told.product("cubic_per_m2", new int[] {1, 3}, new double[] {-1, 1}, x -> x[1] / x[0]));
        }
        return told;
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
