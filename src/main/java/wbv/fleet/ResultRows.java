package wbv.fleet;

import java.util.Base64;
import java.util.List;
import java.util.Optional;
import wbv.recording.TableText;
import wbv.seat.SeatAlarm;
import wbv.seat.SeatPlan;
import wbv.seat.SeatResult;

/** Results of seats as rows of CSV, numbers to seven digits, nothing where nothing is known. */
public final class ResultRows {

    /** Why a whole packet was put aside. */
    public static final String REFUSED = "has other channels or another rate than the seats' plan";

    private final SeatPlan plan;

    /** For seats of one plan, which says what columns there are. */
    public ResultRows(SeatPlan plan) {
        this.plan = plan;
    }

    /** The first line of results.csv, with its end. */
    public String header() {
        StringBuilder head = new StringBuilder("seat,t_s");
        for (SeatPlan.Body body : plan.bodies()) {
            for (int mode = 1; mode <= body.design().degrees(); mode++) {
                String of = body.output() + (body.design().degrees() > 1 ? "." + mode : "");
                head.append(',').append(of).append(".frequency_Hz,").append(of).append(".frequency_deviation_Hz,").append(of)
                        .append(".damping,").append(of).append(".damping_deviation");
            }
            head.append(',').append(body.output()).append(".explained,").append(body.output()).append(".excited");
        }
        if (!plan.axes().isEmpty()) {
            head.append(",a8_m_per_s2,vdv_m_per_s1.75,minutes_to_action,minutes_to_limit");
        }
        if (plan.states().isPresent()) {
            head.append(",state,probability,jerk_within_0.5_s");
        }
        return head.append(",packets,twice,late,lost,lost_samples,restarts\n").toString();
    }

    /** The first line of unread.csv, with its end. */
    public static String unreadHeader() {
        return "reason,packet_base64\n";
    }

    /** Appends a row of results.csv, with its end. */
    public void write(SeatResult result, StringBuilder to) {
        name(result.seat(), to);
        time(result.time(), to);
        for (SeatResult.Body body : result.bodies()) {
            for (SeatResult.Mode mode : body.modes()) {
                number(mode.frequency(), to);
                number(mode.frequencyDeviation(), to);
                number(mode.damping(), to);
                number(mode.dampingDeviation(), to);
            }
            number(body.explained(), to);
            to.append(',').append(body.excited() ? 1 : 0);
        }
        if (result.exposure().isPresent()) {
            SeatResult.Exposure exposure = result.exposure().get();
            number(exposure.a8(), to);
            number(exposure.vdv(), to);
            number(exposure.minutesToAction(), to);
            number(exposure.minutesToLimit(), to);
        }
        if (plan.states().isPresent()) {
            state(result.state(), to);
        }
        SeatResult.Losses losses = result.losses();
        for (long count : new long[] {losses.packets(), losses.twice(), losses.late(), losses.lost(), losses.samples(),
            losses.restarts()}) {
            to.append(',').append(count);
        }
        to.append('\n');
    }

    private static void state(Optional<SeatResult.State> state, StringBuilder to) {
        if (state.isEmpty()) {
            to.append(",,,");
            return;
        }
        List<Double> jerk = state.get().jerk();
        to.append(',').append(state.get().state());
        number(state.get().probability(), to);
        number(jerk.get(jerk.size() - 1), to);
    }

    /** The first line of alarms.csv, with its end. */
    public static String alarmHeader() {
        return "seat,t_s,kind,reason\n";
    }

    /** Appends a row of alarms.csv, with its end. */
    public static void write(String seat, SeatAlarm alarm, StringBuilder to) {
        name(seat, to);
        time(alarm.time(), to);
        to.append(',').append(alarm.kind().word()).append(",\"").append(alarm.reason().replace("\"", "\"\"")).append("\"\n");
    }

    /** A seat's name as rows have it: in quotation marks where it could be taken for something else. */
    public static String name(String seat) {
        return TableText.cell(seat);
    }

    private static void name(String seat, StringBuilder to) {
        to.append(name(seat));
    }

    /** Number of characters that the first field of a row takes. */
    public static int firstField(CharSequence row) {
        int end = 0;
        boolean quoted = false;
        while (end < row.length() && (quoted || row.charAt(end) != ',')) {
            quoted ^= row.charAt(end) == '"';
            end++;
        }
        return end;
    }

    /**
     * Bytes that were no packet of the plan's, as a row of unread.csv, with its end.
     *
     * @param bytes Not modified.
     */
    public static String unread(String reason, byte[] bytes) {
        return '"' + reason.replaceAll("\\p{Cntrl}", " ").replace("\"", "\"\"") + "\"," + Base64.getEncoder().encodeToString(bytes) + '\n';
    }

    private static void time(double seconds, StringBuilder to) {
        to.append(',').append(Math.rint(1e4 * seconds) / 1e4);
    }

    private static void number(double value, StringBuilder to) {
        to.append(',');
        if (!Double.isNaN(value)) {
            to.append((float) value);
        }
    }
}
