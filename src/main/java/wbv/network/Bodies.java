package wbv.network;

import java.util.List;
import java.util.Optional;
import java.util.random.RandomGenerator;
import wbv.recording.Channel;
import wbv.rig.RigSpec;
import wbv.rig.Sitter;
import wbv.rig.Subject;
import wbv.rig.platform.Axis;
import wbv.rig.platform.PlatformExcitation;
import wbv.rig.platform.Program;

/** Kinds of sitter that trials are drawn from, each with its own ranges; every trial has a body of its own. */
public enum Bodies {

    /** One linear mode: ζ 0.1 to 0.6, 2 to 9 Hz, evenly; seat and head. */
    ONE_DOF("1-dof", 1, "seat.acc.z", "head.acc.z"),
    /** Two masses: uncoupled 3 to 7 Hz and 1.5 to 2.5 times that, ζ 0.15 to 0.5, mass ratio 0.1 to 0.5; seat and sternum. */
    TWO_DOF("2-dof", 2, "seat.acc.z", "sternum.acc.z"),
    /**
     * The four simulated people, who soften; vertical shaking only; seat and sternum. Their truth is the slowest vertical mode.
     */
    PEOPLE("people", 1, "seat.acc.z", "sternum.acc.z"),
    /** The same under the nine regimes: all six axes at once. */
    PEOPLE_SIX_AXES("people-six-axes", 1, "seat.acc.z", "sternum.acc.z"),
    /** {@link #ONE_DOF} with forty times the noise of the sensors. */
    NOISY("noisy", 1, "seat.acc.z", "head.acc.z"),
    /** {@link #TWO_DOF} shown to who knows one mode only. */
    TWO_AS_ONE("2-dof-as-1", 1, "seat.acc.z", "sternum.acc.z"),
    /** {@link #PEOPLE} shown to who knows two modes: their truth is the two slowest. */
    PEOPLE_AS_TWO("people-as-2", 2, "seat.acc.z", "sternum.acc.z"),
    /** {@link #TWO_DOF} with forty times the noise of the sensors. */
    TWO_NOISY("2-dof-noisy", 2, "seat.acc.z", "sternum.acc.z"),
    /**
     * {@link #ONE_DOF} whose base moves in x, y and z, each as {@link #ONE_DOF}'s in z, and is pushed up by -0.5 to 0.5 of its
     * mass times the acceleration in x, and in y.
     */
    COUPLED("coupled", 1, "seat.acc.z", "head.acc.z", "seat.acc.x", "seat.acc.y");

    private static final double TAU = 2 * Math.PI;
    private static final double SETTLE = 1.5;
    /** A program fades over its last half second, which no image may show [s]. */
    static final double FADE = 0.5;

    private final String word;
    private final int modes;
    private final List<Channel> channels;

    Bodies(String word, int modes, String... channels) {
        this.word = word;
        this.modes = modes;
        this.channels = List.of(channels).stream().map(Channel::parse).toList();
    }

    /** What the command line calls them. */
    public String word() {
        return word;
    }

    /** Modes whose damping ratio and frequency are asked for. */
    public int modes() {
        return modes;
    }

    /** Excitation first, answer second; then what else moves the base. */
    public List<Channel> channels() {
        return channels;
    }

    /**
     * Draws an experiment of just over one image.
     *
     * @param random modified
     * @param seed of the experiment's own noise
     */
    RigSpec draw(RandomGenerator random, long seed) {
        double rms = level(random);
        double seconds = SETTLE + Imaging.SAMPLES / Imaging.RATE + FADE;
        Sitter sitter = switch (this) {
            case ONE_DOF, NOISY -> new Sitter.OneDof(uniform(random, 0.1, 0.6), uniform(random, 2, 9), Optional.empty());
            case TWO_DOF, TWO_AS_ONE, TWO_NOISY -> two(random);
            case COUPLED -> new Sitter.OneDof(uniform(random, 0.1, 0.6), uniform(random, 2, 9), Optional.empty(),
                    uniform(random, -0.5, 0.5), uniform(random, -0.5, 0.5));
            case PEOPLE, PEOPLE_SIX_AXES, PEOPLE_AS_TWO -> new Sitter.Person(Subject.of(1 + random.nextInt(4)));
        };
        double noise = (this == NOISY || this == TWO_NOISY ? 40 : 1) * uniform(random, 0.5, 2);
        PlatformExcitation excitation = switch (this) {
            case PEOPLE_SIX_AXES -> new PlatformExcitation.OfRegime(1 + random.nextInt(8));
            case COUPLED -> new PlatformExcitation.Together(List.of(shaking(Axis.Z, rms, random),
                    shaking(Axis.X, level(random), random), shaking(Axis.Y, level(random), random)));
            default -> shaking(Axis.Z, rms, random);
        };
        RigSpec usual = RigSpec.oneDof(0.35, 5, 1, seconds, seed);
        double warm = sitter instanceof Sitter.Person ? 10 : 0; // softening remembers five seconds
        return new RigSpec(sitter, Program.of(excitation, seconds + warm), seed, Imaging.RATE, usual.filter(), noise,
                usual.effects(), channels);
    }

    private static PlatformExcitation shaking(Axis axis, double rms, RandomGenerator random) {
        return new PlatformExcitation.Random(axis, 0.5, uniform(random, 10, 15), rms);
    }

    private static double level(RandomGenerator random) {
        return Math.exp(uniform(random, Math.log(0.3), Math.log(2)));
    }

    private static Sitter two(RandomGenerator random) {
        double torso = uniform(random, 35, 60);
        double head = torso * uniform(random, 0.1, 0.5);
        double slow = TAU * uniform(random, 3, 7);
        double fast = slow * uniform(random, 1.5, 2.5);
        double k1 = (torso + head) * slow * slow;
        double c1 = 2 * uniform(random, 0.15, 0.5) * (torso + head) * slow;
        double k2 = head * fast * fast;
        double c2 = 2 * uniform(random, 0.15, 0.5) * head * fast;
        return new Sitter.TwoDof(torso, k1, c1, head, k2, c2, Optional.empty());
    }

    private static double uniform(RandomGenerator random, double low, double high) {
        return low + (high - low) * random.nextDouble();
    }
}
