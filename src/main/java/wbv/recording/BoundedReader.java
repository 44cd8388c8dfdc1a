package wbv.recording;

import java.io.IOException;
import java.util.List;
import java.util.Optional;

/**
 * Rows whose every value some sensor could have measured. What lies beyond is damage, or in another unit: it is refused where it
 * enters, with its line, so that no square or product behind it can overflow.
 */
public final class BoundedReader implements RowReader {

    /**
     * Largest magnitude of a value in its SI unit. Shock accelerometers reach 2e6 m/s² (200 000 g), tachometers 1e5 rad/s, the
     * circumference of the earth is 4e7 m, presses push 1e9 N.
     */
    public static final double MOST = 1e9;
    /** Latest time [s]: doubles there are 2 ms apart and tell samples from each other no more. */
    public static final double LATEST = 1e13;

    private final RowReader rows;
    private final String name;

    /**
     * The rows of a reader, each looked at; closed with it.
     *
     * @param name of the recording, for messages
     */
    public BoundedReader(RowReader rows, String name) {
        this.rows = rows;
        this.name = name;
    }

    @Override
    public boolean read(double[] row) throws IOException {
        if (!rows.read(row)) {
            return false;
        }
        if (!(Math.abs(row[0]) <= LATEST)) {
            throw DataFault.at(name, line(), "the time " + row[0] + " s is not within " + LATEST
                    + " s: mend the line, or say the unit of the times in a map");
        }
        for (int i = 1; i < row.length; i++) {
            if (Math.abs(row[i]) > MOST) {
                Channel channel = rows.channels().get(i - 1);
                throw DataFault.at(name, line(), channel + " is " + row[i] + " " + channel.quantity().unit()
                        + ", which no sensor measures: mend the value, or leave its cell empty");
            }
        }
        return true;
    }

    @Override
    public List<Channel> channels() {
        return rows.channels();
    }

    @Override
    public Metadata metadata() {
        return rows.metadata();
    }

    @Override
    public long passedOver() {
        return rows.passedOver();
    }

    @Override
    public Optional<CalendarTime> origin() {
        return rows.origin();
    }

    @Override
    public Optional<SensorClock> sensorClock() {
        return rows.sensorClock();
    }

    @Override
    public long line() {
        return rows.line();
    }

    @Override
    public double fractionRead() {
        return rows.fractionRead();
    }

    @Override
    public void close() throws IOException {
        rows.close();
    }
}
