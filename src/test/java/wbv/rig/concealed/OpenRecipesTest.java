package wbv.rig.concealed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.rig.concealed.law.Term;
import wbv.rig.platform.Seeds;

class OpenRecipesTest {

    private static Stream<String> laws() {
        return ConcealedSpec.OPEN.stream();
    }

    private static final RideScene SCENE = RideScene.of(Setting.RIG, OptionalDouble.of(8), new Seeds(3));

    /**
     * What bodies above a link weigh against their own motion it must carry: Newton's law, asked of the trace without a look at any law.
     * What is left beside stiffness and damping is the concealed force.
     */
    @ParameterizedTest
    @MethodSource("laws")
    void theForceThatIsSealedIsWhatTheMotionAsksFor(String word) {
        RideScene scene = SCENE;
        Chain chain = scene.chain();
        OmissionRecipe recipe = new Recipes(scene, new Seeds(5).source(word)).of(word, Set.of());
        Omission omission = recipe.of().apply(Math.sqrt(recipe.least() * recipe.most()));
        Setup setup = new Setup(chain);
        omission.change().accept(setup);
        ChainPlant.Trace trace = scene.sketch(setup);
        Imus imus = new Imus(scene, false);
        boolean rider = word.equals("open.slosh");
        int link = rider ? chain.body(omission.where()) : List.of(0, 1, 2, 3).stream().filter(i -> i < chain.size()
                && chain.link(i).equals(omission.where())).findFirst().orElseThrow();
        double[] asked = new double[trace.extension()[link].length];
        for (int s = 0; s < asked.length; s++) {
            double above = 0;
            for (int i = link; i < chain.size(); i++) {
                above += isAbove(chain, i, link) ? chain.mass()[i] * trace.acceleration()[i][s] : 0;
            }
            double linear = chain.stiffness()[link] * trace.extension()[link][s] + chain.damping()[link] * trace.rate()[link][s];
            asked[s] = rider ? above + linear : -above - linear;
        }
        double[] rows = imus.thinned(asked);
        String[] told = ConcealedForce.of(omission, chain, trace, imus).split("\n");
        assertEquals(rows.length, told.length - 1);
        double size = UniformSeries.rms(rows);
        assertTrue(size > 0.1, word + " does nothing: " + size + " N");
        for (int i = 0; i < rows.length; i += 7) {
            assertEquals(rows[i], Double.parseDouble(told[i + 1].split(",")[1]), 1e-4 * size, word);
        }
    }

    private static boolean isAbove(Chain chain, int body, int link) {
        return body == link || body > link && chain.parent()[body] >= 0 && isAbove(chain, chain.parent()[body], link);
    }

    @ParameterizedTest
    @MethodSource("laws")
    void aKeySaysWhatTheLawIsMadeOf(String word) {
        OmissionRecipe recipe = new Recipes(SCENE, new Seeds(6).source(word)).of(word, Set.of());
        Omission omission = recipe.of().apply(recipe.least());
        assertEquals("unknown", omission.mechanism());
        assertFalse(ConcealedSpec.MECHANISMS.contains(word));
        assertFalse(omission.form().isEmpty());
        assertTrue(omission.parameters().size() >= 1 && omission.parameters().values().stream().allMatch(x -> x > 0), word);
        assertEquals(1, omission.law().size());
        for (Term.Factor factor : omission.law().get(0).factors()) {
            assertTrue(
                    Set.of("speed", "deflection", "acceleration", "load", "time", "tilt", "channel", "hidden mass").contains(factor.of()),
                    word);
            assertEquals(Set.of("load", "tilt", "channel").contains(factor.of()) || word.equals("open.muscle.two-joint"),
                    !factor.at().isEmpty(), word);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"open.friction.load", "open.stiffness.bolster", "open.muscle.two-joint"})
    void aLawIsSizedUntilALinearChainMissesItsShare(String word) {
        OmissionRecipe recipe = new Recipes(SCENE, new Seeds(2).source(word)).of(word, Set.of());
        assertEquals(Math.log(0.02), Math.log(OmissionSize.of(recipe, SCENE, new Imus(SCENE, false), 0.02).share()), 0.5);
    }

    @Test
    void theForceIsSealedByRowOfTheRecordingAndHeldByTheKey() throws IOException {
        ConcealedCase made = Concealer.make(new ConcealedSpec("1", List.of("open.friction.side"), 1, Setting.FIELD, false, 3));
        JsonNode key = new ObjectMapper().readTree(made.key());
        String force = made.force().orElseThrow();
        assertEquals(ConcealedForce.digest(force), key.get("force_sha256").asText());
        String[] rows = force.split("\n");
        assertEquals(made.recording().length(), rows.length - 1);
        assertEquals("time_s,force_N,extension_m,rate_m_per_s", rows[0]);
        for (int i = 1; i < rows.length; i++) {
            double[] row = Arrays.stream(rows[i].split(",")).mapToDouble(Double::parseDouble).toArray();
            assertEquals(4, row.length);
            assertEquals((i - 1) / 60.0, row[0], 1e-6);
            assertTrue(Arrays.stream(row).allMatch(Double::isFinite));
        }
        JsonNode law = key.get("mechanisms").get(0).get("law").get(0);
        assertEquals("[{\"of\":\"channel\",\"at\":\"pelvis.acc.y\",\"as\":\"magnitude\"},{\"of\":\"speed\",\"as\":\"sign\"}]",
                law.get("factors").toString());
    }
}
