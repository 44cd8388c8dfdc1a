package wbv.filter;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import wbv.filter.drift.Adwin;
import wbv.filter.model.Spec;
import wbv.recording.DataFault;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/** An estimator that was saved and loaded goes on bit for bit; see {@code SeatStateTest} for seats. */
class EstimatorStateTest {

    private static final int SAMPLES = 1500;
    private static final int POINTS = 40;
    private static final int GOES_ON = 60;

    static List<EstimatorDesign> designs() {
        List<EstimatorDesign> all = new ArrayList<>();
        for (Method method : Method.values()) {
            for (int degrees = 1; degrees <= 2; degrees++) {
                all.add(EstimatorDesign.of(method).withDegrees(degrees).withParticles(100));
            }
        }
        all.add(EstimatorDesign.of(Method.CONSTRAINED).within(FixedBounds.parse("frequency=3:6,damping=0.2:0.5")));
        all.add(EstimatorDesign.of(Method.CONSTRAINED).withSkyhook());
        return all;
    }

    /** A body that becomes stiffer, one sample in 20 missing, a gap of two seconds, a channel dead for a while, shocks. */
    private static double[][] samples(long seed) {
        SimulatedSitter sitter = SimulatedSitter.of(seed);
        SimulatedSitter.Motion motion = sitter.becoming(sitter.withStiffness(1.6), 0.8, SAMPLES / 60.0, 15, seed)
                .measured(Spec.noise(60), seed);
        Random random = new Random(seed);
        double[][] all = {motion.u(), motion.y()};
        for (int i = 0; i < SAMPLES; i++) {
            for (double[] channel : all) {
                boolean gone = random.nextInt(40) == 0 || i > 700 && i < 800 || channel == all[1] && i > 1200 && i < 1280;
                channel[i] = gone ? Double.NaN : channel[i] + (random.nextInt(500) == 0 ? 30 * random.nextGaussian() : 0);
            }
        }
        return all;
    }

    private static long[] bits(BodyEstimate track) {
        return Stream.of(track.frequency(), track.damping(), track.frequencyDeviation(), track.dampingDeviation(), track.prediction(),
                track.nis(), track.outputNoise(), track.share(), (double) track.width(), (double) track.cuts())
                .mapToLong(Double::doubleToRawLongBits).toArray();
    }

    @TestFactory
    Stream<DynamicTest> aSavedEstimatorGoesOnBitForBit() {
        return designs().stream().map(design -> DynamicTest.dynamicTest(design.toString(), () -> goesOn(design)));
    }

    private static void goesOn(EstimatorDesign design) {
        double[][] in = samples(design.hashCode() & 0xFF);
        Random random = new Random(design.method().ordinal());
        Estimator estimator = design.estimator(Spec.at(60), Adwin::new);
        long[][] said = new long[SAMPLES][];
        byte[][] states = new byte[SAMPLES + 1][];
        boolean[] wanted = new boolean[SAMPLES + 1];
        List<Integer> points = new ArrayList<>();
        for (int k = 0; k < POINTS; k++) {
            int at = k == 0 ? 0 : random.nextInt(SAMPLES - GOES_ON);
            points.add(at);
            wanted[at] = true;
            wanted[at + GOES_ON] = true;
        }
        for (int i = 0; i <= SAMPLES; i++) {
            states[i] = wanted[i] ? EstimatorState.of(estimator) : new byte[0];
            if (i < SAMPLES) {
                said[i] = bits(estimator.step(in[0][i], in[1][i]));
            }
        }
        for (int at : points) {
            Estimator copy = EstimatorState.read("state", states[at], Adwin::new);
            assertEquals(design, copy.design());
            for (int i = at; i < at + GOES_ON; i++) {
                assertArrayEquals(said[i], bits(copy.step(in[0][i], in[1][i])), "sample " + i + " of " + at);
            }
            assertArrayEquals(states[at + GOES_ON], EstimatorState.of(copy), "state " + GOES_ON + " samples after " + at);
        }
        assertTrue(estimator.track().missing() > 100, "samples were missing");
    }

    /** Loaded into one that has another past, nothing of that past is left. */
    @TestFactory
    Stream<DynamicTest> whatWasThereBeforeIsForgotten() {
        return designs().stream().map(design -> DynamicTest.dynamicTest(design.toString(), () -> {
            double[][] one = samples(1);
            double[][] other = samples(2);
            Estimator saved = design.estimator(Spec.at(60), Adwin::new);
            Estimator used = design.estimator(Spec.at(60), Adwin::new);
            for (int i = 0; i < 700; i++) {
                saved.step(one[0][i], one[1][i]);
                used.step(other[0][i], other[1][i]);
            }
            StateReader.into(used, "state", StateWriter.of(saved));
            for (int i = 700; i < 1100; i++) {
                assertArrayEquals(bits(saved.step(one[0][i], one[1][i])), bits(used.step(one[0][i], one[1][i])));
            }
            assertArrayEquals(StateWriter.of(saved), StateWriter.of(used));
        }));
    }

    @Test
    void otherMotionsAreKeptToo() {
        double[][] in = samples(3);
        double[][] others = samples(4);
        AccompaniedEstimator first = new AccompaniedEstimator(EstimatorDesign.of(Method.EKF_ADWIN).estimator(Spec.at(60), Adwin::new), 2);
        AccompaniedEstimator second = new AccompaniedEstimator(EstimatorDesign.of(Method.EKF_ADWIN).estimator(Spec.at(60), Adwin::new), 2);
        double[] row = new double[2];
        for (int i = 0; i < SAMPLES; i++) {
            row[0] = others[0][i];
            row[1] = others[1][i];
            if (i == 50 || i == 1000) {
                StateReader.into(second, "state", StateWriter.of(first));
            }
            long[] said = bits(first.step(in[0][i], row, in[1][i]));
            if (i >= 50) {
                assertArrayEquals(said, bits(second.step(in[0][i], row, in[1][i])), "sample " + i);
            }
        }
    }

    @Test
    void aStateIsSmall() {
        double[][] in = samples(3);
        Estimator estimator = EstimatorDesign.of(Method.EKF).estimator(Spec.at(60), Adwin::new);
        Estimator bank = EstimatorDesign.of(Method.EKF_ADWIN).estimator(Spec.at(60), Adwin::new);
        for (int i = 0; i < SAMPLES; i++) {
            estimator.step(in[0][i], in[1][i]);
            bank.step(in[0][i], in[1][i]);
        }
        assertTrue(EstimatorState.of(estimator).length < 2000, EstimatorState.of(estimator).length + " bytes");
        assertTrue(EstimatorState.of(bank).length < 4000, EstimatorState.of(bank).length + " bytes");
    }

    /** Every fault is one line that names the state; none is a fault of ours. */
    @Test
    void whatIsNoStateIsRefused() {
        Estimator estimator = EstimatorDesign.of(Method.CONSTRAINED).estimator(Spec.at(60), Adwin::new);
        byte[] state = EstimatorState.of(estimator);
        Random random = new Random(8);
        for (int cut = 0; cut < state.length; cut += 1 + random.nextInt(20)) {
            refused(Arrays.copyOf(state, cut));
        }
        refused(Arrays.copyOf(state, state.length + 7));
        for (int i = 0; i < 2000; i++) {
            byte[] mutated = state.clone();
            mutated[random.nextInt(state.length)] ^= (byte) (1 + random.nextInt(255));
            refused(mutated);
        }
        assertTrue(refused(version(state, StateWriter.VERSION + 1)).contains("version 5; this program reads 1 to 4"));
        assertTrue(refused(version(state, 0)).contains("version 0"));
        assertTrue(refused(StateWriter.of(estimator)).contains("saved state of something else"));
        Estimator other = EstimatorDesign.of(Method.FUSED).estimator(Spec.at(60), Adwin::new);
        assertThrows(DataFault.class, () -> StateReader.into(other, "x", StateWriter.of(estimator)));
        assertThrows(DataFault.class, () -> StateReader.into(estimator, "x", StateWriter.of(other)));
    }

    private static String refused(byte[] bytes) {
        DataFault fault = assertThrows(DataFault.class, () -> EstimatorState.read("state.bin", bytes, Adwin::new));
        assertTrue(fault.getMessage().startsWith("state.bin: ") && fault.getMessage().indexOf('\n') < 0, fault.getMessage());
        return fault.getMessage();
    }

    /** The same state as another version would have written it: checksum right. */
    static byte[] version(byte[] state, int version) {
        byte[] other = state.clone();
        other[4] = (byte) version;
        java.util.zip.CRC32C sum = new java.util.zip.CRC32C();
        sum.update(other, 0, other.length - 4);
        java.nio.ByteBuffer.wrap(other).putInt(other.length - 4, (int) sum.getValue());
        return other;
    }
}
