package wbv.recording.inspect;

import java.util.Locale;
import wbv.recording.DataFault;
import wbv.recording.Header;
import wbv.recording.Metadata;

/** Times that nobody says the unit of, and that are too slow to be seconds of any motion of a body. */
final class SuspectTimes {

    /** Rate [Hz] up to which samples show nothing of what is measured here: whole-body vibration begins at 0.5 Hz (ISO 2631-1, 1). */
    private static final double SLOW = 1;
    /** So long a recording [s] is meant to be one, and not a table of a few rows. */
    private static final double LONG = 600;
    /** Share by which a rate that is stated may miss the one that the times tell. */
    private static final double NEAR = 0.01;
    private static final double THOUSAND = 1e3;

    private SuspectTimes() {}

    /**
     * Refuses times that look to be in milliseconds or less.
     *
     * @throws DataFault that says in which unit they seem to be and how to state it
     */
    static void check(Inspection seen, Metadata metadata) {
        double rate = seen.clock().rate();
        boolean meant = metadata.units().containsKey(Header.TIME)
                || metadata.rate().isPresent() && Math.abs(metadata.rate().getAsDouble() / rate - 1) < NEAR;
        boolean several = seen.findings().stream().anyMatch(Finding.TwoClocks.class::isInstance);
        if (meant || several || rate > SLOW * (1 + NEAR) || seen.duration() < LONG) {
            return;
        }
        double step = 1 / rate;
        String unit = step < THOUSAND ? "ms" : step < THOUSAND * THOUSAND ? "us" : "ns";
        throw DataFault.in(seen.name(), String.format(Locale.ROOT, "a sample every %.4g s for %.3g h, if its times are in s: they look to "
                + "be in %3$s; name their column t_%3$s, or write \"units\": {\"t\": \"%3$s\"} in the sidecar (t_s or \"s\" if it is so "
                + "slow)", step, seen.duration() / 3600, unit));
    }
}
