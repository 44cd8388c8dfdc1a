package wbv.recording.signals;

import io.jhdf.HdfFile;
import io.jhdf.api.Attribute;
import io.jhdf.api.Dataset;
import io.jhdf.api.Group;
import io.jhdf.api.Node;
import java.lang.reflect.Array;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import wbv.recording.DataFault;

/**
 * HDF5, by jHDF: datasets of one or two dimensions are signals, named by their path; an attribute {@code unit} or {@code units} is their
 * unit. MATLAB's version 7.3 is HDF5 whose matrices lie on their side.
 */
final class HdfSignals {

    private static final String MATLAB = "MATLAB_class";

    private HdfSignals() {}

    static SignalFile read(String file, Path path) {
        try (HdfFile hdf = new HdfFile(path)) {
            boolean matlab = hdf.getChildren().values().stream().anyMatch(node -> node.getAttributes().containsKey(MATLAB));
            MatrixColumns columns = new MatrixColumns(file, matlab);
            add(columns, hdf, "", matlab);
            return columns.signals();
        } catch (DataFault told) {
            throw told;
        } catch (RuntimeException damaged) { // whatever the bytes lead jHDF to
            throw DataFault.in(file, "is a damaged HDF5 file, or cut off or gzipped; save, copy or unpack it again", damaged);
        }
    }

    private static void add(MatrixColumns columns, Group group, String prefix, boolean matlab) {
        for (Node node : group.getChildren().values()) {
            String name = prefix + node.getName();
            if (node instanceof Group inner) {
                if (!node.getName().startsWith("#")) { // MATLAB's own
                    add(columns, inner, name + (matlab ? "." : "/"), matlab);
                }
            } else if (node instanceof Dataset dataset) {
                add(columns, dataset, name, matlab);
            }
        }
    }

    private static void add(MatrixColumns columns, Dataset dataset, String name, boolean matlab) {
        int[] sizes = dataset.getDimensions();
        Class<?> type = dataset.getJavaType();
        // Alone, it is boxed.
        boolean numbers = type.isPrimitive() && type != boolean.class && type != char.class || Number.class.isAssignableFrom(type);
        boolean other = matlab && text(dataset, MATLAB).filter(kind -> kind.equals("char") || kind.equals("cell")).isPresent();
        if (!numbers || other || sizes.length > 2 || dataset.isEmpty()) {
            columns.addOther(name);
            return;
        }
        Object flat = sizes.length == 0 ? dataset.getData() : dataset.getDataFlat();
        IntToDoubleFunction values = numbers(flat);
        int first = sizes.length > 0 ? sizes[0] : 1;
        int second = sizes.length > 1 ? sizes[1] : 1;
        // Rows after one another in HDF5, columns after one another in MATLAB: the same bytes, with the sizes the other way round.
        columns.add(name, matlab ? second : first, matlab ? first : second, matlab ? values : turned(values, first, second),
                text(dataset, "unit").or(() -> text(dataset, "units")));
    }

    /** Numbers where jHDF put them. */
    private static IntToDoubleFunction numbers(Object flat) {
        if (flat instanceof double[] values) {
            return i -> values[i];
        }
        if (flat instanceof float[] values) {
            return i -> values[i];
        }
        return flat.getClass().isArray() ? i -> ((Number) Array.get(flat, i)).doubleValue() : i -> ((Number) flat).doubleValue();
    }

    /** Rows after one another read as columns after one another. */
    private static IntToDoubleFunction turned(IntToDoubleFunction values, int rows, int columns) {
        return columns == 1 ? values : i -> values.applyAsDouble(i % rows * columns + i / rows);
    }

    private static Optional<String> text(Node node, String name) {
        Attribute attribute = node.getAttributes().get(name);
        return attribute == null ? Optional.empty() : Optional.of(attribute.getData().toString());
    }
}
