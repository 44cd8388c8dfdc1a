package wbv.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import wbv.recording.AtomicFile;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.RowReader;
import wbv.recording.format.MapDraft;
import wbv.recording.format.RecordingFile;
import wbv.result.ResultsJson;
import wbv.study.AnalysisRequest;

/** {@code wbv map}: drafts the column map of a file whose columns nobody has named. */
@Command(name = "map", mixinStandardHelpOptions = true,
        description = "Drafts the column map of a foreign table, or of a UFF, MAT, HDF5, Parquet or WAV file that does not say "
                + "all: guesses time, units, axes and places from names and numbers, shows what it took each column for, asks what it "
                + "could not know, and writes the map as JSON.",
        footer = {"", "Examples:", "  wbv map phone.csv", "  wbv analyze phone.csv --map phone.map.json"})
final class MapColumns implements Callable<Integer> {

    @Parameters(paramLabel = "FILE", description = "CSV or other table of text, UFF, MAT, HDF5, Parquet or WAV")
    private Path file;

    @Option(names = "--out", paramLabel = "FILE", description = "the map to write (beside the file, ending in .map.json)")
    private Optional<Path> out = Optional.empty();

    @Mixin
    private Answer answer;

    /** What there is to say of a file that needs no map. */
    private record Named(List<String> channels) {}

    @Override
    public Integer call() throws IOException {
        if (out.isEmpty()) {
            try (RowReader reader = new RecordingFile(file).open()) {
                List<String> channels = reader.channels().stream().map(Channel::toString).toList();
                answer.print(file + " needs no map; its channels are " + String.join(", ", channels) + "\n", "",
                        () -> ResultsJson.render(new Named(channels)));
                return 0;
            } catch (DataFault unknown) {
                // That is why a map is asked for.
            }
        }
        MapDraft draft = MapDraft.of(file);
        Path map = out.orElseGet(this::beside);
        if (out.isEmpty() && Files.exists(map)) {
            throw DataFault.in(map.toString(), "is there already and may have been mended by hand; remove it or name another with --out");
        }
        String json = draft.json(file.getFileName().toString());
        AtomicFile.write(map, json);
        StringBuilder text = new StringBuilder(file.getFileName() + " is " + draft.where() + ".\n");
        draft.lines().forEach(line -> text.append("  ").append(line).append('\n'));
        draft.questions().forEach(question -> text.append("QUESTION: ").append(question).append('\n'));
        boolean moved = draft.command().equals("analyze") && AnalysisRequest.usualInput(draft.drafted()).isEmpty();
        List<String> command = List.of((draft.command() + (moved ? " --input CHANNEL, the one that moves the rest" : "")).split(" ", 2));
        answer.print(text.toString(), "Wrote " + map + (draft.questions().isEmpty() ? "" : "; answer its questions in it") + ". Then: wbv "
                + command.get(0) + " " + file + " --map " + map + (command.size() > 1 ? " " + command.get(1) : "") + "\n", () -> json);
        return 0;
    }

    private Path beside() {
        String name = file.getFileName().toString();
        int dot = name.indexOf('.');
        return file.resolveSibling((dot > 0 ? name.substring(0, dot) : name) + ".map.json");
    }
}
