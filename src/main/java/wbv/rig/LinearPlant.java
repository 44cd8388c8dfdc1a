package wbv.rig;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * Masses in series on the platform, vertical and linear, stepped exactly: known to the last digit, so that an estimator can be
 * measured against it. In all other directions the places follow the platform as if fixed to it; its horizontal motion may push
 * the first mass up.
 *
 * <p>States are the stretch of every link and its rate, x = [d1, d1', d2, d2']; mass i has the absolute acceleration
 * (c_{i+1} d'_{i+1} + k_{i+1} d_{i+1} - c_i d'_i - k_i d_i) / m_i, the first one's with what pushes it in addition.
 */
final class LinearPlant implements Plant {

    private final double[] mass;
    private final double[] damping;
    private final double crossX;
    private final double crossY;
    private final double h;
    private final long stepTick;
    private final double factor;
    private final double[] x;
    private final PlaceMotion[] motions;
    private final double[] stiffness;
    private final double[] force = new double[3];
    private LinearStep step;
    private double[] truth;
    private double previous;
    private long tick;

    static LinearPlant of(Sitter.OneDof sitter, double h, double start) {
        double w = 2 * Math.PI * sitter.frequency();
        return new LinearPlant(sitter.places(), new double[] {1}, new double[] {w * w},
                new double[] {2 * sitter.zeta() * w}, sitter.step(), sitter.crossX(), sitter.crossY(), h, start);
    }

    static LinearPlant of(Sitter.TwoDof sitter, double h, double start) {
        return new LinearPlant(sitter.places(), new double[] {sitter.torso(), sitter.head()},
                new double[] {sitter.k1(), sitter.k2()}, new double[] {sitter.c1(), sitter.c2()}, sitter.step(), 0, 0, h, start);
    }

    private LinearPlant(List<String> places, double[] mass, double[] stiffness, double[] damping, Optional<Sitter.Step> change,
            double crossX, double crossY, double h, double start) {
        this.mass = mass;
        this.stiffness = stiffness;
        this.damping = damping;
        this.crossX = crossX;
        this.crossY = crossY;
        this.h = h;
        this.stepTick = change.map(s -> Math.round((s.time() - start) / h)).orElse(-2L);
        this.factor = change.map(Sitter.Step::factor).orElse(1.0);
        this.x = new double[2 * mass.length];
        this.motions = new PlaceMotion[places.size()];
        for (int i = 0; i < motions.length; i++) {
            motions[i] = new PlaceMotion();
        }
        assemble();
    }

    @Override
    public void step(PlaceMotion platform) {
        if (tick++ == stepTick + 1) {
            for (int i = 0; i < stiffness.length; i++) {
                stiffness[i] *= factor;
            }
            assemble();
        }
        double push = crossX * platform.acceleration[0] + crossY * platform.acceleration[1];
        double base = platform.acceleration[2] - push; // what stretches the first link
        step.apply(x, previous, base);
        previous = base;
        for (PlaceMotion motion : motions) {
            motion.set(platform);
        }
        for (int i = 0; i < mass.length; i++) {
            motions[2 + i].acceleration[2] = acceleration(i) + (i == 0 ? push : 0);
        }
    }

    @Override
    public PlaceMotion motion(int place) {
        return motions[place];
    }

    @Override
    public double[] seatForce() {
        Arrays.fill(force, 0);
        for (int i = 0; i < mass.length; i++) {
            force[2] += mass[i] * motions[2 + i].acceleration[2];
        }
        return force;
    }

    @Override
    public List<String> parameters() {
        return mass.length == 1 ? List.of("zeta", "omega") : List.of("zeta1", "omega1", "zeta2", "omega2");
    }

    @Override
    public void parameters(double[] into) {
        System.arraycopy(truth, 0, into, 0, truth.length);
    }

    @Override
    public List<String> states() {
        List<String> names = List.of("stretch1_m", "stretch_rate1_m_per_s", "stretch2_m", "stretch_rate2_m_per_s");
        return names.subList(0, x.length);
    }

    @Override
    public void states(double[] into) {
        System.arraycopy(x, 0, into, 0, x.length);
    }

    private double acceleration(int i) {
        double force = -stiffness[i] * x[2 * i] - damping[i] * x[2 * i + 1];
        if (i + 1 < mass.length) {
            force += stiffness[i + 1] * x[2 * i + 2] + damping[i + 1] * x[2 * i + 3];
        }
        return force / mass[i];
    }

    /** The matrices from masses, springs and dampers: d_i'' = a_i - a_{i-1}, the base's acceleration being a_0. */
    private void assemble() {
        int n = mass.length;
        double[][] absolute = new double[n + 1][2 * n];
        for (int i = 0; i < n; i++) {
            absolute[i + 1][2 * i] -= stiffness[i] / mass[i];
            absolute[i + 1][2 * i + 1] -= damping[i] / mass[i];
            if (i + 1 < n) {
                absolute[i + 1][2 * i + 2] += stiffness[i + 1] / mass[i];
                absolute[i + 1][2 * i + 3] += damping[i + 1] / mass[i];
            }
        }
        double[][] a = new double[2 * n][2 * n];
        double[] b = new double[2 * n];
        for (int i = 0; i < n; i++) {
            a[2 * i][2 * i + 1] = 1;
            for (int j = 0; j < 2 * n; j++) {
                a[2 * i + 1][j] = absolute[i + 1][j] - absolute[i][j];
            }
        }
        b[1] = -1;
        step = new LinearStep(a, b, h);
        truth = n == 1
                ? new double[] {damping[0] / (2 * Math.sqrt(stiffness[0] * mass[0])), Math.sqrt(stiffness[0] / mass[0])}
                : Modes.of(a).pairs(n);
    }
}
