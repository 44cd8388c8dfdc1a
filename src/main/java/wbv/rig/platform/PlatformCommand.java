package wbv.rig.platform;

/** An excitation in motion: the command of the platform, sample after sample at the inner rate. */
public interface PlatformCommand {

    /**
     * Adds the command of the next inner sample, times a gain.
     *
     * @param gain a factor
     * @param command by axis in {@link Axis} order, six long [m/s² or rad/s]. Modified.
     */
    void next(double gain, double[] command);

    /** What is being done to the sitter at the last sample. */
    default Episode episode() {
        return Episode.RIDING;
    }

    /** Whether a jolt acts at the last sample, or the sitter still rings from one. */
    default boolean jolting() {
        return false;
    }
}
