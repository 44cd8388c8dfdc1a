package wbv.recording.format;

/** Rotation matrices as quaternions. */
final class Rotation {

    private Rotation() {}

    /**
     * The unit quaternion w, x, y, z, w not negative, of a rotation matrix (Shepperd 1978: the greatest of the four squares is
     * the one to divide by).
     *
     * @param m  holds the matrix column by column from index {@code at} on: m11 m21 m31 m12 …
     * @param q  filled from index {@code to} on; NaN where an entry is missing
     */
    static void quaternion(double[] m, int at, double[] q, int to) {
        double m11 = m[at];
        double m21 = m[at + 1];
        double m31 = m[at + 2];
        double m12 = m[at + 3];
        double m22 = m[at + 4];
        double m32 = m[at + 5];
        double m13 = m[at + 6];
        double m23 = m[at + 7];
        double m33 = m[at + 8];
        double w = 1 + m11 + m22 + m33;
        double x = 1 + m11 - m22 - m33;
        double y = 1 - m11 + m22 - m33;
        double z = 1 - m11 - m22 + m33;
        double greatest = Math.max(Math.max(w, x), Math.max(y, z));
        if (greatest == w) {
            set(q, to, w, m32 - m23, m13 - m31, m21 - m12);
        } else if (greatest == x) {
            set(q, to, m32 - m23, x, m12 + m21, m13 + m31);
        } else if (greatest == y) {
            set(q, to, m13 - m31, m12 + m21, y, m23 + m32);
        } else {
            set(q, to, m21 - m12, m13 + m31, m23 + m32, z);
        }
    }

    private static void set(double[] q, int to, double w, double x, double y, double z) {
        double norm = Math.copySign(Math.sqrt(w * w + x * x + y * y + z * z), w);
        q[to] = w / norm;
        q[to + 1] = x / norm;
        q[to + 2] = y / norm;
        q[to + 3] = z / norm;
    }
}
