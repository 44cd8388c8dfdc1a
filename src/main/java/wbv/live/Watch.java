package wbv.live;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.recording.inspect.Finding;
import wbv.recording.inspect.RowLooks;
import wbv.recording.inspect.Severity;

/** Faults of a seat's samples as they come: told when they begin and, where they can end, when they are over. */
final class Watch {

    /** Who is told. */
    interface Listener {
        void tell(Severity severity, String kind, String reason, String advice, boolean over);
    }

    /** Time without a number after which a channel is missing [s]. */
    private static final double ABSENT = 1;
    /** Sensor time between looks at what takes a while to see [s]. */
    private static final double BETWEEN_LOOKS = 5;

    private final List<Channel> channels;
    private final Listener listener;
    private final RowLooks looks;
    private final double rate;
    private final long stuckRun;
    private final double[] before;
    private final long[] same;
    private final long[] absent;
    private final boolean[] stuck;
    private final boolean[] missing;
    private final Set<String> told = new HashSet<>();
    private long rows;

    Watch(List<Channel> channels, double rate, Listener listener) {
        this.channels = channels;
        this.rate = rate;
        this.listener = listener;
        looks = new RowLooks(channels);
        stuckRun = RowLooks.stuckRun(rate);
        before = new double[channels.size()];
        same = new long[before.length];
        absent = new long[before.length];
        stuck = new boolean[before.length];
        missing = new boolean[before.length];
    }

    /**
     * Looks at a row.
     *
     * @param row time, then the channels
     */
    void accept(double[] row) {
        looks.accept(row, 0);
        for (int i = 0; i < before.length; i++) {
            double value = row[1 + i];
            if (Double.isNaN(value)) {
                absent(i);
            } else {
                present(i, value);
            }
        }
        if (++rows % Math.max(1, Math.round(BETWEEN_LOOKS * rate)) == 0) {
            look();
        }
    }

    private void absent(int i) {
        if (++absent[i] > ABSENT * rate && !missing[i]) {
            missing[i] = true;
            listener.tell(Severity.WARNING, "missing", channels.get(i) + " has brought no number for a second",
                    "check the sensor and its cable", false);
        }
    }

    private void present(int i, double value) {
        absent[i] = 0;
        if (missing[i]) {
            missing[i] = false;
            listener.tell(Severity.NOTE, "missing", channels.get(i) + " brings numbers again", "", true);
        }
        same[i] = value == before[i] ? same[i] + 1 : 1;
        before[i] = value;
        if (same[i] > stuckRun && !stuck[i] && restless(channels.get(i))) {
            stuck[i] = true;
            listener.tell(Severity.WARNING, "stuck", channels.get(i) + " stands still at " + (float) value,
                    "check the sensor and its cable; an axis that is not measured is best left out", false);
        } else if (stuck[i] && same[i] == 1) {
            stuck[i] = false;
            listener.tell(Severity.NOTE, "stuck", channels.get(i) + " moves again", "", true);
        }
    }

    /** True for what never stands still, its noise being greater than its digits. */
    private static boolean restless(Channel channel) {
        return channel.quantity() == Quantity.ACCELERATION || channel.quantity() == Quantity.SPECIFIC_FORCE
                || channel.quantity() == Quantity.ANGULAR_RATE;
    }

    /** What takes a while to see is told once. */
    private void look() {
        for (Finding finding : looks.findings(rate)) {
            String kind = kind(finding);
            if (!kind.isEmpty() && told.add(kind + ' ' + subject(finding))) {
                listener.tell(finding.severity(), kind, finding.message(), finding.advice(), false);
            }
        }
    }

    private static String kind(Finding finding) {
        if (finding instanceof Finding.Clipped) {
            return "clipped";
        }
        if (finding instanceof Finding.Spikes) {
            return "spikes";
        }
        if (finding instanceof Finding.ImplausibleUnit) {
            return "unit";
        }
        if (finding instanceof Finding.GravityLeftIn || finding instanceof Finding.GravityMissing) {
            return "gravity";
        }
        return finding instanceof Finding.GrossBias ? "bias" : "";
    }

    private static String subject(Finding finding) {
        if (finding instanceof Finding.Clipped clipped) {
            return clipped.channel().toString();
        }
        if (finding instanceof Finding.Spikes spikes) {
            return spikes.channel().toString();
        }
        if (finding instanceof Finding.ImplausibleUnit unit) {
            return unit.location();
        }
        if (finding instanceof Finding.GrossBias bias) {
            return bias.location() + bias.quantity();
        }
        return finding instanceof Finding.GravityLeftIn left ? left.location()
                : finding instanceof Finding.GravityMissing gone ? gone.location() : "";
    }

    /** Whether a place has a channel that stands still or brings no number now. */
    boolean ails(String place) {
        for (int i = 0; i < channels.size(); i++) {
            if ((stuck[i] || missing[i]) && channels.get(i).location().equals(place)) {
                return true;
            }
        }
        return false;
    }

    /** Channels that stand still or bring no number now. */
    int ailing() {
        int count = 0;
        for (int i = 0; i < stuck.length; i++) {
            count += stuck[i] || missing[i] ? 1 : 0;
        }
        return count;
    }
}
