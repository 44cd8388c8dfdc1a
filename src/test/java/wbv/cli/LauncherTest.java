package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/**
 * The launcher's archive of classes, with a Java that only notes what it was asked: made once for a jar, and missing in silence where it
 * cannot be made.
 */
@EnabledOnOs(OS.LINUX)
class LauncherTest {

    /** Writes an archive where it is asked to; finds none whole where a file 'broken' lies beside it. */
    private static final String JAVA = """
            #!/usr/bin/env bash
            echo "$*" >> "$(dirname "$0")/asked"
            for word; do
              case $word in -Xshare:dump) dumps=1 ;; -XX:SharedArchiveFile=*) [ -z "${dumps:-}" ] || echo classes > "${word#*=}" ;; esac
            done
            case "$*" in *-Xshare:on*) [ ! -e "$(dirname "$0")/broken" ] || exit 1 ;; esac
            echo warning >&2
            """;

    /** Makes what the profile 'fleet' makes. */
    private static final String MAVEN = """
            #!/usr/bin/env bash
            echo "mvn $*" >> "$(dirname "$0")/asked"
            mkdir -p "$(dirname "$0")/../target/fleet-lib"
            echo jar > "$(dirname "$0")/../target/wbv-fleet.jar"
            """;

    @TempDir
    private Path room;
    private Path target;
    private Path path;
    /** The folder of the Java that is to be started. */
    private Path java;
    private Optional<Path> javaHome = Optional.empty();
    private String options = "";

    @BeforeEach
    void install() throws IOException {
        Files.copy(Path.of("wbv"), room.resolve("wbv"), StandardCopyOption.COPY_ATTRIBUTES);
        Files.createDirectories(room.resolve("src/main"));
        Files.writeString(room.resolve("pom.xml"), "");
        target = room.resolve("target");
        Files.createDirectories(target.resolve("lib"));
        Files.writeString(target.resolve("wbv.jar"), "");
        aged(room.resolve("pom.xml"), 200);
        aged(room.resolve("src/main"), 200);
        aged(target.resolve("wbv.jar"), 100);
        path = room.resolve("bin");
        java = path;
        Files.createDirectories(java);
        Files.writeString(java.resolve("java"), JAVA);
        assertTrue(java.resolve("java").toFile().setExecutable(true));
    }

    private static void aged(Path file, int seconds) throws IOException {
        Files.setLastModifiedTime(file, FileTime.fromMillis(System.currentTimeMillis() - 1000L * seconds));
    }

    /** What Java was asked by one start of the launcher. */
    private List<String> start() throws IOException, InterruptedException {
        return start("warning\n", "--version");
    }

    private List<String> start(String expected, String... words) throws IOException, InterruptedException {
        Files.deleteIfExists(java.resolve("asked"));
        List<String> line = new ArrayList<>(List.of(room.resolve("wbv").toString()));
        line.addAll(List.of(words));
        ProcessBuilder builder = new ProcessBuilder(line).redirectErrorStream(true);
        builder.environment().put("PATH", path + File.pathSeparator + System.getenv("PATH"));
        builder.environment().keySet().removeAll(List.of("JAVA_TOOL_OPTIONS", "JDK_JAVA_OPTIONS"));
        builder.environment().put("WBV_JAVA_OPTS", options);
        builder.environment().remove("JAVA_HOME");
        javaHome.ifPresent(home -> builder.environment().put("JAVA_HOME", home.toString()));
        Process launcher = builder.start();
        String printed = new String(launcher.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertTrue(launcher.waitFor(30, TimeUnit.SECONDS));
        assertEquals(expected, printed, "what the last Java prints, and no other");
        assertEquals(0, launcher.exitValue());
        return Files.readAllLines(java.resolve("asked"));
    }

    /** The Java of JAVA_HOME goes before that of the PATH, if there is one; each has an archive of its own. */
    @Test
    void javaHomeGoesBeforeThePath() throws Exception {
        Path home = room.resolve("another java");
        Files.createDirectories(home.resolve("bin"));
        javaHome = Optional.of(home);
        assertEquals(4, start().size(), "JAVA_HOME without a Java is as none");
        Files.move(java.resolve("java"), home.resolve("bin/java"));
        Files.writeString(java.resolve("java"), "#!/bin/sh\necho the Java of the PATH >&2; exit 7\n");
        assertTrue(java.resolve("java").toFile().setExecutable(true));
        java = home.resolve("bin");
        Path old = archives().get(0);
        assertEquals(4, start().size());
        assertFalse(Files.exists(old), "an archive serves one Java");
    }

    @Test
    void withoutAnyJavaOneLineSaysSo() throws Exception {
        Files.createDirectories(room.resolve("tools"));
        for (String tool : List.of("bash", "env", "dirname", "readlink", "find")) {
            Path place = Path.of("/usr/bin").resolve(tool);
            Files.createSymbolicLink(room.resolve("tools").resolve(tool), Files.exists(place) ? place : Path.of("/bin").resolve(tool));
        }
        ProcessBuilder builder = new ProcessBuilder(room.resolve("wbv").toString(), "--version").redirectErrorStream(true);
        builder.environment().put("PATH", room.resolve("tools").toString());
        builder.environment().remove("JAVA_HOME");
        Process launcher = builder.start();
        assertEquals("wbv: java is not on the PATH and JAVA_HOME names none; wbv needs a JDK 17 and Maven 3.8 or newer\n",
                new String(launcher.getInputStream().readAllBytes(), StandardCharsets.UTF_8));
        assertEquals(3, launcher.waitFor());
    }

    private List<Path> archives() throws IOException {
        try (Stream<Path> files = Files.list(target)) {
            return files.filter(file -> file.toString().endsWith(".jsa")).toList();
        }
    }

    @Test
    void archiveIsMadeOnceAndUsedFromThenOn() throws Exception {
        List<String> first = start();
        assertEquals(4, first.size(), "training, archive, verification and the command itself: " + first);
        Path archive = archives().get(0);
        assertTrue(first.get(3).contains("-XX:SharedArchiveFile=" + archive), first.get(3));
        assertEquals(List.of(first.get(3)), start());
        try (Stream<Path> files = Files.list(target)) {
            assertEquals(4, files.count(), "lib, jar, archive and lock");
        }
    }

    /** What reads a short recording once is over before the second compiler pays; a long one, or who knows how long, is not. */
    @Test
    void shortRecordingsAreReadWithTheFirstCompilerAlone() throws Exception {
        start();
        Path ride = Files.writeString(room.resolve("ride.csv"), "t,seat.acc.z\n");
        String plain = "-XX:TieredStopAtLevel=1";
        assertTrue(last(start("warning\n", "analyze", ride.toString(), "--out", "out")).contains(plain));
        assertFalse(last(start("warning\n", "analyze", "-")).contains(plain));
        assertFalse(last(start("warning\n", "diagnose", ride.toString())).contains(plain));
        try (RandomAccessFile file = new RandomAccessFile(ride.toFile(), "rw")) {
            file.setLength(30_000_000);
        }
        assertFalse(last(start("warning\n", "analyze", ride.toString())).contains(plain));
    }

    private static String last(List<String> asked) {
        return asked.get(asked.size() - 1);
    }

    /** A diagnosis lets the heap grow only where it must, and leaves the choice of a collector to whoever makes one. */
    @Test
    void diagnosisIsCollectedInParallelUnlessAnotherIsAskedFor() throws Exception {
        start();
        assertTrue(start("warning\n", "diagnose", "ride.csv").get(0).contains("-XX:+UseParallelGC -XX:GCTimeRatio"));
        assertFalse(start("warning\n", "analyze", "ride.csv").get(0).contains("ParallelGC"));
        options = "-XX:+UseG1GC";
        String asked = start("warning\n", "diagnose", "ride.csv").get(0);
        assertTrue(asked.contains("-XX:+UseG1GC") && !asked.contains("ParallelGC"), asked);
    }

    @Test
    void anotherJarHasAnotherArchive() throws Exception {
        start();
        Path archive = archives().get(0);
        aged(archive, 50);
        aged(target.resolve("wbv.jar"), 10);
        assertEquals(4, start().size());
        assertTrue(Files.getLastModifiedTime(archive).compareTo(Files.getLastModifiedTime(target.resolve("wbv.jar"))) > 0);
        assertEquals(1, archives().size());
    }

    @Test
    void whatJavaDoesNotFindWholeIsNeverUsedNorTriedAgain() throws Exception {
        Files.writeString(java.resolve("broken"), "");
        List<String> first = start();
        assertEquals(4, first.size());
        assertFalse(first.get(3).contains("SharedArchiveFile"), first.get(3));
        assertEquals(0, Files.size(archives().get(0)));
        assertEquals(List.of(first.get(3)), start());
    }

    @Test
    void goesOnWithoutWhereItMayNotWriteOrAnotherIsAtIt() throws Exception {
        Files.createDirectories(target.resolve("archive.lock"));   // no file can be opened there, whoever runs this
        List<String> asked = start();
        assertEquals(1, asked.size());
        assertFalse(asked.get(0).contains("SharedArchiveFile"), asked.get(0));
        Files.delete(target.resolve("archive.lock"));
        Process other = new ProcessBuilder("flock", target.resolve("archive.lock").toString(), "sh", "-c", "echo locked; sleep 20").start();
        try {
            assertEquals('l', other.getInputStream().read());
            assertEquals(1, start().size());
            assertTrue(archives().isEmpty());
        } finally {
            other.descendants().forEach(ProcessHandle::destroy);
            other.destroy();
        }
    }

    @Test
    void leftoversOfOneThatWasKilledAreCleared() throws Exception {
        Files.createDirectories(target.resolve("archive.x1Y2z3"));
        Files.writeString(target.resolve("archive.x1Y2z3/classes.jsa"), "half");
        start();
        assertFalse(Files.exists(target.resolve("archive.x1Y2z3")));
        assertEquals("classes\n", Files.readString(archives().get(0)));
    }

    /** Apache Flink is built in when it is asked for, once, and the class path then has its jar; other commands know nothing of it. */
    @Test
    void manyMachinesAreBuiltWhenTheyAreAskedFor() throws Exception {
        Files.writeString(java.resolve("mvn"), MAVEN);
        assertTrue(java.resolve("mvn").toFile().setExecutable(true));
        Files.createDirectories(room.resolve("src/fleet/java"));
        aged(room.resolve("src/fleet/java"), 200);
        start("warning\n", "fleet", "ride.arff");
        assertFalse(Files.exists(target.resolve("wbv-fleet.jar")));
        String told = "wbv: building with Apache Flink (the first time also downloads its libraries, 95 MB) ...\n";
        List<String> first = start(told + "warning\n", "fleet", "ride.arff", "--local", "2");
        assertTrue(first.get(0).startsWith("mvn ") && first.get(0).contains("-Pfleet"), first.get(0));
        String command = first.get(first.size() - 1);
        assertTrue(command.contains("-cp " + target.resolve("wbv.jar") + File.pathSeparator + target.resolve("wbv-fleet.jar")
                + " wbv.cli.Main fleet ride.arff --local 2"), command);
        assertEquals(List.of(command), start("warning\n", "fleet", "ride.arff", "--local", "2"));
        aged(target.resolve("wbv-fleet.jar"), 50);
        aged(room.resolve("src/fleet/java"), 20);
        assertEquals(2, start(told + "warning\n", "fleet", "ride.arff", "--cluster=localhost:8081").stream()
                .filter(line -> line.startsWith("mvn ") || line.contains("--cluster")).count());
    }

    /**
     * The launcher for Windows, which no test here can run: what it says, builds, starts and asks of its surroundings is what the shell's
     * does, and what cmd would trip over is not in it.
     */
    @Test
    void windowsLauncherSaysAndStartsTheSame() throws IOException {
        String whole = Files.readString(Path.of("wbv.cmd"));
        assertEquals(whole.replace("\r\n", "\n").replace("\n", "\r\n"), whole, "cmd loses its labels where lines end otherwise");
        assertTrue(whole.chars().allMatch(c -> c < 128), "cmd reads it in the console's code page");
        String windows = whole.replace("\r\n", "\n").replace('\\', '/');
        String shell = Files.readString(Path.of("wbv"));
        for (String said : List.of("wbv: building (the first time also downloads its libraries) ...",
                "wbv: the build failed; the lines above say why", "wbv: mvn is not on the PATH; wbv needs a JDK 17 and Maven 3.8 or newer",
                "wbv: java is not on the PATH and JAVA_HOME names none; wbv needs a JDK 17 and Maven 3.8 or newer")) {
            assertTrue(windows.contains("echo " + said + ">&2\n"), said);
            assertTrue(shell.contains(said), said);
        }
        assertTrue(windows.contains("mvn -B -q -f \"%home%/pom.xml\" -Dmaven.test.skip=true package >\"%home%/target/build.log\" 2>&1"));
        assertTrue(shell
                .contains("mvn -B -q -f \"$home/pom.xml\" ${profile[@]+\"${profile[@]}\"} -Dmaven.test.skip=true package >\"$log\" 2>&1"));
        assertTrue(windows.contains("%WBV_JAVA_OPTS% -jar \"%jar%\" %*\n") && shell.contains("${WBV_JAVA_OPTS:-} -jar \"$jar\" \"$@\""),
                "options, and arguments as they are");
        for (String looked : List.of("not exist \"%jar%\"", "not exist \"%home%/target/lib\"", "'pom.xml'", "'src/main'",
                "%JAVA_HOME%/bin/java.exe")) {
            assertTrue(windows.contains(looked), looked);
        }
        assertEquals(3, windows.split("exit /b 3\n", -1).length - 1, "without Java, without Maven, after a build that failed");
        assertTrue(windows.contains("set \"code=%errorlevel%\"\n") && windows.endsWith("exit /b %errorlevel%\n")
                && windows.contains("exit /b %code%\n"));
        assertTrue(windows.contains("DisableDelayedExpansion"), "or a ! in an argument would vanish");
        for (String line : windows.lines().toList()) {
            assertEquals(0, line.chars().filter(c -> c == '"').count() % 2, line);
            if (line.matches(".*(goto|call) :?(run|stale)\\b.*")) {
                String label = line.replaceAll(".*(?:goto|call) :?", "");
                assertEquals(1, windows.lines().filter((":" + label)::equals).count(), label);
            }
        }
    }
}
