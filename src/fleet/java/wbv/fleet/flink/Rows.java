package wbv.fleet.flink;

import java.util.Comparator;
import org.apache.flink.api.common.typeinfo.Types;
import org.apache.flink.util.OutputTag;
import wbv.fleet.ResultRows;

/**
 * Rows as the job writes them: in front of each the place of the packet that it comes of, and its number among the packet's, so that
 * they can be put in the order of one process.
 */
final class Rows {

    static final OutputTag<String> ALARMS = new OutputTag<>("alarms", Types.STRING);
    static final OutputTag<String> UNREAD = new OutputTag<>("unread", Types.STRING);
    static final OutputTag<String> WORST = new OutputTag<>("worst", Types.STRING);

    /** Bits of a place that number the packets of a seat within a round; the round is above. */
    private static final int PACKETS = 24;

    /** Place behind all packets, under which is told what seats still hold then. */
    static final long END = place(Long.MAX_VALUE >>> PACKETS, 0);

    private Rows() {}

    /**
     * Where a packet stands.
     *
     * @param round  of the seats, or number of the packet among all
     * @param packet its number among the seat's of this round
     */
    static long place(long round, int packet) {
        return round << PACKETS | packet;
    }

    /** @param row with its end */
    static String row(long place, int number, CharSequence row) {
        return place + "," + number + "," + row.subSequence(0, row.length() - 1);
    }

    static String unread(long place, int number, String reason, byte[] packet) {
        return row(place, number, ResultRows.unread(reason, packet));
    }

    /** The row itself. */
    static String bare(String row) {
        return row.substring(row.indexOf(',', row.indexOf(',') + 1) + 1);
    }

    /**
     * A row of a table that may be told again.
     *
     * @param number of the table
     * @param revision of it
     * @param row without its end
     */
    static String revised(long number, int revision, int place, String row) {
        return number + "," + revision + "," + place + "," + row;
    }

    /** A row and where it belongs. */
    record Placed(long place, String seat, int number, String row) {

        /**
         * Rounds, within them seats, whose names are numbered in so many digits at least, within them the order in which they were told.
         */
        static final Comparator<Placed> ORDER = Comparator.<Placed>comparingLong(each -> each.place >>> PACKETS)
                .thenComparingInt(each -> each.seat.length()).thenComparing(Placed::seat)
                .thenComparingLong(Placed::place).thenComparingInt(Placed::number);

        static Placed of(String line) {
            int first = line.indexOf(',');
            int second = line.indexOf(',', first + 1);
            String row = line.substring(second + 1);
            return new Placed(Long.parseLong(line.substring(0, first)), row.substring(0, ResultRows.firstField(row)),
                    Integer.parseInt(line.substring(first + 1, second)), row);
        }
    }

    /** A row of a table that may be told again. */
    record Revised(long number, int revision, int place, String row) {

        static Revised of(String line) {
            String[] fields = line.split(",", 4);
            return new Revised(Long.parseLong(fields[0]), Integer.parseInt(fields[1]), Integer.parseInt(fields[2]), fields[3]);
        }
    }
}
