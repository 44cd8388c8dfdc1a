package wbv.diagnosis.surrogate;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import wbv.body.Model;

/**
 * Rigid bodies in the plane of x and z on a base that moves along both and pitches, joined along x and z and about y at points, as numbers
 * that a fit moves: masses, inertias, stiffness and damping by their logarithm, places in m. To first order, see {@link wbv.body.Plane}.
 *
 * @param parts  bodies, those with sensors first
 * @param joints between them
 */
record PlaneNet(List<Part> parts, List<Joint> joints) {

    /** Of a body's motion and of a joint: along x, along z, about y. */
    static final int MOTIONS = 3;

    /**
     * Some of the numbers.
     *
     * @param usual where they are expected
     * @param spread standard deviation about that, assumed
     * @param at where they are. None copied
     */
    record Numbers(double[] usual, double[] spread, double[] at) {
        static Numbers of(double[] usual, double[] spread) {
            return new Numbers(usual, spread, usual);
        }
    }

    /**
     * A body: the logarithm of its mass [kg], its centre's x and z; one with sensors turns, and has the logarithm of its inertia about that
     * [kg m²] and the x and z of its sensors behind them.
     */
    record Part(String name, boolean measured, Numbers numbers) {
        int motions() {
            return measured ? MOTIONS : MOTIONS - 1;
        }

        double mass() {
            return Math.exp(numbers.at[0]);
        }

        double inertia() {
            return Math.exp(numbers.at[3]);
        }

        double x() {
            return numbers.at[1];
        }

        double z() {
            return numbers.at[2];
        }

        Model.Point sensors() {
            return new Model.Point(numbers.at[4], numbers.at[5]);
        }
    }

    /**
     * Between two bodies: the logarithms of stiffness and damping along x and z; between two that turn the x and z of its point, and the
     * logarithms of stiffness and damping about y, behind them. What does not turn is held at its centre.
     *
     * @param lower index of a part, -1 for the base
     */
    record Joint(int lower, int upper, Numbers numbers) {
        boolean turns() {
            return numbers.at.length > 4;
        }

        int motions() {
            return turns() ? MOTIONS : MOTIONS - 1;
        }

        /** Stiffness along x [N/m], along z, or about y [N m/rad]. */
        double stiffness(int motion) {
            return Math.exp(numbers.at[motion == 2 ? 6 : motion]);
        }

        /** Damping along x [N s/m], along z, or about y [N m s/rad]. */
        double damping(int motion) {
            return Math.exp(numbers.at[motion == 2 ? 7 : 2 + motion]);
        }
    }

    PlaneNet {
        parts = List.copyOf(parts);
        joints = List.copyOf(joints);
    }

    PlaneNet with(Joint joint) {
        return new PlaneNet(parts, Stream.concat(joints.stream(), Stream.of(joint)).toList());
    }

    PlaneNet with(Part part, Joint joint) {
        return new PlaneNet(Stream.concat(parts.stream(), Stream.of(part)).toList(),
                Stream.concat(joints.stream(), Stream.of(joint)).toList());
    }

    /**
     * Moved along x and z, all of it.
     *
     * @param z [m]
     */
    PlaneNet raised(double z) {
        List<Part> moved = parts.stream()
                .map(part -> new Part(part.name, part.measured, shifted(part.numbers, z, part.measured ? new int[] {2, 5} : new int[] {2})))
                .toList();
        List<Joint> held = joints.stream()
                .map(joint -> new Joint(joint.lower, joint.upper, joint.turns() ? shifted(joint.numbers, z, 5) : joint.numbers)).toList();
        return new PlaneNet(moved, held);
    }

    private static Numbers shifted(Numbers numbers, double by, int... which) {
        double[] usual = numbers.usual.clone();
        Arrays.stream(which).forEach(i -> usual[i] += by);
        return Numbers.of(usual, numbers.spread);
    }

    double[] usual() {
        return all(Numbers::usual);
    }

    double[] spread() {
        return all(Numbers::spread);
    }

    double[] at() {
        return all(Numbers::at);
    }

    private double[] all(Function<Numbers, double[]> which) {
        return Stream.concat(parts.stream().map(Part::numbers), joints.stream().map(Joint::numbers))
                .flatMapToDouble(numbers -> DoubleStream.of(which.apply(numbers)))
                .toArray();
    }

    /**
     * The same elsewhere.
     *
     * @param at as {@link #at()} gives them. Not modified.
     */
    PlaneNet at(double[] at) {
        int[] next = {0};
        UnaryOperator<Numbers> own = numbers -> {
            next[0] += numbers.at.length;
            return new Numbers(numbers.usual, numbers.spread, Arrays.copyOfRange(at, next[0] - numbers.at.length, next[0]));
        };
        List<Part> moved = parts.stream().map(part -> new Part(part.name, part.measured, own.apply(part.numbers))).toList();
        return new PlaneNet(moved, joints.stream().map(joint -> new Joint(joint.lower, joint.upper, own.apply(joint.numbers))).toList());
    }

    /** All masses [kg]. */
    double mass() {
        return parts.stream().mapToDouble(Part::mass).sum();
    }

    int motions() {
        return parts.stream().mapToInt(Part::motions).sum();
    }

    /** Index of a part's first motion. */
    int first(int part) {
        return parts.stream().limit(part).mapToInt(Part::motions).sum();
    }

    /** Where a joint holds. */
    Model.Point point(Joint joint) {
        Part light = parts.get(joint.upper);
        return joint.turns() ? new Model.Point(joint.numbers.at[4], joint.numbers.at[5]) : new Model.Point(light.x(), light.z());
    }

    /** Its joint between two parts, if there is one. */
    Optional<Joint> between(int a, int b) {
        return joints.stream().filter(joint -> joint.lower == Math.min(a, b) && joint.upper == Math.max(a, b)).findFirst();
    }
}
