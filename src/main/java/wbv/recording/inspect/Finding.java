package wbv.recording.inspect;

import java.util.List;
import java.util.Locale;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/**
 * Something about a recording that its user has to know. Closed, so that no report can forget one. Counts are of the whole
 * recording; lines are of the file, counted from 1.
 */
public sealed interface Finding {

    /** How much depends on it: what comes first in a report. */
    Severity severity();

    /** One line: where, what, how many. */
    String message();

    /** One line: what to do about it, or what was done. */
    String advice();

    /**
     * Holes in the times.
     *
     * @param count   holes
     * @param missing samples that fall into them
     * @param longest the longest hole [s]
     * @param time    of the row before the longest [s]
     * @param line    of that row
     */
    record Gap(long count, long missing, double longest, double time, long line) implements Finding {
        @Override
        public Severity severity() {
            return Severity.WARNING;
        }

        @Override
        public String message() {
            return text("%s in the times, %s missing; the longest is %.3g s at t = %.6g s%s",
                    some(count, "gap"), some(missing, "sample"), longest, time, in(line));
        }

        @Override
        public String advice() {
            return "missing samples stay missing; nothing is made up for them";
        }
    }

    /**
     * Packets that the sensor counted but the file lacks.
     *
     * @param count   holes
     * @param missing packets that fall into them
     * @param share   of all samples, 0 to 1
     * @param longest the longest hole [s]
     * @param time    of the row before the longest [s]
     * @param line    of that row
     */
    record DroppedPackets(long count, long missing, double share, double longest, double time, long line) implements Finding {
        @Override
        public Severity severity() {
            return Severity.WARNING;
        }

        @Override
        public String message() {
            return text("%s lost in %s (%.2g %% of all); the longest hole is %.3g s at t = %.6g s%s",
                    some(missing, "packet"), some(count, "hole"), 100 * share, longest, time, in(line));
        }

        @Override
        public String advice() {
            return "lost packets stay missing; a nearer receiver or recording inside the sensor avoids them";
        }
    }

    /**
     * Times that are not evenly spaced.
     *
     * @param rms          departure [s]
     * @param step         between samples [s]
     * @param interpolated true if it is so much that samples have to be interpolated
     */
    record Jitter(double rms, double step, boolean interpolated) implements Finding {
        @Override
        public Severity severity() {
            return interpolated ? Severity.WARNING : Severity.NOTE;
        }

        @Override
        public String message() {
            return text("the times jitter by %.3g ms rms, %.2g %% of the step", 1e3 * rms, 100 * rms / step);
        }

        @Override
        public String advice() {
            return interpolated ? "samples are interpolated to even times; use the sensor's own clock if it has one"
                    : "small enough to take the rows as evenly spaced";
        }
    }

    /**
     * The measured rate departs from the nominal one.
     *
     * @param nominal [Hz]
     * @param measured [Hz]
     */
    record Drift(double nominal, double measured) implements Finding {
        /** Departure as a ratio, in parts per million. */
        public double ppm() {
            return 1e6 * (measured / nominal - 1);
        }

        @Override
        public Severity severity() {
            return Math.abs(ppm()) < 5000 ? Severity.NOTE : Severity.WARNING;
        }

        @Override
        public String message() {
            return text("the clock runs at %.8g Hz by the times, %.8g Hz is stated: %+.3g ppm", measured, nominal, ppm());
        }

        @Override
        public String advice() {
            return severity() == Severity.NOTE ? "usual for a quartz" : "the times were believed; correct the stated rate";
        }
    }

    /** Rows that repeat a time. */
    record DuplicateTimes(long count, long line) implements Finding {
        @Override
        public Severity severity() {
            return Severity.WARNING;
        }

        @Override
        public String message() {
            return text("%s repeat the time of the row before%s", some(count, "row"), first(line));
        }

        @Override
        public String advice() {
            return "the first row of each time is used";
        }
    }

    /**
     * Rows whose time lies before the row above them, or beyond the rows below.
     *
     * @param time [s] of the first
     */
    record TimeBackwards(long count, long line, double time) implements Finding {
        @Override
        public Severity severity() {
            return Severity.WARNING;
        }

        @Override
        public String message() {
            return text("time is out of order in %s, first with t = %.6g s%s", some(count, "row"), time, in(line));
        }

        @Override
        public String advice() {
            return "these rows are left out";
        }
    }

    /**
     * The rows do not lie on one clock: it starts again, two take turns, or the rate changes.
     *
     * @param time where [s]
     * @param how which of them
     */
    record TwoClocks(long line, double time, String how) implements Finding {
        @Override
        public Severity severity() {
            return Severity.FAULT;
        }

        @Override
        public String message() {
            return text("two clocks: at t = %.6g s%s %s", time, in(line), how);
        }

        @Override
        public String advice() {
            return "split the file at that line, or export each sensor by itself";
        }
    }

    /**
     * Cells without a number.
     *
     * @param channels of one location that lack as many samples
     * @param missing samples that each lacks
     */
    record Missing(List<Channel> channels, long missing, long rows) implements Finding {
        @Override
        public Severity severity() {
            return missing == rows ? Severity.FAULT : missing > rows / 20 ? Severity.WARNING : Severity.NOTE;
        }

        @Override
        public String message() {
            String who = channels.size() == 1 ? channels.get(0).toString() : channels.size() + " channels of " + channels.get(0).location();
            return missing == rows ? who + (channels.size() == 1 ? " holds" : " hold") + " no number at all"
                    : text("%s %s %s of %d", who, channels.size() == 1 ? "lacks" : "lack", some(missing, "sample"), rows);
        }

        @Override
        public String advice() {
            return missing == rows ? "leave " + (channels.size() == 1 ? "the channel" : "them") + " out" : "they stay missing";
        }
    }

    /**
     * A channel that does not move.
     *
     * @param value where it stands, in the channel's unit
     * @param longest samples in the longest run of one value, from a line on
     */
    record Stuck(Channel channel, double value, long longest, long line, long rows) implements Finding {
        @Override
        public Severity severity() {
            return Severity.WARNING;
        }

        @Override
        public String message() {
            return longest >= rows ? text("%s is %s throughout", channel, plain(value))
                    : text("%s stands still at %s for %s%s", channel, plain(value), some(longest, "sample"), first(line));
        }

        @Override
        public String advice() {
            return longest >= rows ? "nothing was measured there, or the axis was not recorded"
                    : "check the sensor and its cable";
        }
    }

    /**
     * Rows in which all channels of a location are exactly zero: a sensor that gave nothing.
     *
     * @param leading true if they stand at the beginning only
     */
    record ZeroRows(String location, long count, long line, boolean leading) implements Finding {
        @Override
        public Severity severity() {
            return leading ? Severity.NOTE : Severity.WARNING;
        }

        @Override
        public String message() {
            return text("all channels of %s are exactly zero in %s%s", location, some(count, "row"), first(line));
        }

        @Override
        public String advice() {
            return leading ? "at rest, or the sensor started late"
                    : "the sensor gave no reading there; treat these rows as missing";
        }
    }

    /** Rows of zeros before the first sample, which the sensor's clock knows nothing of. */
    record PassedOver(long count) implements Finding {
        @Override
        public Severity severity() {
            return Severity.NOTE;
        }

        @Override
        public String message() {
            return text("%s of zeros, the time too, before the first sample: passed over", some(count, "row"));
        }

        @Override
        public String advice() {
            return "a DOT sends one before it measures";
        }
    }

    /**
     * A channel that stays at its greatest or least value again and again.
     *
     * @param value in the channel's unit
     */
    record Clipped(Channel channel, double value, long count, long line) implements Finding {
        @Override
        public Severity severity() {
            return Severity.WARNING;
        }

        @Override
        public String message() {
            return text("%s stays at its extreme value %.6g for %s%s", channel, value, some(count, "sample"), first(line));
        }

        @Override
        public String advice() {
            return "the sensor's range was too small; choose a greater one";
        }
    }

    /**
     * Gravity where it should be gone.
     *
     * @param magnitude of the median vector [m/s²]
     */
    record GravityLeftIn(String location, double magnitude) implements Finding {
        @Override
        public Severity severity() {
            return Severity.WARNING;
        }

        @Override
        public String message() {
            return text("%s.acc has a standing %.3g m/s²: gravity was left in", location, magnitude);
        }

        @Override
        public String advice() {
            return "spectra and models take the mean out; name the columns accg if tilt matters";
        }
    }

    /**
     * No gravity where it should be.
     *
     * @param magnitude of what stands there instead [m/s²]
     */
    record GravityMissing(String location, double magnitude) implements Finding {
        @Override
        public Severity severity() {
            return Severity.WARNING;
        }

        @Override
        public String message() {
            return text("%s.accg stands at %.3g m/s² only: gravity was removed already", location, magnitude);
        }

        @Override
        public String advice() {
            return "name the columns acc";
        }
    }

    /**
     * A standing value that is neither nothing nor gravity: a sensor that is broken or out of calibration.
     *
     * @param x its median, in the quantity's unit
     * @param y likewise
     * @param z likewise
     * @param magnitude of all three, in that unit
     */
    record GrossBias(String location, Quantity quantity, double x, double y, double z, double magnitude) implements Finding {
        @Override
        public Severity severity() {
            return Severity.WARNING;
        }

        @Override
        public String message() {
            return text("%s.%s has a gross bias: its median is (%s, %s, %s) %s, magnitude %.4g", location, quantity.symbol(),
                    axis(x), axis(y), axis(z), quantity.unit(), magnitude);
        }

        /** A median, or a dash where the axis was not measured. */
        private static String axis(double median) {
            return Double.isNaN(median) ? "–" : text("%.4g", median);
        }

        @Override
        public String advice() {
            return quantity == Quantity.ANGULAR_RATE ? "check the sensor's calibration"
                    : "neither 0 nor gravity's 9.81 m/s²: distrust this sensor, its gain included";
        }
    }

    /**
     * Values that make sense in another unit only.
     *
     * @param read as which unit
     * @param likely the unit they seem to be in
     */
    record ImplausibleUnit(String location, Quantity quantity, double value, String read, String likely) implements Finding {
        @Override
        public Severity severity() {
            return Severity.WARNING;
        }

        @Override
        public String message() {
            return text("%s.%s is about %.4g %s; that looks like %s", location, quantity.symbol(), value, read, likely);
        }

        @Override
        public String advice() {
            return "say the unit in a column map (--map)";
        }
    }

    /**
     * Single samples far from both neighbours.
     *
     * @param greatest jump, in the channel's unit
     */
    record Spikes(Channel channel, long count, double greatest, long line) implements Finding {
        @Override
        public Severity severity() {
            return Severity.WARNING;
        }

        @Override
        public String message() {
            return text("%s jumps out and back within one sample, %s, by up to %.4g %s%s", channel, some(count, "time"), greatest,
                    channel.quantity().unit(), first(line));
        }

        @Override
        public String advice() {
            return "glitches of the transmission, not motion; an estimator should reject them";
        }
    }

    /** Six digits; a whole number without a point. */
    private static String plain(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e6 ? Long.toString((long) value) : text("%.6g", value);
    }

    /** Where that is, if lines mean anything. */
    private static String in(long line) {
        return line > 0 ? " (line " + line + ")" : "";
    }

    private static String first(long line) {
        return line > 0 ? ", first at line " + line : "";
    }

    private static String some(long count, String thing) {
        return count + " " + thing + (count == 1 ? "" : "s");
    }

    private static String text(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }
}
