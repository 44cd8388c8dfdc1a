package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Bad input gets one clear line and exit code 1, and leaves nothing behind. */
class BadInputTest {

    @TempDir
    private Path folder;

    static Stream<Arguments> badFiles() {
        String head = "t,platform.acc.z,head.acc.z\n";
        return Stream.of(
                Arguments.of("empty file", "", "empty"),
                Arguments.of("header only", head, "row"),
                Arguments.of("one sample", head + "0,1,2\n", "sample"),
                Arguments.of("text in a cell", head + "0,1,2\n0.1,1,2\n0.2,oops,2\n", "bad.csv:4"),
                Arguments.of("ragged row", head + "0,1,2\n0.1,1\n0.2,1,2\n", "bad.csv:3"),
                Arguments.of("missing channel", "t,seat.acc.x,head.acc.x\n0,1,2\n0.1,1,2\n0.2,1,2\n", "--input"),
                Arguments.of("channel without a number", head + "0,1,\n0.1,2,\n0.2,1,\n0.3,1,\n", "head.acc.z"),
                Arguments.of("twice the same column", "t,head.acc.z,head.acc.z\n0,1,2\n", "head.acc.z"),
                Arguments.of("foreign columns", "time_ms,Az\n0,1\n1,2\n", "--map"),
                Arguments.of("foreign ARFF", "@relation r\n@attribute colour {red,green}\n@data\nred\n", "colour"),
                Arguments.of("two clocks", head + rows(0, 60) + rows(0, 60), "clock"));
    }

    private static String rows(int from, int to) {
        StringBuilder rows = new StringBuilder();
        for (int i = from; i < to; i++) {
            rows.append(i / 60.0).append(',').append(Math.sin(i)).append(',').append(Math.cos(i)).append('\n');
        }
        return rows.toString();
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("badFiles")
    void oneLineAndExitCodeOne(String name, String content, String said) throws IOException {
        Path file = Files.writeString(folder.resolve("bad.csv"), content);
        refuses(file, said);
    }

    private void refuses(Path file, String said) {
        Path out = folder.resolve("out");
        Run run = Run.of("analyze", file.toString(), "--out", out.toString());
        assertEquals(1, run.code(), run.err());
        assertEquals(1, run.err().strip().lines().count(), run.err());
        assertTrue(run.err().startsWith("wbv: ") && run.err().contains(said), run.err());
        assertFalse(Files.exists(out), "something was left behind");
        assertEquals("", run.out());
        try (Stream<Path> left = Files.list(folder)) {
            assertEquals(0, left.filter(path -> path.getFileName().toString().startsWith(".")).count());
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void binaryFile() throws IOException {
        byte[] bytes = new byte[5000];
        new java.util.Random(1).nextBytes(bytes);
        refuses(Files.write(folder.resolve("bad.mtb"), bytes), "bad.mtb");
    }

    @Test
    void directoryAndMissingFile() {
        refuses(folder, folder.toString());
        refuses(folder.resolve("nowhere.csv"), "nowhere.csv");
    }

    @Test
    void channelThatIsNotThere() {
        Run run = Run.of("analyze", "data/arff/one-dof-linear.arff", "--output", "sternum.acc.z", "--out",
                folder.resolve("out").toString());
        assertEquals(1, run.code());
        assertTrue(run.err().contains("no channel sternum.acc.z") && run.err().contains("head.acc.z"), run.err());
    }

    @Test
    void nothingIsHalfWrittenWhereTheResultsCannotGo() throws IOException {
        Path file = Files.writeString(folder.resolve("taken"), "mine");
        Run run = Run.of("analyze", "data/arff/one-dof-linear.arff", "--out", file.toString());
        assertEquals(1, run.code());
        assertTrue(run.err().contains("is a file"), run.err());
        assertEquals("mine", Files.readString(file));
    }

    /** Of every kind of result: the name that was asked for, and no other. */
    @ParameterizedTest
    @ValueSource(strings = {"convert data/arff/one-dof-linear.arff --out %s.csv", "map %t --out %s.json",
        "export wei-griffin-1998-1dof --to python --out %s.py", "export wei-griffin-1998-1dof --to mujoco --out %s.xml",
        "simulate seconds=1 --out %s.csv", "analyze data/arff/one-dof-linear.arff --out %s"})
    void whereNothingCanBeWritten(String command) throws IOException {
        Path table = Files.writeString(folder.resolve("table.csv"), "time,ax\n" + "0.01,1\n0.02,2\n0.03,1\n0.04,3\n");
        for (Path room : List.of(folder.resolve("missing"), Path.of("/proc"))) {
            if (command.endsWith(" %s") && Files.notExists(room) || !Files.isDirectory(Path.of("/proc/self"))) {
                continue;   // folders are made
            }
            Path out = room.resolve("result");
            Run run = Run.of(command.replace("%s", out.toString()).replace("%t", table.toString()).split(" "));
            assertEquals(1, run.code(), run.err());
            assertTrue(run.err().matches("wbv: (" + out + "\\.\\w+|" + room + "): .*\\R") && !run.err().contains(".wbv-"), run.err());
            boolean file = !command.endsWith(" %s");
            assertTrue(!file || run.err().contains(Files.exists(room) ? "cannot be written" : "there is no folder to write it in"),
                    run.err());
        }
    }

    @Test
    void noPermissionToWrite() throws IOException {
        Path locked = Files.createDirectory(folder.resolve("locked"));
        Assumptions.assumeTrue(locked.toFile().setWritable(false) && !Files.isWritable(locked), "this user may write anywhere");
        Run run = Run.of("analyze", "data/arff/one-dof-linear.arff", "--out", locked.resolve("out").toString());
        assertEquals(1, run.code());
        assertTrue(run.err().contains("permission"), run.err());
    }

    /** As a disk does that is full: no file may grow longer than that. */
    @ParameterizedTest
    @ValueSource(strings = {"full.csv", "full.h5", "full.parquet"})
    void whatIsCutOffWhileItIsWrittenIsToldAndNotLeft(String name) throws Exception {
        Path shell = Path.of("/bin/sh");
        Assumptions.assumeTrue(Files.isExecutable(shell), "there is no " + shell);
        Process process = new ProcessBuilder(shell.toString(), "-c", "ulimit -f 64 && exec \"$@\"", "sh",
                Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-Xshare:auto", "-cp",
                System.getProperty("java.class.path"), Main.class.getName(), "convert", "data/arff/one-dof-linear.arff", "--out",
                folder.resolve(name).toString()).start();
        String told = new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(1, process.waitFor(), told);
        assertTrue(told.startsWith("wbv: ") && told.contains("cannot be written: "), told);
        assertEquals(1, told.lines().count(), told);
        try (Stream<Path> left = Files.list(folder)) {
            assertEquals(0, left.count());
        }
    }

    @Test
    void theWholeCommandIsNamed() {
        for (String command : List.of("states apply", "states train", "net predict", "analyze", "states", "net")) {
            Run run = Run.of(command.split(" "));
            assertEquals(2, run.code(), command);
            assertTrue(run.err().contains("Try 'wbv " + command + " --help'."), run.err());
        }
        assertTrue(Run.of().err().contains("Try 'wbv --help'."));
    }

    @Test
    void wrongUsageIsExitCodeTwo() {
        assertEquals(2, Run.of("analyse").code());
        assertEquals(2, Run.of().code());
        assertEquals(2, Run.of("analyze").code());
        assertEquals(2, Run.of("analyze", "data/arff/one-dof-linear.arff", "--input", "platform").code());
        assertEquals(2, Run.of("analyze", "data/arff/one-dof-linear.arff", "--start-damping", "7").code());
        for (String rate : new String[] {"0", "-5", "NaN", "Infinity", "many"}) {
            assertEquals(2, Run.of("analyze", "data/arff/one-dof-linear.arff", "--rate", rate).code(), rate);
        }
        assertEquals(2, Run.of("analyze", "data/arff/one-dof-linear.arff", "--input", "platform.acc.z", "--input", "head.acc.z").code());
        assertEquals(2, Run.of("simulate", "seconds=1e99", "--out", folder.resolve("x.csv").toString()).code());
        assertEquals(2, Run.of("simulate", "seconds=-1", "--out", folder.resolve("x.csv").toString()).code());
        assertEquals(2, Run.of("simulate", "subject=9", "--out", folder.resolve("x.csv").toString()).code());
        assertEquals(2, Run.of("task", "wbv.task.NoSuchTask").code());
    }
}
