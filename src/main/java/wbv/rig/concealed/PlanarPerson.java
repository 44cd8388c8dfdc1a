package wbv.rig.concealed;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.apache.commons.math3.random.RandomGenerator;

/**
 * A seated person as three rigid bodies in the plane of x (forward) and z (up), each free to move along both and to pitch, on a cushion and
 * against a backrest that ride on the platform. Positions are those at rest, in the platform's axes from its sensor; what gravity does at
 * rest is in them, and what it does beside that in the stiffness about joints.
 *
 * @param mass       by body [kg]
 * @param inertia about its centre of mass [kg m²]
 * @param centre of mass: x, z [m]
 * @param sensor where it sits: x, z [m]
 * @param joints     which hold the bodies
 */
record PlanarPerson(double[] mass, double[] inertia, double[][] centre, double[][] sensor, List<Joint> joints) {

    /** Where sensors sit; the first is the platform's, the others those of the bodies. */
    static final List<String> PLACES = List.of("platform", "pelvis", "sternum", "head");
    /** What a sensor sends of the plane; the first moves along the model's axis. */
    private static final List<String> MEASURED = List.of(".acc.z", ".acc.x", ".gyr.y");
    /** Of a joint: along x, along z, about y. */
    static final int COMPONENTS = 3;
    static final int X = 0;
    static final int Z = 1;
    static final int PITCH = 2;

    /**
     * Springs and dashpots along x and z and about y, in the axes of the lower of two bodies.
     *
     * @param name what it is in a seat or a spine
     * @param lower body, -1 for the platform
     * @param upper body
     * @param at where, at rest: x, z [m]
     * @param stiffness along x and z [N/m] and about y [N m/rad]
     * @param damping likewise
     */
    record Joint(String name, int lower, int upper, double[] at, double[] stiffness, double[] damping) {

        /** Between the two places that are measured. */
        String where() {
            return PLACES.get(lower + 1) + "-" + PLACES.get(upper + 1);
        }

        /** Between the two motions that a component holds together, as a model of bodies in a plane calls them. */
        String where(int component) {
            String motion = List.of(".x", ".z", ".pitch").get(component);
            return (lower < 0 ? PLACES.get(0) : PLACES.get(lower + 1) + motion) + "-" + PLACES.get(upper + 1) + motion;
        }
    }

    PlanarPerson {
        joints = List.copyOf(joints);
    }

    int size() {
        return mass.length;
    }

    int joint(String name) {
        return IntStream.range(0, joints.size()).filter(j -> joints.get(j).name().equals(name)).findFirst().orElseThrow();
    }

    /** Someone of 60 to 90 kg; his trunk on the cushion would bounce at 4.2 to 5.8 Hz, his head nod on the neck at 2.5 to 4 Hz. */
    static PlanarPerson draw(RandomGenerator random) {
        double person = 60 + 30 * random.nextDouble();
        double[] mass = {person * spread(0.3, 0.1, random), person * spread(0.4, 0.1, random), person * spread(0.075, 0.1, random)};
        double[] inertia = {mass[0] * 0.15 * 0.15, mass[1] * spread(0.18, 0.1, random) * 0.18,
            mass[2] * spread(0.075, 0.1, random) * 0.075};
        double[][] centre = {{0.03, 0.1}, {-0.01, spread(0.42, 0.04, random)}, {0.02, spread(0.77, 0.03, random)}};
        double[][] sensor = {{-0.1, 0.12}, {0.1, 0.45}, {0.0, 0.88}};
        double all = mass[0] + mass[1] + mass[2];
        double above = mass[1] + mass[2];
        double neck = mass[2] * 0.1 * 0.1 + inertia[2];
        double trunk = inertia[1] + mass[1] * 0.2 * 0.2 + mass[2] * 0.55 * 0.55;
        List<Joint> joints = List.of(
                joint("cushion", -1, 0, new double[] {0, 0.02}, new double[] {all, all, all * 0.35 * 0.35},
                        new double[] {4.5, spread(5.8, 0.16, random), 2.5}, random),
                joint("backrest", -1, 1, new double[] {-0.12, 0.45}, new double[] {above, above, 0},
                        new double[] {spread(4.5, 0.2, random), 1.5, 0}, random),
                joint("lumbar", 0, 1, new double[] {-0.04, 0.22}, new double[] {above, above, trunk},
                        new double[] {8, spread(9, 0.15, random), spread(3, 0.2, random)}, random),
                joint("neck", 1, 2, new double[] {-0.01, 0.67}, new double[] {mass[2], mass[2], neck},
                        new double[] {9, spread(11, 0.15, random),
                            spread(3.2, 0.2, random)},
                        random));
        return new PlanarPerson(mass, inertia, centre, sensor, joints);
    }

    /**
     * @param load mass or inertia that each component would carry alone, none for 0
     * @param hertz at which it would swing then
     */
    private static Joint joint(String name, int lower, int upper, double[] at, double[] load, double[] hertz, RandomGenerator random) {
        double[] stiffness = new double[COMPONENTS];
        double[] damping = new double[COMPONENTS];
        for (int q = 0; q < COMPONENTS; q++) {
            double omega = 2 * Math.PI * hertz[q];
            stiffness[q] = load[q] * omega * omega;
            damping[q] = 2 * spread(0.28, 0.25, random) * load[q] * omega;
        }
        return new Joint(name, lower, upper, at, stiffness, damping);
    }

    private static double spread(double middle, double share, RandomGenerator random) {
        return middle * (1 + share * (2 * random.nextDouble() - 1));
    }

    /** The person as another believes him to be: masses, inertias, stiffness and damping 3 to 12 % off. */
    PlanarPerson wrong(RandomGenerator random) {
        return new PlanarPerson(off(mass, random), off(inertia, random), centre, sensor,
                joints.stream().map(joint -> new Joint(joint.name(), joint.lower(),
                        joint.upper(), joint.at(), off(joint.stiffness(), random), off(joint.damping(), random))).toList());
    }

    private static double[] off(double[] values, RandomGenerator random) {
        return Arrays.stream(values).map(x -> {
            double size = 0.03 + 0.09 * random.nextDouble();
            return x * (random.nextBoolean() ? 1 + size : 1 - size);
        }).toArray();
    }

    /** The person as bodies in a plane, in the form in which {@code model.json} takes them. */
    ObjectNode plane(String name) {
        ObjectNode root = new ObjectMapper().createObjectNode();
        root.put("name", name).put("subject", "person").put("plane", "xz").put("axis", "z");
        ObjectNode base = root.putObject("base").put("name", PLACES.get(0));
        point(base, new double[2]);
        MEASURED.forEach(channel -> base.withArray("sensors").add(PLACES.get(0) + channel));
        for (int i = 0; i < size(); i++) {
            String place = PLACES.get(i + 1);
            ObjectNode body = root.withArray("bodies").addObject().put("name", place).put("mass_kg", Chain.rounded(mass[i]))
                    .put("inertia_kgm2", Chain.rounded(inertia[i]));
            point(body, centre[i]);
            double[] at = sensor[i];
            MEASURED.forEach(channel -> point(body.withArray("sensors").addObject().put("sensor", place + channel), at));
        }
        for (Joint joint : joints) {
            for (int q = 0; q < COMPONENTS; q++) {
                if (joint.stiffness()[q] > 0 || joint.damping()[q] > 0) {
                    ObjectNode link = root.withArray("links").addObject().put("from", PLACES.get(joint.lower() + 1)).put("to",
                            PLACES.get(joint.upper() + 1));
                    if (q == PITCH) {
                        link.put("about", "y").put("stiffness_Nm_per_rad", Chain.rounded(joint.stiffness()[q])).put("damping_Nms_per_rad",
                                Chain.rounded(joint.damping()[q]));
                    } else {
                        point(link.put("along", q == X ? "x" : "z"), joint.at());
                        link.put("stiffness_N_per_m", Chain.rounded(joint.stiffness()[q])).put("damping_Ns_per_m",
                                Chain.rounded(joint.damping()[q]));
                    }
                }
            }
        }
        return root;
    }

    private static void point(ObjectNode node, double[] at) {
        Arrays.stream(at).forEach(value -> node.withArray("at_m").add(Chain.rounded(value)));
    }

    /** A crude vertical chain of the same person: cushion, lumbar joint, neck. */
    ObjectNode chain(String name) {
        ObjectNode root = new ObjectMapper().createObjectNode();
        root.put("name", name).put("subject", "person").put("axis", "z");
        root.putObject("base").put("name", PLACES.get(0)).put("sensor", PLACES.get(0) + ".acc.z");
        ArrayNode bodies = root.putArray("bodies");
        ArrayNode links = root.putArray("links");
        for (int i = 0; i < size(); i++) {
            bodies.addObject().put("name", PLACES.get(i + 1)).put("mass_kg", Chain.rounded(mass[i])).put("sensor",
                    PLACES.get(i + 1) + ".acc.z");
            Joint joint = joints.get(joint(List.of("cushion", "lumbar", "neck").get(i)));
            links.addObject().put("from", PLACES.get(i)).put("to", PLACES.get(i + 1))
                    .put("stiffness_N_per_m", Chain.rounded(joint.stiffness()[Z]))
                    .put("damping_Ns_per_m", Chain.rounded(joint.damping()[Z]));
        }
        return root;
    }
}
