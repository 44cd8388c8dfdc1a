package wbv.diagnosis.search;

/**
 * How hard is sought: what is tried, how far it is fitted, and what is given up on the way. With more of it the search takes longer and
 * finds what it finds or something likelier; it says nothing of what is said then, see {@link Priors}.
 */
public final class Effort {

    /** Fits that are polished, of those that lead. */
    public static final int LEADERS = 3;
    /** Fits that go the whole way, of those that were begun. */
    public static final int FINALISTS = 6;
    /** Fits that go on after the first steps. */
    public static final int CONTENDERS = 16;
    /** Linear hypotheses that are refitted, of those that were screened. */
    public static final int LINEAR = 12;
    /** Laws that are refitted, of those that were screened. */
    public static final int LAWS = 10;
    /** Of how many of the likeliest, be they places, links, mechanisms or starts, more is asked. */
    public static final int SECONDS = 2;
    /** Of how many places more is asked than how well they explain a mismatch. */
    public static final int PLACES = 4;
    /** Links so few that each of them is looked at for every kind of law. */
    public static final int FEW = 3;
    /** Starts of a hypothesis: where it has more, only the one that was screened is begun. */
    public static final int STARTS = 10;
    /** Times that too large a step is halved, or what has a moment is moved and fitted again. */
    public static final int TRIES = 4;
    /** Terms of a law that is learned. */
    public static final int TERMS = 4;
    /** Terms to which others are added. */
    public static final int FIRST_TERMS = 8;
    /** Terms that may stand beside another. */
    public static final int NEXT_TERMS = 160;
    /** Numbers that are kept of what these do: a quarter of a gigabyte, which two minutes of a sitter do not fill. */
    public static final int NUMBERS = 1 << 25;
    /**
     * Terms that are begun where the model went far to make up for the law, where the first order tells little: of five laws made by
     * another place the right one came second to 125th along the motion as measured, and of the three that were begun among the first five
     * after three steps of its free run.
     */
    public static final int BEGUN_TERMS = 64;
    /** Of terms that are begun one in so many is fitted on. */
    public static final int ONE_IN = 4;

    /** How many times what the best leaves beyond the noise another may leave and be as good. */
    public static final double ALIKE = 2;
    /** The same, and may come to be as good. */
    public static final double BEHIND = 4;
    /** The same, and is not given up yet. */
    public static final double HOPELESS = 10;

    /** Steps of a fit after which it shows whether it leads anywhere. */
    public static final int FIRST_STEPS = 4;
    /** Steps of a fit in a heat, once it is among those that may win. */
    public static final int HEAT_STEPS = 8;
    /** Steps of a finalist in the whitening of what it stands on. */
    public static final int FINAL_STEPS = 6;
    /** Steps of a fit that is to be compared. */
    public static final int STEPS = 10;
    /** Steps of a fit from numbers that were not fitted to these data, before it is seen through its own noise. */
    public static final int OWN_STEPS = 12;
    /** Steps of a leader, seen through its own noise, before that is read again. */
    public static final int POLISHING_STEPS = 15;
    /** Steps of a fit that goes the whole way at once. */
    public static final int LAST_STEPS = 25;
    /** Relative gain of a step below which a fit ends in a heat [1]. */
    public static final double ROUGH = 2e-3;
    /** The same of one that is to be compared [1]. */
    public static final double ENOUGH = 1e-3;
    /** The same of a leader [1]. */
    public static final double FINE = 3e-4;
    /** The same of the model alone, against which all are held [1]. */
    public static final double EXACT = 1e-4;
    /**
     * By how much less likely a fit may be than the likeliest to be of no account, whatever else speaks for it [nat]: a hundred such take
     * less from a probability than the digits that are told.
     */
    public static final double NEGLIGIBLE = 15;
    /** Times that a fit and what counts as noise beside it are read again from each other. */
    public static final int ROUNDS = 3;
    /** Stretches of a recording of which each is looked at by itself, to see how something scatters (Schmeiser 1982: ten to thirty). */
    public static final int STRETCHES = 12;
    /** Times as strong as it was looked at, either way, that what has no amplitude may seem to be and is still tried as it is [1]. */
    public static final double NEAR_ONE = 20;
    /** Part of a number by which it is moved to see what that does [1]. */
    public static final double DIFFERENCE = 1e-3;

    private Effort() {}
}
