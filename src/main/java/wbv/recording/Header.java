package wbv.recording;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** The columns of a table that is named as ours are: {@code t} and channels. Slot 0 is the time's, whether there is a {@code t} or not. */
public record Header(List<Channel> channels, int[] slots) {

    /** Name of the column of times. */
    public static final String TIME = "t";

    /**
     * The header that these names make.
     *
     * @param advice how to read a file with other columns
     * @throws DataFault if there is no {@code t} or no channel, a name is no channel, or one stands twice
     */
    public static Header of(String file, long line, List<String> names, String advice) {
        if (!names.contains(TIME)) {
            throw DataFault.at(file, line, "the header must have a column t and channels such as head.acc.z; it has "
                    + shortened(names) + "; " + advice);
        }
        return untimed(file, line, names, advice);
    }

    /**
     * The header that these names make, of a table whose rate is known otherwise: it may do without a {@code t}.
     *
     * @param advice how to read a file with other columns
     * @throws DataFault if there is no channel, a name is no channel, or one stands twice
     */
    public static Header untimed(String file, long line, List<String> names, String advice) {
        requireDistinct(file, line, names);
        List<Channel> channels = new ArrayList<>();
        int[] slots = new int[names.size()];
        for (int i = 0; i < slots.length; i++) {
            if (!names.get(i).equals(TIME)) {
                channels.add(channel(file, line, names.get(i), advice));
                slots[i] = channels.size();
            }
        }
        if (channels.isEmpty()) {
            throw DataFault.at(file, line, "there is a column t but no channel, such as head.acc.z");
        }
        return new Header(channels, slots);
    }

    /** Faults a name that stands twice. */
    public static void requireDistinct(String file, long line, List<String> names) {
        Set<String> seen = new HashSet<>();
        for (String name : names) {
            if (!seen.add(name)) {
                throw DataFault.at(file, line, "the column '" + name + "' stands twice; name each column once");
            }
        }
    }

    private static Channel channel(String file, long line, String name, String advice) {
        try {
            return Channel.parse(name);
        } catch (IllegalArgumentException wrong) {
            throw DataFault.at(file, line, wrong.getMessage() + "; " + advice);
        }
    }

    /** The names, or the first few of many. */
    public static String shortened(List<String> names) {
        return names.size() <= 6 ? names.toString() : names.subList(0, 6) + " and " + (names.size() - 6) + " more";
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Header header && channels.equals(header.channels) && Arrays.equals(slots, header.slots);
    }

    @Override
    public int hashCode() {
        return channels.hashCode();
    }
}
