package wbv.diagnosis.surrogate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
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
    private static final int MOTIONS = 3;

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

    private double[] all(java.util.function.Function<Numbers, double[]> which) {
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
        java.util.function.UnaryOperator<Numbers> own = numbers -> {
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

    /**
     * Equations of motion: M a + C v + K x = 0, a = ẍ + T b with the base's accelerations b; the accelerations that sensors feel are R a.
     *
     * @param mass diagonal
     * @param damping
     * @param stiffness n × n
     * @param carried n × 3
     * @param read sensors × n, three a measured part
     */
    record Matrices(double[] mass, double[][] damping, double[][] stiffness, double[][] carried, double[][] read) {}

    Matrices matrices() {
        int n = motions();
        double[] mass = new double[n];
        double[][] damping = new double[n][n];
        double[][] stiffness = new double[n][n];
        double[][] carried = new double[n][MOTIONS];
        int measured = (int) parts.stream().filter(Part::measured).count();
        double[][] read = new double[MOTIONS * measured][n];
        for (int i = 0; i < parts.size(); i++) {
            Part part = parts.get(i);
            int at = first(i);
            mass[at] = part.mass();
            mass[at + 1] = part.mass();
            carried[at] = new double[] {1, 0, part.z()};
            carried[at + 1] = new double[] {0, 1, -part.x()};
            if (part.measured) {
                mass[at + 2] = part.inertia();
                carried[at + 2][2] = 1;
                read[MOTIONS * i][at] = 1;
                read[MOTIONS * i][at + 2] = part.sensors().z() - part.z();
                read[MOTIONS * i + 1][at + 1] = 1;
                read[MOTIONS * i + 1][at + 2] = part.x() - part.sensors().x();
                read[MOTIONS * i + 2][at + 2] = 1;
            }
        }
        for (Joint joint : joints) {
            double[] own = joint.numbers.at;
            for (int motion = 0; motion < (joint.turns() ? MOTIONS : MOTIONS - 1); motion++) {
                double[] stretch = stretch(joint, motion, n);
                add(stiffness, stretch, Math.exp(own[motion == 2 ? 6 : motion]));
                add(damping, stretch, Math.exp(own[motion == 2 ? 7 : 2 + motion]));
            }
        }
        return new Matrices(mass, damping, stiffness, carried, read);
    }

    private static void add(double[][] matrix, double[] row, double factor) {
        for (int i = 0; i < row.length; i++) {
            for (int j = 0; row[i] != 0 && j < row.length; j++) {
                matrix[i][j] += factor * row[i] * row[j];
            }
        }
    }

    /** What each motion stretches a joint by. */
    private double[] stretch(Joint joint, int motion, int n) {
        double[] out = new double[n];
        Model.Point point = point(joint);
        for (int end = 0; end < 2; end++) {
            int body = end == 0 ? joint.upper : joint.lower;
            if (body >= 0) {
                Part part = parts.get(body);
                double sign = end == 0 ? 1 : -1;
                out[first(body) + motion] += sign;
                if (part.measured && motion < 2) {
                    out[first(body) + 2] += sign * (motion == 0 ? point.z() - part.z() : part.x() - point.x());
                }
            }
        }
        return out;
    }

    /** Where a joint holds. */
    Model.Point point(Joint joint) {
        Part light = parts.get(joint.upper);
        return joint.turns() ? new Model.Point(joint.numbers.at[4], joint.numbers.at[5]) : new Model.Point(light.x(), light.z());
    }

    /**
     * As its user would write it.
     *
     * @param base    name
     * @param axes of it, that along z first
     * @param sensors by the part's name
     * @param factor on masses, stiffness and damping
     */
    Map<String, Object> described(String name, String base, List<String> axes, Map<String, List<String>> sensors, double factor) {
        Map<String, Object> root = new LinkedHashMap<>(Map.of("name", name));
        root.put("plane", "xz");
        root.put("axis", "z");
        root.put("base", Map.of("name", base, "at_m", List.of(0, 0), "sensors", axes));
        root.put("bodies", parts.stream().map(part -> body(part, sensors, factor)).toList());
        root.put("links", joints.stream().flatMap(joint -> links(joint, base, factor)).toList());
        return root;
    }

    private static Map<String, Object> body(Part part, Map<String, List<String>> sensors, double factor) {
        Map<String, Object> body = new LinkedHashMap<>(
                Map.of("name", part.name, "at_m", List.of(part.x(), part.z()), "mass_kg", factor * part.mass()));
        if (part.measured) {
            List<Double> at = List.of(part.sensors().x(), part.sensors().z());
            body.put("inertia_kgm2", factor * part.inertia());
            body.put("sensors", sensors.get(part.name).stream().map(sensor -> Map.of("sensor", sensor, "at_m", at)).toList());
        }
        return body;
    }

    private Stream<Map<String, Object>> links(Joint joint, String base, double factor) {
        double[] own = joint.numbers.at;
        List<Map<String, Object>> out = new ArrayList<>();
        IntStream.range(0, joint.turns() ? MOTIONS : MOTIONS - 1).forEach(motion -> {
            Map<String, Object> link = new LinkedHashMap<>(
                    Map.of("from", joint.lower < 0 ? base : parts.get(joint.lower).name, "to", parts.get(joint.upper).name));
            if (motion == 2) {
                link.put("about", "y");
                link.put("stiffness_Nm_per_rad", factor * Math.exp(own[6]));
                link.put("damping_Nms_per_rad", factor * Math.exp(own[7]));
            } else {
                Model.Point point = point(joint);
                link.put("along", motion == 0 ? "x" : "z");
                link.put("at_m", List.of(point.x(), point.z()));
                link.put("stiffness_N_per_m", factor * Math.exp(own[motion]));
                link.put("damping_Ns_per_m", factor * Math.exp(own[2 + motion]));
            }
            out.add(link);
        });
        return out.stream();
    }

    /** Its joint between two parts, if there is one. */
    Optional<Joint> between(int a, int b) {
        return joints.stream().filter(joint -> joint.lower == Math.min(a, b) && joint.upper == Math.max(a, b)).findFirst();
    }
}
