package wbv.rig.concealed;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import wbv.recording.Channel;
import wbv.rig.concealed.law.Springs;
import wbv.rig.platform.Seeds;

class ConcealerTest {

    private static ConcealedSpec spec(long seed, boolean exact, String... words) {
        return new ConcealedSpec("1", List.of(words), 1, Setting.FIELD, exact, seed);
    }

    @Tag("slow")
    @Test
    void theSameSpecGivesTheSameRecordingModelAndKey() {
        ConcealedCase a = Concealer.make(spec(3, false, "sensor.gain"));
        ConcealedCase b = Concealer.make(spec(3, false, "sensor.gain"));
        assertEquals(a.key(), b.key());
        assertEquals(a.model(), b.model());
        for (Channel channel : a.recording().channels()) {
            assertArrayEquals(a.recording().values(channel), b.recording().values(channel), 0);
        }
    }

    /** Without and with a fault at one sensor, all else drawn alike: only that sensor's channels differ. */
    @Test
    void aFaultChangesItsOwnSensorOnly() {
        RideScene scene = RideScene.of(Setting.FIELD, new Seeds(8));
        Imus imus = new Imus(scene, false);
        Setup healthy = new Setup(scene.chain());
        Setup faulty = new Setup(scene.chain());
        faulty.fault("head", Fault.late(0.01, 0.01));
        Map<String, double[][]> before = imus.sent(healthy, scene.calm(), new Seeds(9));
        Map<String, double[][]> after = imus.sent(faulty, scene.calm(), new Seeds(9));
        for (String place : RideScene.PLACES) {
            for (int q = 0; q < 6; q++) {
                if (!place.equals("head")) {
                    assertArrayEquals(before.get(place)[q], after.get(place)[q], 0, place);
                }
            }
        }
        assertTrue(UniformSeries.rms(UniformSeries.less(before.get("head")[Fault.Z], after.get("head")[Fault.Z])) > 0.01);
    }

    /** Physics moves the bodies and leaves the platform and the motion across alone. */
    @Test
    void aLawChangesTheVerticalsOnly() {
        RideScene scene = RideScene.of(Setting.FIELD, new Seeds(8));
        Imus imus = new Imus(scene, false);
        Setup soft = new Setup(scene.chain());
        soft.link(0, h -> Springs.tanh(scene.chain().stiffness()[0], scene.chain().damping()[0], 3e-4));
        Map<String, double[][]> before = imus.clean(new Setup(scene.chain()), scene.calm());
        Map<String, double[][]> after = imus.clean(soft, scene.sketch(soft));
        for (String place : RideScene.PLACES) {
            for (int q = 0; q < 6; q++) {
                if (place.equals("platform") || q != Fault.Z) {
                    assertArrayEquals(before.get(place)[q], after.get(place)[q], 0, place);
                }
            }
        }
        assertTrue(UniformSeries.rms(UniformSeries.less(before.get("head")[Fault.Z], after.get("head")[Fault.Z])) > 0.05);
    }

    @Test
    void theModelSaysNothingOfWhatIsConcealed() throws IOException {
        ConcealedCase made = Concealer.make(spec(4, false, "sensor.delay"));
        JsonNode model = new ObjectMapper().readTree(made.model());
        for (String word : ConcealedSpec.MECHANISMS) {
            assertFalse(made.model().contains(word));
        }
        JsonNode truth = new ObjectMapper().readTree(made.key()).get("true_linear_model");
        for (int i = 0; i < model.get("links").size(); i++) {
            double wrong = model.get("links").get(i).get("stiffness_N_per_m").asDouble()
                    / truth.get("links").get(i).get("stiffness_N_per_m").asDouble();
            assertTrue(Math.abs(wrong - 1) > 0.025 && Math.abs(wrong - 1) < 0.155, "off by " + wrong);
        }
        assertFalse(made.recording().metadata().toString().contains("seed"));
    }

    @Tag("slow")
    @Test
    void aNullWithAnExactModelLacksNothing() throws IOException {
        ConcealedCase made = Concealer.make(spec(5, true));
        JsonNode key = new ObjectMapper().readTree(made.key());
        assertEquals(0, key.get("mechanisms").size());
        assertTrue(made.force().isEmpty());
        assertEquals(1, key.get("linear_chi2").asDouble(), 0);
        assertEquals(key.get("true_linear_model").get("links"), new ObjectMapper().readTree(made.model()).get("links"));
    }

    /** Of a pair the key says how plain each would be alone; what both are together is their sum over the noise. */
    @Tag("slow")
    @Test
    void theKeyOfAPairSaysHowPlainEachIs() throws IOException {
        JsonNode key = new ObjectMapper().readTree(Concealer.make(spec(6, false, "contact.bumpstop", "sensor.gain")).key());
        double excess = 0;
        for (JsonNode one : key.get("mechanisms")) {
            assertTrue(one.get("linear_chi2").asDouble() > 1.5, one.toString());
            excess += one.get("linear_chi2").asDouble() - 1;
        }
        assertEquals(key.get("linear_chi2").asDouble(), 1 + excess, 1e-3 * excess);
    }

    /** The fit of another linear chain takes up wrong values to the last, and nothing of a stop. */
    @Tag("slow")
    @Test
    void aLinearFitTakesUpWrongValuesAndNoPhysics() {
        RideScene scene = RideScene.of(Setting.FIELD, new Seeds(11));
        Imus imus = new Imus(scene, false);
        Setup calm = new Setup(scene.chain());
        double[] platform = imus.vertical(calm, scene.calm(), "platform");
        List<String> places = scene.outputs();
        int[] body = places.stream().mapToInt(place -> scene.chain().rider(place)).toArray();
        double[][] outputs = places.stream().map(place -> imus.vertical(calm, scene.calm(), place)).toArray(double[][]::new);
        for (double left : new LinearFit(body, platform, outputs).left(scene.chain().stiffer(1.2))) {
            // What is left is the platform's tilt times the motion across, which no chain has.
            assertTrue(left < 1e-4, "left " + left);
        }
        OmissionRecipe stop = new LinkRecipes(scene, 1, new Seeds(2).source("stop")).of("contact.bumpstop");
        OmissionSize sized = OmissionSize.of(stop, scene, imus, 0.03);
        assertEquals(Math.log(0.03), Math.log(sized.share()), 0.7);
    }

    /** Contact can only be lost on the first link, which another law would else be given as often as not. */
    @Test
    void aPairWhoseSecondHasOnePlaceOnlyGetsIt() {
        assertEquals(List.of("contact.loss", "stiffness.softening"), Recipes.choosyFirst(List.of("stiffness.softening", "contact.loss")));
        assertEquals(List.of("mode.hidden", "hysteresis"), Recipes.choosyFirst(List.of("mode.hidden", "hysteresis")));
    }

    @Test
    void nothingCanBeConcealedThatHasNoName() {
        assertThrows(IllegalArgumentException.class, () -> spec(1, true, "magic"));
        assertThrows(IllegalArgumentException.class, () -> new ConcealedSpec("1", List.of(), 0, Setting.RIG, true, 1));
    }

    @Test
    void everyNamedKindCanBeConcealedSomewhere() {
        RideScene scene = RideScene.of(Setting.FIELD, new Seeds(12));
        Recipes recipes = new Recipes(scene, new Seeds(13).source("all"));
        for (List<String> words : List.of(ConcealedSpec.MECHANISMS, ConcealedSpec.UNLISTED, ConcealedSpec.OPEN)) {
            for (String word : words) {
                OmissionRecipe recipe = recipes.of(word, Set.of());
                Omission omission = recipe.of().apply(recipe.least());
                assertEquals(word.startsWith("unlisted.") || word.startsWith("open.") ? "unknown" : word, omission.mechanism());
                assertFalse(omission.parameters().isEmpty());
            }
        }
    }

    /** A place stiff on its guide moves across as the platform does there: a + height times angular acceleration. */
    @Test
    void swayIsTheSecondIntegralOfWhatItsSensorFeels() {
        int n = 9600;
        double w = 2 * Math.PI * 1.5;
        double[] still = new double[n];
        double[] angle = IntStream.range(0, n).mapToDouble(i -> 0.004 * Math.sin(w * i / UniformSeries.RATE)).toArray();
        Sway head = Sway.of("head", still, angle);
        // In the steady state, acceleration = -w² displacement.
        for (int i = n - 1500; i < n - 10; i += 50) {
            assertEquals(-w * w * head.displacement()[i], head.acceleration()[i], 0.02 * w * w * 0.01);
        }
    }
}
