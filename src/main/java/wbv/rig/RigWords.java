package wbv.rig;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import wbv.recording.Channel;
import wbv.rig.platform.Program;
import wbv.rig.platform.SpecNumbers;

/** Reads the words of a {@link RigSpec}; what {@link RigSpec#parse} promises. */
final class RigWords {

    private static final List<String> KEYS = List.of("sitter", "subject", "mass", "posture", "zeta", "f0", "cross", "torso", "head", "step",
            "excitation", "regime", "seconds", "seed", "rate", "filter", "noise", "gravity", "channels", "effects");

    /** Eleven days [s]: what is longer is a slip of the keyboard, and would fill the disk. */
    private static final double LONGEST = 1e6;

    private final Map<String, String> words = new LinkedHashMap<>();

    RigWords(String text) {
        for (String word : text.isBlank() ? new String[0] : text.trim().split("\\s+")) {
            int equals = word.indexOf('=');
            String key = equals < 0 ? word : word.substring(0, equals);
            if (equals < 0 || !KEYS.contains(key)) {
                throw new IllegalArgumentException(
                        "a word of a rig spec is key=value with a key of " + KEYS + ": '" + word + "'");
            }
            if (words.put(key, word.substring(equals + 1)) != null) {
                throw new IllegalArgumentException("said twice in the rig spec: " + key);
            }
        }
    }

    RigSpec spec() {
        Sitter sitter = sitter();
        boolean person = sitter instanceof Sitter.Person;
        String excitation = excitation(person);
        OptionalDouble seconds = words.containsKey("seconds")
                ? OptionalDouble.of(seconds()) : OptionalDouble.empty();
        boolean gravity = gravity();
        List<Channel> channels = words.containsKey("channels")
                ? Channels.parse(words.get("channels"), sitter, gravity) : Channels.usual(sitter, gravity);
        return new RigSpec(sitter, Program.parse(excitation, seconds), seed(), number("rate", 60),
                AntiAlias.parse(words.getOrDefault("filter", "boxcar")), number("noise", 1),
                Effects.parse(words.getOrDefault("effects", "usual")), channels);
    }

    private Sitter sitter() {
        String kind = words.getOrDefault("sitter", "person");
        switch (kind) {
            case "person":
                forbid(kind, "zeta", "f0", "cross", "torso", "head", "step");
                return new Sitter.Person(subject());
            case "one-dof":
                forbid(kind, "subject", "mass", "posture", "torso", "head");
                double[] cross = cross();
                return new Sitter.OneDof(number("zeta", 0.35), number("f0", 5), step(), cross[0], cross[1]);
            case "two-dof":
                forbid(kind, "subject", "mass", "posture", "zeta", "f0", "cross");
                double[] torso = triple("torso", "50.2,74300,2807");
                double[] head = triple("head", "5.5,41000,318");
                return new Sitter.TwoDof(torso[0], torso[1], torso[2], head[0], head[1], head[2], step());
            default:
                throw new IllegalArgumentException("a sitter is one of person one-dof two-dof: '" + kind + "'");
        }
    }

    private Subject subject() {
        Subject subject = Subject.parse(words.getOrDefault("subject", "1"))
                .withPosture(Posture.parse(words.getOrDefault("posture", "normal")));
        return words.containsKey("mass") ? subject.withMass(number("mass", 0)) : subject;
    }

    private String excitation(boolean person) {
        if (words.containsKey("regime")) {
            forbid("regime", "excitation");
            return "regime:" + words.get("regime");
        }
        return words.getOrDefault("excitation", person ? "regime:1" : "random:z:0.5-12:1");
    }

    private Optional<Sitter.Step> step() {
        String word = words.get("step");
        if (word == null) {
            return Optional.empty();
        }
        String[] part = word.split("@", -1);
        if (part.length != 2) {
            throw new IllegalArgumentException("a step is factor@seconds, as 1.25@60: '" + word + "'");
        }
        double factor = SpecNumbers.parse("stiffness factor", part[0]);
        return Optional.of(new Sitter.Step(factor, SpecNumbers.parse("time of the step", part[1])));
    }

    private double[] cross() {
        String[] part = words.getOrDefault("cross", "0,0").split(",", -1);
        if (part.length != 2) {
            throw new IllegalArgumentException("cross is two numbers, of x and of y, as 0.3,-0.2: '" + words.get("cross") + "'");
        }
        return new double[] {SpecNumbers.parse("cross", part[0]), SpecNumbers.parse("cross", part[1])};
    }

    private double[] triple(String key, String usual) {
        String[] part = words.getOrDefault(key, usual).split(",", -1);
        if (part.length != 3) {
            throw new IllegalArgumentException(
                    key + " must be mass,stiffness,damping in kg, N/m, N·s/m: '" + words.get(key) + "'");
        }
        return new double[] {SpecNumbers.parse(key, part[0]), SpecNumbers.parse(key, part[1]), SpecNumbers.parse(key, part[2])};
    }

    private boolean gravity() {
        String word = words.getOrDefault("gravity", "removed");
        if (!word.equals("removed") && !word.equals("included")) {
            throw new IllegalArgumentException("gravity is removed or included: '" + word + "'");
        }
        return word.equals("included");
    }

    private long seed() {
        String word = words.getOrDefault("seed", "1");
        try {
            return Long.parseLong(word);
        } catch (NumberFormatException notANumber) {
            throw new IllegalArgumentException("seed must be a whole number: '" + word + "'", notANumber);
        }
    }

    private double seconds() {
        double seconds = number("seconds", 0);
        if (!(seconds > 0 && seconds <= LONGEST)) {
            throw new IllegalArgumentException("seconds must be > 0 to " + SpecNumbers.plain(LONGEST) + ": " + words.get("seconds"));
        }
        return seconds;
    }

    private double number(String key, double usual) {
        return words.containsKey(key) ? SpecNumbers.parse(key, words.get(key)) : usual;
    }

    private void forbid(String with, String... keys) {
        for (String key : keys) {
            if (words.containsKey(key)) {
                throw new IllegalArgumentException(key + " means nothing with " + with);
            }
        }
    }
}
