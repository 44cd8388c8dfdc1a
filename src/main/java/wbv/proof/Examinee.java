package wbv.proof;

import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStreamWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import wbv.recording.AtomicFile;

/** A {@link Worker} in a Java process of its own, begun again when it dies or thinks too long. */
final class Examinee implements Closeable {

    private final Path home;
    private Process process;
    private BufferedWriter to;
    private BufferedReader from;

    /** @param home where it works; keys lie elsewhere */
    Examinee(Path home) {
        this.home = home;
    }

    /**
     * Asks about one folder and waits for {@code answer.json} in it.
     *
     * @param limit for the answer [s]
     */
    void ask(Path folder, long limit) throws IOException {
        if (process == null || !process.isAlive()) {
            begin();
        }
        long start = System.nanoTime();
        String why;
        try {
            to.write(folder.toAbsolutePath() + "\n");
            to.flush();
            BufferedReader answers = from;
            String line = CompletableFuture.supplyAsync(() -> read(answers)).get(limit, TimeUnit.SECONDS);
            if (!line.isEmpty()) {
                return;
            }
            why = "the process died";
        } catch (TimeoutException e) {
            why = "no answer within " + limit + " s";
        } catch (IOException | ExecutionException e) {
            why = "the process died: " + e.getMessage();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted", e);
        }
        close();
        AtomicFile.write(folder.resolve("answer.json"), ProofAnswer.failed(why, (System.nanoTime() - start) / 1e9).json());
    }

    private void begin() throws IOException {
        Path java = Path.of(System.getProperty("java.home"), "bin", "java");
        String[] entries = System.getProperty("java.class.path").split(File.pathSeparator);
        StringBuilder path = new StringBuilder();
        for (String entry : entries) {
            path.append(path.isEmpty() ? "" : File.pathSeparator).append(Path.of(entry).toAbsolutePath());
        }
        process = new ProcessBuilder(java.toString(), "-Xmx1500m", "-cp", path.toString(), Worker.class.getName())
                .directory(home.toFile()).redirectError(home.resolve("worker.log").toFile()).start();
        to = new BufferedWriter(new OutputStreamWriter(process.getOutputStream(), StandardCharsets.UTF_8));
        from = new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
    }

    private static String read(BufferedReader in) {
        try {
            String line = in.readLine();
            return line == null ? "" : line;
        } catch (IOException e) {
            return "";
        }
    }

    @Override
    public void close() {
        if (process != null) {
            process.destroyForcibly().onExit().join();   // or the next question would be put to a dying process
        }
    }
}
