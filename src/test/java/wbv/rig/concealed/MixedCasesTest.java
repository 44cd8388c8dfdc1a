package wbv.rig.concealed;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.util.List;
import java.util.stream.IntStream;
import org.apache.commons.math3.random.RandomGenerator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.rig.concealed.law.LinkPhysics;
import wbv.rig.platform.Seeds;

/** Benches, planar people and levels, as cases. */
class MixedCasesTest {

    private static ConcealedCase made(Setting setting, String word, boolean exact, long seed) {
        return Concealer.make(new ConcealedSpec("1", word.isEmpty() ? List.of() : List.of(word), 1, setting, exact, seed));
    }

    @ParameterizedTest
    @CsvSource({"BENCH, friction.coulomb, 2", "BENCH_LEVELS, contact.backlash, 3", "BENCH, sensor.ac-coupled, 11", "BENCH, drift.step, 5",
        "BENCH, drift.slow, 6"})
    void theSameSpecGivesTheSameAndTheModelIsARigThatSaysNothing(Setting setting, String word, long seed) throws IOException {
        ConcealedCase one = made(setting, word, false, seed);
        ConcealedCase again = made(setting, word, false, seed);
        assertEquals(one.key(), again.key());
        assertEquals(one.model(), again.model());
        assertEquals(one.beside().keySet(), again.beside().keySet());
        for (Channel channel : one.recording().channels()) {
            assertArrayEquals(one.recording().values(channel), again.recording().values(channel), 0);
        }
        JsonNode model = new ObjectMapper().readTree(one.model());
        assertEquals("rig", model.get("subject").asText());
        assertFalse(one.model().contains(word));
        JsonNode key = new ObjectMapper().readTree(one.key());
        assertEquals(word, key.get("mechanisms").get(0).get("mechanism").asText());
        assertTrue(key.get("linear_chi2").asDouble() > 1.5, one.key());
        assertEquals(setting == Setting.BENCH_LEVELS, one.beside().containsKey(ConcealedCase.WITH));
    }

    /** The force that is sealed is that of the law, by row. */
    @Test
    void aLawOfABenchIsSealedAsItsForce() {
        ConcealedCase made = made(Setting.BENCH, "open.damping.rebound", false, 7);
        double[][] rows = made.force().orElseThrow().lines().skip(1)
                .map(line -> java.util.Arrays.stream(line.split(",")).mapToDouble(Double::parseDouble).toArray())
                .toArray(double[][]::new);
        assertEquals(made.recording().length(), rows.length);
        // A damper in rebound alone: where the link is compressed it does nothing but what the low-pass carries over.
        double pulls = 0;
        double pushes = 0;
        for (double[] row : rows) {
            pulls += Math.max(0, row[3]) * row[1];
            pushes += Math.max(0, -row[3]) * Math.abs(row[1]);
        }
        assertTrue(pulls > 0 && pushes < 0.05 * pulls, pulls + " and " + pushes);
    }

    /** Three recordings of three levels; the sensors of the sitter are where they were and their noise is another one. */
    @ParameterizedTest
    @CsvSource({"BENCH_LEVELS, 5, table.acc.", "RIDE_LEVELS, 6, platform.acc.z"})
    void levelsAreThreeRecordingsOfOneSubject(Setting setting, long seed, String driver) throws IOException {
        ConcealedCase made = made(setting, "", true, seed);
        JsonNode levels = new ObjectMapper().readTree(made.key()).get("levels");
        List<Recording> three = List.of(made.recording(), made.beside().get(ConcealedCase.WITH), made.beside().get(ConcealedCase.PROOF));
        Channel channel = made.recording().channels().stream().filter(each -> each.toString().startsWith(driver)).findFirst()
                .orElse(made.recording().channels().get(0));
        double[] over = new double[3];
        for (int i = 0; i < 3; i++) {
            over[i] = UniformSeries.rms(three.get(i).values(channel)) / levels.get(i).asDouble();
        }
        assertEquals(over[0], over[1], 0.35 * over[0]);
        assertEquals(over[0], over[2], 0.35 * over[0]);
        double[] quiet = three.get(0).values(channel);
        double[] other = three.get(1).values(channel);
        assertTrue(IntStream.range(0, 20).filter(i -> quiet[i] == other[i]).count() < 5, "noise must not come twice");
    }

    /**
     * The same person, driven by the platform as it was recorded, does what was recorded but for sensors and noise; with values that are
     * off he does not.
     */
    @Tag("slow")
    @Test
    void aSimulationWithExactValuesDoesWhatWasRecorded() {
        double exact = worst(made(Setting.PLANAR, "", true, 4));
        double off = worst(made(Setting.PLANAR, "", false, 4));
        assertTrue(exact < 0.08, "misses " + exact);
        assertTrue(off > 1.5 * exact, "misses " + off);
    }

    private static double worst(ConcealedCase made) {
        Recording simulation = made.beside().get(ConcealedCase.SIMULATION);
        double worst = 0;
        for (Channel channel : simulation.channels()) {
            double[] clean = made.clean().values(channel);
            worst = Math.max(worst, UniformSeries.rms(UniformSeries.less(simulation.values(channel), clean)) / UniformSeries.rms(clean));
        }
        assertEquals(9, simulation.channels().size());
        return worst;
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 7, 20})
    void rowsAreJoinedByWhatWentThroughThem(double hertz) {
        double w = 2 * Math.PI * hertz;
        double[] rows = IntStream.range(0, 300).mapToDouble(i -> Math.sin(w * i / 60)).toArray();
        double[] fine = PlanarConcealer.between(rows, 16);
        for (int i = 20 * 16; i < 280 * 16; i++) {
            assertEquals(Math.sin(w * i / 960), fine[i], 2e-3, "at " + i);
        }
    }

    /** Two inputs through filters and noise of its own: the noise is what is left. */
    @Test
    void filtersLeaveWhatIsNotTheInputs() {
        RandomGenerator random = new Seeds(7).source("rows");
        double[][] inputs = new double[2][2400];
        double[] output = new double[2400];
        for (int s = 0; s < 2400; s++) {
            inputs[0][s] = random.nextGaussian();
            inputs[1][s] = random.nextGaussian();
            output[s] = 0.3 * random.nextGaussian() + 5 + inputs[0][s] + (s < 40 ? 0 : 2 * inputs[1][s - 40] - inputs[0][s - 7]);
        }
        assertEquals(0.09, new Filters(inputs).left(output), 0.01);
    }

    /** At its least size a law hardly bends a spring, at its most it is another one; where the body stands it pulls no one. */
    @ParameterizedTest
    @ValueSource(strings = {"stiffness.softening", "stiffness.hardening", "stiffness.asymmetric", "damping.quadratic", "friction.coulomb",
        "hysteresis",
        "contact.bumpstop", "contact.loss", "contact.backlash", "open.damping.rebound", "open.damping.blow-off", "open.damping.eddy",
        "open.damping.travel", "open.friction.wedge"})
    void lawsGrowWithTheirSizeAndPassThroughRest(String word) {
        double w = 2 * Math.PI * 40;
        double k = 3e5;
        double c = 120;
        Coordinate at = new Coordinate(k, c, 1e-3, w * 1e-3, Math.hypot(k, c * w) * 1e-3, false, 4);
        CoordinateLaw law = CoordinateLaw.of(word, at, new Seeds(1).source(word));
        double little = departure(law, law.least(), at, w);
        double much = departure(law, law.most(), at, w);
        assertTrue(little < 0.2 && much > 4 * little && much > 0.15, little + " to " + much);
        double still = law.physics().apply(law.most()).apply(1e-5).force(0, 0, 0, new double[1], 0);
        assertEquals(0, still, 0.07 * at.force());
        assertFalse(law.parameters().apply(law.most()).isEmpty());
    }

    /** As it was before the moment, spring and dashpot times the factors that the key tells after it; slowly, all along the recording. */
    @ParameterizedTest
    @CsvSource({"drift.step, 1", "drift.step, 2", "drift.step, 5", "drift.slow, 3", "drift.slow, 4"})
    void whatChangesInTimeEndsByTheFactorsThatAreTold(String word, long seed) {
        double w = 2 * Math.PI * 40;
        Coordinate at = new Coordinate(3e5, 120, 1e-3, w * 1e-3, Math.hypot(3e5, 120 * w) * 1e-3, false, 4);
        CoordinateLaw law = CoordinateLaw.of(word, at, new Seeds(seed).source(word));
        LinkPhysics physics = law.physics().apply(law.most()).apply(1e-5);
        double stiffness = law.parameters().apply(law.most()).get("stiffness_factor");
        double damping = law.parameters().apply(law.most()).get("damping_factor");
        assertTrue(stiffness != 1 || damping != 1, law.form());
        assertEquals(at.k(), physics.force(0, 1, 0, new double[0], 0), 1e-9 * at.k());
        assertEquals(at.c(), physics.force(0, 0, 1, new double[0], 0), 1e-9 * at.c());
        double later = word.equals("drift.step") ? 4 : 1e3;
        assertEquals(stiffness * at.k(), physics.force(later, 1, 0, new double[0], 0), 1e-9 * at.k());
        assertEquals(damping * at.c(), physics.force(later, 0, 1, new double[0], 0), 1e-9 * at.c());
        assertEquals(word.equals("drift.step"), law.parameters().apply(law.most()).containsKey("time_s"));
    }

    /** Root mean square of what it does beside spring and dashpot along a sine, over the usual force. */
    private static double departure(CoordinateLaw law, double size, Coordinate at, double w) {
        double h = 1e-5;
        LinkPhysics physics = law.physics().apply(size).apply(h);
        double[] y = new double[physics.states()];
        double[] rate = new double[physics.states()];
        double sum = 0;
        int n = 10_000;
        for (int i = 0; i < n; i++) {
            double r = Math.sqrt(2) * at.travel() * Math.sin(w * i * h);
            double v = Math.sqrt(2) * at.travel() * w * Math.cos(w * i * h);
            double beside = physics.force(i * h, r, v, y, 0) - at.k() * r - at.c() * v;
            sum += beside * beside / n;
            physics.rates(i * h, r, v, y, 0, rate);
            for (int q = 0; q < y.length; q++) {
                y[q] += h * rate[q];
            }
            physics.commit((i + 1) * h, Math.sqrt(2) * at.travel() * Math.sin(w * (i + 1) * h), v);
        }
        return Math.sqrt(sum) / at.force();
    }
}
