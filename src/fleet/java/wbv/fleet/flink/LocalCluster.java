package wbv.fleet.flink;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.function.Consumer;

/**
 * One JobManager and some TaskManagers, processes of this computer that hear nobody else, and a keeper (ZooKeeper) that knows what
 * the JobManager does. Any of them that dies is replaced: a JobManager goes on with the job of the one before.
 */
final class LocalCluster {

    private static final long PATIENCE = 180_000; // ms; a machine that is busy with something else takes a minute
    private static final int MOST_REPLACED = 20;

    private final Processes processes;
    private final ClassPaths classes;
    private final Path settings;
    private final Consumer<String> tell;
    private final RestPort rest;
    private final Path keeperSettings;
    private Process keeper;
    private Process jobManager;
    private final List<Process> workers = new ArrayList<>();
    private int started;
    private int replaced;

    /**
     * Starts it. Returns when all its workers are there.
     *
     * @param folder for its settings and temporary files
     */
    LocalCluster(Processes processes, ClassPaths classes, Path folder, int workers, Consumer<String> tell)
            throws IOException, InterruptedException {
        this.processes = processes;
        this.classes = classes;
        this.tell = tell;
        this.settings = Files.createDirectories(folder.resolve("conf"));
        Path temporary = Files.createDirectories(folder.resolve("tmp"));
        List<Integer> ports = freePorts(3);
        this.rest = new RestPort("localhost", ports.get(1));
        Files.writeString(settings.resolve("config.yaml"), """
                jobmanager.rpc.address: localhost
                high-availability.type: zookeeper
                high-availability.zookeeper.quorum: localhost:%d
                high-availability.zookeeper.client.session-timeout: 10s
                high-availability.zookeeper.client.tolerate-suspended-connections: true
                high-availability.cluster-id: /wbv-fleet
                high-availability.storageDir: %s
                jobmanager.bind-host: localhost
                jobmanager.memory.process.size: 1000m
                rest.address: localhost
                rest.bind-address: localhost
                rest.port: %d
                rest.bind-port: %3$d
                taskmanager.host: localhost
                taskmanager.bind-host: localhost
                taskmanager.numberOfTaskSlots: 1
                taskmanager.cpu.cores: 1
                taskmanager.memory.framework.heap.size: 64m
                taskmanager.memory.framework.off-heap.size: 64m
                taskmanager.memory.task.heap.size: 900m
                taskmanager.memory.task.off-heap.size: 0b
                taskmanager.memory.managed.size: 32m
                taskmanager.memory.network.min: 64m
                taskmanager.memory.network.max: 64m
                taskmanager.memory.jvm-metaspace.size: 128m
                taskmanager.memory.jvm-overhead.min: 64m
                taskmanager.memory.jvm-overhead.max: 64m
                taskmanager.network.memory.buffer-debloat.enabled: true
                external-resources: none
                heartbeat.interval: 3s
                heartbeat.timeout: 20s
                io.tmp.dirs: %s
                """.formatted(ports.get(0), folder.resolve("kept").toUri(), rest.port(), temporary));
        this.keeperSettings = settings.resolve("keeper.cfg");
        Files.writeString(keeperSettings, """
                dataDir=%s
                clientPort=%d
                clientPortAddress=127.0.0.1
                admin.enableServer=false
                server.1=localhost:%d:%d
                """.formatted(Files.createDirectories(folder.resolve("keeper")), ports.get(0), ports.get(0) + 1, ports.get(0) + 2));
        this.keeper = keeper();
        this.jobManager = jobManager();
        for (int k = 0; k < workers; k++) {
            this.workers.add(worker());
        }
        long until = System.currentTimeMillis() + PATIENCE;
        OptionalInt free = rest.free();
        while (free.orElse(0) < workers) {
            keep();
            if (System.currentTimeMillis() > until) {
                throw new IOException("the cluster did not start within " + PATIENCE / 1000 + " s; see " + processes.folder());
            }
            Thread.sleep(300);
            free = rest.free();
        }
    }

    RestPort rest() {
        return rest;
    }

    /** The workers, as processes. */
    List<Process> workers() {
        return List.copyOf(workers);
    }

    private Process start(String name, String memory, List<String> words) throws IOException {
        List<String> options = new ArrayList<>(List.of(memory, "-XX:+UseSerialGC", "-cp", classes.machines(),
                Machine.class.getName()));
        options.addAll(words);
        return processes.start(name, options);
    }

    private Process keeper() throws IOException {
        return start("keeper", "-Xmx64m", List.of("keeper", "--zkConfigFile", keeperSettings.toString(), "--peerId", "1"));
    }

    private Process jobManager() throws IOException {
        return start("jobmanager-" + ++started, "-Xmx512m", List.of("jobmanager", "--configDir", settings.toString()));
    }

    /** The one that takes orders. */
    Process jobManagerProcess() {
        return jobManager;
    }

    private Process worker() throws IOException {
        String name = "taskmanager-" + ++started;
        return start(name, "-Xmx1000m", List.of("taskmanager", "--configDir", settings.toString(), "-D",
                "taskmanager.resource-id=" + name));
    }

    /**
     * Replaces processes that died.
     *
     * @throws IOException if they die again and again
     */
    void keep() throws IOException {
        if (!keeper.isAlive()) {
            requireFew();
            keeper = keeper();
            tell.accept("wbv: the cluster's keeper died; another takes its place");
        }
        if (!jobManager.isAlive()) {
            requireFew();
            jobManager = jobManager();
            tell.accept("wbv: the JobManager died; another takes its place");
        }
        for (int k = 0; k < workers.size(); k++) {
            if (!workers.get(k).isAlive()) {
                requireFew();
                workers.set(k, worker());
                tell.accept("wbv: a worker died; another takes its place");
            }
        }
    }

    private void requireFew() throws IOException {
        if (++replaced > MOST_REPLACED) {
            throw new IOException("the cluster's processes die again and again; see " + processes.folder());
        }
    }

    private static List<Integer> freePorts(int count) throws IOException {
        List<ServerSocket> sockets = new ArrayList<>();
        List<Integer> ports = new ArrayList<>();
        try {
            for (int k = 0; k < count; k++) {
                ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
                sockets.add(socket);
                ports.add(socket.getLocalPort());
            }
        } finally {
            for (ServerSocket socket : sockets) {
                socket.close();
            }
        }
        return ports;
    }
}
