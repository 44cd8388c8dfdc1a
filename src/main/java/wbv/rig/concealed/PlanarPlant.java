package wbv.rig.concealed;

import java.util.List;
import wbv.rig.concealed.law.LinkPhysics;

/**
 * A planar person in motion: Newton and Euler for each body in the axes of the platform, which accelerate and turn, Runge-Kutta's fourth
 * order. Nothing is made small: bodies turn by whole angles, forces act where the points are, in the axes of the body below, and sensors
 * turn with what they sit on. Pitch turns z towards x.
 */
final class PlanarPlant {

    /** Steps a sample of what is recorded: 4800 Hz. */
    static final int FINE = 5;
    /** Steps a sample where only sizes matter. */
    static final int COARSE = 2;

    /**
     * What the platform does, in its own axes, by sample at {@link UniformSeries#RATE}.
     *
     * @param x
     * @param z acceleration [m/s²]
     * @param rate of pitch [rad/s]
     * @param spin its derivative
     */
    record Base(double[] x, double[] z, double[] rate, double[] spin) {

        /** @param rate of pitch, of which the derivative is taken */
        static Base of(double[] x, double[] z, double[] rate) {
            return new Base(x, z, rate, UniformSeries.rate(rate));
        }

        int length() {
            return x.length;
        }
    }

    /**
     * What a run leaves.
     *
     * @param felt      by body: acceleration along x and z in the axes of its sensor [m/s²], rate of pitch [rad/s], each by sample
     * @param extension by joint and component [m, rad]
     * @param rate of that
     * @param force that resists it [N, N m]
     * @param state     positions [m] and pitch [rad] of the bodies against the platform, then their rates, by sample
     */
    record Trace(double[][][] felt, double[][][] extension, double[][][] rate, double[][][] force, double[][] state) {}

    private final PlanarPerson person;
    private final List<PlanarPerson.Joint> joints;
    private final double[] push;
    private final int substeps;
    private final double h;
    private final int bodies;
    private final LinkPhysics[][] physics;
    private final int[][] first;
    private final int states;
    private final double[][] r;
    private final double[][] v;
    private final double[][] carried;
    private final double[] cos;
    private final double[] sin;
    /** From the upper and from the lower body's centre of mass to each joint's point on it, in the platform's axes: x, z. */
    private final double[][] above;
    private final double[][] below;

    /** @param substeps steps a sample */
    PlanarPlant(PlanarSetup setup, int substeps) {
        person = setup.person();
        joints = person.joints();
        push = setup.push();
        this.substeps = substeps;
        h = 1 / (UniformSeries.RATE * substeps);
        bodies = person.size();
        physics = new LinkPhysics[joints.size()][PlanarPerson.COMPONENTS];
        first = new int[joints.size()][PlanarPerson.COMPONENTS];
        int next = 6 * bodies;
        for (int j = 0; j < joints.size(); j++) {
            for (int q = 0; q < PlanarPerson.COMPONENTS; q++) {
                physics[j][q] = setup.physics(j, q, h);
                first[j][q] = next;
                next += physics[j][q].states();
            }
        }
        states = next;
        r = new double[joints.size()][PlanarPerson.COMPONENTS];
        v = new double[joints.size()][PlanarPerson.COMPONENTS];
        carried = new double[joints.size()][PlanarPerson.COMPONENTS];
        cos = new double[bodies];
        sin = new double[bodies];
        above = new double[joints.size()][2];
        below = new double[joints.size()][2];
    }

    /** At rest. */
    double[] rest() {
        double[] y = new double[states];
        for (int i = 0; i < bodies; i++) {
            y[3 * i] = person.centre()[i][0];
            y[3 * i + 1] = person.centre()[i][1];
        }
        return y;
    }

    Trace run(Base base) {
        return run(base, rest());
    }

    /** @param start states: position and pitch by body, then their rates, then those of the laws. Modified. */
    Trace run(Base base, double[] start) {
        int length = base.length();
        Trace trace = new Trace(new double[bodies][3][length], new double[joints.size()][3][length], new double[joints.size()][3][length],
                new double[joints.size()][3][length], new double[6 * bodies][length]);
        double[] y = start;
        double[][] k = new double[4][states];
        double[] trial = new double[states];
        long step = 0;
        for (int s = 0; s < length; s++) {
            for (int sub = 0; sub < substeps; sub++) {
                double t = step * h;
                for (int stage = 0; stage < 4; stage++) {
                    double share = stage == 0 ? 0 : stage == 3 ? 1 : 0.5;
                    double[] from = y;
                    if (stage > 0) {
                        double ahead = stage == 3 ? h : h / 2;
                        for (int i = 0; i < states; i++) {
                            trial[i] = y[i] + ahead * k[stage - 1][i];
                        }
                        from = trial;
                    }
                    rates(t + share * h, base, s, (sub + share) / substeps, from, k[stage]);
                    if (stage == 0 && sub == 0) {
                        look(trace, base, s, y, k[0]);
                    }
                }
                for (int i = 0; i < states; i++) {
                    y[i] += h / 6 * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i]);
                }
                step++;
                stretch(y);
                for (int j = 0; j < joints.size(); j++) {
                    for (int q = 0; q < PlanarPerson.COMPONENTS; q++) {
                        physics[j][q].commit(step * h, r[j][q], v[j][q]);
                    }
                }
            }
        }
        return trace;
    }

    /** Extension of all joints and its rate, in the axes of the body below, which turn. */
    private void stretch(double[] y) {
        for (int i = 0; i < bodies; i++) {
            cos[i] = Math.cos(y[3 * i + 2]);
            sin[i] = Math.sin(y[3 * i + 2]);
        }
        for (int j = 0; j < joints.size(); j++) {
            PlanarPerson.Joint joint = joints.get(j);
            int u = 3 * joint.upper();
            int l = 3 * joint.lower();
            boolean grounded = l < 0;
            double[] up = arm(joint, joint.upper(), above[j]);
            double px = y[u] + up[0];
            double pz = y[u + 1] + up[1];
            double rate = y[3 * bodies + u + 2];
            double vx = y[3 * bodies + u] + rate * up[1];
            double vz = y[3 * bodies + u + 1] - rate * up[0];
            double turn = grounded ? 0 : y[l + 2];
            double turning = grounded ? 0 : y[3 * bodies + l + 2];
            double dx = px - joint.at()[0];
            double dz = pz - joint.at()[1];
            if (!grounded) {
                double[] low = arm(joint, joint.lower(), below[j]);
                dx = px - y[l] - low[0];
                dz = pz - y[l + 1] - low[1];
                vx -= y[3 * bodies + l] + turning * (pz - y[l + 1]);
                vz -= y[3 * bodies + l + 1] - turning * (px - y[l]);
            }
            double c = grounded ? 1 : cos[joint.lower()];
            double s = grounded ? 0 : sin[joint.lower()];
            r[j][0] = c * dx - s * dz;
            r[j][1] = s * dx + c * dz;
            r[j][2] = y[u + 2] - turn;
            v[j][0] = c * vx - s * vz;
            v[j][1] = s * vx + c * vz;
            v[j][2] = rate - turning;
        }
    }

    /**
     * From a body's centre of mass to a joint's point on it, in the platform's axes.
     *
     * @param into Modified.
     */
    private double[] arm(PlanarPerson.Joint joint, int body, double[] into) {
        double x = joint.at()[0] - person.centre()[body][0];
        double z = joint.at()[1] - person.centre()[body][1];
        into[0] = cos[body] * x + sin[body] * z;
        into[1] = cos[body] * z - sin[body] * x;
        return into;
    }

    /** From the axes of what is pitched to the platform's. */
    private static double[] turned(double x, double z, double pitch) {
        double cos = Math.cos(pitch);
        double sin = Math.sin(pitch);
        return new double[] {cos * x + sin * z, cos * z - sin * x};
    }

    private void rates(double t, Base base, int s, double at, double[] y, double[] into) {
        double ax = ChainPlant.cubic(base.x(), s, at);
        double az = ChainPlant.cubic(base.z(), s, at);
        double rate = ChainPlant.cubic(base.rate(), s, at);
        double spin = ChainPlant.cubic(base.spin(), s, at);
        stretch(y);
        int n = 3 * bodies;
        for (int i = 0; i < n; i++) {
            into[i] = y[n + i];
            into[n + i] = 0;
        }
        for (int j = 0; j < joints.size(); j++) {
            PlanarPerson.Joint joint = joints.get(j);
            for (int q = 0; q < PlanarPerson.COMPONENTS; q++) {
                carried[j][q] = physics[j][q].force(t, r[j][q], v[j][q], y, first[j][q]);
                physics[j][q].rates(t, r[j][q], v[j][q], y, first[j][q], into);
            }
            int u = 3 * joint.upper();
            int l = 3 * joint.lower();
            double c = l < 0 ? 1 : cos[joint.lower()];
            double d = l < 0 ? 0 : sin[joint.lower()];
            double fx = c * -carried[j][0] + d * -carried[j][1];
            double fz = c * -carried[j][1] - d * -carried[j][0];
            double[] up = above[j];
            act(into, n + u, fx, fz, up[0], up[1], -carried[j][2]);
            if (l >= 0) {
                // At the same point in space, so that neither momentum is lost.
                act(into, n + l, -fx, -fz, y[u] + up[0] - y[l], y[u + 1] + up[1] - y[l + 1], carried[j][2]);
            }
        }
        if (push.length > 0) {
            into[n + 4] += push[s] + (s + 1 < push.length ? push[s + 1] - push[s] : 0) * at;
        }
        for (int i = 0; i < bodies; i++) {
            int p = 3 * i;
            into[n + p] = into[n + p] / person.mass()[i] - ax - spin * y[p + 1] - 2 * rate * y[n + p + 1] + rate * rate * y[p];
            into[n + p + 1] = into[n + p + 1] / person.mass()[i] - az + spin * y[p] + 2 * rate * y[n + p] + rate * rate * y[p + 1];
            into[n + p + 2] = into[n + p + 2] / person.inertia()[i] - spin;
        }
    }

    /** Adds a force at an arm from the centre of mass, and a moment. */
    private static void act(double[] into, int at, double fx, double fz, double x, double z, double moment) {
        into[at] += fx;
        into[at + 1] += fz;
        into[at + 2] += z * fx - x * fz + moment;
    }

    private void look(Trace trace, Base base, int s, double[] y, double[] rates) {
        int n = 3 * bodies;
        for (int i = 0; i < bodies; i++) {
            int p = 3 * i;
            double rate = base.rate()[s];
            double spin = base.spin()[s];
            double ax = rates[n + p] + base.x()[s] + spin * y[p + 1] + 2 * rate * y[n + p + 1] - rate * rate * y[p];
            double az = rates[n + p + 1] + base.z()[s] - spin * y[p] - 2 * rate * y[n + p] - rate * rate * y[p + 1];
            double turning = rate + y[n + p + 2];
            double angular = spin + rates[n + p + 2];
            double[] arm = turned(person.sensor()[i][0] - person.centre()[i][0], person.sensor()[i][1] - person.centre()[i][1], y[p + 2]);
            double[] own = turned(ax + angular * arm[1] - turning * turning * arm[0], az - angular * arm[0] - turning * turning * arm[1],
                    -y[p + 2]);
            trace.felt()[i][0][s] = own[0];
            trace.felt()[i][1][s] = own[1];
            trace.felt()[i][2][s] = turning;
        }
        for (int j = 0; j < joints.size(); j++) {
            for (int q = 0; q < PlanarPerson.COMPONENTS; q++) {
                trace.extension()[j][q][s] = r[j][q];
                trace.rate()[j][q][s] = v[j][q];
                trace.force()[j][q][s] = carried[j][q];
            }
        }
        for (int i = 0; i < 2 * n; i++) {
            trace.state()[i][s] = y[i];
        }
    }
}
