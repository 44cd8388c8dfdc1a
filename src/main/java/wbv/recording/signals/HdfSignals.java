package wbv.recording.signals;

import io.jhdf.HdfFile;
import io.jhdf.WritableHdfFile;
import io.jhdf.api.Attribute;
import io.jhdf.api.Dataset;
import io.jhdf.api.Group;
import io.jhdf.api.Node;
import io.jhdf.exceptions.HdfWritingException;
import java.io.IOException;
import java.io.OutputStream;
import java.lang.reflect.Array;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import wbv.recording.Channel;
import wbv.recording.DataFault;

/**
 * HDF5, by jHDF: datasets of one or two dimensions are signals, named by their path; an attribute {@code unit} or {@code units} is their
 * unit. MATLAB's version 7.3 is HDF5 whose matrices lie on their side. Written are a dataset {@code t} and one for each channel, in double
 * precision, uncompressed, each with its unit; an attribute {@code order} of the whole has their names as they stood, since a group of HDF5
 * has no order.
 */
final class HdfSignals {

    private static final String MATLAB = "MATLAB_class";
    private static final String ORDER = "order";

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
        for (Node node : ordered(group)) {
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

    /** What a group holds, first what its order names. */
    private static List<Node> ordered(Group group) {
        Attribute stated = group.getAttributes().get(ORDER);
        List<String> names = stated != null && stated.getData() instanceof String[] known ? List.of(known) : List.of();
        List<Node> nodes = new ArrayList<>(group.getChildren().values());
        nodes.sort(Comparator.comparingInt(node -> names.contains(node.getName()) ? names.indexOf(node.getName()) : names.size()));
        return nodes;
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

    /** jHDF writes where it can go back, which a stream cannot: so to a file beside all others, and from there. */
    static void write(SampledColumns columns, OutputStream out) throws IOException {
        Path file = Files.createTempFile("wbv", ".h5");
        try {
            try (WritableHdfFile hdf = HdfFile.write(file)) {
                put(hdf, "t", columns.length(), columns::time, "s");
                for (int i = 0; i < columns.channels().size(); i++) {
                    int number = i;
                    Channel channel = columns.channels().get(i);
                    put(hdf, channel.toString(), columns.length(), j -> columns.value(number, j), channel.quantity().unit());
                }
                hdf.putAttribute(ORDER, columns.channels().stream().map(Channel::toString).toArray(String[]::new));
            } catch (HdfWritingException failed) { // as by a disk that is full: jHDF says so when it is closed, in a way of its own
                String why = failed.getCause() instanceof IOException system ? system.getMessage() : failed.getMessage();
                throw new FileSystemException(file.getParent().toString(), null,
                        "HDF5 is made here before it goes to its place, and cannot be written: " + why);
            }
            Files.copy(file, out);
        } finally {
            Files.delete(file);
        }
    }

    private static void put(WritableHdfFile hdf, String name, int length, IntToDoubleFunction values, String unit) {
        hdf.putDataset(name, IntStream.range(0, length).mapToDouble(values).toArray()).putAttribute("unit", unit);
    }

    private static Optional<String> text(Node node, String name) {
        Attribute attribute = node.getAttributes().get(name);
        return attribute == null ? Optional.empty() : Optional.of(attribute.getData().toString());
    }
}
