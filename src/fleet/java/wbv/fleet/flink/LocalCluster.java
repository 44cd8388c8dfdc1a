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

/** One JobManager and some TaskManagers, processes of this computer that hear nobody else. A TaskManager that died is replaced. */
final class LocalCluster {

    private static final long PATIENCE = 180_000; // ms; a machine that is busy with something else takes a minute
    private static final int MOST_REPLACED = 20;

    private final Processes processes;
    private final ClassPaths classes;
    private final Path settings;
    private final Consumer<String> tell;
    private final RestPort rest;
    private final Process jobManager;
    private final List<Process> workers = new ArrayList<>();
    private int started;

    /** Starts it. Returns when all its workers are there. @param folder for its settings and temporary files */
    LocalCluster(Processes processes, ClassPaths classes, Path folder, int workers, Consumer<String> tell)
            throws IOException, InterruptedException {
        this.processes = processes;
        this.classes = classes;
        this.tell = tell;
        this.settings = Files.createDirectories(folder.resolve("conf"));
        Path temporary = Files.createDirectories(folder.resolve("tmp"));
        List<Integer> ports = freePorts(2);
        this.rest = new RestPort("localhost", ports.get(1));
        Files.writeString(settings.resolve("config.yaml"), """
                jobmanager.rpc.address: localhost
                jobmanager.rpc.port: %d
                jobmanager.bind-host: localhost
                jobmanager.memory.process.size: 1000m
                rest.address: localhost
                rest.bind-address: localhost
                rest.port: %d
                rest.bind-port: %2$d
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
                """.formatted(ports.get(0), rest.port(), temporary));
        this.jobManager = start("jobmanager", "-Xmx512m", List.of("jobmanager", "--configDir", settings.toString()));
        for (int k = 0; k < workers; k++) {
            this.workers.add(worker());
        }
        long until = System.currentTimeMillis() + PATIENCE;
        OptionalInt free = rest.free();
        while (free.orElse(0) < workers) {
            keep();
            if (System.currentTimeMillis() > until) {
                throw new IOException("the cluster did not start within " + PATIENCE / 1000 + " s; see " + processes.log("jobmanager"));
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

    private Process worker() throws IOException {
        String name = "taskmanager-" + ++started;
        return start(name, "-Xmx1000m", List.of("taskmanager", "--configDir", settings.toString(), "-D",
                "taskmanager.resource-id=" + name));
    }

    /** Replaces workers that died. @throws IOException if what takes orders died, or workers die again and again */
    void keep() throws IOException {
        if (!jobManager.isAlive()) {
            throw new IOException("the cluster's JobManager ended; see " + processes.log("jobmanager"));
        }
        for (int k = 0; k < workers.size(); k++) {
            if (!workers.get(k).isAlive()) {
                if (started >= workers.size() + MOST_REPLACED) {
                    throw new IOException("the cluster's workers die again and again; see " + processes.log("taskmanager-" + started));
                }
                workers.set(k, worker());
                tell.accept("wbv: a worker died; another takes its place");
            }
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
