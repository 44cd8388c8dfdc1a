package wbv.recording.format;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import wbv.recording.DataFault;
import wbv.recording.RowReader;
import wbv.recording.inspect.RowSource;

/** Files of one sensor each that are one recording, joined by {@link MergedReader}. */
public record RecordingSet(List<RecordingFile> files) implements RowSource {

    public RecordingSet {
        files = List.copyOf(files);
        if (files.isEmpty()) {
            throw new IllegalArgumentException("a set needs at least one file");
        }
    }

    @Override
    public RowReader open() throws IOException {
        List<RowReader> readers = new ArrayList<>();
        try {
            for (RecordingFile file : files) {
                readers.add(file.bounded());
            }
            return new MergedReader(readers);
        } catch (DataFault | IOException failed) {
            for (RowReader reader : readers) {
                reader.close();
            }
            throw failed;
        }
    }

    /** The files, as messages name them. */
    @Override
    public String toString() {
        return files.size() == 1 ? files.get(0).toString() : files.get(0) + " and " + (files.size() - 1) + " more";
    }
}
