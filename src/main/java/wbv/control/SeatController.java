package wbv.control;

/**
 * What moves a seat's damper or actuator. The contract of every controller: {@link #step} allocates nothing, takes NaN for a lost
 * reading, and never asks for more than its {@link SeatHardware} can do.
 */
public sealed interface SeatController permits PassiveSeat, SkyhookSeat, OptimalSeat {

    /** Samples a second that every controller is made for [Hz]. */
    double RATE = 250;
    /** Time between two samples [s]. */
    double STEP = 1 / RATE;

    /**
     * One sample.
     *
     * @param readings Not modified.
     * @param command Modified.
     */
    void step(SeatReadings readings, SeatCommand command);
}
