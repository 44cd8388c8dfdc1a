package wbv.exposure;

import java.util.function.DoubleConsumer;

/**
 * Puts a frequency weighting on samples as they come and gives the weighted values on, at a higher rate, so that fourth powers
 * are not lost, and peaks between two samples. Every sample becomes {@link #factor()} values; those of a sample that is missing,
 * and too long missing to be bridged, are NaN. Values come late; {@link #finish} gives the last of them.
 */
public sealed interface Weigher permits ExactWeigher, StreamWeigher {

    /** Missing samples in a row that are bridged by a cubic [s]. */
    double LONGEST_BRIDGE = 0.05;

    /** Takes weighted values in order, NaN where one is missing. */
    interface Sink extends DoubleConsumer {

        /** Amount from which a value between two may matter, in the values' unit. */
        default double leastBetween() {
            return Double.POSITIVE_INFINITY;
        }

        /**
         * Hears a value between the last ones. It is one more look at the signal, not more of it.
         *
         * @param value in the values' unit
         */
        default void between(double value) {}
    }

    /**
     * Takes the next sample; NaN is missing.
     *
     * @param value [m/s²], or [rad/s] of what turns
     */
    void accept(double value);

    /** Ends the stream. Feed nothing afterwards. */
    void finish();

    /** Weighted values for a sample. */
    int factor();

    /** Samples in a row that are bridged at a rate [Hz]. */
    static int longestBridge(double rate) {
        return Math.max(1, (int) Math.round(LONGEST_BRIDGE * rate));
    }
}
