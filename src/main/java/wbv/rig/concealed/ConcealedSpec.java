package wbv.rig.concealed;

import java.util.List;

/**
 * What to conceal.
 *
 * @param name     of the case
 * @param words    mechanisms in the vocabulary's words, or {@code unlisted.*} for kinds that are in no library; none for a null; or one
 *                 {@code open.*}, a law that is in no library; or one {@code unrelated.*}, where the input is of another recording than the
 *                 outputs
 * @param strength of the effect over the usual one, &gt; 0: the part of an output's variance that the best linear fit misses is
 *                 5 to 30 % times this
 * @param exact    whether the model handed out has the true linear values; otherwise they are 3 to 15 % off
 * @param seed     of everything drawn
 */
public record ConcealedSpec(String name, List<String> words, double strength, Setting setting, boolean exact, long seed) {

    /** Mechanisms of the vocabulary that can be concealed. */
    public static final List<String> MECHANISMS = List.of("stiffness.softening", "stiffness.hardening", "stiffness.asymmetric",
            "damping.quadratic", "friction.coulomb", "hysteresis", "memory.viscoelastic", "contact.loss", "contact.bumpstop",
            "contact.backlash", "mode.hidden", "coupling.axis", "coupling.rotation", "drift.step", "drift.slow", "muscle.reflex",
            "input.unmeasured", "sensor.mount", "sensor.misalignment", "sensor.delay", "sensor.bias", "sensor.gain",
            "sensor.clipping",
            "sensor.dropouts");

    /** Kinds that no word of the vocabulary means. */
    public static final List<String> UNLISTED = List.of("unlisted.breathing", "unlisted.thixotropy", "unlisted.sway",
            "unlisted.hand");

    /** Laws that are in no library, to be learned: what a seat, its suspension or a sitter might do and nobody has named here. */
    public static final List<
            String> OPEN = List.of("open.damping.travel", "open.damping.breathing", "open.damping.level", "open.damping.tilt",
                    "open.damping.rebound", "open.damping.blow-off", "open.damping.eddy", "open.drag.lagged", "open.stiffness.load",
                    "open.stiffness.bolster",
                    "open.stiffness.mullins", "open.friction.wedge", "open.friction.load", "open.friction.side", "open.muscle.two-joint",
                    "open.cushion.orifice", "open.inerter", "open.slosh");

    /**
     * What stands by itself: the platform of one recording beside the sitter of another, who rides elsewhere or sits at rest; the force on
     * a bench beside the motion that another force made.
     */
    public static final List<
            String> UNRELATED = List.of("unrelated.ride", "unrelated.rest", "unrelated.ride", "unrelated.rest", "unrelated.bench");

    /** Where what can be concealed is not what a sitter's chain can have: sensors of benches. */
    public static final List<String> BENCHES = List.of("sensor.ac-coupled");

    /** Whether input and outputs have nothing to do with each other. */
    public boolean isUnrelated() {
        return words.stream().anyMatch(UNRELATED::contains);
    }

    /** Whether a law is concealed that is to be learned. */
    public boolean isOpen() {
        return words.stream().anyMatch(OPEN::contains);
    }

    /** Whether the force of a law that is to be learned is sealed beside the key: of one link of a chain, in one recording. */
    public boolean hasForce() {
        return isOpen() && setting != Setting.PLANAR && setting != Setting.JOINTED;
    }

    public ConcealedSpec {
        words = List.copyOf(words);
        for (String word : words) {
            if (!MECHANISMS.contains(word) && !UNLISTED.contains(word) && !BENCHES.contains(word)
                    && !((OPEN.contains(word) || UNRELATED.contains(word)) && words.size() == 1)) {
                throw new IllegalArgumentException("nothing of this name can be concealed: '" + word + "'");
            }
        }
        if (!(strength > 0)) {
            throw new IllegalArgumentException("strength must be > 0: " + strength);
        }
    }
}
