package wbv.body;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Where bodies that move in the plane of x and z are, by which their motions go together beyond first order: bodies turn by whole angles, forces
 * act where the points are, in the axes of the lower body, sensors turn with what they sit on, and what moves on a base that turns is thrown about.
 *
 * @param origin of the base: x, z [m]. Not copied
 * @param axes   index among the base's axes of its motion along x, along z and about y; -1 where it has none. Not copied
 * @param bodies rigid bodies
 * @param joints of links along x and z: a link about y has none
 */
public record Plane(double[] origin, int[] axes, List<Rigid> bodies, List<Joint> joints) {

    /** A motion of a rigid body. */
    public enum Motion { X, Z, PITCH }

    /** A body. @param coordinate of each motion, -1 for none. Not copied @param x of its centre of mass [m] @param z likewise */
    public record Rigid(int[] coordinate, double x, double z) { }

    /** A link at a point. @param along X or Z @param lower index of a rigid body, -1 for the base @param upper likewise @param x of the point [m] @param z likewise */
    public record Joint(int link, Motion along, int lower, int upper, double x, double z) { }

    /** Where a sensor sits. @param body index of a rigid body @param reads its axis, or PITCH @param x from the body's centre [m] @param z likewise */
    public record Mount(int body, Motion reads, double x, double z) { }

    public Plane {
        bodies = List.copyOf(bodies);
        joints = List.copyOf(joints);
    }

    /**
     * What goes beyond first order in a motion.
     *
     * <p>Not for several threads at once.
     */
    final class Beyond {
        private final Excitation excitation;
        private final Structure structure;
        /** Positions [m, rad], speeds and accelerations against the base, by coordinate and sample. */
        private final double[][] q;
        private final double[][] v;
        private final double[][] a;
        /** Of the base along x, along z, about y. */
        private final double[][] base;
        private final double[] rate;
        private final int samples;

        Beyond(Excitation excitation, Structure structure) {
            this.excitation = excitation;
            this.structure = structure;
            this.samples = excitation.fineSamples();
            int n = structure.bodies();
            q = new double[n][];
            v = new double[n][];
            a = new double[n][];
            double[] none = new double[samples];
            base = IntStream.of(axes).mapToObj(axis -> axis < 0 ? none : excitation.fineSeries(excitation.base(axis))).toArray(double[][]::new);
            rate = axes[2] < 0 ? none : excitation.fineSeries(Spectra.overJOmega(excitation.omega(), excitation.base(axes[2])));
        }

        /** Takes a motion, whose forces may then be asked for. @param motion against the base, spectra by coordinate. Not modified. */
        void moves(double[][] motion) {
            for (int i = 0; i < motion.length; i++) {
                q[i] = excitation.fineSeries(motion[i]);
                v[i] = excitation.fineSeries(Spectra.timesJOmega(excitation.omega(), motion[i]));
            }
        }

        /** Takes its accelerations too, for readings. @param motion as in {@link #moves}. Not modified. */
        void accelerates(double[][] motion) {
            for (int i = 0; i < motion.length; i++) {
                a[i] = excitation.fineSeries(Spectra.timesJOmega(excitation.omega(), Spectra.timesJOmega(excitation.omega(), motion[i])));
            }
        }

        private double of(double[][] series, int body, Motion motion, int j) {
            int at = body < 0 ? -1 : bodies.get(body).coordinate()[motion.ordinal()];
            return at < 0 ? 0 : series[at][j];
        }

        /**
         * Forces of the motion taken on the coordinates beside those of first order [N, N m], by coordinate and sample.
         *
         * @param carried what each link carries in the motion, by link and sample. Not modified.
         */
        double[][] forces(double[][] carried) {
            double[][] out = new double[structure.bodies()][samples];
            for (Joint joint : joints) {
                Pull pull = new Pull(joint);
                for (int j = 0; j < samples; j++) {
                    pull.at(j, carried[joint.link()][j], out);
                }
            }
            for (int b = 0; b < bodies.size(); b++) {
                thrown(b, out);
            }
            return out;
        }

        /** What a base that turns does to a body beside its own acceleration: centrifugal, Coriolis and Euler forces of second order. */
        private void thrown(int body, double[][] out) {
            int x = bodies.get(body).coordinate()[0];
            int z = bodies.get(body).coordinate()[1];
            for (int j = 0; j < samples; j++) {
                if (x >= 0) {
                    out[x][j] -= structure.mass()[x] * beside(body, Motion.X, j);
                }
                if (z >= 0) {
                    out[z][j] -= structure.mass()[z] * beside(body, Motion.Z, j);
                }
            }
        }

        /** Acceleration of a body's centre in the base's axes beside that against the base, the base's own, and what its spin makes at rest. */
        private double beside(int body, Motion motion, int j) {
            double w = rate[j];
            double px = bodies.get(body).x() - origin[0] + of(q, body, Motion.X, j);
            double pz = bodies.get(body).z() - origin[1] + of(q, body, Motion.Z, j);
            return motion == Motion.X ? base[2][j] * of(q, body, Motion.Z, j) + 2 * w * of(v, body, Motion.Z, j) - w * w * px
                    : -base[2][j] * of(q, body, Motion.X, j) - 2 * w * of(v, body, Motion.X, j) - w * w * pz;
        }

        /** What a sensor reads of the motion and the accelerations taken beside its reading of first order, by sample; nothing of a rate. */
        double[] reading(Mount mount) {
            double[] out = new double[samples];
            int b = mount.body();
            for (int j = 0; j < samples && mount.reads() != Motion.PITCH; j++) {
                double angle = of(q, b, Motion.PITCH, j);
                double turning = rate[j] + of(v, b, Motion.PITCH, j);
                double angular = base[2][j] + of(a, b, Motion.PITCH, j);
                double plainX = of(a, b, Motion.X, j) + base[0][j] + base[2][j] * (bodies.get(b).z() - origin[1]);
                double plainZ = of(a, b, Motion.Z, j) + base[1][j] - base[2][j] * (bodies.get(b).x() - origin[0]);
                double armX = Math.cos(angle) * mount.x() + Math.sin(angle) * mount.z();
                double armZ = Math.cos(angle) * mount.z() - Math.sin(angle) * mount.x();
                double x = plainX + beside(b, Motion.X, j) + angular * armZ - turning * turning * armX;
                double z = plainZ + beside(b, Motion.Z, j) - angular * armX - turning * turning * armZ;
                out[j] = mount.reads() == Motion.X ? Math.cos(angle) * x - Math.sin(angle) * z - plainX - angular * mount.z()
                        : Math.sin(angle) * x + Math.cos(angle) * z - plainZ + angular * mount.x();
            }
            return out;
        }

        /** A link at a point, with whole angles. */
        private final class Pull {
            private final Joint joint;
            private final double upX;
            private final double upZ;
            private final double lowX;
            private final double lowZ;
            private final Optional<Rigid> lower;

            Pull(Joint joint) {
                this.joint = joint;
                Rigid upper = bodies.get(joint.upper());
                lower = joint.lower() < 0 ? Optional.empty() : Optional.of(bodies.get(joint.lower()));
                upX = joint.x() - upper.x();
                upZ = joint.z() - upper.z();
                lowX = lower.map(each -> joint.x() - each.x()).orElse(0.0);
                lowZ = lower.map(each -> joint.z() - each.z()).orElse(0.0);
            }

            /** Adds what the whole angles do at a sample. @param carried by the link to first order @param out by coordinate and sample. Modified. */
            void at(int j, double carried, double[][] out) {
                int u = joint.upper();
                int l = joint.lower();
                double up = of(q, u, Motion.PITCH, j);
                double low = of(q, l, Motion.PITCH, j);
                double upRate = of(v, u, Motion.PITCH, j);
                double lowRate = of(v, l, Motion.PITCH, j);
                double cosUp = Math.cos(up);
                double sinUp = Math.sin(up);
                double cos = Math.cos(low);
                double sin = Math.sin(low);
                double armX = cosUp * upX + sinUp * upZ;
                double armZ = cosUp * upZ - sinUp * upX;
                double footX = cos * lowX + sin * lowZ;
                double footZ = cos * lowZ - sin * lowX;
                // From the lower body's centre to the upper's point, where the force acts on both.
                double reachX = of(q, u, Motion.X, j) - of(q, l, Motion.X, j) + armX + (lower.isPresent() ? lowX - upX : 0);
                double reachZ = of(q, u, Motion.Z, j) - of(q, l, Motion.Z, j) + armZ + (lower.isPresent() ? lowZ - upZ : 0);
                double dx = lower.isPresent() ? reachX - footX : reachX - upX;
                double dz = lower.isPresent() ? reachZ - footZ : reachZ - upZ;
                double vx = of(v, u, Motion.X, j) - of(v, l, Motion.X, j) + upRate * armZ - (lower.isPresent() ? lowRate * reachZ : 0);
                double vz = of(v, u, Motion.Z, j) - of(v, l, Motion.Z, j) - upRate * armX + (lower.isPresent() ? lowRate * reachX : 0);
                boolean x = joint.along() == Motion.X;
                double ex = x ? cos : sin;
                double ez = x ? -sin : cos;
                double stretch = ex * dx + ez * dz;
                double speed = ex * vx + ez * vz;
                Row row = structure.stretch(joint.link());
                double whole = carried + structure.stiffness()[joint.link()] * (stretch - along(row, q, j))
                        + structure.damping()[joint.link()] * (speed - along(row, v, j));
                for (int i = 0; i < row.at().length; i++) {
                    out[row.at()[i]][j] += row.by()[i] * carried;   // what acts to first order goes
                }
                push(u, -whole * ex, -whole * ez, armX, armZ, j, out);
                if (lower.isPresent()) {
                    push(l, whole * ex, whole * ez, reachX, reachZ, j, out);
                }
            }
        }

        private static double along(Row row, double[][] series, int j) {
            double sum = 0;
            for (int i = 0; i < row.at().length; i++) {
                sum += row.by()[i] * series[row.at()[i]][j];
            }
            return sum;
        }

        private void push(int body, double fx, double fz, double armX, double armZ, int j, double[][] out) {
            int[] coordinate = bodies.get(body).coordinate();
            double[] parts = {fx, fz, armZ * fx - armX * fz};
            for (int i = 0; i < parts.length; i++) {
                if (coordinate[i] >= 0) {
                    out[coordinate[i]][j] += parts[i];
                }
            }
        }
    }
}
