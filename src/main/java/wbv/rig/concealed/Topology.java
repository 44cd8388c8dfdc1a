package wbv.rig.concealed;

import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;

/** Which bodies a sitter is lumped into; masses, stiffness and damping are drawn anew for every case. */
enum Topology {
    SEAT_TORSO_HEAD(List.of("seat", "torso", "head"), -1, 0, 1),
    SEAT_PELVIS_TORSO_HEAD(List.of("seat", "pelvis", "torso", "head"), -1, 0, 1, 2),
    SEAT_TORSO_VISCERA_HEAD(List.of("seat", "torso", "viscera", "head"), -1, 0, 1, 1),
    PELVIS_TORSO_HEAD(List.of("pelvis", "torso", "head"), -1, 0, 1);

    private final List<String> names;
    private final int[] parent;

    Topology(List<String> names, int... parent) {
        this.names = names;
        this.parent = parent;
    }

    /** A sitter whose first resonance lies at 4 to 6 Hz, and whose head alone on the neck would swing at 8 to 14 Hz. */
    Chain draw(RandomGenerator random) {
        int n = names.size();
        double person = 60 + 30 * random.nextDouble();
        double[] mass = new double[n];
        double[] stiffness = new double[n];
        double[] damping = new double[n];
        boolean pelvis = names.contains("pelvis");
        boolean viscera = names.contains("viscera");
        double first = 4.2 + 1.6 * random.nextDouble();
        for (int i = 0; i < n; i++) {
            double own = switch (names.get(i)) {
                case "seat" -> 11 + 3 * random.nextDouble();
                case "pelvis" -> person * spread(0.27, 0.1, random);
                case "torso" -> person * spread(pelvis ? 0.37 : viscera ? 0.5 : 0.6, 0.1, random);
                case "viscera" -> person * spread(0.11, 0.15, random);
                default -> person * spread(0.075, 0.1, random);
            };
            mass[i] = own;
            switch (names.get(i)) {
                case "head" -> set(i, own, 8 + 5 * random.nextDouble(), spread(0.28, 0.3, random), stiffness, damping);
                case "viscera" -> set(i, own, 5.5 + 2.5 * random.nextDouble(), spread(0.2, 0.3, random), stiffness, damping);
                default -> {
                    boolean base = parent[i] < 0;
                    // What the link carries, by share of the person: everything above the platform, the trunk above the pelvis.
                    double carried = person * (base || i == 1 && !names.get(0).equals("pelvis") ? 0.85 : 0.5);
                    double frequency = (names.get(i).equals("seat") ? 2.1 : 1.35) * first * spread(1, 0.12, random);
                    set(i, carried, frequency, spread(0.26, 0.3, random), stiffness, damping);
                }
            }
        }
        Chain chain = new Chain(names, parent, mass, stiffness, damping);
        // The trunk's links are scaled until the whole has its first resonance where it should be.
        for (int pass = 0; pass < 6; pass++) {
            double ratio = first / chain.frequencies()[0];
            for (int i = 0; i < n; i++) {
                if (!names.get(i).equals("head") && !names.get(i).equals("viscera")) {
                    stiffness[i] *= ratio * ratio;
                    damping[i] *= ratio;
                }
            }
        }
        return chain;
    }

    private static void set(int i, double mass, double frequency, double zeta, double[] stiffness, double[] damping) {
        double omega = 2 * Math.PI * frequency;
        stiffness[i] = mass * omega * omega;
        damping[i] = 2 * zeta * mass * omega;
    }

    private static double spread(double middle, double share, RandomGenerator random) {
        return middle * (1 + share * (2 * random.nextDouble() - 1));
    }
}
