package wbv.recording;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Looks at every row of a recording once, with memory that does not grow with its length, and says what is there. */
public final class Inspector {

    private final String name;
    private final List<Channel> channels;
    private final Times times;
    private final ChannelLook[] looks;
    private final Map<String, LocationLook> locations = new LinkedHashMap<>();
    private final LocationLook[] locationLooks;
    private final ThinnedRows thinned;
    private final double[] previous;
    private long rows;

    /** An inspector of what this reader gives. @param name the recording, for messages */
    public Inspector(String name, RowReader reader) {
        this(name, reader.channels(), reader.metadata(), reader.sensorClock());
    }

    /**
     * @param name     the recording, for messages
     * @param channels the columns of the rows to come
     * @param metadata states the nominal rate, if any
     * @param sensor   the sensor's own clock that times were made from, if they were
     */
    public Inspector(String name, List<Channel> channels, Metadata metadata, Optional<SensorClock> sensor) {
        this.name = name;
        this.channels = List.copyOf(channels);
        this.times = new Times(metadata.rate(), sensor);
        this.looks = channels.stream().map(ChannelLook::new).toArray(ChannelLook[]::new);
        for (int i = 0; i < looks.length; i++) {
            locations.computeIfAbsent(channels.get(i).location(), LocationLook::new).add(channels.get(i), i);
        }
        this.locationLooks = locations.values().toArray(LocationLook[]::new);
        this.thinned = new ThinnedRows(looks.length);
        this.previous = new double[1 + looks.length];
        previous[0] = Double.NaN;
    }

    /** Looks at a row. @param row time [s], then the channels. Not kept. @param line where it stands */
    public void accept(double[] row, long line) {
        rows++;
        boolean repeated = row[0] == previous[0] && Rows.same(row, previous);
        times.accept(row[0], line, repeated);
        if (repeated) {
            return;
        }
        System.arraycopy(row, 0, previous, 0, row.length);
        for (int i = 0; i < looks.length; i++) {
            looks[i].accept(row[1 + i], line);
        }
        for (LocationLook look : locationLooks) {
            look.accept(row, line);
        }
        thinned.accept(row);
    }

    /** Ends the inspection. @throws DataFault if there were fewer than two samples */
    public Inspection finish() {
        times.finish(name);
        Clock clock = times.clock();
        Map<Channel, Summary> summaries = new LinkedHashMap<>();
        for (ChannelLook look : looks) {
            summaries.put(look.channel(), look.summary());
        }
        List<Finding> findings = new ArrayList<>(times.findings());
        long stuckRun = Math.max(20, (long) (clock.rate() / 2));
        for (ChannelLook look : looks) {
            findings.addAll(look.findings(stuckRun, locations.get(look.channel().location()).zeroRows()));
        }
        for (LocationLook look : locationLooks) {
            findings.addAll(look.findings(channel -> thinned.median(channels.indexOf(channel)),
                    channel -> summaries.get(channel).rms()));
        }
        findings.sort(Comparator.comparing(Finding::severity).reversed());
        return new Inspection(name, rows, times.samples(), clock, times.timing(), summaries, findings);
    }
}
