package wbv.recording.inspect;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.Header;

/**
 * What one look at every row found.
 *
 * @param name      the recording, as messages name it
 * @param rows      rows read
 * @param samples   samples on the clock from the first row to the last, missing ones included
 * @param clock     the uniform clock that the rows lie on
 * @param timing    how the times behave
 * @param summaries by channel, in column order
 * @param findings  what is wrong or worth knowing, gravest first
 */
public record Inspection(String name, long rows, long samples, Clock clock, Timing timing, Map<Channel, Summary> summaries,
        List<Finding> findings) {

    public Inspection {
        summaries = Collections.unmodifiableMap(new LinkedHashMap<>(summaries));
        findings = List.copyOf(findings);
    }

    /** Time from the first sample to one step after the last [s]. */
    public double duration() {
        return samples / clock.rate();
    }

    /**
     * Demands a channel that can be used.
     *
     * @throws DataFault if the recording has no such channel, or it holds no number
     */
    public void require(Channel channel) {
        Summary summary = summaries.get(channel);
        if (summary == null) {
            throw DataFault.in(name, "has no channel " + channel + "; it has "
                    + Header.shortened(summaries.keySet().stream().map(Channel::toString).toList()));
        }
        if (summary.count() == 0) {
            throw DataFault.in(name, "channel " + channel + " holds no number in any of its " + rows + " rows; choose another");
        }
    }
}
