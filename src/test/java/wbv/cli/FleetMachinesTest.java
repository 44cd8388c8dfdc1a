package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.fleet.FleetEngine;

/** What {@code wbv fleet} says of many machines in a build that has none. */
class FleetMachinesTest {

    @TempDir
    private Path temporary;

    private Run fleet(String... more) {
        String[] words = new String[more.length + 4];
        System.arraycopy(new String[] {"fleet", "data/arff/one-dof-linear.arff", "--out", temporary.resolve("out").toString()}, 0, words, 0,
                4);
        System.arraycopy(more, 0, words, 4, more.length);
        return Run.of(words);
    }

    @Test
    void withoutFlinkOneLineSaysHowToGetIt() {
        assumeTrue(FleetEngine.class.getResource("/META-INF/services/" + FleetEngine.class.getName()) == null,
                "the folder of classes holds those of the profile 'fleet'");
        for (String[] more : new String[][] {{"--local", "2"}, {"--cluster", "localhost:8081"}}) {
            Run run = fleet(more);
            assertEquals(2, run.code());
            assertTrue(run.err().startsWith("wbv: this wbv was built without Apache Flink: './wbv fleet'"), run.err());
            assertFalse(Files.exists(temporary.resolve("out")));
        }
    }

    @Test
    void machinesOfOurOwnAndOthersExcludeEachOther() {
        Run run = fleet("--local", "2", "--cluster", "localhost:8081");
        assertEquals(2, run.code());
        assertTrue(run.err().startsWith("wbv: --local starts machines, --cluster names some: choose one"), run.err());
    }

    /** Packets written to a file and followed from there are those of the replay. */
    @Test
    void packetsAreSentToAFileAndFollowedFromIt() throws IOException {
        Path file = temporary.resolve("fleet.packets");
        Path replayed = temporary.resolve("replayed");
        Path followed = temporary.resolve("followed");
        String[] seats = {"fleet", "data/arff/one-dof-linear.arff", "--seats", "3", "--packet", "20", "--disturb", "3"};
        assertEquals(0, Run.of(and(seats, "--out", replayed.toString())).code());
        Run sent = Run.of(and(seats, "--send", file.toString()));
        assertEquals(0, sent.code(), sent.err());
        assertTrue(sent.out().contains("--channels platform.acc.z,head.acc.z"), sent.out());
        Run run = Run.of("fleet", file.toString(), "--channels", "platform.acc.z,head.acc.z", "--out", followed.toString());
        assertEquals(0, run.code(), run.err());
        for (String name : List.of("results.csv", "alarms.csv", "machines.csv", "worst.csv")) {
            assertEquals(-1, Files.mismatch(replayed.resolve(name), followed.resolve(name)), name);
        }
        for (String[] wrong : new String[][] {{"--channels must name the channels of the packets", file.toString()},
            {"its packets have 2 channels, --channels names 1", file.toString(), "--channels", "head.acc.z"},
            {"files of packets and recordings are not followed together", file.toString(), "data/arff/one-dof-linear.arff"},
            {"these are packets", file.toString(), "--channels", "platform.acc.z,head.acc.z", "--send", "x"},
            {"--rate must say", "kafka://localhost:9092/packets"},
            {"a topic is named kafka://HOST:PORT/TOPIC", "kafka://localhost/packets", "--rate", "60"},
            {"add --local N or --cluster", "kafka://localhost:9092/packets", "--rate", "60", "--channels", "platform.acc.z,head.acc.z"}}) {
            String[] words = wrong.clone();
            words[0] = "fleet";
            Run refused = Run.of(and(words, "--out", temporary.resolve("none").toString()));
            assertTrue(refused.code() == 2 || refused.code() == 1, wrong[0]);
            assertTrue(refused.err().contains(wrong[0]), refused.err());
        }
        assertFalse(Files.exists(temporary.resolve("none")));
    }

    private static String[] and(String[] words, String... more) {
        return Stream.concat(Arrays.stream(words), Arrays.stream(more)).toArray(String[]::new);
    }
}
