package wbv.fleet.flink;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** Java processes of one run, each with a log of its own. Closing ends them all. */
final class Processes implements AutoCloseable {

    private final Path logs;
    private final List<Process> all = new ArrayList<>();
    private boolean closed;

    /** @param logs folder for what they say */
    Processes(Path logs) throws IOException {
        this.logs = Files.createDirectories(logs);
    }

    /** Where the logs are. */
    Path folder() {
        return logs;
    }

    Path log(String name) {
        return logs.resolve(name + ".log");
    }

    /**
     * Starts one.
     *
     * @param options of Java and the class path, main class and its arguments
     */
    synchronized Process start(String name, List<String> options) throws IOException {
        if (closed) {
            throw new IOException("the run was stopped");
        }
        List<String> words = new ArrayList<>();
        words.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        words.addAll(options);
        Process process = new ProcessBuilder(words).redirectErrorStream(true)
                .redirectOutput(ProcessBuilder.Redirect.appendTo(log(name).toFile())).start();
        all.add(process);
        return process;
    }

    @Override
    public synchronized void close() {
        closed = true;
        all.forEach(Process::destroyForcibly);
        for (Process each : all) {
            try {
                each.waitFor(10, TimeUnit.SECONDS);
            } catch (InterruptedException stopped) {
                Thread.currentThread().interrupt();
            }
        }
    }
}
