package wbv.recording;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class UnfinishedTest {

    @TempDir
    private Path folder;

    @Test
    void whatGetsNoNameLeavesNothing() throws IOException {
        try (Unfinished unfinished = Unfinished.in(folder)) {
            Files.writeString(unfinished.path(), "half");
            assertEquals(2, names().size());
        }
        assertEquals(List.of(), names());
    }

    @Test
    void whatGetsItsNameIsAllThatIsLeft() throws IOException {
        Files.writeString(folder.resolve("table"), "old");
        try (Unfinished unfinished = Unfinished.in(folder)) {
            Files.writeString(unfinished.path(), "new");
            unfinished.become(folder.resolve("table"));
        }
        assertEquals(List.of("table"), names());
        assertEquals("new", Files.readString(folder.resolve("table")));
    }

    @Test
    void whatADeadRunLeftIsSweptAndNothingElseIs() throws IOException {
        Files.createDirectory(folder.resolve(".wbv-dead-1"));
        Files.writeString(folder.resolve(".wbv-dead-1/report.html"), "half");
        Files.createFile(folder.resolve(".wbv-dead-1.lock"));
        Files.writeString(folder.resolve(".wbv-dead-2"), "half");
        Files.createFile(folder.resolve(".wbv-dead-2.lock"));
        Path precious = Files.createDirectory(folder.resolve("precious"));
        Files.writeString(precious.resolve("thesis.tex"), "years of work");
        Files.createSymbolicLink(folder.resolve(".wbv-dead-3"), precious);
        Files.createFile(folder.resolve(".wbv-dead-3.lock"));
        Files.writeString(folder.resolve(".wbv-notes"), "no lock beside it: nobody knows whose");
        try (Unfinished unfinished = Unfinished.in(folder)) {
            assertFalse(Files.exists(unfinished.path()));
        }
        assertEquals(List.of(".wbv-notes", "precious"), names());
        assertEquals("years of work", Files.readString(precious.resolve("thesis.tex")));
    }

    /** The lock, not the name, says that a run is alive. */
    @Test
    void whatALiveRunHoldsIsLeftAlone() throws Exception {
        Process other = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
                System.getProperty("java.class.path"), Holder.class.getName(), folder.toString()).start();
        try {
            assertEquals('!', other.getInputStream().read());
            List<String> held = names();
            assertEquals(2, held.size());
            Unfinished.in(folder).close();
            assertEquals(held, names());
            other.destroyForcibly().waitFor(60, TimeUnit.SECONDS);   // kill -9 where there is one
            assertEquals(held, names());
            Unfinished.in(folder).close();
            assertEquals(List.of(), names());
        } finally {
            other.destroyForcibly();
        }
    }

    /** A process that begins something and never ends it. */
    static final class Holder {

        public static void main(String[] folder) throws IOException {
            Unfinished unfinished = Unfinished.in(Path.of(folder[0]));
            Files.writeString(unfinished.path(), "half");
            System.out.print('!');
            System.out.flush();
            System.in.read();
            unfinished.close();
        }
    }

    @Test
    void severalAtOnceInOneFolderKeepOutOfEachOthersWay() throws IOException {
        try (Unfinished one = Unfinished.in(folder); Unfinished two = Unfinished.in(folder)) {
            Files.writeString(one.path(), "1");
            Files.writeString(two.path(), "2");
            Unfinished.in(folder).close();
            one.become(folder.resolve("one"));
            two.become(folder.resolve("two"));
        }
        assertEquals(List.of("one", "two"), names());
    }

    @Test
    void aFileIsWholeOrAsItWas() throws IOException {
        Path file = Files.writeString(folder.resolve("file"), "old");
        try (AtomicFile begun = AtomicFile.begin(file)) {
            begun.stream().write(new byte[100_000]);
            assertEquals("old", Files.readString(file));
        }
        assertEquals("old", Files.readString(file));
        AtomicFile.write(file, new byte[] {1, 2});
        assertArrayEquals(new byte[] {1, 2}, Files.readAllBytes(file));
        assertEquals(List.of("file"), names());
        Path inTheWay = Files.createDirectory(folder.resolve("directory"));
        FileSystemException fault = assertThrows(FileSystemException.class, () -> AtomicFile.write(inTheWay, new byte[0]));
        assertEquals(inTheWay.toString(), fault.getFile());
        assertTrue(Files.isDirectory(inTheWay));
    }

    @Test
    void aLockOfTheSameJavaCountsAsWell() throws IOException {
        Files.writeString(folder.resolve(".wbv-other"), "half");
        try (FileChannel channel = FileChannel.open(folder.resolve(".wbv-other.lock"), StandardOpenOption.CREATE_NEW,
                StandardOpenOption.WRITE); FileLock held = channel.lock()) {
            Unfinished.in(folder).close();
            assertTrue(held.isValid());
            assertEquals(List.of(".wbv-other", ".wbv-other.lock"), names());
        }
    }

    private List<String> names() throws IOException {
        try (Stream<Path> list = Files.list(folder)) {
            return list.map(path -> path.getFileName().toString()).sorted().toList();
        }
    }
}
