package wbv.fleet.flink;

import java.util.Base64;
import java.util.Comparator;
import org.apache.flink.api.common.typeinfo.Types;
import org.apache.flink.util.OutputTag;

/**
 * Rows as the job writes them: in front of each the place of the packet that it comes of, and its number among the packet's, so that
 * they can be put in the order of one process.
 */
final class Rows {

    static final OutputTag<String> ALARMS = new OutputTag<>("alarms", Types.STRING);
    static final OutputTag<String> UNREAD = new OutputTag<>("unread", Types.STRING);

    /** Bits of a place that number the packets of a seat within a round; the round is above. */
    private static final int PACKETS = 24;

    private Rows() { }

    /** Where a packet stands in its seat's stream. @param packet its number among the seat's of this round */
    static long place(int round, int packet) {
        return (long) round << PACKETS | packet;
    }

    /** @param row with its end */
    static String row(long place, int number, CharSequence row) {
        return place + "," + number + "," + row.subSequence(0, row.length() - 1);
    }

    static String unread(long place, int number, String reason, byte[] packet) {
        return place + "," + number + ",\"" + reason.replace("\"", "\"\"") + "\"," + Base64.getEncoder().encodeToString(packet);
    }

    /** A row and where it belongs. */
    record Placed(long place, String seat, int number, String row) {

        /** Rounds, within them seats, whose names are numbered in so many digits at least, within them the order in which they were told. */
        static final Comparator<Placed> ORDER = Comparator.<Placed>comparingLong(each -> each.place >>> PACKETS)
                .thenComparingInt(each -> each.seat.length()).thenComparing(Placed::seat)
                .thenComparingLong(Placed::place).thenComparingInt(Placed::number);

        static Placed of(String line) {
            int first = line.indexOf(',');
            int second = line.indexOf(',', first + 1);
            int third = line.indexOf(',', second + 1);
            return new Placed(Long.parseLong(line.substring(0, first)), line.substring(second + 1, third),
                    Integer.parseInt(line.substring(first + 1, second)), line.substring(second + 1));
        }
    }
}
