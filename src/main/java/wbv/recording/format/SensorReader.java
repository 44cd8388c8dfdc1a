package wbv.recording.format;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.RowReader;
import wbv.recording.SensorClock;

/** An export of one sensor: times from its own counter, which wraps; the rotation matrix as a quaternion. */
final class SensorReader implements RowReader {

    private static final double WORD = 4_294_967_296.0;

    private final DelimitedTable table;
    private final SensorColumns columns;
    private final Metadata metadata;
    private final double ticksPerSecond;
    private final double modulus;
    private final double[] raw;
    private final boolean passedOver;
    private Optional<double[]> ahead = Optional.empty();
    private final boolean some;
    private boolean held;
    private final double first;
    private double last;
    private double ticks;

    /**
     * Reads the first row, for what its counter says. A first row that is all zeros, its counter too, is passed over where the next one is
     * out of step with it: a DOT may send one before its first sample.
     *
     * @param ticksPerSecond what the counter counts [Hz]
     * @param modulus        at what it begins again; a 16 bit counter that goes beyond 65535 is taken for one of 32 bit
     * @param longest        step from one row to the next in ticks, beyond which a first row of zeros is out of step; infinite where it is
     *                       always a sample
     */
    SensorReader(DelimitedTable table, SensorColumns columns, Metadata metadata, double ticksPerSecond, double modulus, double longest)
            throws IOException {
        this.table = table;
        this.columns = columns;
        this.metadata = metadata.withUnits(NamedColumns.known(columns.channels()));
        this.ticksPerSecond = ticksPerSecond;
        this.modulus = modulus;
        this.raw = new double[columns.width()];
        boolean read = table.read(raw);
        double[] next = new double[raw.length];
        if (read && blank() && table.read(next)) {
            ahead = Optional.of(next);
        }
        this.passedOver = Math.abs(next[0]) > longest;
        if (passedOver) {
            takeAhead();
        }
        this.some = read;
        this.held = read;
        this.first = read ? raw[0] : 0;
        this.last = first;
        if (Double.isNaN(first)) {
            throw noCount();
        }
    }

    private boolean blank() {
        for (double value : raw) {
            if (value != 0) {
                return false;
            }
        }
        return true;
    }

    private void takeAhead() {
        System.arraycopy(ahead.orElseThrow(), 0, raw, 0, raw.length);
        ahead = Optional.empty();
    }

    private DataFault noCount() {
        return table.fault("the row has no packet counter or sample time; export it with one");
    }

    @Override
    public List<Channel> channels() {
        return columns.channels();
    }

    @Override
    public Metadata metadata() {
        return metadata;
    }

    @Override
    public long passedOver() {
        return passedOver ? 1 : 0;
    }

    @Override
    public Optional<SensorClock> sensorClock() {
        return Optional.of(new SensorClock(some ? first / ticksPerSecond : 0, modulus / ticksPerSecond));
    }

    @Override
    public boolean read(double[] row) throws IOException {
        if (!held && ahead.isPresent()) {
            takeAhead();
        } else if (!held && !table.read(raw)) {
            return false;
        }
        held = false;
        count();
        row[0] = ticks / ticksPerSecond;
        int direct = columns.units().size();
        for (int i = 0; i < direct; i++) {
            row[1 + i] = columns.units().get(i).toSi(raw[1 + i]);
        }
        if (columns.matrix() > 0) {
            Rotation.quaternion(raw, columns.matrix(), row, 1 + direct);
        }
        return true;
    }

    /** Counts on, over wraps; a step of more than half the range is one backwards. */
    private void count() {
        if (Double.isNaN(raw[0])) {
            throw noCount();
        }
        double range = Math.max(raw[0], last) >= modulus ? WORD : modulus;
        double step = raw[0] - last;
        step -= range * Math.rint(step / range);
        ticks += step;
        last = raw[0];
    }

    @Override
    public long line() {
        return ahead.isPresent() ? table.line() - 1 : table.line();
    }

    @Override
    public double fractionRead() {
        return table.fractionRead();
    }

    @Override
    public void close() throws IOException {
        table.close();
    }
}
