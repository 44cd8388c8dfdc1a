package wbv.signal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.recording.DataFault;
import wbv.signal.FrequencyResponse.Excited;
import wbv.signal.KnownBodies.Response;

class ResponseMatrixTest {

    private static final double RATE = 60;
    private static final int LENGTH = 1 << 17;
    private static final int SEGMENT = 1024;

    private static Response body(String name) {
        return switch (name) {
            case "one" -> KnownBodies.oneDegree(5, 0.35);
            case "two" -> KnownBodies.chain(KnownBodies.ALLEN, 1);
            case "four" -> KnownBodies.chain(KnownBodies.BOILEAU, 3);
            default -> throw new IllegalArgumentException(name);
        };
    }

    /** The bodies of the tests are those of the literature: |H| as computed elsewhere from the same masses and springs. */
    @Test
    void theBodiesAreTheKnownOnes() {
        double[][] allen = {{2, 1.129444}, {5, 1.458062}, {10, 1.279637}};
        for (double[] oracle : allen) {
            assertEquals(oracle[1], modulus(body("two"), oracle[0]), 1e-6);
        }
        double[][] boileau = {{2, 1.179}, {4, 1.696}, {5, 1.759}, {6, 1.500}, {8, 0.951}, {10, 0.670}, {16, 0.375}, {20, 0.308}};
        for (double[] oracle : boileau) {
            assertEquals(oracle[1], modulus(body("four"), oracle[0]), 6e-4);
        }
        assertEquals(1.7970, modulus(body("one"), 5 * 0.9115), 1e-4);
    }

    private static double modulus(Response response, double f) {
        double[] h = response.at(f);
        return Math.hypot(h[0], h[1]);
    }

    /** Noise on the output: H1 lies about the closed form as widely as it says, and its 95 % bands hold 95 % of the truth. */
    @ParameterizedTest
    @ValueSource(strings = {"one", "two", "four"})
    void bodiesAreRecoveredWithinTheStatedError(String name) {
        Random random = new Random(11);
        double[] x = KnownBodies.spectrum(LENGTH, RATE, 0.3, 25, random);
        double[] y = new double[LENGTH];
        KnownBodies.pass(x, body(name), RATE, y);
        ResponseMatrix h = ResponseMatrix.of(KnownBodies.spectra(RATE, SEGMENT, KnownBodies.record(x, 0, random),
                KnownBodies.record(y, 0.7, random)), 1, Excited.USUAL);
        double[] margin = h.margin(0, 0, 0.95);
        double[] angle = h.phaseMargin(0, 0, 0.95);
        double squares = 0;
        int inModulus = 0;
        int inPhase = 0;
        int count = 0;
        for (int k = 9; h.frequency()[k] < 24; k += 2) {
            double[] truth = body(name).at(h.frequency()[k]);
            double a = h.h1(0, 0).re()[k] - truth[0];
            double b = h.h1(0, 0).im()[k] - truth[1];
            squares += (a * a + b * b) / (2 * Math.pow(h.deviation(0, 0)[k], 2));
            inModulus += Math.abs(h.h1(0, 0).magnitude(k) - Math.hypot(truth[0], truth[1])) <= margin[k] ? 1 : 0;
            double turn = Math.IEEEremainder(h.h1(0, 0).phase(k) - Math.atan2(truth[1], truth[0]), 2 * Math.PI);
            inPhase += Math.abs(turn) <= angle[k] ? 1 : 0;
            count++;
        }
        // Every other bin of Hann's window is nearly independent: the mean square of 200 is 1 ± 0.07, a share of 95 % ± 1.5 %.
        assertTrue(count > 190);
        assertEquals(1, squares / count, 0.3);
        assertEquals(0.95, (double) inModulus / count, 0.06);
        assertEquals(0.95, (double) inPhase / count, 0.06);
        assertTrue(h.usable(0, 0)[100] && h.usable(0, 0)[300]);
    }

    /** Noise of the same signal-to-noise ratio on input and output: H1 is low, H2 high by the same factor, Hv right. */
    @ParameterizedTest
    @ValueSource(doubles = {0.05, 0.2, 0.5})
    void hvIsUnbiasedWhereBothAreNoisy(double noise) {
        Random random = new Random(12);
        int length = 1 << 19;
        double[] x = KnownBodies.spectrum(length, RATE, 0, 30, random);
        double[] y = new double[length];
        KnownBodies.pass(x, f -> new double[] {1.2, -0.9}, RATE, y);   // modulus 1.5 at all frequencies
        double power = RATE / 2;
        ResponseMatrix h = ResponseMatrix.of(KnownBodies.spectra(RATE, 256,
                KnownBodies.record(x, Math.sqrt(noise * power), random),
                KnownBodies.record(y, 1.5 * Math.sqrt(noise * power), random)), 1, Excited.USUAL);
        double[] real = new double[3];
        double[] imaginary = new double[3];
        int count = 0;
        for (int k = 3; k < 126; k++) {
            ComplexSeries[] all = {h.h1(0, 0), h.h2(0, 0).orElseThrow(), h.hv(0, 0)};
            for (int e = 0; e < 3; e++) {
                real[e] += all[e].re()[k];
                imaginary[e] += all[e].im()[k];
            }
            count++;
        }
        double scatter = 1.5 * Math.sqrt((Math.pow(1 + noise, 2) - 1) / 2 / h.averages());
        double bound = 5 * scatter / Math.sqrt(count / 2.0);
        assertEquals(1.2 / (1 + noise), real[0] / count, bound);
        assertEquals(1.2 * (1 + noise), real[1] / count, bound * 2);
        assertEquals(1.2, real[2] / count, bound);
        assertEquals(-0.9, imaginary[2] / count, bound);
        assertTrue(bound < 0.1 * noise * 1.2 || noise < 0.1, "the bias must show");
    }

    /** Three inputs that share most of their motion, three outputs: H1 finds every entry, and one input alone would not. */
    @ParameterizedTest
    @CsvSource({"0, 0.3", "0.7, 0.3", "0.9, 0.3"})
    void inputsThatMoveTogetherAreToldApart(double shared, double noise) {
        Random random = new Random(13);
        double[][] x = sharing(shared, random);
        double[][] gain = {{1, 0.3, -0.2}, {0, 1.4, 0.5}, {0.6, 0, 0.8}};
        ResponseMatrix h = respond(x, gain, 0, noise, random);
        double squares = 0;
        int count = 0;
        for (int o = 0; o < 3; o++) {
            for (int i = 0; i < 3; i++) {
                for (int k = 20; k < 480; k += 2) {
                    double a = h.h1(o, i).re()[k] - gain[o][i];
                    double b = h.h1(o, i).im()[k];
                    squares += (a * a + b * b) / (2 * Math.pow(h.deviation(o, i)[k], 2));
                    count++;
                }
            }
        }
        assertEquals(1, squares / count, 0.1);
        // What each input has in common with the other two, from the matrix (1-s) I + s 1 of the inputs.
        double own = (1 - shared) * (1 + 2 * shared) / (1 + shared);
        assertEquals(1 - own, mean(h.coherenceAmongInputs(0)), 0.03);
        ResponseMatrix alone = respond(new double[][] {x[0]}, new double[][] {gain[0]}, 0, 0, random, x);
        assertEquals(1 + shared * (0.3 - 0.2), mean(alone.h1(0, 0).re()), 0.02);
    }

    /** Inputs and outputs all as noisy as each other, inputs that move together: Hv is right, H1 and H2 are not. */
    @Test
    void hvOfSeveralInputsIsUnbiasedWhereAllAreNoisy() {
        Random random = new Random(14);
        double[][] x = sharing(0.5, random);
        // A rotation keeps the power of the inputs that share evenly, so that one noise suits every channel.
        double[][] gain = {{0.8, 0.36, 0.48}, {-0.6, 0.48, 0.64}, {0, -0.8, 0.6}};
        double[][] bias = new double[3][9];
        ResponseMatrix clean = respond(x, gain, 0, 0, random);
        double noise = 0.2;
        double[] extra = new double[3];
        for (int o = 0; o < 3; o++) {
            extra[o] = Math.sqrt(noise * mean(clean.outputDensity(o)) * RATE / 2);
        }
        ResponseMatrix h = respond(x, gain, Math.sqrt(noise * RATE / 2), extra, random, x);
        for (int o = 0; o < 3; o++) {
            for (int i = 0; i < 3; i++) {
                bias[0][3 * o + i] = mean(h.h1(o, i).re()) - gain[o][i];
                bias[1][3 * o + i] = mean(h.h2(o, i).orElseThrow().re()) - gain[o][i];
                bias[2][3 * o + i] = mean(h.hv(o, i).re()) - gain[o][i];
            }
        }
        assertTrue(norm(bias[0]) > 0.3, "H1 " + norm(bias[0]));
        assertTrue(norm(bias[1]) > 0.3, "H2 " + norm(bias[1]));
        assertEquals(0, norm(bias[2]), 0.05);
    }

    /** Noise on the inputs alone leaves H2 right, which H1 is not. */
    @Test
    void h2OfSeveralInputsIsUnbiasedWhereOnlyTheyAreNoisy() {
        Random random = new Random(15);
        double[][] x = sharing(0.5, random);
        double[][] gain = {{1, 0.3, -0.2}, {0, 1.4, 0.5}, {0.6, 0, 0.8}};
        ResponseMatrix h = respond(x, gain, Math.sqrt(0.2 * RATE / 2), 0, random);
        double low = 0;
        for (int o = 0; o < 3; o++) {
            for (int i = 0; i < 3; i++) {
                assertEquals(gain[o][i], mean(h.h2(o, i).orElseThrow().re()), 0.02);
                low += Math.abs(gain[o][i] - mean(h.h1(o, i).re()));
            }
        }
        assertTrue(low > 0.5);
    }

    /** Partial and multiple coherence of y = x1 + x2/2 + noise with inputs of correlation ρ, from their definitions. */
    @Test
    void coherencesAreThoseOfTheGaussianModel() {
        Random random = new Random(16);
        double rho = 0.6;
        int length = 1 << 17;
        double[][] records = new double[3][length];
        for (int n = 0; n < length; n++) {
            double a = random.nextGaussian();
            double b = rho * a + Math.sqrt(1 - rho * rho) * random.nextGaussian();
            records[0][n] = a;
            records[1][n] = b;
            records[2][n] = a + b / 2 + 0.8 * random.nextGaussian();
        }
        ResponseMatrix h = ResponseMatrix.of(KnownBodies.spectra(RATE, 128, records), 2, Excited.USUAL);
        double signal = 1 + 0.25 + rho;
        double total = signal + 0.64;
        assertEquals(signal / total, mean(h.multipleCoherence(0)), 0.005);
        assertEquals(Math.pow(1 + rho / 2, 2) / total, mean(h.ordinaryCoherence(0, 0)), 0.005);
        assertEquals((1 - rho * rho) / (1 - rho * rho + 0.64), mean(h.partialCoherence(0, 0)), 0.005);
        assertEquals(0.25 * (1 - rho * rho) / (0.25 * (1 - rho * rho) + 0.64), mean(h.partialCoherence(0, 1)), 0.005);
        assertEquals(rho * rho, mean(h.coherenceAmongInputs(0)), 0.005);
    }

    @Test
    void withOneInputEverythingIsThatOfThePair() {
        Random random = new Random(17);
        double[] x = KnownBodies.record(new double[1 << 14], 1, random);
        double[] y = KnownBodies.record(x.clone(), 0.5, random);
        CrossSpectrum pair = new CrossSpectrum(new Segmentation(RATE, 256, 0.5), Detrend.MEAN, 1);
        for (int n = 0; n < x.length; n++) {
            pair.accept(x[n], y[n]);
        }
        FrequencyResponse one = pair.response(0, Excited.USUAL);
        ResponseMatrix h = ResponseMatrix.of(KnownBodies.spectra(RATE, 256, x, y), 1, Excited.USUAL);
        assertArrayEquals(one.h1().re(), h.h1(0, 0).re(), 1e-12);
        assertArrayEquals(one.h1().im(), h.h1(0, 0).im(), 1e-12);
        for (int k = 1; k < 128; k++) {
            assertEquals(one.h2().magnitude(k), h.h2(0, 0).orElseThrow().magnitude(k), 1e-9 * one.h2().magnitude(k));
            assertEquals(one.hv().re()[k], h.hv(0, 0).re()[k], 1e-9);
            assertEquals(one.hv().im()[k], h.hv(0, 0).im()[k], 1e-9);
            assertEquals(one.coherence()[k], h.multipleCoherence(0)[k], 1e-12);
            assertEquals(one.coherence()[k], h.partialCoherence(0, 0)[k], 1e-12);
        }
    }

    @Test
    void twinInputsCannotBeToldApart() {
        Random random = new Random(18);
        double[] x = KnownBodies.record(new double[1 << 13], 1, random);
        double[] twin = KnownBodies.record(new double[1 << 13], 1e-3, random);
        for (int n = 0; n < x.length; n++) {
            twin[n] += x[n];
        }
        ResponseMatrix h = ResponseMatrix.of(KnownBodies.spectra(RATE, 256, x, twin, x), 2, Excited.USUAL);
        ResponseMatrix same = ResponseMatrix.of(KnownBodies.spectra(RATE, 256, x, x, x), 2, Excited.USUAL);
        for (int k = 0; k < 129; k++) {
            assertFalse(h.usable(0, 0)[k] || same.usable(0, 0)[k]);
            assertTrue(Double.isNaN(same.h1(0, 0).re()[k]));
        }
    }

    @Test
    void asManyAveragesAsInputsAreNotEnough() {
        Random random = new Random(19);
        double[][] records = new double[4][1100];
        for (double[] record : records) {
            System.arraycopy(KnownBodies.record(new double[2048], 1, random), 0, record, 0, record.length);
        }
        SpectralMatrix few = KnownBodies.spectra(RATE, 512, records);
        DataFault fault = assertThrows(DataFault.class, () -> ResponseMatrix.of(few, 3, Excited.USUAL));
        assertTrue(fault.getMessage().contains("more than 3 independent segments"), fault.getMessage());
    }

    @Test
    void aMemoryFollowsWhatChanges() {
        Random random = new Random(20);
        Segmentation segmentation = new Segmentation(RATE, 128, 0.5);
        SpectralMatrix forgets = new SpectralMatrix(segmentation, Detrend.MEAN, 2, 0.9);
        for (int n = 0; n < 40_000; n++) {
            double x = random.nextGaussian();
            forgets.accept(new double[] {x, (n < 20_000 ? 1 : 3) * x});
        }
        ResponseMatrix h = ResponseMatrix.of(forgets, 1, Excited.USUAL);
        assertEquals(3, h.h1(0, 0).magnitude(20), 1e-9);
        // A geometric memory of 0.9 is worth (1 + 0.9)/(1 - 0.9) = 19 segments, which overlap.
        assertEquals(segmentation.independent(19), h.averages(), 1e-9);
    }

    /** Inputs of unit density whose pairs have the coherence-amplitude {@code shared}. */
    private static double[][] sharing(double shared, Random random) {
        double[] common = KnownBodies.spectrum(LENGTH, RATE, 0, 30, random);
        double[][] x = new double[3][];
        for (int i = 0; i < 3; i++) {
            double[] own = KnownBodies.spectrum(LENGTH, RATE, 0, 30, random);
            x[i] = new double[LENGTH];
            for (int n = 0; n < LENGTH; n++) {
                x[i][n] = Math.sqrt(shared) * common[n] + Math.sqrt(1 - shared) * own[n];
            }
        }
        return x;
    }

    private static ResponseMatrix respond(double[][] x, double[][] gain, double inputNoise, double outputNoise, Random random) {
        return respond(x, gain, inputNoise, outputNoise, random, x);
    }

    private static ResponseMatrix respond(double[][] x, double[][] gain, double inputNoise, double outputNoise, Random random,
            double[][] acting) {
        return respond(x, gain, inputNoise, new double[] {outputNoise, outputNoise, outputNoise}, random, acting);
    }

    /** @param x inputs that are measured @param acting inputs that act */
    private static ResponseMatrix respond(double[][] x, double[][] gain, double inputNoise, double[] outputNoise, Random random,
            double[][] acting) {
        double[][] records = new double[x.length + gain.length][];
        for (int i = 0; i < x.length; i++) {
            records[i] = KnownBodies.record(x[i], inputNoise, random);
        }
        for (int o = 0; o < gain.length; o++) {
            double[] y = new double[LENGTH];
            for (int i = 0; i < acting.length; i++) {
                for (int n = 0; n < LENGTH; n++) {
                    y[n] += gain[o][i] * acting[i][n];
                }
            }
            records[x.length + o] = KnownBodies.record(y, outputNoise[o], random);
        }
        return ResponseMatrix.of(KnownBodies.spectra(RATE, SEGMENT, records), x.length, Excited.USUAL);
    }

    private static double mean(double[] values) {
        double sum = 0;
        int count = 0;
        for (int k = values.length / 20; k < 19 * values.length / 20; k++) {
            sum += values[k];
            count++;
        }
        return sum / count;
    }

    private static double norm(double[] values) {
        double squares = 0;
        for (double value : values) {
            squares += value * value;
        }
        return Math.sqrt(squares);
    }
}
