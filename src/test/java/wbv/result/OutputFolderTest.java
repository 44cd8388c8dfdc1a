package wbv.result;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.recording.DataFault;

class OutputFolderTest {

    @TempDir
    private Path home;

    @Test
    void aNewFolderAppearsWithItsParentsWhenPublished() throws IOException {
        Path target = home.resolve("a/b/out");
        try (OutputFolder out = OutputFolder.at(target)) {
            Files.writeString(out.file("report.html"), "new");
            assertFalse(Files.exists(home.resolve("a")));
            out.publish();
        }
        assertEquals("new", Files.readString(target.resolve("report.html")));
        assertEquals(List.of("a"), names(home));
    }

    @Test
    void withoutPublishingNothingIsLeft() throws IOException {
        Path existing = Files.createDirectory(home.resolve("existing"));
        Files.writeString(existing.resolve("report.html"), "old");
        for (Path target : List.of(home.resolve("new"), existing)) {
            try (OutputFolder out = OutputFolder.at(target)) {
                Files.writeString(out.file("report.html"), "half");
            }
        }
        assertEquals(List.of("existing"), names(home));
        assertEquals(List.of("report.html"), names(existing));
        assertEquals("old", Files.readString(existing.resolve("report.html")));
    }

    @Test
    void publishingReplacesFilesOfTheSameNameAndTouchesNothingElse() throws IOException {
        Path target = Files.createDirectory(home.resolve("out"));
        Files.writeString(target.resolve("report.html"), "old");
        Files.writeString(target.resolve("thesis.tex"), "years of work");
        Files.createDirectory(target.resolve("photos"));
        try (OutputFolder out = OutputFolder.at(target)) {
            Files.writeString(out.file("report.html"), "new");
            Files.writeString(out.file("results.json"), "{}");
            out.publish();
        }
        assertEquals(List.of("photos", "report.html", "results.json", "thesis.tex"), names(target));
        assertEquals("new", Files.readString(target.resolve("report.html")));
        assertEquals("years of work", Files.readString(target.resolve("thesis.tex")));
    }

    @Test
    void aFolderInTheWayOfAFileStopsEverythingBeforeAnythingIsMoved() throws IOException {
        Path target = Files.createDirectory(home.resolve("out"));
        Files.createDirectory(target.resolve("tracks.csv"));
        Files.writeString(target.resolve("report.html"), "old");
        try (OutputFolder out = OutputFolder.at(target)) {
            Files.writeString(out.file("report.html"), "new");
            Files.writeString(out.file("tracks.csv"), "t");
            assertThrows(DataFault.class, out::publish);
        }
        assertEquals("old", Files.readString(target.resolve("report.html")));
        assertEquals(List.of("report.html", "tracks.csv"), names(target));
    }

    @ParameterizedTest
    @ValueSource(strings = {"file", "file/out", "file/a/b"})
    void aFileIsNoFolder(String target) throws IOException {
        Files.writeString(home.resolve("file"), "mine");
        DataFault fault = assertThrows(DataFault.class, () -> OutputFolder.at(home.resolve(target)));
        assertTrue(fault.getMessage().endsWith("file: is a file; results need a folder"), fault.getMessage());
        assertEquals("mine", Files.readString(home.resolve("file")));
    }

    @Test
    void aFolderWithoutPermissionIsRefusedAtOnce() throws IOException {
        Path locked = Files.createDirectory(home.resolve("locked"));
        Assumptions.assumeTrue(locked.toFile().setWritable(false) && !Files.isWritable(locked),
                "this user may write everywhere");
        DataFault fault = assertThrows(DataFault.class, () -> OutputFolder.at(locked.resolve("out")));
        assertTrue(fault.getMessage().contains("no permission"), fault.getMessage());
    }

    @ParameterizedTest
    @ValueSource(strings = {"", ".", "..", "../other", "sub/file", "/etc/passwd"})
    void resultsHavePlainNames(String name) throws IOException {
        try (OutputFolder out = OutputFolder.at(home.resolve("out"))) {
            assertThrows(IllegalArgumentException.class, () -> out.file(name));
        }
    }

    private static List<String> names(Path folder) throws IOException {
        try (Stream<Path> list = Files.list(folder)) {
            return list.map(path -> path.getFileName().toString()).sorted().toList();
        }
    }
}
