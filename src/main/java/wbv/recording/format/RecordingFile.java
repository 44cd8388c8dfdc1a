package wbv.recording.format;

import java.io.IOException;
import java.nio.file.Path;
import wbv.recording.DataFault;
import wbv.recording.RowReader;
import wbv.recording.inspect.RowSource;

/**
 * A recording in a file, in any format that is known, recognised by its content.
 *
 * @param path    the file; gzip or not
 * @param options what the user says about it
 */
public record RecordingFile(Path path, ReadOptions options) implements RowSource {

    /** A file about which nothing is said. */
    public RecordingFile(Path path) {
        this(path, ReadOptions.DEFAULT);
    }

    @Override
    public RowReader open() throws IOException {
        Source source = Source.open(path);
        try {
            Sidecar sidecar = Sidecar.of(path);
            Format format = Format.of(Head.of(source), options);
            if (!sidecar.units().isEmpty() && format.statesUnits()) {
                throw DataFault.in(Sidecar.beside(path).toString(), "'units' is about a CSV or ARFF that is named as ours are; " + path
                        + " has its units from " + (options.map().isPresent() ? "the map" : "what it says itself"));
            }
            RowReader reader = format.open(source, new Context(path, options, sidecar));
            return SignedReader.of(reader, sidecar, path);
        } catch (DataFault | IOException failed) {
            source.close();
            throw failed;
        }
    }

    /** The file, as messages name it. */
    @Override
    public String toString() {
        return path.toString();
    }
}
