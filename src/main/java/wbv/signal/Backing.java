package wbv.signal;

import org.apache.commons.math3.distribution.BinomialDistribution;

/** What stands behind a frequency response at a frequency, or what is missing there. */
public enum Backing {

    /** The input has power there, and the output follows it. */
    USABLE("usable"),

    /** The input has too little power there, against its own maximum or its own floor; or its mean has been taken out. */
    NOT_EXCITED("not excited"),

    /**
     * The input has power, but does not make the output: other motion, noise, or what is not linear does. A coherence high enough
     * is ruled out (5 %).
     */
    NOT_CAUSED("not caused by this input alone"),

    /** The coherence is low, yet what the input leaves of the output is no more than the output has where nothing is excited. */
    BELOW_NOISE("below the output's noise"),

    /** The coherence is too low to be believed, yet there are too few averages to say that it is low. */
    IN_DOUBT("too few averages to tell"),

    /** The inputs move as one there, so that their answers cannot be told apart. */
    NOT_APART("inputs move as one");

    private final String words;

    Backing(String words) {
        this.words = words;
    }

    /** What a legend says. */
    public String words() {
        return words;
    }

    /**
     * Whether frequencies are more than chance takes for such in 1 % of cases, where each is taken wrongly in 5 %. Hann's window makes
     * neighbours alike: every other one counts.
     *
     * @param found of them
     * @param asked frequencies
     */
    public static boolean isBeyondChance(long found, long asked) {
        return found / 2 > new BinomialDistribution(null, (int) Math.max(1, asked / 2), FrequencyResponse.Excited.RARE)
                .inverseCumulativeProbability(0.99);
    }

    /** Where a response may be used. */
    static boolean[] usable(Backing[] all) {
        boolean[] usable = new boolean[all.length];
        for (int k = 0; k < all.length; k++) {
            usable[k] = all[k] == USABLE;
        }
        return usable;
    }
}
