package wbv.rig;

import java.util.ArrayList;
import java.util.List;

/**
 * The average sitter and his seat as rigid bodies held by links, before any subject's mass or stiffness: seven bodies, each with
 * three translations and three rotations.
 *
 * <p>All of it is assumed: masses are shares of body mass (the sitting mass is 0.74 of it), places and points of attachment are
 * in metres from the middle of the platform, x forward, y left, z up. A link's frequency and damping ratio in each direction
 * are those that all it carries would have on it alone; so another mass keeps them. The vertical ones were fitted to what was
 * measured on people: apparent mass over sitting mass as one mass on 5 Hz and 0.475 has it (Fairley and Griffin 1989), one peak
 * of the head over the seat, 1.5 to 2 near 5 Hz, and two of the pelvis over the platform.
 */
final class Anatomy {

    /** The platform, as the lower end of a link. */
    static final int PLATFORM = -1;
    static final int SEAT = 0;
    static final int PELVIS = 1;
    static final int VISCERA = 2;
    static final int TRUNK = 3;
    static final int LEFT_SHOULDER = 4;
    static final int RIGHT_SHOULDER = 5;
    static final int HEAD = 6;

    /**
     * A rigid body.
     *
     * @param share of body mass
     * @param x
     * @param y
     * @param z its centre [m]
     * @param gyration radius of gyration, any axis [m]
     */
    record Body(String name, double share, double x, double y, double z, double gyration) {}

    /**
     * A link from a body to the one it carries.
     *
     * @param x         point of attachment [m]; where axes are not coupled, this and the x of every body are taken as 0
     * @param frequency along x, y, z and about x, y, z [Hz]
     * @param zeta damping ratios in the same order
     */
    record Tissue(int from, int to, double x, double y, double z, double[] frequency, double[] zeta) {}

    /**
     * Where a sensor sits.
     *
     * @param name of the place
     * @param body
     * @param r from the body's centre [m]
     */
    record Mount(String name, int body, double[] r) {}

    private static final double ARM = 0.18;
    /** Height of the seat pan [m]: what is above grows with stature. */
    private static final double PAN = 0.47;

    private static final List<Body> AVERAGE = List.of(
            new Body("seat", 0.10, 0.00, 0, 0.42, 0.20),
            new Body("pelvis", 0.25, 0.02, 0, 0.56, 0.12),
            new Body("viscera", 0.12, 0.03, 0, 0.72, 0.08),
            new Body("trunk", 0.20, 0.00, 0, 0.86, 0.18),
            new Body("left_shoulder", 0.05, 0.00, ARM, 0.98, 0.08),
            new Body("right_shoulder", 0.05, 0.00, -ARM, 0.98, 0.08),
            new Body("head", 0.07, 0.02, 0, 1.26, 0.08));

    private static final List<Tissue> LINKS = List.of(
            link(PLATFORM, SEAT, 0, 0, 0.40, new double[] {15, 10.5, 8, 12}, new double[] {0.3, 0.25, 0.3, 0.3}),
            link(SEAT, PELVIS, -0.03, 0, 0.47, new double[] {4.0, 7.25, 3.0, 3.0}, new double[] {0.4, 0.74, 0.5, 0.6}),
            link(PELVIS, VISCERA, 0.02, 0, 0.68, new double[] {5.0, 8.2, 12, 12}, new double[] {0.2, 0.25, 0.3, 0.3}),
            link(PELVIS, TRUNK, -0.05, 0, 0.66, new double[] {7.0, 8.6, 2.5, 2.5}, new double[] {0.4, 0.61, 0.6, 0.6}),
            link(TRUNK, LEFT_SHOULDER, 0, ARM, 1.00, new double[] {9.0, 9.8, 12, 12}, new double[] {0.35, 0.48, 0.4, 0.4}),
            link(TRUNK, RIGHT_SHOULDER, 0, -ARM, 1.00, new double[] {9.0, 9.8, 12, 12}, new double[] {0.35, 0.48, 0.4, 0.4}),
            link(TRUNK, HEAD, -0.01, 0, 1.10, new double[] {10, 11, 2.5, 2.0}, new double[] {0.4, 0.59, 0.7, 0.7}));

    private static final List<Mount> MOUNTS = List.of(
            new Mount("platform", PLATFORM, new double[] {0, 0, 0}),
            new Mount("seat", SEAT, new double[] {0, 0, 0.05}),
            new Mount("left_thigh", PELVIS, new double[] {0.25, 0.12, 0.02}),
            new Mount("right_thigh", PELVIS, new double[] {0.25, -0.12, 0.02}),
            new Mount("pelvis", PELVIS, new double[] {-0.12, 0, 0.05}),
            new Mount("lumbar", TRUNK, new double[] {-0.10, 0, -0.15}),
            new Mount("sternum", TRUNK, new double[] {0.10, 0, 0.05}),
            new Mount("left_shoulder", LEFT_SHOULDER, new double[] {0, 0.02, 0.05}),
            new Mount("right_shoulder", RIGHT_SHOULDER, new double[] {0, -0.02, 0.05}),
            new Mount("head", HEAD, new double[] {0.08, 0, 0.04}));

    private final List<Body> bodies;
    private final List<Tissue> tissues;

    /** @param stature of the person [m] */
    Anatomy(double stature) {
        double tall = stature / Subject.STATURE;
        bodies = AVERAGE.stream().map(b -> new Body(b.name(), b.share(), b.x(), b.y(), grown(b.z(), tall), b.gyration())).toList();
        tissues = LINKS.stream()
                .map(t -> new Tissue(t.from(), t.to(), t.x(), t.y(), grown(t.z(), tall), t.frequency(), t.zeta())).toList();
    }

    List<Body> bodies() {
        return bodies;
    }

    List<Tissue> tissues() {
        return tissues;
    }

    List<Mount> mounts() {
        return MOUNTS;
    }

    /** All that a link carries: its upper body and everything on it. */
    List<Integer> carried(Tissue tissue) {
        List<Integer> carried = new ArrayList<>(List.of(tissue.to()));
        for (Tissue other : tissues) {
            if (other.from() == tissue.to()) {
                carried.addAll(carried(other));
            }
        }
        return carried;
    }

    /**
     * @param frequency across (x and y), along z, about x and y, about z [Hz]
     * @param zeta damping ratios in the same order
     */
    private static Tissue link(int from, int to, double x, double y, double z, double[] frequency, double[] zeta) {
        return new Tissue(from, to, x, y, z, spread(frequency), spread(zeta));
    }

    private static double grown(double height, double tall) {
        return height <= PAN ? height : PAN + (height - PAN) * tall;
    }

    private static double[] spread(double[] of) {
        return new double[] {of[0], of[0], of[1], of[2], of[2], of[3]};
    }
}
