package wbv.sensing;

/** Gravity in the world's axes, z up: what an accelerometer at rest reads is its reverse. */
final class Gravity {

    /** Standard acceleration of free fall [m/s²]. */
    static final double STANDARD = 9.80665;

    private Gravity() {}

    /**
     * Free acceleration in the world from the specific force that a sensor reads: {@code R f - (0, 0, g)} (thesis Eq. 2-31, 2-32
     * as
     * they must read).
     *
     * @param specific in the sensor's axes [m/s²]. Not modified.
     * @param out Modified.
     */
    static void removeInWorld(Orientation sensor, double[] specific, double[] out) {
        sensor.outward(specific, out);
        out[2] -= STANDARD;
    }
}
