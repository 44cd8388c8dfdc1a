package wbv.rig.concealed;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import wbv.rig.concealed.law.LinkPhysics;

/**
 * A chain in motion: Runge-Kutta's fourth order, several steps a sample. Coordinates are relative to the platform,
 * so only its acceleration drives: m q'' = Σ forces - m a. Between samples the platform is a cubic through four of them.
 */
final class ChainPlant {

    /** Steps a sample of what is recorded: 8640 Hz. */
    static final int FINE = 9;
    /** Steps a sample where only sizes matter. */
    static final int COARSE = 4;

    /**
     * What a run leaves.
     *
     * @param acceleration absolute, by body and sample [m/s²]
     * @param extension by link [m]
     * @param rate [m/s]
     * @param force in each link, then in those under bodies that nobody sees, positive in tension [N]
     */
    record Trace(double[][] acceleration, double[][] extension, double[][] rate, double[][] force) {}

    private final Setup setup;
    private final int substeps;
    private final int n;
    private final int[] parent;
    private final double[] mass;
    private final LinkPhysics[] physics;
    private final int[] first;
    private final int states;
    private final double[][] linkForce;
    private final double[][] bodyForce;
    private final double[] carried;
    private final double[] inertance;
    private final boolean inert;

    /**
     * @param rate of the series that drive it [Hz]
     * @param substeps steps a sample
     */
    ChainPlant(Setup setup, double rate, int substeps) {
        this.setup = setup;
        this.substeps = substeps;
        List<Integer> parents = new ArrayList<>();
        List<Double> masses = new ArrayList<>();
        List<LinkPhysics> laws = new ArrayList<>();
        Chain chain = setup.chain();
        double h = 1 / (rate * substeps);
        for (int i = 0; i < chain.size(); i++) {
            parents.add(chain.parent()[i]);
            masses.add(chain.mass()[i]);
            laws.add(setup.physics(i, h));
        }
        for (Setup.Rider rider : setup.riders()) {
            parents.add(rider.body());
            masses.add(rider.mass());
            laws.add(rider.physics());
        }
        n = parents.size();
        parent = parents.stream().mapToInt(i -> i).toArray();
        mass = masses.stream().mapToDouble(x -> x).toArray();
        physics = laws.toArray(LinkPhysics[]::new);
        first = new int[n];
        int next = 2 * n;
        for (int i = 0; i < n; i++) {
            first[i] = next;
            next += physics[i].states();
        }
        states = next;
        linkForce = setup.linkForces();
        bodyForce = setup.bodyForces();
        carried = new double[n];
        inertance = laws.stream().mapToDouble(LinkPhysics::inertance).toArray();
        inert = Arrays.stream(inertance).anyMatch(b -> b != 0);
    }

    /**
     * Plays the platform's acceleration.
     *
     * @param platform [m/s²] by sample. Not modified.
     * @param rate samples per second [Hz]
     */
    Trace run(double[] platform, double rate) {
        int length = platform.length;
        int visible = setup.chain().size();
        Trace trace = new Trace(new double[visible][length], new double[visible][length], new double[visible][length],
                new double[n][length]);
        double h = 1 / (rate * substeps);
        double[] y = new double[states];
        double[][] k = new double[4][states];
        double[] trial = new double[states];
        double[] force = new double[n];
        long step = 0;
        for (int s = 0; s < length; s++) {
            for (int sub = 0; sub < substeps; sub++) {
                double t = step * h;
                for (int stage = 0; stage < 4; stage++) {
                    double share = stage == 0 ? 0 : stage == 3 ? 1 : 0.5;
                    double at = (sub + share) / substeps;
                    double[] from = y;
                    if (stage > 0) {
                        double ahead = stage == 3 ? h : h / 2;
                        for (int i = 0; i < states; i++) {
                            trial[i] = y[i] + ahead * k[stage - 1][i];
                        }
                        from = trial;
                    }
                    rates(t + share * h, s, at, cubic(platform, s, at), from, force, k[stage]);
                    if (stage == 0 && sub == 0) {
                        look(trace, s, platform[s], y, k[0]);
                    }
                }
                for (int i = 0; i < states; i++) {
                    y[i] += h / 6 * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i]);
                }
                step++;
                for (int i = 0; i < n; i++) {
                    int p = parent[i];
                    physics[i].commit(step * h, p < 0 ? y[i] : y[i] - y[p], p < 0 ? y[n + i] : y[n + i] - y[n + p]);
                }
            }
        }
        return trace;
    }

    private void rates(double t, int sample, double at, double base, double[] y, double[] force, double[] into) {
        Arrays.fill(force, 0);
        for (int i = 0; i < n; i++) {
            int p = parent[i];
            double r = p < 0 ? y[i] : y[i] - y[p];
            double v = p < 0 ? y[n + i] : y[n + i] - y[n + p];
            double f = physics[i].force(t, r, v, y, first[i]);
            physics[i].rates(t, r, v, y, first[i], into);
            if (i < linkForce.length && linkForce[i].length > 0) {
                f += straight(linkForce[i], sample, at);
            }
            carried[i] = f;
            force[i] -= f;
            if (p >= 0) {
                force[p] += f;
            }
            if (i < bodyForce.length && bodyForce[i].length > 0) {
                force[i] += straight(bodyForce[i], sample, at);
            }
        }
        for (int i = 0; i < n; i++) {
            into[i] = y[n + i];
            into[n + i] = force[i] / mass[i] - base;
        }
        if (inert) {
            accelerate(base, force, into);
        }
    }

    /**
     * Accelerations where links resist them: (mass + inertance of the tree) q'' = force - mass base, eliminated from the tops down. What
     * the links carry grows by it.
     */
    private void accelerate(double base, double[] force, double[] into) {
        double[] weight = mass.clone();
        double[] push = new double[n];
        for (int i = n - 1; i >= 0; i--) {
            push[i] += force[i] - mass[i] * base;
            weight[i] += inertance[i];
            int p = parent[i];
            if (p >= 0) {
                weight[p] += inertance[i] * (1 - inertance[i] / weight[i]);
                push[p] += inertance[i] * push[i] / weight[i];
            }
        }
        for (int i = 0; i < n; i++) {
            int p = parent[i];
            double below = p < 0 ? 0 : into[n + p];
            into[n + i] = (push[i] + inertance[i] * below) / weight[i];
            carried[i] += inertance[i] * (into[n + i] - below);
        }
    }

    private void look(Trace trace, int s, double base, double[] y, double[] rates) {
        for (int i = 0; i < trace.acceleration.length; i++) {
            int p = parent[i];
            trace.acceleration[i][s] = rates[n + i] + base;
            trace.extension[i][s] = p < 0 ? y[i] : y[i] - y[p];
            trace.rate[i][s] = p < 0 ? y[n + i] : y[n + i] - y[n + p];
        }
        for (int i = 0; i < n; i++) {
            trace.force[i][s] = carried[i];
        }
    }

    private static double straight(double[] x, int s, double at) {
        double now = x[s];
        return at == 0 || s + 1 == x.length ? now : now + (x[s + 1] - now) * at;
    }

    /** Lagrange's cubic through the two samples before and the two after. */
    static double cubic(double[] x, int s, double at) {
        if (at == 0) {
            return x[s];
        }
        double a = x[Math.max(0, s - 1)];
        double b = x[s];
        double c = x[Math.min(x.length - 1, s + 1)];
        double d = x[Math.min(x.length - 1, s + 2)];
        return b + at * (c - a / 3 - b / 2 - d / 6 + at * (a / 2 - b + c / 2 + at * (b / 2 - c / 2 + (d - a) / 6)));
    }
}
