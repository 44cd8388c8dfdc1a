package wbv.recording.inspect;

import java.util.Optional;

/** Counts holes in the times and keeps the longest. */
final class Holes {

    private long count;
    private long missing;
    private double longest;
    private double time;
    private long line;

    /**
     * A hole.
     *
     * @param samples that fall into it
     * @param length of it [s]
     * @param before time of the row before it
     * @param atLine its line
     */
    void met(long samples, double length, double before, long atLine) {
        count++;
        missing += samples;
        if (length > longest) {
            longest = length;
            time = before;
            line = atLine;
        }
    }

    /**
     * What is missing, if anything is.
     *
     * @param samples all there should be
     * @param counted true if a sensor counted them
     */
    Optional<Finding> finding(long samples, boolean counted) {
        if (count == 0) {
            return Optional.empty();
        }
        return Optional.of(counted ? new Finding.DroppedPackets(count, missing, (double) missing / samples, longest, time, line)
                : new Finding.Gap(count, missing, longest, time, line));
    }
}
