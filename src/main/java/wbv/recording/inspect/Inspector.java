package wbv.recording.inspect;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.RowReader;
import wbv.recording.SensorClock;

/** Looks at every row of a recording once, with memory that does not grow with its length, and says what is there. */
public final class Inspector {

    private final String name;
    private final Times times;
    private final RowLooks looks;
    private final double[] previous;
    private final long passedOver;
    private long rows;

    /**
     * An inspector of what this reader gives.
     *
     * @param name the recording, for messages
     */
    public Inspector(String name, RowReader reader) {
        this(name, reader.channels(), reader.metadata(), reader.sensorClock(), reader.passedOver());
    }

    /**
     * An inspector of rows that come from elsewhere.
     *
     * @param name     the recording, for messages
     * @param channels the columns of the rows to come
     * @param metadata states the nominal rate, if any
     * @param sensor   the sensor's own clock that times were made from, if they were
     */
    public Inspector(String name, List<Channel> channels, Metadata metadata, Optional<SensorClock> sensor) {
        this(name, channels, metadata, sensor, 0);
    }

    private Inspector(String name, List<Channel> channels, Metadata metadata, Optional<SensorClock> sensor, long passedOver) {
        this.name = name;
        this.times = new Times(metadata.rate(), sensor);
        this.looks = new RowLooks(channels, ThinnedRows.MOST);
        this.previous = new double[1 + channels.size()];
        previous[0] = Double.NaN;
        this.passedOver = passedOver;
    }

    /**
     * Looks at a row.
     *
     * @param row time [s], then the channels in SI units, one more than channels long. Not modified, not kept.
     * @param line where it stands
     */
    public void accept(double[] row, long line) {
        rows++;
        boolean repeated = row[0] == previous[0] && RowComparison.same(row, previous);
        times.accept(row[0], line, repeated);
        if (repeated) {
            return;
        }
        System.arraycopy(row, 0, previous, 0, row.length);
        looks.accept(row, line);
    }

    /**
     * Ends the inspection.
     *
     * @throws wbv.recording.DataFault if there were fewer than two samples
     */
    public Inspection finish() {
        times.finish(name);
        Clock clock = times.clock();
        List<Finding> findings = new ArrayList<>(times.findings());
        findings.addAll(looks.findings(clock.rate()));
        if (passedOver > 0) {
            findings.add(new Finding.PassedOver(passedOver));
        }
        findings.sort(Comparator.comparing(Finding::severity).reversed());
        return new Inspection(name, rows, times.samples(), clock, times.timing(), looks.summaries(), findings);
    }
}
