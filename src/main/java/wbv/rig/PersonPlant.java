package wbv.rig;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A whole person on a seat: the bodies and links of an {@link Anatomy} with a subject's mass and stiffness, stepped by
 * Runge-Kutta's fourth order twice in an inner step.
 *
 * <p>Coordinates are relative to where each body would be if it were fixed to the platform, so the platform acts as a field
 * of inertia, -(a + α × R + ω × (ω × R)) at a body's centre R. Rotations are small; the weight of a leaning body is left out.
 */
final class PersonPlant implements Plant {

    private static final int FREE = 5;
    private static final int SUBSTEPS = 2;

    private final double h;
    private final List<String> names;
    private final Link[] links;
    private final double[] inverseMass;
    private final double[][] centres;
    private final Anatomy.Mount[] mounts;
    private final double[][] levers;
    private final Motion[] bodies;
    private final Motion[] motions;
    private final Softening softening;
    private final double[] modes;
    private final Motion before = new Motion();
    private final Motion between = new Motion();
    private final double[] x;
    private final double[] v;
    private final double[] trialX;
    private final double[] trialV;
    private final double[] sumX;
    private final double[] sumV;
    private final double[] acceleration;

    PersonPlant(Subject subject, Anatomy anatomy, Effects effects, double h) {
        this.h = h;
        List<Anatomy.Body> segments = anatomy.bodies();
        int n = segments.size();
        names = segments.stream().map(Anatomy.Body::name).toList();
        centres = new double[n][];
        inverseMass = new double[FREE * n];
        bodies = new Motion[n];
        for (int i = 0; i < n; i++) {
            Anatomy.Body body = segments.get(i);
            double mass = body.share() * subject.mass();
            centres[i] = body.centre();
            if (!effects.has(Effect.CROSS)) {
                centres[i][0] = 0;
            }
            boolean fixed = i == Anatomy.SEAT && !effects.has(Effect.CUSHION);
            for (int j = 0; j < FREE; j++) {
                double inertia = j < 3 ? mass : mass * body.gyration() * body.gyration();
                inverseMass[FREE * i + j] = fixed ? 0 : 1 / inertia;
            }
            bodies[i] = new Motion();
        }
        links = anatomy.tissues().stream().map(t -> link(t, anatomy, subject, effects)).toArray(Link[]::new);
        mounts = anatomy.mounts().toArray(Anatomy.Mount[]::new);
        levers = new double[mounts.length][];
        motions = new Motion[mounts.length];
        for (int i = 0; i < mounts.length; i++) {
            levers[i] = effects.has(Effect.LEVER) ? mounts[i].r() : new double[3];
            motions[i] = new Motion();
        }
        softening = new Softening(effects.has(Effect.SOFTENING), h);
        x = new double[FREE * n];
        v = new double[FREE * n];
        trialX = new double[FREE * n];
        trialV = new double[FREE * n];
        sumX = new double[FREE * n];
        sumV = new double[FREE * n];
        acceleration = new double[FREE * n];
        modes = Modes.of(verticalSystem()).pairs(2);
    }

    @Override
    public void step(Motion platform) {
        softening.feel(platform.acceleration);
        double k = softening.stiffness();
        double c = softening.damping();
        double dt = h / SUBSTEPS;
        for (int s = 0; s < SUBSTEPS; s++) {
            rungeKutta(platform, (double) s / SUBSTEPS, (s + 1.0) / SUBSTEPS, dt, k, c);
        }
        before.set(platform);
        accelerate(x, v, platform, k, c);
        look(platform);
    }

    @Override
    public Motion motion(int place) {
        return motions[place];
    }

    /** Magnitude [m/s²], stiffness over that at the reference magnitude, and the first two vertical modes, linearised. */
    @Override
    public List<String> parameters() {
        return List.of("magnitude", "stiffness", "zeta1", "omega1", "zeta2", "omega2");
    }

    @Override
    public void parameters(double[] into) {
        double factor = softening.damping();
        into[0] = softening.magnitude();
        into[1] = softening.stiffness();
        for (int i = 0; i < 2; i++) {
            into[2 + 2 * i] = modes[2 * i];
            into[3 + 2 * i] = modes[2 * i + 1] * factor;
        }
    }

    /** Of every body, relative to where it would be if fixed to the platform: place, roll, pitch, and then their rates. */
    @Override
    public List<String> states() {
        List<String> places = new ArrayList<>();
        List<String> rates = new ArrayList<>();
        for (String body : names) {
            for (String axis : List.of("x", "y", "z")) {
                places.add(body + "_" + axis + "_m");
                rates.add(body + "_" + axis + "_m_per_s");
            }
            for (String axis : List.of("roll", "pitch")) {
                places.add(body + "_" + axis + "_rad");
                rates.add(body + "_" + axis + "_rad_per_s");
            }
        }
        places.addAll(rates);
        return places;
    }

    @Override
    public void states(double[] into) {
        System.arraycopy(x, 0, into, 0, x.length);
        System.arraycopy(v, 0, into, x.length, v.length);
    }

    private Link link(Anatomy.Tissue tissue, Anatomy anatomy, Subject subject, Effects effects) {
        double[] point = {effects.has(Effect.CROSS) ? tissue.x() : 0, tissue.y(), tissue.z()};
        double mass = 0;
        double inertia = 0;
        for (int i : anatomy.carried(tissue)) {
            double m = anatomy.bodies().get(i).share() * subject.mass();
            double rho = anatomy.bodies().get(i).gyration();
            double height = anatomy.bodies().get(i).z() - tissue.z();
            mass += m;
            inertia += m * (height * height + rho * rho);
        }
        double[] stiffness = new double[FREE];
        double[] damping = new double[FREE];
        for (int i = 0; i < FREE; i++) {
            double carried = i < 3 ? mass : inertia;
            double w = 2 * Math.PI * tissue.frequency()[i] * subject.tautness();
            stiffness[i] = carried * w * w;
            damping[i] = 2 * tissue.zeta()[i] * subject.tightness() * carried * w;
        }
        double[] below = tissue.from() < 0 ? point : minus(point, centres[tissue.from()]);
        return new Link(FREE * tissue.from(), FREE * tissue.to(), below, minus(point, centres[tissue.to()]), stiffness, damping);
    }

    private void rungeKutta(Motion platform, double start, double end, double dt, double k, double c) {
        int n = x.length;
        double[] at = {start, (start + end) / 2, (start + end) / 2, end};
        System.arraycopy(x, 0, trialX, 0, n);
        System.arraycopy(v, 0, trialV, 0, n);
        System.arraycopy(x, 0, sumX, 0, n);
        System.arraycopy(v, 0, sumV, 0, n);
        for (int stage = 0; stage < 4; stage++) {
            interpolate(platform, at[stage]);
            accelerate(trialX, trialV, between, k, c);
            double weight = dt * (stage == 0 || stage == 3 ? 1.0 / 6 : 1.0 / 3);
            double ahead = stage == 2 ? dt : dt / 2;
            for (int i = 0; i < n; i++) {
                sumX[i] += weight * trialV[i];
                sumV[i] += weight * acceleration[i];
                trialX[i] = x[i] + ahead * trialV[i];
                trialV[i] = v[i] + ahead * acceleration[i];
            }
        }
        System.arraycopy(sumX, 0, x, 0, n);
        System.arraycopy(sumV, 0, v, 0, n);
    }

    /** Accelerations relative to the platform: forces over masses, less what the platform does at every centre. */
    private void accelerate(double[] position, double[] rate, Motion platform, double k, double c) {
        Arrays.fill(acceleration, 0);
        for (Link link : links) {
            link.act(position, rate, k, c, acceleration);
        }
        for (int i = 0; i < bodies.length; i++) {
            bodies[i].setRigid(platform, centres[i]);
            for (int j = 0; j < FREE; j++) {
                int q = FREE * i + j;
                double carried = j < 3 ? bodies[i].acceleration[j] : platform.spin[j - 3];
                acceleration[q] = inverseMass[q] == 0 ? 0 : acceleration[q] * inverseMass[q] - carried;
            }
        }
    }

    private void look(Motion platform) {
        for (int i = 0; i < bodies.length; i++) {
            int q = FREE * i;
            for (int j = 0; j < 3; j++) {
                bodies[i].acceleration[j] += acceleration[q + j];
            }
            for (int j = 0; j < 2; j++) {
                bodies[i].angle[j] += x[q + 3 + j];
                bodies[i].rate[j] += v[q + 3 + j];
                bodies[i].spin[j] += acceleration[q + 3 + j];
            }
        }
        for (int i = 0; i < mounts.length; i++) {
            Motion body = mounts[i].body() == Anatomy.PLATFORM ? platform : bodies[mounts[i].body()];
            motions[i].setRigid(body, levers[i]);
        }
    }

    private void interpolate(Motion platform, double share) {
        mix(before.acceleration, platform.acceleration, share, between.acceleration);
        mix(before.rate, platform.rate, share, between.rate);
        mix(before.spin, platform.spin, share, between.spin);
    }

    private static void mix(double[] a, double[] b, double share, double[] into) {
        for (int i = 0; i < 3; i++) {
            into[i] = a[i] + (b[i] - a[i]) * share;
        }
    }

    private static double[] minus(double[] a, double[] b) {
        return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    }

    /** The linear system of the vertical coordinates alone, at the reference magnitude, found by unit displacements and rates. */
    private double[][] verticalSystem() {
        List<Integer> free = new ArrayList<>();
        for (int i = 0; i < bodies.length; i++) {
            if (inverseMass[FREE * i + 2] > 0) {
                free.add(FREE * i + 2);
            }
        }
        int n = free.size();
        double[][] a = new double[2 * n][2 * n];
        Motion rest = new Motion();
        for (int j = 0; j < 2 * n; j++) {
            double[] unit = j < n ? x : v;
            unit[free.get(j % n)] = 1;
            accelerate(x, v, rest, 1, 1);
            unit[free.get(j % n)] = 0;
            for (int i = 0; i < n; i++) {
                a[n + i][j] = acceleration[free.get(i)];
            }
            if (j >= n) {
                a[j - n][j] = 1;
            }
        }
        return a;
    }
}
