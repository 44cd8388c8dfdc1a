package wbv.diagnosis.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.GammaDistribution;
import org.apache.commons.math3.distribution.RealDistribution;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.apache.commons.math3.stat.descriptive.DescriptiveStatistics;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
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
            BodyForce force = onTwoRides(seed, List.of());
            assertFalse(force.coherent(), seed + ": " + force);
            LevelDependence following = force.following();
            // In proportion would be 1. A tenth is what is left of the sensors' own errors, which follow the ride.
            assertEquals(0, following.slope(), 0.1 + 3 * following.doubt(), seed + ": " + following);
            assertTrue(following.doubt() < 0.15, seed + ": " + following);
            assertTrue(following.isSteady(), seed + ": " + following);
        }
    }

    /** No push, and no force of a person's own, is what a mass does that no sensor sees. */
    @Test
    void theForceOfASwingingMassGoesWithTheBase() throws Exception {
        for (long seed : SEEDS) {
            assertTrue(onTwoRides(seed, List.of("mode.hidden")).coherent(), "seed " + seed);
        }
    }

    /** Powers are gamma distributed, as those of narrow bands of noise are; the noise is half of the force's on average. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1, 2})
    void theSlopeScattersByItsDoubt(double slope) {
        RandomGenerator random = new Well19937c(7);
        RealDistribution scatter = new GammaDistribution(random, 4, 0.25);
        DescriptiveStatistics deviates = new DescriptiveStatistics();
        for (int draw = 0; draw < 400; draw++) {
            double[] motion = IntStream.range(0, 60).mapToDouble(block -> Math.exp(0.6 * random.nextGaussian())).toArray();
            double[] power = Arrays.stream(motion).map(m -> (0.25 * Math.pow(m, slope) + 0.25) * scatter.sample()).toArray();
            LevelDependence found = LevelDependence.following(power, motion, 0.25);
            deviates.addValue((found.slope() - slope) / found.doubt());
        }
        assertEquals(0, deviates.getMean(), 0.25);
        assertEquals(1, deviates.getStandardDeviation(), 0.2);
    }

    @Test
    void motionOfOneLevelTellsNothing() {
        double[] same = new double[40];
        Arrays.fill(same, 2);
        assertFalse(LevelDependence.following(IntStream.range(0, 40).mapToDouble(block -> 1 + block % 7).toArray(), same, 0).isTold());
    }

    @Test
    void whatIsNoiseAloneFollowsNothingForCertain() {
        double[] motion = {1, 2, 3, 4, 5, 6, 7, 8};
        assertFalse(LevelDependence.following(new double[] {1, 1.1, 0.9, 1, 1.05, 0.95, 1, 1}, motion, 1).isSteady());
    }

    /**
     * What a model as given leaves of a sitter who sits still, two rides together.
     *
     * @param concealed words of what is missing besides
     */
    private BodyForce onTwoRides(long seed, List<String> concealed) throws Exception {
        ConcealedCase made = Concealer.make(new ConcealedSpec("levels", concealed, 1, Setting.RIDE_LEVELS, true, seed));
        Model model = ModelFile.read(Files.writeString(folder.resolve("model.json"), made.model(), StandardCharsets.UTF_8));
        Evidence evidence = new Evidence(model,
                Rides.of(Map.of("one", made.recording()), Optional.of(Map.entry("other", made.beside().get(ConcealedCase.WITH))))
                        .recording());
        Candidate baseline = Baseline.of(evidence);
        return BodyForce.onAnyBody(evidence, new Fitter(evidence).look(baseline, baseline.start(), evidence.fit())).orElseThrow();
    }
}
