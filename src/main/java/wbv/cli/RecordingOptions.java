package wbv.cli;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.Timer;
import java.util.TimerTask;
import java.util.TreeSet;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.RowReader;
import wbv.recording.format.ColumnMap;
import wbv.recording.format.ReadOptions;
import wbv.recording.format.RecordingFile;
import wbv.recording.format.RecordingSet;
import wbv.recording.inspect.RowSource;

/** How every command names its recording. */
final class RecordingOptions {

    /** How long standard input may go on before it is told that its end is waited for [ms]. */
    private static final long PATIENCE = 5000;

    @Parameters(paramLabel = "RECORDING", arity = "1..*",
            description = "CSV, ARFF, UFF 58, MAT, HDF5, Parquet, WAV, MT Manager, DOT or MVNX file, gzip or not; several files of one "
                    + "sensor each are joined; '-' reads standard input to its end")
    private List<String> names = new ArrayList<>();

    @Option(names = "--map", paramLabel = "FILE",
            description = "JSON that says which column of a foreign file is which channel; 'wbv map' drafts one")
    private Optional<Path> map = Optional.empty();

    @Option(names = "--rate", paramLabel = "HZ", description = "sampling rate, where the file does not state it")
    private Optional<Double> rate = Optional.empty();

    @Option(names = "--location", paramLabel = "SENSOR=PLACE",
            description = "where a sensor sat, by serial number, device tag or file name: --location 00B421EE=head")
    private Map<String, String> locations = new LinkedHashMap<>();

    @Spec(Spec.Target.MIXEE)
    private CommandSpec spec;

    private Optional<Path> spooled = Optional.empty();

    /** The recording that was named. Standard input is copied to a temporary file, since it is read twice. */
    RowSource source() throws IOException {
        List<RecordingFile> files = files();
        RowSource source = files.size() == 1 ? files.get(0) : new RecordingSet(files);
        requireLocations(source);
        return source;
    }

    /** The sampling rate that was said [Hz]. */
    Optional<Double> rate() {
        return rate;
    }

    /** The recordings that were named, each file by itself. */
    List<RowSource> each() throws IOException {
        return List.copyOf(files());
    }

    private List<RecordingFile> files() throws IOException {
        ReadOptions options = options();
        List<RecordingFile> files = new ArrayList<>();
        for (Path path : paths()) {
            files.add(new RecordingFile(path, options));
        }
        return files;
    }

    /** Another recording, read with the same options. */
    RowSource another(Path file) throws IOException {
        return new RecordingFile(file, options());
    }

    private ReadOptions options() throws IOException {
        if (rate.isPresent() && !Clock.isRate(rate.get())) {
            throw new ParameterException(spec.commandLine(),
                    "--rate must be " + Clock.SLOWEST + " to " + Clock.FASTEST + " Hz: " + rate.get());
        }
        return new ReadOptions(map.isPresent() ? Optional.of(ColumnMap.read(map.get())) : Optional.empty(),
                rate.map(OptionalDouble::of).orElseGet(OptionalDouble::empty), locations);
    }

    /** A place given to a sensor that no file has is a slip of the pen. */
    private void requireLocations(RowSource source) throws IOException {
        if (locations.isEmpty()) {
            return;
        }
        try (RowReader reader = source.open()) {
            Set<String> found = new TreeSet<>();
            reader.channels().forEach(channel -> found.add(channel.location()));
            for (Map.Entry<String, String> entry : locations.entrySet()) {
                if (!found.contains(entry.getValue())) {
                    throw new DataFault("--location " + entry.getKey() + "=" + entry.getValue() + ": no file has a sensor " + entry.getKey()
                            + "; the places are now " + found);
                }
            }
        }
    }

    /** The files that the recording is read from, and the map. */
    List<Path> inputs() throws IOException {
        List<Path> all = new ArrayList<>(paths());
        map.ifPresent(all::add);
        return all;
    }

    private List<Path> paths() throws IOException {
        List<Path> paths = new ArrayList<>();
        for (String name : names) {
            paths.add(name.equals("-") ? spool() : Path.of(name));
        }
        return paths;
    }

    private Path spool() throws IOException {
        if (spooled.isEmpty()) {
            Path folder = Files.createTempDirectory("wbv-");
            folder.toFile().deleteOnExit();
            Path file = folder.resolve("standard-input");
            file.toFile().deleteOnExit();
            if (standardInputIsClosed()) {
                throw new DataFault("standard input: is closed; pipe a recording into it");
            }
            // System.in is not closed behind it: where standard input was closed, its number is that of a file of Java's own.
            long bytes;
            Timer patience = new Timer(true);
            patience.schedule(new TimerTask() {
                @Override
                public void run() {
                    spec.commandLine().getErr()
                            .println("standard input: is read to its end before it is answered; 'wbv live -' follows it as it comes");
                }
            }, PATIENCE);
            try (OutputStream copy = Files.newOutputStream(file)) {
                bytes = System.in.transferTo(copy);
            } catch (FileSystemException named) {
                throw named;
            } catch (IOException failed) {
                throw new DataFault("standard input: cannot be copied to " + file + ": " + failed.getMessage(), failed);
            } finally {
                patience.cancel();
            }
            if (bytes == 0) {
                throw new DataFault("standard input: is empty; pipe a recording into it");
            }
            spooled = Optional.of(file);
        }
        return spooled.get();
    }

    /**
     * Whether standard input was closed when the program began: the first file that Java opens then takes its number, and that is
     * one of Java's own. Told where the system shows its open files (Linux); elsewhere that file is read and found to be no
     * recording.
     */
    static boolean standardInputIsClosed() throws IOException {
        Path input = Path.of("/proc/self/fd/0");
        return Files.isRegularFile(input) && input.toRealPath().startsWith(Path.of(System.getProperty("java.home")).toRealPath());
    }

    /** What to call the recording in a report and in file names. */
    String title() {
        return names.size() == 1 ? title(0) : Path.of(names.get(0)).getFileName() + " and " + (names.size() - 1) + " more";
    }

    /** What to call one of the files. */
    String title(int file) {
        return names.get(file).equals("-") ? "standard input" : Path.of(names.get(file)).getFileName().toString();
    }

    Optional<Path> map() {
        return map;
    }

    List<String> names() {
        return names;
    }
}
