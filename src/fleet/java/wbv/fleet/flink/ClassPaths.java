package wbv.fleet.flink;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * What processes are started with.
 *
 * @param machines of a cluster of our own: Flink, and no more of wbv than what starts it
 * @param client   that hands the job in
 * @param jars     that it sends to machines of our own
 * @param kafka    that it sends to machines of others besides: those of our own have them
 */
record ClassPaths(String machines, String client, List<Path> jars, List<Path> kafka) {

    /** Libraries that seats need. */
    private static final List<String> SEATS = List.of("commons-math3-", "ejml-", "jackson-", "moa-");
    /** What packets from Kafka need, and no cluster has. */
    private static final List<String> KAFKA = List.of("flink-connector-kafka-", "kafka-clients-", "lz4-java-", "snappy-java-", "zstd-jni-");
    /** What Flink needs and is among wbv's libraries already. */
    private static final List<String> SHARED = List.of("slf4j-api-", "commons-math3-");

    /** Beside the jar that this class is in; from a folder of classes, everything that this process knows. */
    static ClassPaths here() {
        Path here;
        try {
            here = Path.of(ClassPaths.class.getProtectionDomain().getCodeSource().getLocation().toURI());
        } catch (URISyntaxException never) {
            throw new IllegalStateException(never);
        }
        if (Files.isDirectory(here)) {
            String all = System.getProperty("java.class.path");
            return new ClassPaths(all, all, List.of(), List.of());
        }
        Path target = here.getParent();
        List<Path> flink = jars(target.resolve("fleet-lib"), List.of(""));
        List<Path> machines = new ArrayList<>(flink);
        machines.addAll(jars(target.resolve("lib"), SHARED));
        machines.add(here);
        List<Path> sent = new ArrayList<>(List.of(here, target.resolve("wbv.jar")));
        sent.addAll(jars(target.resolve("lib"), SEATS));
        List<Path> client = new ArrayList<>(sent);
        client.addAll(machines);
        return new ClassPaths(joined(machines), joined(client), sent, jars(target.resolve("fleet-lib"), KAFKA));
    }

    private static List<Path> jars(Path folder, List<String> beginnings) {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> beginnings.stream().anyMatch(file.getFileName().toString()::startsWith)).sorted().toList();
        } catch (IOException missing) {
            throw new UncheckedIOException(missing);
        }
    }

    /** Everything that machines of others are sent. */
    List<Path> all() {
        List<Path> all = new ArrayList<>(jars);
        all.addAll(kafka);
        return all;
    }

    private static String joined(List<Path> jars) {
        return jars.stream().map(Path::toString).collect(Collectors.joining(File.pathSeparator));
    }
}
