package wbv.recording.inspect;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.recording.DataFault;
import wbv.recording.format.RecordingFile;

/** A recording greater than the heap is inspected and laid on its clock as a stream, in a Java of its own. */
class FlatMemoryTest {

    private static final int HEAP = 24 << 20;
    private static final int CHANNELS = 30;

    @TempDir
    Path folder;

    /** What the other Java runs. */
    public static void main(String[] arguments) throws IOException {
        RecordingFile file = new RecordingFile(Path.of(arguments[0]));
        Inspection inspection = file.inspect();
        long samples = 0;
        try (UniformReader reader = file.uniform(inspection)) {
            double[] row = new double[1 + reader.channels().size()];
            while (reader.read(row)) {
                samples++;
            }
        }
        System.out.println(inspection.rows() + " " + samples + " " + Runtime.getRuntime().maxMemory());
        try {
            file.load(inspection);
        } catch (DataFault tooLarge) {
            System.out.println(tooLarge.getMessage());
        }
    }

    @Tag("slow")
    @Test
    void aFileGreaterThanTheHeapIsStreamed() throws IOException, InterruptedException {
        Path path = folder.resolve("large.csv");
        long rows = write(path);
        assertTrue(Files.size(path) > 2L * HEAP && 8L * CHANNELS * rows > HEAP);
        Process java = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-Xmx" + HEAP,
                "-cp", System.getProperty("java.class.path"), FlatMemoryTest.class.getName(), path.toString())
                .redirectErrorStream(true).start();
        String output = new String(java.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, java.waitFor(), output);
        assertTrue(output.startsWith(rows + " " + rows + " "), output);
        assertTrue(output.contains("read it as a stream"), output);
    }

    /** The same thousand rows of noise over and over, under new times. */
    private static long write(Path path) throws IOException {
        Random random = new Random(9);
        byte[][] tails = new byte[1000][];
        for (int i = 0; i < tails.length; i++) {
            StringBuilder tail = new StringBuilder();
            for (int j = 0; j < CHANNELS; j++) {
                tail.append(',').append(Math.rint(1e5 * random.nextGaussian()) / 1e5);
            }
            tails[i] = tail.append('\n').toString().getBytes(StandardCharsets.US_ASCII);
        }
        StringBuilder header = new StringBuilder("t");
        for (int j = 0; j < CHANNELS; j++) {
            header.append(",place_").append(j).append(".acc.z");
        }
        long rows = 200_000;
        try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(path), 1 << 16)) {
            out.write(header.append('\n').toString().getBytes(StandardCharsets.US_ASCII));
            for (int i = 0; i < rows; i++) {
                out.write(Double.toString(i / 100.0).getBytes(StandardCharsets.US_ASCII));
                out.write(tails[i % tails.length]);
            }
        }
        return rows;
    }
}
