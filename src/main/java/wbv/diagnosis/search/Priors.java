package wbv.diagnosis.search;

/**
 * What is believed before a recording is seen, and from when on something is said: the numbers on which the search, learning and verdicts
 * rest. How sharply fits tell is not believed but measured, see {@link Calibration}; how hard is sought decides nothing, see
 * {@link Effort}. What a force of its own looks like, and what sensors do, stands where these are read.
 */
public final class Priors {

    /** Probability from which on one name is the answer, and that the names of a set hold together [1]. */
    public static final double HELD = 0.9;
    /** Odds of the other of two names where one holds just enough [1]. */
    public static final double ODDS = (1 - HELD) / HELD;
    /** Part from which on something is most of what there is, and from which on what is likelier is more likely than not [1]. */
    public static final double MAJORITY = 0.5;
    /** Probability with which chance may seem to be an improvement [1]. */
    public static final double CHANCE = 0.001;

    /**
     * Part of a mismatch that the best of the library is supposed to leave where the right law is none of it [1]: more than any of 101
     * right names left, of which 95 left a tenth at most, and the worst 0.24.
     */
    public static final double UNLISTED = 0.28;
    /**
     * Part of its own force to which a formula that is right may be wrong, and part of a mismatch that a right name may leave [1]: right
     * families of other formulas left a tenth at most, as did 95 of 101 right names.
     */
    public static final double FORM = 0.1;
    /** Part of a mismatch from which on a mechanism explains nearly all of it, so that no other law in its place explains much more [1]. */
    public static final double NEARLY_ALL = 0.95;
    /** Part of a mismatch that what a push or two places leave scatters by: by the push's own level, by numbers that fit the noise [1]. */
    public static final double SCATTER = 0.012;

    /** Mean square of a whitened residual where noise is known in full, and what it scatters by [1]. */
    public static final double NOISE = 1.04;
    /**
     * Below this much of the noise nothing is missing that a recording could show [1]: of 107 recordings in which nothing was concealed,
     * with sensors and sitters as they are, the fits leave 1.02 with a standard deviation of 0.03 (rig) to 0.05 (road) and never more than
     * 1.13, on either window.
     */
    public static final double SILENT = 1.2;
    /** From here on a mismatch is plain, whatever the rest of the recording shows: half as much again as the noise [1]. */
    public static final double LOUD = 1.5;
    /** What is more cannot be the noise by any chance [1]. */
    public static final double STRANGE = 3;
    /** What is left of a mismatch so plain that a law could not pass for something linear, nor its form for all of what is missing [1]. */
    public static final double GLARING = 10;

    /**
     * By how much the logarithm of a stiffness or damping that a user gives is off, half of them by more [1]: assumed; the answers to 172
     * concealed recordings are as likely with 0.2 and 0.4.
     */
    public static final double NUMBER = 0.3;
    /** The same as the standard deviation of a normal error, of which half lies within 0.6745 [1]. */
    public static final double NUMBER_DEVIATION = NUMBER / 0.6745;
    /** How well a user knows a mass of the model, each on its own [1]: assumed. */
    public static final double MASS = 0.1;
    /** How likely it is that a sensor is at fault which is later than sensors scatter [1]: assumed. */
    public static final double LATE = 0.75;

    private Priors() {}
}
