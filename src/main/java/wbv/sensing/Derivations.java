package wbv.sensing;

import java.util.List;
import java.util.Optional;
import wbv.recording.Channel;

/**
 * Channels that are to be derived from those of a recording.
 *
 * @param still    a stretch of a recording in which everyone holds still, by which sensors are turned into the body's axes
 * @param free     places whose free acceleration is wanted, in the axes of the place
 * @param levers   points whose acceleration follows from that of another on the same segment
 * @param joints   pairs of segments whose angles are wanted
 * @param settling time constant with which gravity holds the tilt where a place has no quaternion [s]
 */
public record Derivations(Optional<Still> still, List<String> free, List<Lever> levers, List<Joint> joints, double settling) {

    /**
     * A stretch of time.
     *
     * @param from
     * @param to on the recording's clock [s]
     */
    public record Still(double from, double to) {
        public Still {
            if (!(to > from) || Double.isInfinite(to - from)) {
                throw new IllegalArgumentException("a still pose must end after it begins: " + from + " to " + to + " s");
            }
        }
    }

    /** No segment is longer [m]. */
    private static final double LONGEST = 100;
    /** Eleven days [s]. */
    private static final double SLOWEST = 1e6;

    /**
     * A point.
     *
     * @param place that is measured
     * @param arm from there to the point [m]
     * @param name of the point
     */
    public record Lever(String place, List<Double> arm, String name) {
        public Lever {
            requireName(place);
            requireName(name);
            arm = List.copyOf(arm);
            if (arm.size() != 3 || !arm.stream().allMatch(length -> Math.abs(length) <= LONGEST)) {
                throw new IllegalArgumentException("a lever arm is three lengths of up to " + LONGEST + " m: " + arm);
            }
        }
    }

    /**
     * Two segments.
     *
     * @param lower place on the one
     * @param upper place on the other
     * @param name of the joint
     */
    public record Joint(String lower, String upper, String name) {
        public Joint {
            requireName(lower);
            requireName(upper);
            requireName(name);
            if (lower.equals(upper)) {
                throw new IllegalArgumentException("a joint is between two places: " + lower + " twice");
            }
        }
    }

    public Derivations {
        free = List.copyOf(free);
        free.forEach(Derivations::requireName);
        levers = List.copyOf(levers);
        joints = List.copyOf(joints);
        if (!(settling > 0 && settling <= SLOWEST)) {
            throw new IllegalArgumentException("settling time must be > 0 to " + SLOWEST + " s: " + settling);
        }
    }

    private static void requireName(String name) {
        if (!Channel.isLocation(name)) {
            throw new IllegalArgumentException("a place is a word of a-z, 0-9 and _, beginning with a letter: '" + name + "'");
        }
    }

    /** Whether nothing is to be done. */
    public boolean isEmpty() {
        return still.isEmpty() && free.isEmpty() && levers.isEmpty() && joints.isEmpty();
    }
}
