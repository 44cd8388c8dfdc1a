package wbv.control;

/** What a seat's sensors say at one instant; NaN is lost. One object is filled anew for every step. */
public final class SeatReadings {

    private double floor = Double.NaN;
    private double frame = Double.NaN;
    private double deflection = Double.NaN;
    private double spring = Double.NaN;
    private double trunk = Double.NaN;

    /** No reading yet. */
    public SeatReadings() {}

    /**
     * A new instant.
     *
     * @param floorAcceleration upwards, without gravity [m/s²]
     * @param frameAcceleration of what the suspension carries, likewise [m/s²]
     * @param frameDeflection place of the frame over the floor, from the middle of the stroke, upwards [m]
     * @param springForce of the suspension's spring on the frame, its preload with it [N]
     * @param trunkAcceleration of a sensor that the sitter wears [m/s²]
     */
    public void set(double floorAcceleration, double frameAcceleration, double frameDeflection, double springForce,
            double trunkAcceleration) {
        floor = floorAcceleration;
        frame = frameAcceleration;
        deflection = frameDeflection;
        spring = springForce;
        trunk = trunkAcceleration;
    }

    /** Acceleration of the floor [m/s²]. */
    public double floor() {
        return floor;
    }

    /** Acceleration of the frame [m/s²]. */
    public double frame() {
        return frame;
    }

    /** Deflection of the suspension [m]. */
    public double deflection() {
        return deflection;
    }

    /** Force of the suspension's spring [N]. */
    public double spring() {
        return spring;
    }

    /** Acceleration of the sitter's trunk [m/s²]. */
    public double trunk() {
        return trunk;
    }
}
