package wbv.body.simulate;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import wbv.body.Plane;
import wbv.body.Plane.Joint;
import wbv.body.Plane.Motion;
import wbv.body.Plane.Mount;
import wbv.body.Plane.Rigid;
import wbv.body.Row;
import wbv.body.Spectra;
import wbv.body.Structure;

/**
 * What goes beyond first order in a motion.
 *
 * <p>Not for several threads at once.
 */
final class BeyondFirstOrder {
    private final Plane plane;
    private final Excitation excitation;
    private final Structure structure;
    private final Grid grid;
    private final int samples;
    private final double[] none;
    /** Of the base along x, along z, about y [m/s², rad/s²]. */
    private final double[][] base;
    /** At which the base turns [rad/s]. */
    private final double[] spin;
    /** What the rigid bodies do, the base behind them. */
    private final Moving[] moving;

    BeyondFirstOrder(Plane plane, Excitation excitation, Structure structure) {
        this.plane = plane;
        this.excitation = excitation;
        this.structure = structure;
        grid = excitation.products();
        samples = grid.points();
        none = new double[samples];
        base = IntStream.of(plane.axes()).mapToObj(axis -> axis < 0 ? none : grid.series(excitation.base(axis))).toArray(double[][]::new);
        spin = plane.axes()[2] < 0 ? none : grid.series(Spectra.overJOmega(excitation.omega(), excitation.base(plane.axes()[2])));
        moving = IntStream.rangeClosed(0, plane.bodies().size()).mapToObj(b -> new Moving()).toArray(Moving[]::new);
    }

    /** Series of one body against the base, by {@link Motion}: none where it does not move. */
    private final class Moving {
        private final double[][] place = {none, none, none};
        private final double[][] speed = {none, none, none};
        private final double[][] acceleration = {none, none, none};
        private final double[] cos = new double[samples];
        private final double[] sin = new double[samples];

        Moving() {
            Arrays.fill(cos, 1);
        }
    }

    private Moving of(int body) {
        return moving[body < 0 ? plane.bodies().size() : body];
    }

    /**
     * Takes a motion, whose forces may then be asked for.
     *
     * @param motion against the base, spectra by coordinate. Not modified.
     */
    void moves(double[][] motion) {
        for (int b = 0; b < plane.bodies().size(); b++) {
            Moving own = moving[b];
            for (int i = 0; i < own.place.length; i++) {
                int at = plane.bodies().get(b).coordinate()[i];
                if (at >= 0) {
                    own.place[i] = grid.series(motion[at]);
                    own.speed[i] = grid.series(Spectra.timesJOmega(excitation.omega(), motion[at]));
                }
            }
            double[] angle = own.place[2];
            for (int j = 0; j < samples; j++) {
                own.cos[j] = Math.cos(angle[j]);
                own.sin[j] = Math.sin(angle[j]);
            }
        }
    }

    /**
     * Takes its accelerations too, for readings.
     *
     * @param motion as in {@link #moves}. Not modified.
     */
    void accelerates(double[][] motion) {
        for (int b = 0; b < plane.bodies().size(); b++) {
            for (int i = 0; i < moving[b].acceleration.length; i++) {
                int at = plane.bodies().get(b).coordinate()[i];
                if (at >= 0) {
                    moving[b].acceleration[i] = grid.series(Spectra.timesJOmega(excitation.omega(),
                            Spectra.timesJOmega(excitation.omega(), motion[at])));
                }
            }
        }
    }

    /**
     * Forces of the motion taken on the coordinates beside those of first order [N, N m], spectra by coordinate.
     *
     * @param carried what each link carries in the motion, spectra by link. Not modified.
     */
    double[][] forces(double[][] carried) {
        double[][] out = new double[structure.bodies()][samples];
        for (Joint joint : plane.joints()) {
            pull(joint, grid.series(carried[joint.link()]), out);
        }
        for (int b = 0; b < plane.bodies().size(); b++) {
            thrown(b, out);
        }
        return Arrays.stream(out).map(grid::spectrum).toArray(double[][]::new);
    }

    /** What a base that turns does to a body beside its own acceleration: centrifugal, Coriolis and Euler forces of second order. */
    private void thrown(int body, double[][] out) {
        for (Motion along : List.of(Motion.X, Motion.Z)) {
            int at = plane.bodies().get(body).coordinate()[along.ordinal()];
            if (at >= 0) {
                double mass = structure.mass()[at];
                double[] beside = beside(body, along);
                for (int j = 0; j < samples; j++) {
                    out[at][j] -= mass * beside[j];
                }
            }
        }
    }

    /** Acceleration of a body's centre in the base's axes beside that against the base, the base's own, and what its spin makes at rest. */
    private double[] beside(int body, Motion along) {
        int own = along.ordinal();
        int across = Motion.Z.ordinal() - own;
        double turn = along == Motion.X ? 1 : -1;
        double out = along == Motion.X ? plane.bodies().get(body).x() - plane.origin()[0]
                : plane.bodies().get(body).z() - plane.origin()[1];
        double[] place = moving[body].place[own];
        double[] aside = moving[body].place[across];
        double[] speed = moving[body].speed[across];
        double[] beside = new double[samples];
        for (int j = 0; j < samples; j++) {
            beside[j] = turn * (base[2][j] * aside[j] + 2 * spin[j] * speed[j]) - spin[j] * spin[j] * (out + place[j]);
        }
        return beside;
    }

    /** What a sensor reads of the motion and the accelerations taken beside its reading of first order, a spectrum; nothing of a rate. */
    double[] reading(Mount mount) {
        double[] out = new double[samples];
        if (mount.reads() == Motion.PITCH) {
            return grid.spectrum(out);
        }
        Moving own = moving[mount.body()];
        Rigid body = plane.bodies().get(mount.body());
        double[] besideX = beside(mount.body(), Motion.X);
        double[] besideZ = beside(mount.body(), Motion.Z);
        boolean readsX = mount.reads() == Motion.X;
        for (int j = 0; j < samples; j++) {
            double cos = own.cos[j];
            double sin = own.sin[j];
            double turning = spin[j] + own.speed[2][j];
            double angular = base[2][j] + own.acceleration[2][j];
            double plainX = own.acceleration[0][j] + base[0][j] + base[2][j] * (body.z() - plane.origin()[1]);
            double plainZ = own.acceleration[1][j] + base[1][j] - base[2][j] * (body.x() - plane.origin()[0]);
            double armX = cos * mount.x() + sin * mount.z();
            double armZ = cos * mount.z() - sin * mount.x();
            double x = plainX + besideX[j] + angular * armZ - turning * turning * armX;
            double z = plainZ + besideZ[j] - angular * armX - turning * turning * armZ;
            out[j] = readsX ? cos * x - sin * z - plainX - angular * mount.z() : sin * x + cos * z - plainZ + angular * mount.x();
        }
        return grid.spectrum(out);
    }

    /**
     * Adds what the whole angles do to a link at a point.
     *
     * @param carried by it to first order, by sample
     * @param out by coordinate and sample. Modified.
     */
    private void pull(Joint joint, double[] carried, double[][] out) {
        Rigid over = plane.bodies().get(joint.upper());
        boolean grounded = joint.lower() < 0;
        double upX = joint.x() - over.x();
        double upZ = joint.z() - over.z();
        double lowX = grounded ? upX : joint.x() - plane.bodies().get(joint.lower()).x();
        double lowZ = grounded ? upZ : joint.z() - plane.bodies().get(joint.lower()).z();
        Moving upper = of(joint.upper());
        Moving lower = of(joint.lower());
        boolean x = joint.along() == Motion.X;
        Row row = structure.stretch(joint.link());
        double[] firstStretch = along(row, false);
        double[] firstSpeed = along(row, true);
        double stiffness = structure.stiffness()[joint.link()];
        double damping = structure.damping()[joint.link()];
        for (int i = 0; i < row.at().length; i++) {
            Spectra.add(out[row.at()[i]], carried, row.by()[i]);   // what acts to first order goes
        }
        double[][] up = pushed(joint.upper(), out);
        double[][] low = pushed(joint.lower(), out);
        for (int j = 0; j < samples; j++) {
            double armX = upper.cos[j] * upX + upper.sin[j] * upZ;
            double armZ = upper.cos[j] * upZ - upper.sin[j] * upX;
            double footX = lower.cos[j] * lowX + lower.sin[j] * lowZ;
            double footZ = lower.cos[j] * lowZ - lower.sin[j] * lowX;
            // From the lower body's centre, or the point of the base, to the upper's point, where the force acts on both.
            double reachX = upper.place[0][j] - lower.place[0][j] + armX + lowX - upX;
            double reachZ = upper.place[1][j] - lower.place[1][j] + armZ + lowZ - upZ;
            double vx = upper.speed[0][j] - lower.speed[0][j] + upper.speed[2][j] * armZ - lower.speed[2][j] * reachZ;
            double vz = upper.speed[1][j] - lower.speed[1][j] - upper.speed[2][j] * armX + lower.speed[2][j] * reachX;
            double ex = x ? lower.cos[j] : lower.sin[j];
            double ez = x ? -lower.sin[j] : lower.cos[j];
            double stretch = ex * (reachX - footX) + ez * (reachZ - footZ);
            double speed = ex * vx + ez * vz;
            double whole = carried[j] + stiffness * (stretch - firstStretch[j]) + damping * (speed - firstSpeed[j]);
            double fx = whole * ex;
            double fz = whole * ez;
            up[0][j] -= fx;
            up[1][j] -= fz;
            up[2][j] -= armZ * fx - armX * fz;
            low[0][j] += fx;
            low[1][j] += fz;
            low[2][j] += reachZ * fx - reachX * fz;
        }
    }

    /** Where forces and the moment on a body are added: nowhere that counts where it does not move. */
    private double[][] pushed(int body, double[][] out) {
        double[][] to = new double[3][];
        for (int i = 0; i < to.length; i++) {
            int at = body < 0 ? -1 : plane.bodies().get(body).coordinate()[i];
            to[i] = at < 0 ? new double[samples] : out[at];
        }
        return to;
    }

    /** The stretch of a link to first order, or its speed. */
    private double[] along(Row row, boolean speed) {
        double[] sum = new double[samples];
        for (int b = 0; b < plane.bodies().size(); b++) {
            for (int i = 0; i < row.at().length; i++) {
                for (int m = 0; m < 3; m++) {
                    if (plane.bodies().get(b).coordinate()[m] == row.at()[i]) {
                        Spectra.add(sum, speed ? moving[b].speed[m] : moving[b].place[m], row.by()[i]);
                    }
                }
            }
        }
        return sum;
    }
}
