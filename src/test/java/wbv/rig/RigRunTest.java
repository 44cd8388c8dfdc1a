package wbv.rig;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.recording.Channel;
import wbv.recording.Recording;

/** An experiment as a stream of rows. */
class RigRunTest {

    private static final String PERSON = "subject=3 regime=8 seconds=4 effects=all ";

    @Test
    void sameSpecGivesTheSameBits() {
        assertArrayEquals(ImuTest.read(RigSpec.parse(PERSON + "seed=9")), ImuTest.read(RigSpec.parse(PERSON + "seed=9")));
    }

    @Test
    void anotherSeedGivesAnotherExperiment() {
        double[][] one = ImuTest.read(RigSpec.parse("regime=2 seconds=4 seed=1 effects=none"));
        double[][] other = ImuTest.read(RigSpec.parse("regime=2 seconds=4 seed=2 effects=none"));
        for (int channel = 1; channel < one[0].length; channel++) {
            assertNotEquals(one[200][channel], other[200][channel]);
        }
    }

    @Test
    void longerExperimentBeginsLikeTheShorter() {
        double[][] shorter = ImuTest.read(RigSpec.parse("regime=2 seconds=3"));
        double[][] longer = ImuTest.read(RigSpec.parse("regime=2 seconds=6"));
        for (int i = 0; i < 140; i++) {
            assertArrayEquals(shorter[i], longer[i], "row " + i + ", before the shorter one fades");
        }
    }

    @Test
    void rowsComeOnOneClockFromZero() {
        RigSpec spec = RigSpec.parse("regime=1 seconds=2 rate=100");
        double[][] rows = ImuTest.read(spec);
        assertEquals(200, rows.length);
        for (int i = 0; i < rows.length; i++) {
            assertEquals(i / 100.0, rows[i][0]);
        }
        RigRun run = spec.withSeconds(0.02).run();
        double[] row = new double[1 + run.channels().size()];
        assertTrue(run.read(row) && run.read(row));
        assertFalse(run.read(row));
    }

    @ParameterizedTest
    @ValueSource(doubles = {60, 100, 256, 1000})
    void everythingRestsUntilTheExcitationBegins(double rate) {
        double[][] rows = ImuTest.read(RigSpec.parse("excitation=idle@1+regime:3@1 effects=none").withRate(rate));
        for (int i = 0; i < rate; i++) {
            for (int j = 1; j < rows[i].length; j++) {
                assertEquals(0, rows[i][j], "row " + i + ", column " + j);
            }
        }
        assertNotEquals(0, rows[(int) (1.5 * rate)][3]);
    }

    @Test
    void aSensorLeftOutChangesNoOther() {
        RigSpec all = RigSpec.parse(PERSON + "seed=2");
        RigSpec some = all.withChannels(List.of(Channel.parse("head.gyr.y"), Channel.parse("sternum.acc.z")));
        double[][] wide = ImuTest.read(all);
        double[][] narrow = ImuTest.read(some);
        int gyr = 1 + all.channels().indexOf(Channel.parse("head.gyr.y"));
        int acc = 1 + all.channels().indexOf(Channel.parse("sternum.acc.z"));
        for (int i = 0; i < narrow.length; i++) {
            assertEquals(wide[i][gyr], narrow[i][1]);
            assertEquals(wide[i][acc], narrow[i][2]);
        }
    }

    @ParameterizedTest
    @EnumSource(value = Effect.class, names = {"NOISE", "BIAS", "DRIFT", "TILT", "RESOLUTION", "LOSS"})
    void errorOfSensorsLeavesTheTruthAsItWas(Effect effect) {
        RigSpec with = RigSpec.parse("regime=6 seconds=3 seed=3 effects=all");
        RigSpec without = with.withEffects(with.effects().without(effect));
        double[][] ideal = ideal(with);
        double[][] same = ideal(without);
        for (int i = 0; i < ideal.length; i++) {
            assertArrayEquals(ideal[i], same[i]);
        }
    }

    @ParameterizedTest
    @EnumSource(value = Effect.class, names = {"SOFTENING", "CROSS", "LEVER", "CUSHION"})
    void effectOfTheSitterLeavesThePlatformAsItWasAndChangesTheHead(Effect effect) {
        RigSpec with = RigSpec.parse("regime=6 seconds=5 seed=3");
        double[][] one = ideal(with);
        double[][] other = ideal(with.withEffects(with.effects().without(effect)));
        double change = 0;
        int head = 1 + with.channels().indexOf(Channel.parse("head.acc.x"));
        for (int i = 0; i < one.length; i++) {
            for (int j = 1; j <= 6; j++) {
                assertEquals(one[i][j], other[i][j]);
            }
            change = Math.max(change, Math.abs(one[i][head] - other[i][head]));
        }
        assertTrue(change > 0.01, "the head feels it: " + change);
    }

    @Test
    void noiseFactorScalesTheNoiseAlone() {
        double[][] quiet = ImuTest.read(RigSpec.parse("sitter=one-dof effects=none noise=0 seconds=5"));
        double[][] usual = ImuTest.read(RigSpec.parse("sitter=one-dof effects=noise noise=1 seconds=5"));
        double[][] loud = ImuTest.read(RigSpec.parse("sitter=one-dof effects=noise noise=3 seconds=5"));
        for (int i = 0; i < quiet.length; i++) {
            assertEquals(3 * (usual[i][1] - quiet[i][1]), loud[i][1] - quiet[i][1], 1e-12);
        }
    }

    @Test
    void recordingInMemoryHoldsTheRows() {
        RigSpec spec = RigSpec.oneDof(0.3, 5, 1, 2, 4);
        Recording recording = spec.recording();
        double[][] rows = ImuTest.read(spec);
        assertEquals(120, recording.length());
        assertEquals(60, recording.clock().rate());
        for (int i = 0; i < rows.length; i++) {
            assertEquals(rows[i][2], recording.values(Channel.parse("head.acc.z"))[i]);
        }
    }

    @Test
    void metadataSaysHowToMakeItAgain() {
        RigSpec spec = RigSpec.parse(PERSON);
        assertEquals(spec, RigSpec.parse(spec.run().metadata().notes().get("rig")));
        assertEquals(88.09, spec.run().metadata().subject().orElseThrow().mass().orElseThrow());
        assertTrue(spec.run().metadata().source().orElseThrow().contains("simulated"));
    }

    private static double[][] ideal(RigSpec spec) {
        RigRun run = spec.run();
        double[][] rows = new double[(int) spec.rows()][1 + spec.channels().size()];
        for (double[] row : rows) {
            assertTrue(run.read(row));
            run.ideal(row);
        }
        return rows;
    }
}
