package wbv.diagnosis.surrogate;

import java.util.Locale;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.Recording;

/**
 * The samples that a recording and a simulation on its clock have in common.
 *
 * @param first   sample of the recording
 * @param skipped samples of the simulation before it
 * @param length  in samples
 */
record Overlap(int first, int skipped, int length) {

    /** By how much of a sample the two clocks may be apart, and may come apart over the recording. */
    private static final double APART = 0.1;
    private static final double DRIFT = 0.5;

    Overlap {
        if (first < 0 || skipped < 0 || length <= 0) {
            throw new IllegalArgumentException("an overlap lies in both: " + first + ", " + skipped + ", " + length);
        }
    }

    /**
     * Of a recording and a simulation.
     *
     * @param name what messages call the simulation
     * @throws DataFault if the clocks differ or the two have no time in common
     */
    static Overlap of(Recording recording, Recording simulation, String name) {
        Clock clock = recording.clock();
        Clock other = simulation.clock();
        double shift = (other.start() - clock.start()) * clock.rate();
        double drift = (other.rate() / clock.rate() - 1) * Math.min(recording.length(), simulation.length());
        if (Math.abs(shift - Math.rint(shift)) > APART || Math.abs(drift) > DRIFT) {
            throw DataFault.in(name, String.format(Locale.ROOT, "is not on the recording's clock: it begins at %.6g s with %.8g Hz, "
                    + "the recording at %.6g s with %.8g Hz; save it at the recording's times", other.start(), other.rate(), clock.start(),
                    clock.rate()));
        }
        int first = (int) Math.max(0, Math.rint(shift));
        int skipped = first - (int) Math.rint(shift);
        int length = Math.min(recording.length() - first, simulation.length() - skipped);
        if (length <= 0) {
            throw DataFault.in(name, "ends before the recording begins, or begins after it ends");
        }
        return new Overlap(first, skipped, length);
    }

    /** The part of the recording; itself where that is all of it. */
    Recording ofRecording(Recording recording) {
        return length == recording.length() ? recording : recording.part(first, first + length);
    }

    /** The part of the simulation, on its own clock; itself where that is all of it. */
    Recording ofSimulation(Recording simulation) {
        return length == simulation.length() ? simulation : simulation.part(skipped, skipped + length);
    }
}
