package wbv.rig;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * A subject's masses and links: an {@link Anatomy} times body mass, tautness and tightness, with the effects that are off left
 * out. Body i has the coordinates 6 i to 6 i + 5: x, y, z, roll, pitch, yaw.
 */
final class Skeleton {

    /** Coordinates of a body. */
    static final int FREE = 6;

    private final Subject subject;
    private final Anatomy anatomy;
    private final Effects effects;
    private final double[][] centres;
    private final double[] inverseMass;
    private final double[][] levers;
    private final Link[] links;
    private final int seatLink;

    Skeleton(Subject subject, Anatomy anatomy, Effects effects) {
        this.subject = subject;
        this.anatomy = anatomy;
        this.effects = effects;
        int n = anatomy.bodies().size();
        centres = new double[n][];
        inverseMass = new double[FREE * n];
        for (int i = 0; i < n; i++) {
            Anatomy.Body body = anatomy.bodies().get(i);
            double mass = body.share() * subject.mass();
            centres[i] = new double[] {effects.has(Effect.CROSS) ? body.x() : 0, body.y(), body.z()};
            Arrays.fill(inverseMass, FREE * i, FREE * i + 3, 1 / mass);
            Arrays.fill(inverseMass, FREE * i + 3, FREE * i + FREE, 1 / (mass * body.gyration() * body.gyration()));
        }
        levers = anatomy.mounts().stream().map(m -> effects.has(Effect.LEVER) ? m.r() : new double[3]).toArray(double[][]::new);
        links = anatomy.tissues().stream().map(this::link).toArray(Link[]::new);
        seatLink = IntStream.range(0, links.length).filter(l -> anatomy.tissues().get(l).from() == Anatomy.SEAT).findFirst().orElseThrow();
    }

    int bodies() {
        return centres.length;
    }

    int mounts() {
        return levers.length;
    }

    /** Names of the bodies. */
    List<String> names() {
        return anatomy.bodies().stream().map(Anatomy.Body::name).toList();
    }

    /** Where a body's centre is [m]. Not a copy. */
    double[] centre(int body) {
        return centres[body];
    }

    /** Whether a body is one with the platform: the seat without a cushion. */
    boolean fixed(int body) {
        return body == Anatomy.SEAT && !effects.has(Effect.CUSHION);
    }

    /** One over mass [kg] or moment of inertia [kg·m²] of a coordinate. */
    double inverseMass(int coordinate) {
        return inverseMass[coordinate];
    }

    Anatomy.Mount mount(int place) {
        return anatomy.mounts().get(place);
    }

    /** From the centre of the body to the sensor at a place [m]. Not a copy. */
    double[] lever(int place) {
        return levers[place];
    }

    /**
     * The links' forces on all coordinates.
     *
     * @param x coordinates. Not modified.
     * @param v their rates. Not modified.
     * @param stiffness factor of the present
     * @param damping factor of the present
     * @param into forces. Modified.
     */
    void forces(double[] x, double[] v, double stiffness, double damping, double[] into) {
        Arrays.fill(into, 0);
        for (Link link : links) {
            link.act(x, v, stiffness, damping, into);
        }
    }

    /** What the seat pushes the pelvis with at the last {@link #forces}: along x, y, z [N] first. Not a copy. */
    double[] seatForce() {
        return links[seatLink].force();
    }

    /** Modes of the vertical coordinates alone at the reference magnitude, from forces under unit displacements and rates. */
    Modes verticalModes() {
        List<Integer> free = new ArrayList<>();
        for (int i = 0; i < bodies(); i++) {
            if (!fixed(i)) {
                free.add(FREE * i + 2);
            }
        }
        int n = free.size();
        double[][] a = new double[2 * n][2 * n];
        double[] x = new double[inverseMass.length];
        double[] v = new double[inverseMass.length];
        double[] force = new double[inverseMass.length];
        for (int j = 0; j < 2 * n; j++) {
            double[] unit = j < n ? x : v;
            unit[free.get(j % n)] = 1;
            forces(x, v, 1, 1, force);
            unit[free.get(j % n)] = 0;
            for (int i = 0; i < n; i++) {
                a[n + i][j] = force[free.get(i)] * inverseMass[free.get(i)];
            }
            if (j >= n) {
                a[j - n][j] = 1;
            }
        }
        return Modes.of(a);
    }

    /** Stiffness and damping that give all that a link carries its stated frequencies and damping ratios. */
    private Link link(Anatomy.Tissue tissue) {
        double[] point = {effects.has(Effect.CROSS) ? tissue.x() : 0, tissue.y(), tissue.z()};
        double mass = 0;
        double inertia = 0;
        double twist = 0;
        for (int i : anatomy.carried(tissue)) {
            Anatomy.Body body = anatomy.bodies().get(i);
            double height = body.z() - tissue.z();
            double aside = body.y() - tissue.y();
            double m = body.share() * subject.mass();
            double own = body.gyration() * body.gyration();
            mass += m;
            inertia += m * (height * height + own);
            twist += m * (aside * aside + own);
        }
        double[] stiffness = new double[FREE];
        double[] damping = new double[FREE];
        for (int i = 0; i < FREE; i++) {
            double carried = i < 3 ? mass : i < 5 ? inertia : twist;
            double w = 2 * Math.PI * tissue.frequency()[i] * subject.tautnessAsHeSits();
            stiffness[i] = carried * w * w;
            damping[i] = 2 * tissue.zeta()[i] * subject.tightness() * carried * w;
        }
        double[] below = tissue.from() < 0 ? point : minus(point, centres[tissue.from()]);
        return new Link(FREE * tissue.from(), FREE * tissue.to(), below, minus(point, centres[tissue.to()]), stiffness, damping);
    }

    private static double[] minus(double[] a, double[] b) {
        return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    }
}
