package wbv.rig.concealed;

/**
 * One coordinate along or about which a spring and a dashpot work, and how it moves while they are linear.
 *
 * @param k stiffness, 0 for a body that nothing holds [N/m or N m/rad]
 * @param c damping
 * @param travel root mean square [m or rad]
 * @param speed of that
 * @param force root mean square of what the spring and the dashpot carry, or of what pushes where nothing holds [N or N m]
 * @param turns whether it is an angle
 * @param seconds of the recording
 */
record Coordinate(double k, double c, double travel, double speed, double force, boolean turns, double seconds) {

    /** Of a sine of as much travel and speed [s]. */
    double period() {
        return 2 * Math.PI * travel / speed;
    }

    /** The stiffness by which laws are sized: its own, or what would carry the force. */
    double scale() {
        return k > 0 ? k : force / travel;
    }

    /** The damping by which laws are sized. */
    double drag() {
        return k > 0 && c > 0 ? c : force / speed;
    }

    String newtons() {
        return turns ? "Nm" : "N";
    }

    String metres() {
        return turns ? "rad" : "m";
    }
}
