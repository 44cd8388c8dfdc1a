package wbv.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import picocli.CommandLine.Option;
import wbv.result.OutputFolder;

/** Where a command puts its results. */
final class ResultFolder {

    @Option(names = "--out", paramLabel = "DIR", defaultValue = "out", description = "folder for the results (${DEFAULT-VALUE})")
    private Path path;

    Path path() {
        return path;
    }

    /** Opens the folder, into which results come all at once or not at all. */
    OutputFolder open() throws IOException {
        return OutputFolder.at(path);
    }

    /** What a result of this name holds, once it is there. */
    Answer.Json json(String name) {
        return () -> Files.readString(path.resolve(name));
    }

    /** Where a result of this name lies. */
    Path file(String name) {
        return path.resolve(name);
    }
}
