package wbv.recording.inspect;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import wbv.recording.Channel;

/**
 * Looks at the values of rows, with memory that does not grow with their number, and says at any moment what is wrong with them up
 * to then: channels that stand still, clip, jump out and back or are missing, gravity where it should not be, units that make no
 * sense. What is wrong with their times is the business of {@link Times} and {@link RowClock}.
 */
public final class RowLooks {

    /** Rows that medians are taken over, of a stream. */
    private static final int OF_A_STREAM = 256;

    private final List<Channel> channels;
    private final ChannelLook[] looks;
    private final Map<String, LocationLook> locations = new LinkedHashMap<>();
    private final LocationLook[] locationLooks;
    private final ThinnedRows thinned;

    /**
     * Looks at a stream.
     *
     * @param channels the columns of the rows to come
     */
    public RowLooks(List<Channel> channels) {
        this(channels, OF_A_STREAM);
    }

    /** @param most rows that medians are taken over, at most */
    RowLooks(List<Channel> channels, int most) {
        this.channels = List.copyOf(channels);
        this.looks = channels.stream().map(ChannelLook::new).toArray(ChannelLook[]::new);
        for (int i = 0; i < looks.length; i++) {
            locations.computeIfAbsent(channels.get(i).location(), LocationLook::new).add(channels.get(i), i);
        }
        this.locationLooks = locations.values().toArray(LocationLook[]::new);
        this.thinned = new ThinnedRows(looks.length, most);
    }

    /**
     * Looks at a row.
     *
     * @param row time [s], then the channels in SI units, one more than channels long. Not modified, not kept.
     * @param line where it stands, 0 where lines mean nothing
     */
    public void accept(double[] row, long line) {
        for (int i = 0; i < looks.length; i++) {
            looks[i].accept(row[1 + i], line);
        }
        for (LocationLook look : locationLooks) {
            look.accept(row, line);
        }
        thinned.accept(row);
    }

    /** What the channels hold. */
    public Map<Channel, Summary> summaries() {
        Map<Channel, Summary> summaries = new LinkedHashMap<>();
        for (ChannelLook look : looks) {
            summaries.put(look.channel(), look.summary());
        }
        return summaries;
    }

    /**
     * What is wrong with the values up to now, gravest first.
     *
     * @param rate of the rows [Hz]
     */
    public List<Finding> findings(double rate) {
        Map<Channel, Summary> summaries = summaries();
        List<Finding> findings = new ArrayList<>(missing(summaries));
        long stuckRun = stuckRun(rate);
        for (ChannelLook look : looks) {
            findings.addAll(look.findings(stuckRun, locations.get(look.channel().location()).zeroRows()));
        }
        for (LocationLook look : locationLooks) {
            findings.addAll(look.findings(channel -> thinned.median(channels.indexOf(channel)),
                    channel -> summaries.get(channel).rms()));
        }
        findings.sort(Comparator.comparing(Finding::severity).reversed());
        return findings;
    }

    /**
     * Equal values in a row from which on a sensor counts as stuck: half a second, and 20.
     *
     * @param rate [Hz]
     */
    public static long stuckRun(double rate) {
        return Math.max(20, (long) (rate / 2));
    }

    /** What is missing, channels of one sensor that lack as much in one line: a lost packet takes them all. */
    private static List<Finding> missing(Map<Channel, Summary> summaries) {
        Map<String, List<Channel>> together = new LinkedHashMap<>();
        summaries.forEach((channel, summary) -> {
            if (summary.missing() > 0) {
                together.computeIfAbsent(channel.location() + ' ' + summary.missing(), key -> new ArrayList<>()).add(channel);
            }
        });
        List<Finding> found = new ArrayList<>();
        for (List<Channel> channels : together.values()) {
            Summary one = summaries.get(channels.get(0));
            found.add(new Finding.Missing(List.copyOf(channels), one.missing(), one.count() + one.missing()));
        }
        return found;
    }
}
