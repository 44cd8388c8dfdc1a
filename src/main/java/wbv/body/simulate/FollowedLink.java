package wbv.body.simulate;

import wbv.body.Row;
import wbv.body.Structure;
import wbv.body.number.Modulator;

/**
 * What multiplies a law that goes by another link, at the end of a free run's step: linear in the state and in the forces that all laws
 * have then, and a part of that. A law that goes by none has {@link #NONE}.
 *
 * <p>Not for several threads at once.
 */
final class FollowedLink {

    /** No link is followed. */
    static final FollowedLink NONE = new FollowedLink(Modulator.NONE, -1, new double[0], new double[0], new double[0][], new double[0][], 0,
            0);

    /** Index of the link; -1 for none. */
    final int link;
    /** Whether what it carries is taken, which depends on its stiffness and its damping themselves. */
    final boolean isLoad;
    /** By state as {@link ModalStep} keeps it, and by law whose force acts then: what adds up to the whole. */
    final double[] read;
    final double[] give;
    private final Modulator modulator;
    /** By state, and by law: the link's displacement and velocity. */
    private final double[][] motionRead;
    private final double[][] motionGive;

    /** What the link's stiffness and damping, or 0 and 1, take of its displacement and velocity. */
    private final double stiffness;
    private final double damping;

    private double height;
    private double rising;
    private double sum;
    private double displacement;
    private double velocity;

    private FollowedLink(Modulator modulator, int link, double[] read, double[] give, double[][] motionRead, double[][] motionGive,
            double stiffness, double damping) {
        this.link = link;
        this.isLoad = modulator.otherLink().filter(other -> other.of() == Modulator.Of.LOAD).isPresent();
        this.modulator = modulator;
        this.read = read;
        this.give = give;
        this.motionRead = motionRead;
        this.motionGive = motionGive;
        this.stiffness = stiffness;
        this.damping = damping;
    }

    /** @param laws links of all laws */
    static FollowedLink of(Modulator modulator, Structure structure, ModalStep linear, int[] laws) {
        return modulator.otherLink().map(other -> of(modulator, other, structure, linear, laws)).orElse(NONE);
    }

    private static FollowedLink of(Modulator modulator, Modulator.OtherLink other, Structure structure, ModalStep linear, int[] laws) {
        int link = other.link();
        Row stretch = structure.stretch(link);
        double stiffness = switch (other.of()) {
            case LOAD -> structure.stiffness()[link];
            case DEFLECTION -> 1;
            case SPEED -> 0;
        };
        double damping = switch (other.of()) {
            case LOAD -> structure.damping()[link];
            case DEFLECTION -> 0;
            case SPEED -> 1;
        };
        double[] read = linear.reads(stretch, stiffness, damping);
        double[] give = linear.gives(read);
        for (int k = 0; k < laws.length && other.of() == Modulator.Of.LOAD; k++) {
            give[k] += laws[k] == link ? 1 : 0;
        }
        double[][] motion = {linear.reads(stretch, 1, 0), linear.reads(stretch, 0, 1)};
        return new FollowedLink(modulator, link, read, give, motion, new double[][] {linear.gives(motion[0]), linear.gives(motion[1])},
                stiffness, damping);
    }

    /** Whether a link is followed. */
    boolean follows() {
        return link >= 0;
    }

    /** What lifts the link at a sample, the end of the step that follows. */
    void lifted(Lift lift, int j) {
        if (follows()) {
            height = lift.height(link, j);
            rising = lift.rate(link, j);
        }
    }

    /** Derivative of the whole to a parameter that lifts the link. */
    double liftSlope(Lift lift, int p, int j) {
        return -stiffness * Lift.at(lift.heightSlope()[p][link], j) - damping * Lift.at(lift.rateSlope()[p][link], j);
    }

    /** The whole, in the modulator's unit, with all laws' forces. */
    double whole(double[] y, double[] forces) {
        return ModalStep.dot(read, y) + ModalStep.dot(give, forces) - stiffness * height - damping * rising;
    }

    /** What multiplies the law, in the modulator's unit. */
    double value(double whole) {
        return modulator instanceof Modulator.PartOf part ? part.of(whole) : whole;
    }

    /** Derivative of the value to the whole where the step has ended [1]. */
    double slope() {
        if (!(modulator instanceof Modulator.PartOf part)) {
            return 1;
        }
        return switch (part.part()) {
            case MAGNITUDE -> Math.signum(sum);
            case POSITIVE -> sum > 0 ? 1 : 0;
            case NEGATIVE -> sum < 0 ? -1 : 0;
        };
    }

    /** Keeps the motion at the end of a step. */
    void settle(double[] y, double[] forces) {
        sum = whole(y, forces);
        displacement = ModalStep.dot(motionRead[0], y) + ModalStep.dot(motionGive[0], forces) - height;
        velocity = ModalStep.dot(motionRead[1], y) + ModalStep.dot(motionGive[1], forces) - rising;
    }

    /** Displacement of the link where the step has ended [m]. */
    double displacement() {
        return displacement;
    }

    /** Velocity of the link where the step has ended [m/s]. */
    double velocity() {
        return velocity;
    }
}
