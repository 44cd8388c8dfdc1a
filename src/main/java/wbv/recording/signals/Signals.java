package wbv.recording.signals;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.IntToDoubleFunction;

/** Signals that are held in memory, all of one length. */
final class Signals implements SignalFile {

    private final List<Label> labels;
    private final List<IntToDoubleFunction> values;
    private final Optional<String> time;
    private final OptionalDouble rate;
    private final Map<String, String> notes;
    private final int length;
    private int next;

    /**
     * @param values of each label, by sample
     * @param length samples of each
     */
    Signals(List<Label> labels, List<IntToDoubleFunction> values, int length, Optional<String> time, OptionalDouble rate,
            Map<String, String> notes) {
        this.labels = List.copyOf(labels);
        this.values = List.copyOf(values);
        this.time = time;
        this.rate = rate;
        this.notes = new LinkedHashMap<>(notes);
        this.length = length;
    }

    @Override
    public List<Label> labels() {
        return labels;
    }

    @Override
    public Optional<String> time() {
        return time;
    }

    @Override
    public OptionalDouble rate() {
        return rate;
    }

    @Override
    public Map<String, String> notes() {
        return notes;
    }

    @Override
    public boolean read(double[] row) {
        if (next == length) {
            return false;
        }
        for (int i = 0; i < row.length; i++) {
            row[i] = values.get(i).applyAsDouble(next);
        }
        next++;
        return true;
    }

    @Override
    public double fractionRead() {
        return length == 0 ? 1 : (double) next / length;
    }

    @Override
    public void close() {
        // nothing is open
    }
}
