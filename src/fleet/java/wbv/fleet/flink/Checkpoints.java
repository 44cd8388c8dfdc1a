package wbv.fleet.flink;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** What jobs of one run kept on their way. */
final class Checkpoints {

    private static final String NAME = "chk-";
    private static final String WHOLE = "_metadata";

    private Checkpoints() {}

    /**
     * The newest that is whole.
     *
     * @param folder of one folder for each job, the jobs of one run one after the other
     */
    static Optional<Path> newest(Path folder) throws IOException {
        if (!Files.isDirectory(folder)) {
            return Optional.empty();
        }
        try (Stream<Path> all = Files.walk(folder, 2)) {
            List<Path> whole = all.filter(each -> each.getFileName().toString().startsWith(NAME) && Files.exists(each.resolve(WHOLE)))
                    .sorted(Comparator.comparingLong(Checkpoints::written).thenComparingLong(Checkpoints::number)).toList();
            return whole.isEmpty() ? Optional.empty() : Optional.of(whole.get(whole.size() - 1));
        }
    }

    private static long number(Path checkpoint) {
        return Long.parseLong(checkpoint.getFileName().toString().substring(NAME.length()));
    }

    private static long written(Path checkpoint) {
        return checkpoint.resolve(WHOLE).toFile().lastModified();
    }
}
