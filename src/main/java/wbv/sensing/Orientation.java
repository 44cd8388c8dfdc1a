package wbv.sensing;

import java.io.Serializable;

/**
 * How one frame stands in another: a rotation that turns vectors of the inner frame (a sensor) into those of the outer (the
 * world, a body), held as a unit quaternion and changed in place.
 */
public final class Orientation implements Serializable {

    private static final long serialVersionUID = 1;

    private double w = 1;
    private double x;
    private double y;
    private double z;

    /** Both frames alike. */
    public Orientation() {}

    /**
     * As a quaternion with its real part first, of any length but 0.
     *
     * @param w [1]
     * @param x [1]
     * @param y [1]
     * @param z [1]
     * @throws IllegalArgumentException if it is none
     */
    public static Orientation of(double w, double x, double y, double z) {
        Orientation made = new Orientation();
        made.set(w, x, y, z);
        return made;
    }

    /**
     * The least rotation that turns one direction into another.
     *
     * @param from
     * @param to three long, of any unit, not all 0. Not modified.
     */
    public static Orientation between(double[] from, double[] to) {
        double[] a = Vectors.unit(from);
        double[] b = Vectors.unit(to);
        double dot = Vectors.dot(a, b);
        double[] cross = Vectors.cross(a, b);
        if (dot < -1 + 1e-12) {   // half a turn, about any axis across
            double[] across = Vectors.unit(Vectors.cross(a, Math.abs(a[0]) < 0.7 ? new double[] {1, 0, 0} : new double[] {0, 1,
                0}));
            return of(0, across[0], across[1], across[2]);
        }
        return of(1 + dot, cross[0], cross[1], cross[2]);
    }

    /**
     * Sets it to a quaternion of any length but 0.
     *
     * @param qw
     * @param qx
     * @param qy
     * @param qz its parts [1]
     * @throws IllegalArgumentException if it is none
     */
    public void set(double qw, double qx, double qy, double qz) {
        double length = Math.sqrt(qw * qw + qx * qx + qy * qy + qz * qz);
        if (!(length > 0) || Double.isInfinite(length)) {
            throw new IllegalArgumentException("a quaternion must have a finite length > 0: " + qw + ", " + qx + ", " + qy + ", "
                    + qz);
        }
        w = qw / length;
        x = qx / length;
        y = qy / length;
        z = qz / length;
    }

    /** Becomes equal to another. */
    public void set(Orientation other) {
        set(other.w, other.x, other.y, other.z);
    }

    /** Real part of the quaternion [1]. */
    public double w() {
        return w;
    }

    /** Its part along x [1]. */
    public double x() {
        return x;
    }

    /** Its part along y [1]. */
    public double y() {
        return y;
    }

    /** Its part along z [1]. */
    public double z() {
        return z;
    }

    /**
     * Turns a vector of the inner frame into the outer. Thesis: Eq. 2-32.
     *
     * @param v three long, of any unit. Not modified, unless it is out.
     * @param out three long, in that unit. Modified.
     */
    public void outward(double[] v, double[] out) {
        rotate(v, out, 1);
    }

    /**
     * Turns a vector of the outer frame into the inner.
     *
     * @param v three long, of any unit. Not modified, unless it is out.
     * @param out three long, in that unit. Modified.
     */
    public void inward(double[] v, double[] out) {
        rotate(v, out, -1);
    }

    /** v + 2w (q × v) + 2 q × (q × v). */
    private void rotate(double[] v, double[] out, int sign) {
        double qx = sign * x;
        double qy = sign * y;
        double qz = sign * z;
        double tx = 2 * (qy * v[2] - qz * v[1]);
        double ty = 2 * (qz * v[0] - qx * v[2]);
        double tz = 2 * (qx * v[1] - qy * v[0]);
        double ox = v[0] + w * tx + qy * tz - qz * ty;
        double oy = v[1] + w * ty + qz * tx - qx * tz;
        double oz = v[2] + w * tz + qx * ty - qy * tx;
        out[0] = ox;
        out[1] = oy;
        out[2] = oz;
    }

    /**
     * Turns the inner frame on by a rotation vector in its own axes.
     *
     * @param rx [rad]
     * @param ry [rad]
     * @param rz [rad]
     */
    public void turn(double rx, double ry, double rz) {
        double half = Math.sqrt(rx * rx + ry * ry + rz * rz) / 2;
        double c = Math.cos(half);
        double s = half < 1e-8 ? 0.5 : Math.sin(half) / (2 * half);
        after(c, s * rx, s * ry, s * rz);
    }

    /** Turns the inner frame by another rotation first: this ⊗ other. */
    public void after(Orientation other) {
        after(other.w, other.x, other.y, other.z);
    }

    private void after(double a, double b, double c, double d) {
        set(w * a - x * b - y * c - z * d, w * b + x * a + y * d - z * c, w * c - x * d + y * a + z * b, w * d + x * c - y * b
                + z * a);
    }

    /** Turns the outer frame too: other ⊗ this. */
    public void before(Orientation other) {
        double a = other.w;
        double b = other.x;
        double c = other.y;
        double d = other.z;
        set(a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y, a * y - b * z + c * w + d * x, a * z + b * y - c * x
                + d * w);
    }

    /** The rotation the other way, a new one. */
    public Orientation inverse() {
        return of(w, -x, -y, -z);
    }

    /** How far it is from none [rad], 0 to π. */
    public double angle() {
        return 2 * Math.atan2(Math.sqrt(x * x + y * y + z * z), Math.abs(w));
    }

    /** Angle about the outer z axis of where the inner x axis points [rad]. */
    public double heading() {
        return Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
    }
}
