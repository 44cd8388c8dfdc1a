package wbv.recording.format;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import wbv.recording.CalendarTime;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.RowReader;
import wbv.recording.SensorClock;

/**
 * Several recordings of one clock side by side, such as the files of ten sensors of one radio station: rows that fall on one
 * sample become one row, with NaN for a sensor that has none there. Joined as a stream, by the sensors' own counters or clocks
 * where they have them (wraps allowed for), by {@code t} otherwise.
 */
public final class MergedReader implements RowReader {

    private final List<RowReader> readers;
    private final List<Channel> channels = new ArrayList<>();
    private final Metadata metadata;
    private final double[] offsets;
    private final double[][] ahead;
    private final boolean[] present;
    private final double tolerance;
    private final Optional<SensorClock> clock;

    /**
     * Reads the first row of each.
     *
     * @param readers two or more, closed by this one
     * @throws DataFault if a channel stands in two of them, some have a sensor's clock and some have not, no rate is stated
     *                   or the rates differ
     */
    public MergedReader(List<RowReader> readers) throws IOException {
        if (readers.isEmpty()) {
            throw new IllegalArgumentException("there must be at least one recording to merge");
        }
        this.readers = List.copyOf(readers);
        Set<Channel> seen = new LinkedHashSet<>();
        Metadata all = Metadata.NONE;
        for (RowReader reader : readers) {
            for (Channel channel : reader.channels()) {
                if (!seen.add(channel)) {
                    throw new DataFault(channel + " stands in two of the recordings to join; give each sensor its own location, "
                            + "or, where it is another ride with the same sensors, diagnose it with --with");
                }
            }
            all = all.orElse(reader.metadata());
        }
        this.channels.addAll(seen);
        this.metadata = all;
        this.tolerance = 0.5 / rate();
        this.offsets = offsets();
        double least = Arrays.stream(offsets).min().orElse(0);
        boolean counted = readers.get(0).sensorClock().isPresent();
        this.clock = readers.get(0).sensorClock().map(first -> new SensorClock(first.origin() + least, first.period()));
        for (int i = 0; i < offsets.length; i++) {
            offsets[i] -= counted ? least : 0;
        }
        this.ahead = new double[readers.size()][];
        this.present = new boolean[readers.size()];
        for (int i = 0; i < ahead.length; i++) {
            ahead[i] = new double[1 + readers.get(i).channels().size()];
            advance(i);
        }
        laidByDate();
    }

    /** Rows that are dated count from the first of each file: the dates say how far these are apart. */
    private void laidByDate() {
        List<CalendarTime> dates = readers.stream().flatMap(reader -> reader.origin().stream()).toList();
        if (!dates.isEmpty() && dates.size() < readers.size()) {
            throw new DataFault("recordings timed by dates and by numbers share no clock and cannot be joined");
        }
        if (dates.stream().map(CalendarTime::zoned).distinct().count() > 1) {
            throw new DataFault("recordings dated with a time zone and without one may be hours apart and cannot be joined; give all of "
                    + "them a zone, such as Z or +01:00, or none");
        }
        double least = dates.stream().mapToDouble(CalendarTime::seconds).min().orElse(0);
        for (int i = 0; i < dates.size(); i++) {
            double later = dates.get(i).seconds() - least;
            offsets[i] += later;
            ahead[i][0] += later;
        }
    }

    private double rate() {
        double rate = Double.NaN;
        for (RowReader reader : readers) {
            double one = reader.metadata().rate().orElse(Double.NaN);
            if (Math.abs(one / rate - 1) > 0.01) {
                throw new DataFault("recordings of " + rate + " and " + one
                        + " Hz cannot be joined row by row; resample one of them");
            }
            rate = Double.isNaN(rate) ? one : rate;
        }
        if (Double.isNaN(rate)) {
            throw new DataFault("none of the recordings to join states its rate; say it in Hz with --rate");
        }
        return rate;
    }

    /** What to add to each reader's times to bring it to the first one's. */
    private double[] offsets() {
        double[] shifts = new double[readers.size()];
        Optional<SensorClock> first = readers.get(0).sensorClock();
        for (int i = 1; i < shifts.length; i++) {
            Optional<SensorClock> other = readers.get(i).sensorClock();
            if (other.isPresent() != first.isPresent()) {
                throw new DataFault("recordings timed by a sensor's counter and by t share no clock and cannot be joined");
            }
            if (first.isPresent()) {
                double shift = other.get().origin() - first.get().origin();
                double period = first.get().period();
                shifts[i] = Double.isInfinite(period) ? shift : shift - period * Math.rint(shift / period);
            }
        }
        return shifts;
    }

    private void advance(int i) throws IOException {
        present[i] = readers.get(i).read(ahead[i]);
        ahead[i][0] += offsets[i];
    }

    @Override
    public List<Channel> channels() {
        return List.copyOf(channels);
    }

    @Override
    public Metadata metadata() {
        return metadata;
    }

    @Override
    public boolean read(double[] row) throws IOException {
        double time = Double.POSITIVE_INFINITY;
        for (int i = 0; i < ahead.length; i++) {
            time = present[i] ? Math.min(time, ahead[i][0]) : time;
        }
        if (time == Double.POSITIVE_INFINITY) {
            return false;
        }
        row[0] = time;
        int at = 1;
        for (int i = 0; i < ahead.length; i++) {
            int width = ahead[i].length - 1;
            if (present[i] && ahead[i][0] - time < tolerance) {
                System.arraycopy(ahead[i], 1, row, at, width);
                advance(i);
            } else {
                Arrays.fill(row, at, at + width, Double.NaN);
            }
            at += width;
        }
        return true;
    }

    @Override
    public long line() {
        return 0;
    }

    @Override
    public double fractionRead() {
        return readers.stream().mapToDouble(RowReader::fractionRead).min().orElse(Double.NaN);
    }

    @Override
    public long passedOver() {
        return readers.stream().mapToLong(RowReader::passedOver).sum();
    }

    @Override
    public Optional<SensorClock> sensorClock() {
        return clock;
    }

    @Override
    public void close() throws IOException {
        IOException failed = null;
        for (RowReader reader : readers) {
            try {
                reader.close();
            } catch (IOException again) {
                failed = again;
            }
        }
        if (failed != null) {
            throw failed;
        }
    }
}
