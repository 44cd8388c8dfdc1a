package wbv.recording.inspect;

import java.util.Arrays;
import java.util.OptionalDouble;

/**
 * The even clock of rows that come one by one from a stream without an end. It learns the rate from the first rows, then says of
 * each which sample it is: a slow phase-locked loop ({@link Tracker}) follows, so that neither drift nor rounded times are taken for
 * gaps. A sensor that starts again, its times with it, is followed from there on.
 */
public final class RowClock {

    /** What became of a row. */
    public enum Placed {
        /** It is the next sample, or a later one after samples that are missing. */
        NEXT,
        /** It falls on a sample that was given, or repeats a time. */
        REPEATED,
        /** It lies before a row that was given. */
        LATE,
        /** The clock began again, or leapt so far that nothing is known of the time between; this row is the first of the new one. */
        RESTARTED
    }

    /** Rows from which the rate is learned, and where their times jitter. */
    public static final int FIRST = 64;
    private static final int FIRST_OF_JITTER = 512;
    /** A leap after which nothing before matters any more [s]: eight periods of 0.4 Hz, that weightings reach down to. */
    private static final double LEAP = 20;
    /** Rows in a row that lie behind, in order among themselves, from which on the clock began again. */
    private static final int BEHIND = 3;
    /** Rows that lie behind by less may have been sent again, after a connection was lost [s]. */
    private static final double RESENT = 10;

    private final OptionalDouble nominal;
    private final double[] early = new double[FIRST_OF_JITTER];
    private int held;
    private Timing look;
    private Tracker tracker;
    private double rate = Double.NaN;
    private double last = Double.NaN;
    private double behind = Double.NaN;
    private int rowsBehind;
    private long missing;
    private double first;
    private long samples;

    /**
     * Learns the rate from the first rows, {@link #FIRST} or more.
     *
     * @param nominal the rate, where it is known [Hz]
     */
    public RowClock(OptionalDouble nominal) {
        this.nominal = nominal;
    }

    /**
     * A clock that goes on where another was.
     *
     * @param rate its own [Hz]
     * @param last time of the last sample [s]; NaN where there was none
     */
    public static RowClock resumed(double rate, double last) {
        RowClock clock = new RowClock(OptionalDouble.of(rate));
        clock.look = new Timing(Double.isNaN(last) ? 0 : last, 1 / rate, 0, 0, 0, false);
        clock.tracker = new Tracker(clock.look);
        clock.rate = rate;
        if (!Double.isNaN(last)) {
            clock.placed(last, true);
        }
        return clock;
    }

    /**
     * Takes the time of one of the first rows [s].
     *
     * @return true once the rate is known: now {@link #place} takes the same times again, and all that follow
     */
    public boolean learn(double time) {
        if (held > 0 && time <= early[held - 1]) {
            if (early[held - 1] - time > 1) {
                held = 0; // began again while its rate was being learned
            } else {
                return false;
            }
        }
        early[held++] = time;
        if (held < FIRST) {
            return false;
        }
        Timing seen = new FirstLook(Arrays.copyOf(early, held)).timing(nominal);
        if (seen.blur() > 0 && held < FIRST_OF_JITTER && nominal.isEmpty()) {
            return false;
        }
        begin(seen);
        return true;
    }

    /**
     * The stream ended: learns from what there is.
     *
     * @return false if that is fewer than two rows
     */
    public boolean learnNow() {
        if (tracker == null && held > 1) {
            begin(new FirstLook(Arrays.copyOf(early, held)).timing(nominal));
        }
        return tracker != null;
    }

    private void begin(Timing seen) {
        look = seen;
        tracker = new Tracker(seen);
        double measured = 1 / seen.step();
        double whole = Math.rint(measured);
        double slip = Math.abs(whole / measured - 1) * held;
        double written = Math.max(seen.blur(), resolution()) / seen.step();
        rate = nominal.isPresent() ? nominal.getAsDouble() : whole > 0 && slip < 0.02 + written / 2 ? whole : measured;
    }

    /** The coarsest that the first times are written to [s]. */
    private double resolution() {
        Resolution written = new Resolution();
        for (int i = 0; i < held; i++) {
            written.of(early[i]);
        }
        return Tracker.error(written.coarsest(), look.step());
    }

    /** Samples a second [Hz]; NaN until they are known. */
    public double rate() {
        return rate;
    }

    /** By how much single times are off by the first look, earliest to latest [s]; 0 but for real jitter. */
    public double jitter() {
        return look.blur();
    }

    /** The rate that the rows keep since the clock began [Hz]; NaN before there is a second of them. */
    public double measured() {
        return samples > rate ? samples / (last - first) : Double.NaN;
    }

    /**
     * Places a row; the rate is known.
     *
     * @param time its own [s]
     */
    public Placed place(double time) {
        missing = 0;
        if (Double.isNaN(last)) {
            return placed(time, true);
        }
        if (time < last) {
            rowsBehind = time > behind ? rowsBehind + 1 : 1;
            behind = time;
            boolean again = rowsBehind >= BEHIND && (last - time > RESENT || rowsBehind > RESENT * rate);
            return again ? restarted(time) : Placed.LATE;
        }
        rowsBehind = 0;
        behind = Double.NaN;
        if (time - last > LEAP) {
            return restarted(time);
        }
        long advance = tracker.place(time);
        if (advance == Tracker.REPEATED) {
            return Placed.REPEATED;
        }
        missing = advance - 1;
        samples += advance;
        last = time;
        return Placed.NEXT;
    }

    private Placed restarted(double time) {
        tracker = new Tracker(new Timing(time, look.step(), look.blur(), 0, 0, false));
        placed(time, false);
        return Placed.RESTARTED;
    }

    private Placed placed(double time, boolean begins) {
        tracker.place(time);
        first = time;
        samples = 0;
        last = time;
        rowsBehind = 0;
        behind = Double.NaN;
        return begins ? Placed.NEXT : Placed.RESTARTED;
    }

    /** Samples that are missing between the row before and the one that was placed last. */
    public long missing() {
        return missing;
    }
}
