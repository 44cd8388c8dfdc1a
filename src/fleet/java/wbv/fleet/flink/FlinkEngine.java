package wbv.fleet.flink;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import wbv.fleet.FleetEngine;
import wbv.fleet.FleetOrder;
import wbv.fleet.FleetSource;
import wbv.fleet.FleetTable;
import wbv.fleet.ResultRows;
import wbv.recording.AtomicFile;
import wbv.recording.DataFault;

/** {@link FleetEngine} by Apache Flink. Flink itself runs in processes of its own, here or elsewhere, never in this one. */
public final class FlinkEngine implements FleetEngine {

    static final String PARTS = "fleet-parts";
    /** What a cluster of our own leaves, and another one does not need. */
    private static final List<String> BESIDE = List.of("conf", "tmp", "keeper", "kept");
    private static final List<String> ALL = List.of("conf", "tmp", "keeper", "kept", FleetJob.CHECKPOINTS, Topics.RESULTS, Topics.ALARMS,
            Topics.MACHINES, Topics.WORST, Topics.UNREAD, "log");

    /** What happens beside a run, now and then. */
    interface Meanwhile {
        void look() throws IOException;
    }

    @Override
    public void local(FleetOrder order, int machines, double between, Path out, Consumer<String> tell) throws IOException {
        local(order, machines, between, out, tell, cluster -> {});
    }

    /** @param see shown the cluster now and then while the job runs */
    void local(FleetOrder order, int machines, double between, Path out, Consumer<String> tell, Consumer<LocalCluster> see)
            throws IOException {
        ClassPaths classes = ClassPaths.here();
        run(order, between, out, tell, (processes, parts) -> {
            tell.accept("wbv: starting a cluster of " + (machines + 2) + " processes");
            LocalCluster cluster = new LocalCluster(processes, classes, parts, machines, tell);
            submit(processes, classes, classes.jars(), parts, cluster.rest(), machines, between, () -> {
                see.accept(cluster);
                cluster.keep();
            });
        });
    }

    @Override
    public void cluster(FleetOrder order, String address, double between, Path out, Consumer<String> tell) throws IOException {
        RestPort rest = RestPort.of(address);
        int free = rest.free().orElseThrow(() -> DataFault.in(address, "no cluster of Apache Flink answers there (its REST port)"));
        if (free == 0) {
            throw DataFault.in(address, "the cluster has no free slot; wait for its other jobs, or give it more workers");
        }
        ClassPaths classes = ClassPaths.here();
        run(order, between, out, tell,
                (processes, parts) -> submit(processes, classes, classes.all(), parts, rest, free, between, () -> {}));
    }

    private interface Work {
        void with(Processes processes, Path parts) throws IOException, InterruptedException;
    }

    private static void run(FleetOrder order, double between, Path out, Consumer<String> tell, Work work) throws IOException {
        Path parts = Files.createDirectories(out.toAbsolutePath().normalize().resolve(PARTS));
        try (FileChannel alone = FileChannel.open(parts.resolve("lock"), StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
            if (alone.tryLock() == null) {
                throw DataFault.in(parts.toString(), "is being written by another run; choose another --out, or wait for its end");
            }
            if (begin(order.bytes(), parts)) {
                tell.accept("wbv: going on where the run before stopped");
            }
            try (Processes processes = new Processes(parts.resolve("log"))) {
                Thread hook = new Thread(processes::close);
                Runtime.getRuntime().addShutdownHook(hook);
                try {
                    work.with(processes, parts);
                } catch (InterruptedException stopped) {
                    Thread.currentThread().interrupt();
                    throw new IOException("the run was interrupted; the same command goes on with it", stopped);
                } finally {
                    forget(hook);
                }
            }
            if (!(order.source() instanceof FleetSource.Topic)) {
                gather(order, parts, out, tell);
            }
        }
        delete(parts);
    }

    /**
     * Makes the folder ready.
     *
     * @return whether a run of the same order was stopped there, and left a checkpoint to go on with
     */
    private static boolean begin(byte[] order, Path parts) throws IOException {
        Path file = parts.resolve("order");
        boolean there = Files.exists(file);
        if (there && !Arrays.equals(order, Files.readAllBytes(file))) {
            throw DataFault.in(parts.toString(), "is where another run stopped; finish that, choose another --out, or delete it to begin"
                    + " anew");
        }
        boolean goesOn = there && Checkpoints.newest(parts.resolve(FleetJob.CHECKPOINTS)).isPresent();
        for (String left : goesOn ? BESIDE : ALL) {
            delete(parts.resolve(left));
        }
        AtomicFile.write(file, order);
        return goesOn;
    }

    static void gather(FleetOrder order, Path parts, Path out, Consumer<String> tell) throws IOException {
        ResultRows rows = new ResultRows(order.follow().plan());
        Gathered.write(parts.resolve(Topics.RESULTS), rows.header(), out.resolve("results.csv"));
        Gathered.write(parts.resolve(Topics.ALARMS), ResultRows.alarmHeader(), out.resolve("alarms.csv"));
        Gathered.writeTables(parts.resolve(Topics.MACHINES), FleetTable.MACHINES, out.resolve("machines.csv"));
        Gathered.writeTables(parts.resolve(Topics.WORST), FleetTable.WORST, out.resolve("worst.csv"));
        if (!Gathered.rows(parts.resolve(Topics.UNREAD)).isEmpty()) {
            int unread = Gathered.write(parts.resolve(Topics.UNREAD), ResultRows.unreadHeader(), out.resolve("unread.csv"));
            tell.accept("wbv: " + unread + " packets could not be read; they are in " + out.resolve("unread.csv"));
        }
    }

    private static void forget(Thread hook) {
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException runsAlready) {
            // and does what there is to do
        }
    }

    private static void submit(Processes processes, ClassPaths classes, List<Path> jars, Path parts, RestPort rest, int parallelism,
            double between, Meanwhile meanwhile) throws IOException, InterruptedException {
        List<String> words = new ArrayList<>(List.of("-Xmx512m", "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-cp", classes.client(),
                FleetJob.class.getName(), parts.resolve("order").toString(), parts.toString(), String.valueOf(parallelism),
                String.valueOf(Math.round(1000 * between)), rest.host(), String.valueOf(rest.port())));
        jars.forEach(jar -> words.add(jar.toString()));
        Process client = processes.start("client", words);
        while (client.isAlive()) {
            meanwhile.look();
            Thread.sleep(200);
        }
        if (client.exitValue() != 0) {
            throw new IOException("the job failed: " + reason(processes.log("client")) + "; see " + processes.log("client"));
        }
    }

    /** What was at the bottom of it. */
    private static String reason(Path log) throws IOException {
        try (Stream<String> lines = Files.lines(log)) {
            return lines.filter(line -> line.startsWith("Caused by: ")).reduce((first, second) -> second)
                    .map(line -> line.substring("Caused by: ".length())).orElse("its client ended");
        }
    }

    private static void delete(Path folder) {
        if (!Files.exists(folder)) {
            return;
        }
        try (Stream<Path> all = Files.walk(folder)) {
            for (Path each : all.sorted(Comparator.reverseOrder()).toList()) {
                Files.deleteIfExists(each);
            }
        } catch (IOException left) {
            // it is in the way of nothing
        }
    }
}
