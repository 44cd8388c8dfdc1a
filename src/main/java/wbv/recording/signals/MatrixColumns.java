package wbv.recording.signals;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.IntToDoubleFunction;
import wbv.recording.DataFault;
import wbv.recording.Header;

/**
 * Named matrices as signals: the longest dimension that occurs is that of the samples, every vector and every column of a matrix of that
 * length is a signal, and a single number with a name such as {@code fs} is their rate.
 */
final class MatrixColumns {

    /** A recording has fewer signals than samples; what is larger is a table of something else. */
    private static final int MOST_SIGNALS = 512;

    private final String file;
    private final boolean fromOne;
    private final Map<String, Matrix> matrices = new LinkedHashMap<>();
    private final List<String> others = new ArrayList<>();
    private final Map<String, String> notes = new LinkedHashMap<>();

    /** @param fromOne true where columns are written {@code a(:,1)}, false where {@code a[:,0]} */
    MatrixColumns(String file, boolean fromOne) {
        this.file = file;
        this.fromOne = fromOne;
    }

    /** @param values by number, column after column */
    private record Matrix(int rows, int columns, IntToDoubleFunction values, Optional<String> unit) {

        private IntToDoubleFunction column(int number, boolean lying) {
            return lying ? sample -> values.applyAsDouble(sample * rows + number) : sample -> values.applyAsDouble(number * rows + sample);
        }
    }

    /**
     * Adds a matrix, whose numbers stay where they are.
     *
     * @param values by number, column after column
     */
    void add(String name, int rows, int columns, IntToDoubleFunction values, Optional<String> unit) {
        matrices.put(name, new Matrix(rows, columns, values, unit));
    }

    /** Adds the name of something that is no matrix of numbers. */
    void addOther(String name) {
        others.add(name);
    }

    void note(String name, String text) {
        notes.put(name, text);
    }

    /** How the matrix's own language writes one of its columns, or rows where they lie. */
    private String index(int number, boolean lying) {
        String both = lying ? (number + (fromOne ? 1 : 0)) + ",:" : ":," + (number + (fromOne ? 1 : 0));
        return fromOne ? "(" + both + ")" : "[" + both + "]";
    }

    SignalFile signals() {
        int length = matrices.values().stream().mapToInt(matrix -> Math.max(matrix.rows, matrix.columns)).max().orElse(0);
        if (length < 2) {
            throw DataFault.in(file, "holds no vector or matrix of numbers" + (others.isEmpty() ? "" : "; there are "
                    + Header.shortened(others) + ", text or objects (save a table as a struct: s = table2struct(T, 'ToScalar', true))"));
        }
        OptionalDouble rate = OptionalDouble.empty();
        List<Label> labels = new ArrayList<>();
        List<IntToDoubleFunction> values = new ArrayList<>();
        Optional<String> time = Optional.empty();
        for (Map.Entry<String, Matrix> each : matrices.entrySet()) {
            Matrix matrix = each.getValue();
            String name = each.getKey();
            boolean lying = matrix.rows != length;
            int width = lying ? matrix.rows : matrix.columns;
            if (matrix.rows == 1 && matrix.columns == 1) {
                OptionalDouble stated = ClockWords.rate(name, matrix.values.applyAsDouble(0));
                rate = stated.isPresent() ? stated : rate;
            } else if (Math.max(matrix.rows, matrix.columns) != length || width > MOST_SIGNALS) {
                others.add(name);
            } else {
                for (int i = 0; i < width; i++) {
                    String signal = width == 1 ? name : name + index(i, lying);
                    Label label = Label.of(signal);
                    labels.add(matrix.unit.flatMap(UnitWords::of).map(label::in).orElse(label));
                    values.add(matrix.column(i, lying));
                }
                time = time.isEmpty() && width == 1 && ClockWords.isTime(name) ? Optional.of(name) : time;
            }
        }
        if (labels.isEmpty()) {
            throw DataFault.in(file, "holds matrices of " + length + " rows and more columns than a recording has signals");
        }
        if (!others.isEmpty()) {
            notes.put("not read", String.join(", ", others));
        }
        return new Signals(labels, values, length, time, time.isPresent() ? OptionalDouble.empty() : rate, notes);
    }
}
