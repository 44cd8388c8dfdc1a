package wbv.diagnosis;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A mechanism that leaves little beside it another that shows only once the first is known. */
class CompanionTest {

    @TempDir
    private Path folder;

    /** A swinging mass explains nearly all; what is left comes from elsewhere, and goes with a memory. */
    @Test
    void whatIsLeftIsNamed() throws Exception {
        PairSearchTest.bothAreNamed(folder, List.of("mode.hidden", "memory.viscoelastic"), -9084959666881355306L);
    }

    /** A spring explains nearly all, but another link has to be four times as stiff as given. */
    @Test
    void anOddNumberIsAMemory() throws Exception {
        PairSearchTest.bothAreNamed(folder, List.of("stiffness.asymmetric", "memory.viscoelastic"), -8114840872632837746L);
    }
}
