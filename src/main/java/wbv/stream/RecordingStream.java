package wbv.stream;

import com.github.javacliparser.FileOption;
import com.github.javacliparser.MultiChoiceOption;
import com.github.javacliparser.StringOption;
import com.yahoo.labs.samoa.instances.Instance;
import com.yahoo.labs.samoa.instances.InstancesHeader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import moa.core.Example;
import moa.core.ObjectRepository;
import moa.options.AbstractOptionHandler;
import moa.streams.InstanceStream;
import moa.tasks.TaskMonitor;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.RowReader;
import wbv.recording.format.ColumnMap;
import wbv.recording.format.PipedReader;
import wbv.recording.format.ReadOptions;
import wbv.recording.format.RecordingFile;
import wbv.recording.inspect.Inspection;

/**
 * A recording as a MOA stream, laid on its uniform clock; samples that it lacks are missing values, or left out. Standard input and pipes
 * are streamed as they come, once, without an end if they have none.
 */
public class RecordingStream extends AbstractOptionHandler implements InstanceStream {

    private static final long serialVersionUID = 1;

    public final FileOption fileOption = new FileOption("file", 'f',
            "The recording: CSV, ARFF, either as .gz, or any table with a map; '-' for standard input, or a pipe, once and as it comes.",
            "recording.csv", "csv", false);
    public final StringOption inputOption = new StringOption("input", 'i',
            "Input channels, separated by commas.", "platform.acc.z");
    public final StringOption outputOption = new StringOption("output", 'o',
            "Output channel: the class attribute.", "head.acc.z");
    public final FileOption mapOption = new FileOption("map", 'm',
            "JSON file that says which columns of a foreign table are which channels.", null, "json", false);
    /** What becomes of samples that the recording lacks. */
    public final MultiChoiceOption lostOption = Lost.option();

    private RowInstances instances;
    private long length;
    private boolean passing;

    @Override
    public String getPurposeString() {
        return "A recording of inertial sensors, on a uniform clock.";
    }

    @Override
    protected void prepareForUseImpl(TaskMonitor monitor, ObjectRepository repository) {
        File file = new File(fileOption.getValue(), mapOption.getValue() == null ? "" : mapOption.getValue());
        List<Channel> inputs = Arrays.stream(inputOption.getValue().split(",")).map(Channel::parse).toList();
        Channel output = Channel.parse(outputOption.getValue());
        String relation = getCLICreationString(InstanceStream.class);
        try {
            passing = file.isPipe();
            if (passing) {
                instances = new RowInstances(relation, new Passing(file.path(), file.piped()), inputs, output, Lost.of(lostOption));
                return;
            }
            Inspection inspection = file.source().inspect();
            length = inspection.samples();
            inputs.forEach(inspection::require);
            inspection.require(output);
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
        instances = new RowInstances(relation, file, inputs, output, Lost.of(lostOption));
    }

    /** Rows that pass once: opened again they go on where they are, and a copy has none. */
    private static final class Passing implements RowInstances.Rows {

        private static final long serialVersionUID = 1;

        private final String name;
        private final transient RowReader rows;

        private Passing(String name, RowReader rows) {
            this.name = name;
            this.rows = rows;
        }

        @Override
        public boolean passes() {
            return true;
        }

        @Override
        public RowReader open() {
            if (rows == null) {
                throw DataFault.in(name, "is a stream that passes once; it cannot be read again or copied");
            }
            return rows;
        }
    }

    /**
     * Names of files, which serialise where open files do not.
     *
     * @param map empty where there is none
     */
    private record File(String path, String map) implements RowInstances.Rows {

        RecordingFile source() throws IOException {
            return new RecordingFile(Path.of(path), options());
        }

        /** Whether it can be read once only. */
        private boolean isPipe() {
            return path.equals("-")
                    || Files.exists(Path.of(path)) && !Files.isRegularFile(Path.of(path)) && !Files.isDirectory(Path.of(path));
        }

        private RowReader piped() throws IOException {
            return path.equals("-") ? new PipedReader("standard input", System.in, options())
                    : new PipedReader(path, Files.newInputStream(Path.of(path)), options());
        }

        private ReadOptions options() throws IOException {
            Optional<ColumnMap> columns = map.isEmpty() ? Optional.empty() : Optional.of(ColumnMap.read(Path.of(map)));
            return new ReadOptions(columns, ReadOptions.DEFAULT.rate(), ReadOptions.DEFAULT.locations());
        }

        @Override
        public RowReader open() throws IOException {
            RecordingFile source = source();
            return source.uniform(source.inspect());
        }
    }

    @Override
    public InstancesHeader getHeader() {
        return instances.header();
    }

    @Override
    public boolean hasMoreInstances() {
        return instances.hasMore();
    }

    @Override
    public Example<Instance> nextInstance() {
        return instances.next();
    }

    /** Samples left, from the first inspection; exact but for samples that repeat others or are left out. -1 where nobody knows. */
    @Override
    public long estimatedRemainingInstances() {
        return passing ? -1 : Math.max(0, length - instances.taken());
    }

    @Override
    public boolean isRestartable() {
        return !passing;
    }

    @Override
    public void restart() {
        instances.restart();
    }

    @Override
    public void getDescription(StringBuilder out, int indent) {
        out.append(getPurposeString());
    }
}
