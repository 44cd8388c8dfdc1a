package wbv.rig.concealed;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import org.apache.commons.math3.random.RandomGenerator;

/** Chooses a place for a mechanism and sizes it by the scene. */
final class Recipes {

    private static final String LOSS = "contact.loss";

    private final RideScene scene;
    private final RandomGenerator random;

    Recipes(RideScene scene, RandomGenerator random) {
        this.scene = scene;
        this.random = random;
    }

    /** @param taken places that another omission already holds */
    OmissionRecipe of(String word, Set<String> taken) {
        if (word.startsWith("sensor.")) {
            return new SensorRecipes(scene, one(scene.outputs().stream().filter(p -> !taken.contains(p + ".acc.z")).toList()),
                    random).of(word);
        }
        if (word.startsWith("open.")) {
            return open(word, taken);
        }
        return switch (word) {
            case "mode.hidden" -> hidden(one(bodies(taken, Set.of("torso", "pelvis"))));
            case "input.unmeasured" -> force(one(bodies(taken, Set.of("seat", "pelvis", "torso", "head"))));
            case "unlisted.hand" -> hand(scene.chain().body("torso"));
            case "coupling.rotation" -> rotation(one(links(taken, Set.of("seat", "pelvis", "torso"))));
            case "coupling.axis" -> across(one(links(taken, Set.of("pelvis", "torso", "head"))));
            case LOSS -> link(word, one(links(taken, Set.of(scene.chain().parent()[1] >= 0
                    && scene.chain().body("seat") == 0
                            ? scene.chain().names().get(1) : scene.chain().names().get(0)))));
            case "muscle.reflex" -> link(word, one(links(taken, Set.of("torso", "head"))));
            // The neck moves too little for these to show.
            case "friction.coulomb", "hysteresis", "damping.quadratic", "memory.viscoelastic" ->
                link(word, one(links(taken, Set.of("seat", "pelvis", "torso"))));
            default -> link(word, one(links(taken, Set.of("seat", "pelvis", "torso", "head"))));
        };
    }

    private OmissionRecipe open(String word, Set<String> taken) {
        Set<String> upper = switch (word) {
            case "open.slosh" -> Set.of("torso", "pelvis");
            // Elsewhere a chain of other masses does much the same.
            case "open.inerter" -> Set.of("head");
            // What stiffens a neck shows at the head, though the neck moves little.
            case "open.stiffness.load", "open.muscle.two-joint" -> Set.of("seat", "pelvis", "torso", "head");
            default -> Set.of("seat", "pelvis", "torso");
        };
        return new OpenRecipes(scene, one(links(taken, upper)), random).of(word);
    }

    /** The words with those first that only one place will do for, before another takes it. */
    static List<String> choosyFirst(List<String> words) {
        return words.stream().sorted(Comparator.comparing(word -> !word.equals(LOSS))).toList();
    }

    private OmissionRecipe link(String word, int link) {
        return new LinkRecipes(scene, link, random).of(word);
    }

    private OmissionRecipe hidden(int body) {
        double frequency = 4 + 4 * random.nextDouble();
        double zeta = 0.08 + 0.12 * random.nextDouble();
        double omega = 2 * Math.PI * frequency;
        String name = scene.chain().names().get(body);
        return new OmissionRecipe(0.01, 0.3, a -> {
            double mass = a * scene.chain().mass()[body];
            return new Omission("mode.hidden", name, "a swinging mass", Map.of("mass_kg", mass, "stiffness_N_per_m",
                    mass * omega * omega,
                    "damping_Ns_per_m", 2 * zeta * mass * omega),
                    setup -> setup.ride(new Setup.Rider(body, mass, mass * omega * omega, 2 * zeta * mass * omega)));
        });
    }

    private OmissionRecipe force(int body) {
        String name = scene.chain().names().get(body);
        int length = scene.shaking().length();
        if (random.nextBoolean()) {
            double frequency = 3 + 6 * random.nextDouble();
            double phase = 2 * Math.PI * random.nextDouble();
            double[] tone = IntStream.range(0, length).mapToDouble(i -> Math.sin(2 * Math.PI * frequency * i / UniformSeries.RATE
                    + phase)).toArray();
            return new OmissionRecipe(0.3, 100, a -> new Omission("input.unmeasured", name, "tone", Map.of("frequency_hz", frequency,
                    "amplitude_N", a),
                    setup -> setup.push(body, UniformSeries.scaled(tone, a))));
        }
        double[] broad = UniformSeries.lines(length, 1.5, 8, -0.5, 1, random);
        return new OmissionRecipe(0.3, 100, a -> new Omission("input.unmeasured", name, "broadband", Map.of("rms_N", a),
                setup -> setup.push(body, UniformSeries.scaled(broad, a))));
    }

    /** Pushes of a hand now and then. */
    private OmissionRecipe hand(int body) {
        double[] push = UniformSeries.lines(scene.shaking().length(), 0.6, 6, -0.3, 1, random);
        int burst = (int) (2.5 * UniformSeries.RATE);
        for (int from = 0; from < push.length; from += burst) {
            double gain = random.nextDouble() < 0.5 ? 0 : 1 + random.nextDouble();
            for (int i = from; i < Math.min(push.length, from + burst); i++) {
                push[i] *= gain * Math.sin(Math.PI * (i - from) / burst);
            }
        }
        double[] unit = UniformSeries.scaled(push, 1 / Math.max(1e-9, UniformSeries.rms(push)));
        return new OmissionRecipe(0.3, 80, a -> new Omission("unknown", scene.chain().names().get(body), "hand that pushes now and then",
                Map.of("rms_N", a), setup -> setup.push(body, UniformSeries.scaled(unit, a))));
    }

    /** Pitch lifts the lower end of a link: k arm θ + c arm θ' pulls the upper body down. */
    private OmissionRecipe rotation(int link) {
        double[] angle = scene.shaking().pitch();
        double[] rate = UniformSeries.rate(angle);
        double k = scene.chain().stiffness()[link];
        double c = scene.chain().damping()[link];
        double[] unit = IntStream.range(0, angle.length).mapToDouble(i -> k * angle[i] + c * rate[i]).toArray();
        return new OmissionRecipe(0.005, 0.5, a -> new Omission("coupling.rotation", scene.chain().link(link), "lever arm on the pitch",
                Map.of("lever_arm_m", a), setup -> setup.pull(link, UniformSeries.scaled(unit, a))));
    }

    private OmissionRecipe across(int link) {
        Chain chain = scene.chain();
        String upper = chain.place(link);
        String lower = chain.parent()[link] < 0 ? Chain.PLATFORM : chain.place(chain.parent()[link]);
        double[] u = UniformSeries.less(scene.fore().get(upper).displacement(), scene.fore().get(lower).displacement());
        double unit = chain.stiffness()[link] * UniformSeries.rms(scene.calm().extension()[link]) / UniformSeries.rms(u);
        return new OmissionRecipe(0.02, 3, a -> new Omission("coupling.axis", chain.link(link), "spring across, fore and aft",
                Map.of("cross_stiffness_N_per_m", a * unit), setup -> setup.pull(link, UniformSeries.scaled(u, a * unit))));
    }

    private List<Integer> bodies(Set<String> taken, Set<String> names) {
        return IntStream.range(0, scene.chain().size()).filter(i -> names.contains(scene.chain().names().get(i))
                && !taken.contains(scene.chain().names().get(i))).boxed().toList();
    }

    private List<Integer> links(Set<String> taken, Set<String> upper) {
        return IntStream.range(0, scene.chain().size()).filter(i -> upper.contains(scene.chain().names().get(i))
                && !taken.contains(scene.chain().link(i))).boxed().toList();
    }

    private <T> T one(List<T> choices) {
        List<T> open = new ArrayList<>(choices);
        return open.get(random.nextInt(open.size()));
    }
}
