package wbv.fleet.flink;

import java.util.Base64;
import java.util.Comparator;
import org.apache.flink.api.common.typeinfo.Types;
import org.apache.flink.util.OutputTag;

/** Rows as the job writes them: round and number within it in front of the row, so that they can be put in the order of one process. */
final class Rows {

    static final OutputTag<String> ALARMS = new OutputTag<>("alarms", Types.STRING);
    static final OutputTag<String> UNREAD = new OutputTag<>("unread", Types.STRING);

    private Rows() { }

    /** @param row with its end */
    static String row(long round, int number, CharSequence row) {
        return round + "," + number + "," + row.subSequence(0, row.length() - 1);
    }

    static String unread(long round, int number, String reason, byte[] packet) {
        return round + "," + number + ",\"" + reason.replace("\"", "\"\"") + "\"," + Base64.getEncoder().encodeToString(packet);
    }

    /** A row and where it belongs. */
    record Placed(long round, String seat, int number, String row) {

        /** Rounds, within them seats, whose names are numbered in so many digits at least, within them the order in which they were told. */
        static final Comparator<Placed> ORDER = Comparator.comparingLong(Placed::round)
                .thenComparingInt(each -> each.seat.length()).thenComparing(Placed::seat).thenComparingInt(Placed::number);

        static Placed of(String line) {
            int first = line.indexOf(',');
            int second = line.indexOf(',', first + 1);
            int third = line.indexOf(',', second + 1);
            return new Placed(Long.parseLong(line.substring(0, first)), line.substring(second + 1, third),
                    Integer.parseInt(line.substring(first + 1, second)), line.substring(second + 1));
        }
    }
}
