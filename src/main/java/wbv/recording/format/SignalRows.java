package wbv.recording.format;

import java.io.EOFException;
import java.io.IOException;
import java.util.Optional;
import java.util.zip.ZipException;
import wbv.recording.CalendarTime;
import wbv.recording.DataFault;
import wbv.recording.signals.Label;
import wbv.recording.signals.SignalFile;

/** The rows of a file of signals, those that are wanted in their slots. */
final class SignalRows implements SlotRows {

    private final Source source;
    private final SignalFile signals;
    private final int[] slots;
    private final double[] all;
    private final boolean isTime;
    private long rows;

    /** @param slots by signal */
    SignalRows(Source source, SignalFile signals, int[] slots) {
        this.source = source;
        this.signals = signals;
        this.slots = slots.clone();
        this.all = new double[slots.length];
        this.isTime = signals.time().map(name -> signals.labels().stream().map(Label::name).toList().indexOf(name))
                .filter(at -> at >= 0 && slots[at] == 0).isPresent();
    }

    @Override
    public boolean read(double[] row) throws IOException {
        try {
            if (!signals.read(all)) {
                return false;
            }
        } catch (EOFException | ZipException damaged) {
            throw Source.damaged(source.name(), damaged);
        }
        rows++;
        for (int i = 0; i < all.length; i++) {
            if (Double.isInfinite(all[i]) && slots[i] >= 0) {
                throw fault("the signal '" + signals.labels().get(i).name() + "' is infinite");
            }
            if (slots[i] >= 0) {
                row[slots[i]] = all[i];
            }
        }
        return true;
    }

    @Override
    public DataFault fault(String message) {
        return DataFault.in(source.name(), message + " (sample " + rows + ")");
    }

    @Override
    public long line() {
        return 0;
    }

    /** Where the signal of dates is the time and not another. */
    @Override
    public Optional<CalendarTime> origin() {
        return isTime ? signals.origin() : Optional.empty();
    }

    @Override
    public double fractionRead() {
        return signals.fractionRead();
    }

    @Override
    public void close() throws IOException {
        try (source; signals) {
            // both
        }
    }
}
