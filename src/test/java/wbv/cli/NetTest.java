package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.network.WithEngine;

/** The commands {@code net train}, {@code evaluate} and {@code predict}, from words to files. */
class NetTest {

    private static final String LINEAR = "data/arff/one-dof-linear.arff";

    @TempDir
    private Path folder;

    /** 5 Hz and 0.35, says the truth beside the recording. */
    @Test
    void theModelThatShipsReadsTheBodyThatTheRigHas() throws IOException {
        WithEngine.orSkip();
        Path out = folder.resolve("out");
        Run run = Run.of("net", "predict", LINEAR, "--input", "platform.acc.z", "--output", "head.acc.z", "--hop", "1", "--out",
                out.toString());
        assertEquals(0, run.code(), run.err());
        List<String> lines = Files.readAllLines(out.resolve("readings.csv"));
        assertEquals("t,damping,damping_deviation,frequency_Hz,frequency_deviation_Hz,network_damping,network_damping_deviation,"
                + "network_frequency_Hz,network_frequency_deviation_Hz,misfit", lines.get(0));
        double[][] rows = lines.stream().skip(1).map(line -> Arrays.stream(line.split(",")).mapToDouble(Double::parseDouble)
                .toArray()).toArray(double[][]::new);
        assertTrue(rows.length > 50, rows.length + " windows");
        assertEquals(5, Arrays.stream(rows).mapToDouble(row -> row[3]).average().orElseThrow(), 0.2);
        assertEquals(0.35, Arrays.stream(rows).mapToDouble(row -> row[1]).average().orElseThrow(), 0.03);
        long held = Arrays.stream(rows).filter(row -> Math.abs(row[3] - 5) < 1.645 * row[4]).count();
        assertTrue(held > 0.7 * rows.length, held + " of " + rows.length + " intervals of 90 % hold 5 Hz");
        assertTrue(Files.readString(out.resolve("report.html")).contains("Natural frequency"));
    }

    @Tag("slow")
    @Test
    void aModelIsTrainedEvaluatedAndUsed() throws IOException {
        WithEngine.orSkip();
        for (String name : List.of("a", "b")) {
            Run run = Run.of("net", "train", "--images", "60", "--epochs", "2", "--network", "cnn", "--out",
                    folder.resolve(name).toString());
            assertEquals(0, run.code(), run.err());
        }
        Path model = folder.resolve("a").resolve("model.safetensors");
        assertArrayEquals(Files.readAllBytes(model), Files.readAllBytes(folder.resolve("b").resolve("model.safetensors")));
        assertEquals(3, Files.readAllLines(folder.resolve("a").resolve("losses.csv")).size());
        assertTrue(Files.readString(folder.resolve("a").resolve("report.html")).contains("Loss over the epochs"));
        Path out = folder.resolve("evaluated");
        Run evaluated = Run.of("net", "evaluate", "--model", model.toString(), "--trials", "20", "--ridge", "0", "--out",
                out.toString());
        assertEquals(0, evaluated.code(), evaluated.err());
        String table = Files.readString(out.resolve("evaluation.csv"));
        for (String method : List.of("cnn, 60 images", "cnn, 60 images, then fitted", "fit in frequency",
                "refined instruments", "ekf-adwin", "fused", "the mean of all")) {
            assertTrue(table.contains("1-dof,\"" + method + "\",ζ"), method + " in " + table);
        }
    }

    /** 40 times the noise is told in words; on the rig's own body the words say that all is as it should be. */
    @Test
    void aWindowUnlikeAnythingTrainedOnIsToldInWords() throws IOException {
        WithEngine.orSkip();
        Run usual = Run.of("net", "predict", LINEAR, "--input", "platform.acc.z", "--output", "head.acc.z", "--out",
                folder.resolve("usual").toString());
        assertTrue(usual.out().contains("The windows are like those that the network was trained on"), usual.out());
        Path noisy = folder.resolve("noisy.csv");
        assertEquals(0, Run.of("simulate", "sitter=one-dof", "seconds=20", "noise=40", "--out", noisy.toString()).code());
        Run told = Run.of("net", "predict", noisy.toString(), "--input", "platform.acc.z", "--output", "head.acc.z", "--out",
                folder.resolve("told").toString());
        assertEquals(0, told.code(), told.err());
        assertTrue(told.out().startsWith("No value: "), told.out());
        assertFalse(told.out().contains("±"), told.out());
        assertFalse(new ObjectMapper().readTree(folder.resolve("told").resolve("results.json").toFile()).get("holds").asBoolean());
        assertTrue(told.out().contains("unlike anything that the network was trained on"), told.out());
        assertTrue(Files.readString(folder.resolve("told").resolve("report.html")).contains("unlike anything"));
    }

    /** Without a sensor at the seat: the recording needs no exciting channel. */
    @Test
    void theAnswerAloneIsReadWhereTheNetworkSeesNoMore() throws IOException {
        WithEngine.orSkip();
        Run run = Run.of("net", "train", "--images", "60", "--epochs", "2", "--network", "answer-only", "--out",
                folder.resolve("model").toString());
        assertEquals(0, run.code(), run.err());
        Run read = Run.of("net", "predict", LINEAR, "--model", folder.resolve("model").resolve("model.safetensors").toString(),
                "--out", folder.resolve("out").toString());
        assertEquals(0, read.code(), read.err());
        assertTrue(read.out().startsWith("Not checked: without the excitation nobody can say"), read.out());
    }

    @Test
    void whatDoesNotFitIsOneLine() throws IOException {
        WithEngine.orSkip();
        assertEquals(2, Run.of("net").code());
        assertEquals(2, Run.of("net", "train", "--network", "oracle").code());
        assertEquals(2, Run.of("net", "train", "--images", "3").code());
        Path out = folder.resolve("no");
        Path model = Files.write(folder.resolve("model.safetensors"), new byte[] {1, 2, 3});
        oneLine("is no safetensors file", "net", "predict", LINEAR, "--model", model.toString(), "--out", out.toString());
        oneLine("has no channel seat.acc.z", "net", "predict", LINEAR, "--out", out.toString());
        oneLine("trained on acc.z", "net", "predict", "data/arff/ride-subject1.arff", "--input", "seat.acc.x", "--output",
                "head.acc.z", "--out", out.toString());
        Path fast = folder.resolve("fast.csv");
        assertEquals(0, Run.of("simulate", "sitter=one-dof", "seconds=5", "rate=100", "--out", fast.toString()).code());
        oneLine("60.0 Hz alone", "net", "predict", fast.toString(), "--input", "platform.acc.z", "--out", out.toString());
        Path brief = folder.resolve("brief.csv");
        assertEquals(0, Run.of("simulate", "sitter=one-dof", "seconds=3", "--out", brief.toString()).code());
        oneLine("needs 219", "net", "predict", brief.toString(), "--input", "platform.acc.z", "--out", out.toString());
        assertFalse(Files.exists(out));
    }

    private static void oneLine(String words, String... arguments) {
        Run run = Run.of(arguments);
        assertEquals(1, run.code(), run.err());
        assertEquals(1, run.err().lines().count(), run.err());
        assertTrue(run.err().contains(words), run.err());
    }

    /** Without PyTorch's library 'net' says so in one line; without any of DJL 'analyze' works, for it loads none of it. */
    @Tag("slow")
    @Test
    void withoutTheLibraryEverythingElseWorks() throws Exception {
        Path out = folder.resolve("out");
        Run net = without("pytorch-native", "net", "predict", LINEAR, "--input", "platform.acc.z", "--out", out.toString());
        assertEquals(1, net.code(), net.err());
        assertEquals(1, net.err().lines().count(), net.err());
        assertTrue(net.err().contains("Everything else works without"), net.err());
        assertFalse(Files.exists(out));
        Run analyze = without("ai/djl", "analyze", LINEAR, "--out", out.toString());
        assertEquals(0, analyze.code(), analyze.err());
        assertTrue(Files.exists(out.resolve("report.html")));
    }

    private static Run without(String jar, String... arguments) throws Exception {
        String path = Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
                .filter(entry -> !entry.replace(File.separatorChar, '/').contains(jar))
                .collect(Collectors.joining(File.pathSeparator));
        List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
                path,
                "wbv.cli.Main"));
        command.addAll(List.of(arguments));
        Path err = Files.createTempFile("wbv", ".txt");
        Process process = new ProcessBuilder(command).redirectError(err.toFile()).redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .start();
        assertTrue(process.waitFor(120, TimeUnit.SECONDS));
        String text = Files.readString(err, StandardCharsets.UTF_8);
        Files.delete(err);
        return new Run(process.exitValue(), "", text);
    }
}
