package wbv.diagnosis.search;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Setting;

/** A mechanism that leaves little beside it another that shows only once the first is known. Asked apart: it takes a minute. */
@Tag("exam")
class SecondMechanismTest {

    @TempDir
    private Path folder;

    /** A swinging mass explains nearly all; what is left comes from elsewhere, and goes with a memory. */
    @Test
    void whatIsLeftIsNamed() throws Exception {
        PairSearchTest.bothAreNamed(folder, List.of("mode.hidden", "memory.viscoelastic"), -9084959666881355306L);
    }

    /** What a reflex leaves that is not only late but slow too is its form, though the head's sensor could do nearly the same. */
    @Test
    void whatALawLeavesAtItsPlaceIsItsForm() throws Exception {
        PairSearchTest.allIsNamed(folder,
                new ConcealedSpec("form", List.of("muscle.reflex"), 0.3, Setting.RIG, false, -6379168608981105790L));
    }

    /** A spring explains nearly all, but another link has to be four times as stiff as given. */
    @Test
    void anOddNumberIsAMemory() throws Exception {
        PairSearchTest.bothAreNamed(folder, List.of("stiffness.asymmetric", "memory.viscoelastic"), -8114840872632837746L);
    }
}
