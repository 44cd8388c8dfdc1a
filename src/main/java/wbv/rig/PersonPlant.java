package wbv.rig;

import java.util.ArrayList;
import java.util.List;

/**
 * A whole person on a seat: the bodies and links of a {@link Skeleton}, stepped by Runge-Kutta's fourth order twice in an
 * inner step.
 *
 * <p>Coordinates are relative to where each body would be if it were fixed to the platform, so the platform acts as a field
 * of inertia, -(a + α × R + ω × (ω × R)) at a body's centre R. Rotations are small; the weight of a leaning body is left out.
 */
final class PersonPlant implements Plant {

    private static final int FREE = Skeleton.FREE;
    private static final int SUBSTEPS = 2;

    private final double h;
    private final Skeleton skeleton;
    private final AmplitudeSoftening softening;
    private final double[] modes;
    private final PlaceMotion[] bodies;
    private final PlaceMotion[] motions;
    private final PlaceMotion before = new PlaceMotion();
    private final PlaceMotion between = new PlaceMotion();
    private final double[] x;
    private final double[] v;
    private final double[] trialX;
    private final double[] trialV;
    private final double[] sumX;
    private final double[] sumV;
    private final double[] acceleration;

    PersonPlant(Skeleton skeleton, AmplitudeSoftening softening, double h) {
        this.h = h;
        this.skeleton = skeleton;
        this.softening = softening;
        modes = skeleton.verticalModes().pairs(2);
        bodies = motions(skeleton.bodies());
        motions = motions(skeleton.mounts());
        int n = FREE * bodies.length;
        x = new double[n];
        v = new double[n];
        trialX = new double[n];
        trialV = new double[n];
        sumX = new double[n];
        sumV = new double[n];
        acceleration = new double[n];
    }

    @Override
    public void step(PlaceMotion platform) {
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
    public PlaceMotion motion(int place) {
        return motions[place];
    }

    @Override
    public double[] seatForce() {
        return skeleton.seatForce();
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

    /** Of every body, relative to where it would be if fixed to the platform: place, roll, pitch, yaw, and then their rates. */
    @Override
    public List<String> states() {
        List<String> places = new ArrayList<>();
        List<String> rates = new ArrayList<>();
        for (String body : skeleton.names()) {
            for (String axis : List.of("x", "y", "z")) {
                places.add(body + "_" + axis + "_m");
                rates.add(body + "_" + axis + "_m_per_s");
            }
            for (String axis : List.of("roll", "pitch", "yaw")) {
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

    private void rungeKutta(PlaceMotion platform, double start, double end, double dt, double k, double c) {
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
    private void accelerate(double[] position, double[] rate, PlaceMotion platform, double k, double c) {
        skeleton.forces(position, rate, k, c, acceleration);
        for (int i = 0; i < bodies.length; i++) {
            bodies[i].setRigid(platform, skeleton.centre(i));
            for (int j = 0; j < FREE; j++) {
                int q = FREE * i + j;
                double carried = j < 3 ? bodies[i].acceleration[j] : platform.spin[j - 3];
                acceleration[q] = skeleton.fixed(i) ? 0 : acceleration[q] * skeleton.inverseMass(q) - carried;
            }
        }
    }

    private void look(PlaceMotion platform) {
        for (int i = 0; i < bodies.length; i++) {
            int q = FREE * i;
            for (int j = 0; j < 3; j++) {
                bodies[i].acceleration[j] += acceleration[q + j];
            }
            for (int j = 0; j < 3; j++) {
                bodies[i].angle[j] += x[q + 3 + j];
                bodies[i].rate[j] += v[q + 3 + j];
                bodies[i].spin[j] += acceleration[q + 3 + j];
            }
        }
        for (int i = 0; i < motions.length; i++) {
            int body = skeleton.mount(i).body();
            motions[i].setRigid(body == Anatomy.PLATFORM ? platform : bodies[body], skeleton.lever(i));
        }
    }

    private void interpolate(PlaceMotion platform, double share) {
        mix(before.acceleration, platform.acceleration, share, between.acceleration);
        mix(before.rate, platform.rate, share, between.rate);
        mix(before.spin, platform.spin, share, between.spin);
    }

    private static void mix(double[] a, double[] b, double share, double[] into) {
        for (int i = 0; i < 3; i++) {
            into[i] = a[i] + (b[i] - a[i]) * share;
        }
    }

    private static PlaceMotion[] motions(int count) {
        PlaceMotion[] motions = new PlaceMotion[count];
        for (int i = 0; i < count; i++) {
            motions[i] = new PlaceMotion();
        }
        return motions;
    }
}
