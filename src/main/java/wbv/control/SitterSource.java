package wbv.control;

/** Who sits there, as a controller shall believe it, at every sample. */
public sealed interface SitterSource permits ToldSitter, FollowedSitter {

    /**
     * One sample.
     *
     * @param readings Not modified.
     */
    void hear(SeatReadings readings);

    /** Mass that moves with the seat [kg]. */
    double rigid();

    /** Mass on the sitter's spring [kg]. */
    double moving();

    /** Natural frequency [Hz]. */
    double frequency();

    /** Damping ratio [1]. */
    double damping();
}
