package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.fleet.FleetEngine;

/** What {@code wbv fleet} says of many machines in a build that has none. */
class FleetMachinesTest {

    @TempDir
    private Path temporary;

    private Run fleet(String... more) {
        String[] words = new String[more.length + 4];
        System.arraycopy(new String[] {"fleet", "data/arff/one-dof-linear.arff", "--out", temporary.resolve("out").toString()}, 0, words, 0, 4);
        System.arraycopy(more, 0, words, 4, more.length);
        return Run.of(words);
    }

    @Test
    void withoutFlinkOneLineSaysHowToGetIt() {
        assumeTrue(FleetEngine.class.getResource("/META-INF/services/" + FleetEngine.class.getName()) == null, "the folder of classes holds those of the profile 'fleet'");
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
}
