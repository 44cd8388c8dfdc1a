package wbv.proof;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.random.RandomGenerator;
import java.util.random.RandomGeneratorFactory;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Setting;
import wbv.rig.platform.Seeds;

/**
 * What the proof asks, in the order in which it asks: shuffled, so that numbers tell nothing and any beginning of it is a fair
 * sample; laws that are to be learned come after all others, shuffled among themselves, then benches, planar people and levels, and people
 * with a model of their joints and benches that change in time last, likewise.
 *
 * @param questions numbered from 1
 */
public record Suite(List<Question> questions) {

    /** What kind of question it is. */
    public enum Group {
        LISTED, NOTHING, UNLISTED, PAIR, UNRELATED, OPEN,
        /** A bench, moved by a measured force or on a measured base. */
        RIG,
        /** A person of rigid bodies in a plane, beside what the user's own simulator gave. */
        PLANAR,
        /** The same person, of whom his user has a model of bodies in a plane. */
        JOINTED,
        /** Three recordings at three levels, of a bench or a sitter. */
        LEVELS;

        /** Whether it asks of everything: mechanisms, laws that are to be learned, and nothing. */
        boolean isMixed() {
            return this == RIG || this == PLANAR || this == LEVELS || this == JOINTED;
        }
    }

    /** One question. */
    public record Question(String id, Group group, ConcealedSpec spec) {

        /**
         * How its answer is marked: {@link Group#LISTED}, {@link Group#OPEN} or {@link Group#NOTHING} where the group asks of all of them.
         */
        Group kind() {
            return !group.isMixed() ? group : spec.words().isEmpty() ? Group.NOTHING : spec.isOpen() ? Group.OPEN : Group.LISTED;
        }
    }

    private static final double[] STRENGTHS = {1, 0.3, 0.1};
    private static final int SEEDS = 5;
    private static final int NULLS = 100;
    private static final int UNLISTED = 40;
    private static final int PAIRS = 20;
    private static final int DRAWS = 3;
    /** Laws of which a ride of one level shows next to nothing: what they add is linear there, or near it. */
    private static final Set<String> OF_LEVELS = Set.of("open.damping.level", "open.drag.lagged", "open.inerter", "open.slosh");
    /** What follows the platform's rotation. */
    private static final Set<String> OF_ROTATION = Set.of("coupling.rotation", "open.damping.tilt");
    private static final List<
            String> RIG = List.of("stiffness.softening", "stiffness.hardening", "damping.quadratic", "friction.coulomb", "hysteresis",
                    "contact.bumpstop", "contact.backlash", "sensor.delay", "sensor.gain", "sensor.ac-coupled", "sensor.clipping");
    private static final List<
            String> RIG_OPEN = List.of("open.damping.rebound", "open.damping.rebound", "open.damping.blow-off", "open.damping.eddy",
                    "open.damping.travel", "open.friction.wedge");
    private static final List<String> PLANAR = List.of("stiffness.softening", "stiffness.hardening", "stiffness.asymmetric",
            "damping.quadratic",
            "friction.coulomb", "hysteresis", "contact.bumpstop", "contact.loss", "sensor.delay", "sensor.mount", "sensor.misalignment");
    /** What joints have; what a sensor's channels have in common no single one of them says. */
    private static final List<String> JOINTED = PLANAR.stream().filter(word -> !word.startsWith("sensor.")).toList();
    private static final List<String> PLANAR_OPEN = List.of("open.damping.rebound", "open.damping.travel", "open.friction.wedge");
    /** What a level changes. */
    private static final List<
            String> LEVELS = List.of("stiffness.softening", "stiffness.hardening", "damping.quadratic", "friction.coulomb", "hysteresis",
                    "contact.bumpstop", "contact.backlash");
    /** Of each of the three, with exact values, and as many with wrong ones. */
    private static final int MIXED_NULLS = 4;
    private static final List<String> RIG_CHANGING = List.of("drift.step", "drift.slow");
    /** Of each of the two and of each strength. */
    private static final int CHANGES = 4;
    private static final double FIELD = 0.3;
    private static final double EXACT = 0.3;

    /** The full proof. */
    public static Suite full(long seed) {
        Draft draft = new Draft(seed);
        for (String mechanism : ConcealedSpec.MECHANISMS) {
            for (double strength : STRENGTHS) {
                for (int i = 0; i < SEEDS; i++) {
                    draft.add(Group.LISTED, List.of(mechanism), strength);
                }
            }
        }
        for (int i = 0; i < NULLS; i++) {
            draft.add(Group.NOTHING, List.of(), 1);
        }
        for (int i = 0; i < UNLISTED; i++) {
            draft.add(Group.UNLISTED, List.of(ConcealedSpec.UNLISTED.get(i % ConcealedSpec.UNLISTED.size())), i % 3 == 2 ? 0.3
                    : 1);
        }
        for (int i = 0; i < PAIRS; i++) {
            draft.pair();
        }
        // From a source of their own and after all others, so that these stay what they were before there were open ones.
        Draft open = new Draft(new Seeds(seed).of("open").seed());
        for (int i = 0; i < DRAWS; i++) {
            for (String law : ConcealedSpec.OPEN) {
                open.add(Group.OPEN, List.of(law), i % 3 == 2 ? 0.3 : 1);
            }
        }
        List<Question> questions = new ArrayList<>(draft.shuffled().questions);
        questions.addAll(open.shuffled(questions.size()).questions);
        questions.addAll(mixed(seed).shuffled(questions.size()).questions);
        questions.addAll(jointed(seed).shuffled(questions.size()).questions);
        questions.addAll(changing(seed).shuffled(questions.size()).questions);
        return new Suite(questions);
    }

    /** Benches, planar people and levels, from a source of their own. */
    private static Draft mixed(long seed) {
        Draft draft = new Draft(new Seeds(seed).of("rig, planar, levels").seed());
        for (double strength : List.of(1.0, 0.3)) {
            RIG.forEach(word -> draft.add(Group.RIG, List.of(word), strength, Setting.BENCH, false));
            PLANAR.forEach(word -> draft.add(Group.PLANAR, List.of(word), strength, Setting.PLANAR, false));
        }
        RIG_OPEN.forEach(word -> draft.add(Group.RIG, List.of(word), 1, Setting.BENCH, false));
        PLANAR_OPEN.forEach(word -> draft.add(Group.PLANAR, List.of(word), 1, Setting.PLANAR, false));
        LEVELS.forEach(word -> List.of(Setting.BENCH_LEVELS, Setting.RIDE_LEVELS)
                .forEach(setting -> draft.add(Group.LEVELS, List.of(word), 1, setting, false)));
        for (boolean exact : List.of(true, false)) {
            for (int i = 0; i < MIXED_NULLS; i++) {
                draft.add(Group.RIG, List.of(), 1, Setting.BENCH, exact);
                draft.add(Group.PLANAR, List.of(), 1, Setting.PLANAR, exact);
                draft.add(Group.LEVELS, List.of(), 1, i % 2 == 0 ? Setting.BENCH_LEVELS : Setting.RIDE_LEVELS, exact);
            }
        }
        return draft;
    }

    /** People in a plane with a model of their joints, from a source of their own. */
    private static Draft jointed(long seed) {
        Draft draft = new Draft(new Seeds(seed).of("jointed").seed());
        for (double strength : List.of(1.0, 0.3)) {
            JOINTED.forEach(word -> draft.add(Group.JOINTED, List.of(word), strength, Setting.JOINTED, false));
        }
        PLANAR_OPEN.forEach(word -> draft.add(Group.JOINTED, List.of(word), 1, Setting.JOINTED, false));
        for (boolean exact : List.of(true, false)) {
            for (int i = 0; i < MIXED_NULLS; i++) {
                draft.add(Group.JOINTED, List.of(), 1, Setting.JOINTED, exact);
            }
        }
        return draft;
    }

    /** Benches that change in time, from a source of their own. */
    private static Draft changing(long seed) {
        Draft draft = new Draft(new Seeds(seed).of("changing").seed());
        for (double strength : List.of(1.0, 0.3)) {
            for (int i = 0; i < CHANGES; i++) {
                RIG_CHANGING.forEach(word -> draft.add(Group.RIG, List.of(word), strength, Setting.BENCH, false));
            }
        }
        return draft;
    }

    /** A dozen questions of all kinds. */
    public static Suite quick(long seed) {
        Draft draft = new Draft(seed);
        for (String mechanism : List.of("stiffness.softening", "friction.coulomb", "contact.bumpstop", "mode.hidden",
                "drift.step",
                "sensor.mount", "sensor.delay", "input.unmeasured")) {
            draft.add(Group.LISTED, List.of(mechanism), 1);
        }
        draft.add(Group.NOTHING, List.of(), 1);
        draft.add(Group.NOTHING, List.of(), 1);
        draft.add(Group.UNLISTED, List.of("unlisted.breathing"), 1);
        return draft.shuffled();
    }

    /** The negative control: recordings whose outputs have nothing to do with their input, of which nothing can be said. */
    public static Suite unrelated(long seed) {
        Draft draft = new Draft(seed);
        for (int i = 0; i < NULLS; i++) {
            draft.add(Group.UNRELATED, List.of(ConcealedSpec.UNRELATED.get(i % ConcealedSpec.UNRELATED.size())), 1);
        }
        return draft.shuffled();
    }

    /** Those from one number to another, counted from 1, both included; as many as there are. */
    public Suite part(int from, int to) {
        int end = Math.min(to, questions.size());
        return new Suite(questions.subList(Math.min(Math.max(from, 1) - 1, end), end));
    }

    /**
     * Those with a mechanism or an open law, or {@code nothing}, {@code unlisted}, {@code pair}, {@code open}, {@code rig}, {@code planar},
     * {@code jointed}, {@code levels}.
     *
     * @param words one of these or several, with commas between
     */
    public Suite only(String words) {
        List<String> any = List.of(words.split(","));
        return new Suite(questions.stream().filter(q -> any.contains(q.group().name().toLowerCase(Locale.ROOT))
                || (q.group() == Group.LISTED || q.group() == Group.OPEN) && q.spec().words().stream().anyMatch(any::contains)).toList());
    }

    private static final class Draft {
        private final List<Group> groups = new ArrayList<>();
        private final List<ConcealedSpec> specs = new ArrayList<>();
        private final RandomGenerator random;

        Draft(long seed) {
            random = RandomGeneratorFactory.of("L64X128MixRandom").create(seed);
        }

        void add(Group group, List<String> words, double strength) {
            boolean field = random.nextDouble() < FIELD;
            Setting setting = field ? Setting.FIELD : random.nextDouble() < 0.2 ? Setting.ROTATION : Setting.RIG;
            if (words.stream().anyMatch(OF_ROTATION::contains)) {
                setting = Setting.ROTATION;
            }
            if (words.stream().anyMatch(OF_LEVELS::contains)) {
                setting = Setting.RIG;
            }
            groups.add(group);
            specs.add(new ConcealedSpec("?", words, strength, setting, words.isEmpty() && random.nextDouble() < EXACT,
                    random.nextLong()));
        }

        void add(Group group, List<String> words, double strength, Setting setting, boolean exact) {
            groups.add(group);
            specs.add(new ConcealedSpec("?", words, strength, setting, exact, random.nextLong()));
        }

        /** Two plain mechanisms, one at least in the body. */
        void pair() {
            List<String> all = ConcealedSpec.MECHANISMS;
            List<String> body = all.stream().filter(word -> !word.startsWith("sensor.")).toList();
            String first = body.get(random.nextInt(body.size()));
            String second = first;
            while (second.equals(first)) {
                second = all.get(random.nextInt(all.size()));
            }
            add(Group.PAIR, List.of(first, second), 1);
        }

        Suite shuffled() {
            return shuffled(0);
        }

        /** @param before how many questions are asked before */
        Suite shuffled(int before) {
            List<Question> out = new ArrayList<>();
            List<Integer> order = new ArrayList<>();
            for (int i = 0; i < specs.size(); i++) {
                order.add(random.nextInt(order.size() + 1), i);
            }
            for (int i : order) {
                String id = String.format(Locale.ROOT, "%03d", before + out.size() + 1);
                ConcealedSpec spec = specs.get(i);
                out.add(new Question(id, groups.get(i), new ConcealedSpec(id, spec.words(), spec.strength(), spec.setting(),
                        spec.exact(),
                        spec.seed())));
            }
            return new Suite(out);
        }
    }
}
