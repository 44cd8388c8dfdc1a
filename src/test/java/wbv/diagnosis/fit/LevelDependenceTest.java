package wbv.diagnosis.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.diagnosis.Rides;
import wbv.rig.concealed.ConcealedCase;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Concealer;
import wbv.rig.concealed.Setting;

/** How the level of a person's own force follows that of the ride: not at all, on rides of two levels, one at least twice the other. */
class LevelDependenceTest {

    private static final long[] SEEDS = {1, 2, 3, 4};

    @TempDir
    private Path folder;

    @Test
    void aForceAsStrongOnEveryRideFollowsNone() throws Exception {
        for (long seed : SEEDS) {
            LevelDependence following = onTwoRides(seed).following();
            // In proportion would be 1. A tenth is what is left of the sensors' own errors, which follow the ride.
            assertEquals(0, following.slope(), 0.1 + 3 * following.doubt(), seed + ": " + following);
            assertTrue(following.doubt() < 0.15, seed + ": " + following);
            assertTrue(following.isSteady(), seed + ": " + following);
        }
    }

    /** What a model as given leaves of a sitter who sits still, two rides together. */
    private BodyForce onTwoRides(long seed) throws Exception {
        ConcealedCase made = Concealer.make(new ConcealedSpec("levels", List.of(), 1, Setting.RIDE_LEVELS, true, seed));
        Model model = ModelFile.read(Files.writeString(folder.resolve("model.json"), made.model(), StandardCharsets.UTF_8));
        Evidence evidence = new Evidence(model,
                Rides.of(Map.of("one", made.recording()), Optional.of(Map.entry("other", made.beside().get(ConcealedCase.WITH))))
                        .recording());
        Candidate baseline = Baseline.of(evidence);
        return BodyForce.in(evidence, new Fitter(evidence).look(baseline, baseline.start(), evidence.fit())).orElseThrow();
    }
}
