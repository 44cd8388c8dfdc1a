package wbv.rig;

/** A rotation written as a rotation vector; it turns vectors of the world into the axes of a sensor. */
final class RotationVector {

    private final double[] axis = new double[3];
    private double sine;
    private double cosine = 1;

    /**
     * Sets the sensor's rotation against the world.
     *
     * @param x
     * @param y
     * @param z rotation vector [rad]
     */
    void set(double x, double y, double z) {
        double angle = Math.sqrt(x * x + y * y + z * z);
        sine = StrictMath.sin(angle);
        cosine = StrictMath.cos(angle);
        double scale = angle == 0 ? 0 : 1 / angle;
        axis[0] = x * scale;
        axis[1] = y * scale;
        axis[2] = z * scale;
    }

    /**
     * v cos - (n × v) sin + n (n·v)(1 - cos): Rodrigues' formula for the inverse rotation.
     *
     * @param v in the world's axes. Not modified.
     * @param into in the sensor's. Modified.
     */
    void turn(double[] v, double[] into) {
        double dot = axis[0] * v[0] + axis[1] * v[1] + axis[2] * v[2];
        for (int i = 0; i < 3; i++) {
            int j = (i + 1) % 3;
            int k = (i + 2) % 3;
            double cross = axis[j] * v[k] - axis[k] * v[j];
            into[i] = v[i] * cosine - cross * sine + axis[i] * dot * (1 - cosine);
        }
    }
}
