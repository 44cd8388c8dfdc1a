package wbv.recording.format;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import wbv.recording.AxisSigns;
import wbv.recording.CalendarTime;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.Quantity;
import wbv.recording.RowReader;
import wbv.recording.SensorClock;

/** Rows with the axes turned right that the sidecar says were mounted the wrong way round. */
final class SignedReader implements RowReader {

    private final RowReader rows;
    private final double[] signs;

    private SignedReader(RowReader rows, double[] signs) {
        this.rows = rows;
        this.signs = signs;
    }

    /** The reader itself where no sign is to be changed. */
    static RowReader of(RowReader rows, Sidecar sidecar, Path path) {
        if (sidecar.signs().isEmpty()) {
            return rows;
        }
        List<Channel> channels = rows.channels();
        double[] signs = new double[1 + channels.size()];
        signs[0] = 1;
        for (int i = 0; i < channels.size(); i++) {
            Channel channel = channels.get(i);
            AxisSigns axes = sidecar.signs().getOrDefault(channel.location(), new AxisSigns(1, 1, 1));
            signs[1 + i] = axes.of(channel.axis());
            if (channel.quantity() == Quantity.QUATERNION && !axes.equals(new AxisSigns(1, 1, 1))) {
                throw DataFault.in(Sidecar.beside(path).toString(), "'axis_signs." + channel.location()
                        + "' would have to turn a quaternion too, which signs cannot; leave out its quat columns");
            }
        }
        for (String location : sidecar.signs().keySet()) {
            if (channels.stream().noneMatch(channel -> channel.location().equals(location))) {
                throw DataFault.in(Sidecar.beside(path).toString(), "'axis_signs." + location
                        + "' names no location of the recording");
            }
        }
        return new SignedReader(rows, signs);
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
    public boolean read(double[] row) throws IOException {
        if (!rows.read(row)) {
            return false;
        }
        for (int i = 1; i < signs.length; i++) {
            row[i] *= signs[i];
        }
        return true;
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
    public void close() throws IOException {
        rows.close();
    }
}
