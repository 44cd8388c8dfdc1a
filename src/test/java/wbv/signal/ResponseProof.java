package wbv.signal;

import java.util.Locale;
import java.util.Random;
import wbv.signal.FrequencyResponse.Excited;
import wbv.signal.KnownBodies.Response;

/**
 * The figures of docs/thesis.md, chapter 2: how well frequency responses of known bodies are measured, over many draws: 40, or as many as
 * the argument says.
 */
public final class ResponseProof {

    private static final double RATE = 60;
    private static final int LENGTH = 1 << 16;
    private static final int SEGMENT = 1024;

    private ResponseProof() {}

    public static void main(String[] arguments) {
        int draws = arguments.length > 0 ? Integer.parseInt(arguments[0]) : 40;
        closedForms(draws);
        noisyInputs(draws);
        sharedInputs(draws);
    }

    private static void closedForms(int draws) {
        Response[] bodies = {KnownBodies.oneDegree(5, 0.35), KnownBodies.chain(KnownBodies.ALLEN, 1),
            KnownBodies.chain(KnownBodies.BOILEAU, 3)};
        String[] names = {"one degree, 5 Hz, 0.35", "two, Allen's", "four, Boileau and Rakheja's"};
        System.out.println("| body | error of |H1|, rms | stated | 95 % band of modulus holds | of phase |\n"
                + "|---|---|---|---|---|");
        for (int b = 0; b < bodies.length; b++) {
            double squares = 0;
            double stated = 0;
            int modulus = 0;
            int phase = 0;
            int count = 0;
            for (int draw = 0; draw < draws; draw++) {
                Random random = new Random(1000 + draw);
                double[] x = KnownBodies.spectrum(LENGTH, RATE, 0.3, 25, random);
                double[] y = new double[LENGTH];
                KnownBodies.pass(x, bodies[b], RATE, y);
                ResponseMatrix h = ResponseMatrix.of(KnownBodies.spectra(RATE, SEGMENT, KnownBodies.record(x, 0, random),
                        KnownBodies.record(y, 0.7, random)), 1, Excited.USUAL);
                double[] margin = h.margin(0, 0, 0.95);
                double[] angle = h.phaseMargin(0, 0, 0.95);
                for (int k = 9; h.frequency()[k] < 20; k++) {
                    double[] truth = bodies[b].at(h.frequency()[k]);
                    double size = Math.hypot(truth[0], truth[1]);
                    double off = h.h1(0, 0).magnitude(k) - size;
                    squares += off * off / size / size;
                    stated += Math.pow(h.deviation(0, 0)[k] / size, 2);
                    modulus += Math.abs(off) <= margin[k] ? 1 : 0;
                    double turn = Math.IEEEremainder(h.h1(0, 0).phase(k) - Math.atan2(truth[1], truth[0]), 2 * Math.PI);
                    phase += Math.abs(turn) <= angle[k] ? 1 : 0;
                    count++;
                }
            }
            System.out.printf(Locale.ROOT, "| %s | %.2f %% | %.2f %% | %.1f %% | %.1f %% |%n", names[b],
                    100 * Math.sqrt(squares / count), 100 * Math.sqrt(stated / count), 100.0 * modulus / count,
                    100.0 * phase / count);
        }
    }

    private static void noisyInputs(int draws) {
        System.out.println("\n| noise over signal, input and output | H1 | H2 | Hv |\n|---|---|---|---|");
        for (double noise : new double[] {0.05, 0.2, 0.5}) {
            double[] sum = new double[3];
            int count = 0;
            for (int draw = 0; draw < draws; draw++) {
                Random random = new Random(2000 + draw);
                double[] x = KnownBodies.spectrum(LENGTH, RATE, 0, 30, random);
                double[] y = new double[LENGTH];
                KnownBodies.pass(x, f -> new double[] {1.2, -0.9}, RATE, y);
                double level = Math.sqrt(noise * RATE / 2);
                ResponseMatrix h = ResponseMatrix.of(KnownBodies.spectra(RATE, 256, KnownBodies.record(x, level, random),
                        KnownBodies.record(y, 1.5 * level, random)), 1, Excited.USUAL);
                ComplexSeries[] all = {h.h1(0, 0), h.h2(0, 0).orElseThrow(), h.hv(0, 0)};
                for (int k = 3; k < 126; k++) {
                    for (int e = 0; e < 3; e++) {
                        sum[e] += (1.2 * all[e].re()[k] - 0.9 * all[e].im()[k]) / 2.25;   // along the truth
                    }
                    count++;
                }
            }
            System.out.printf(Locale.ROOT, "| %.0f %% | %+.1f %% | %+.1f %% | %+.2f %% |%n", 100 * noise,
                    100 * (sum[0] / count - 1), 100 * (sum[1] / count - 1), 100 * (sum[2] / count - 1));
        }
    }

    private static void sharedInputs(int draws) {
        double[] gain = {1, 0.3, -0.2};
        System.out.println("\n| coherence of inputs by pairs | error, rms of three entries | stated | one alone is off by |\n"
                + "|---|---|---|---|");
        for (double shared : new double[] {0, 0.7, 0.9}) {
            double squares = 0;
            double stated = 0;
            double alone = 0;
            int count = 0;
            for (int draw = 0; draw < draws; draw++) {
                Random random = new Random(3000 + draw);
                double[] common = KnownBodies.spectrum(LENGTH, RATE, 0, 30, random);
                double[][] records = new double[4][];
                double[] y = new double[LENGTH];
                for (int i = 0; i < 3; i++) {
                    double[] own = KnownBodies.spectrum(LENGTH, RATE, 0, 30, random);
                    for (int n = 0; n < LENGTH; n++) {
                        own[n] = Math.sqrt(shared) * common[n] + Math.sqrt(1 - shared) * own[n];
                        y[n] += gain[i] * own[n];
                    }
                    records[i] = KnownBodies.record(own, 0, random);
                }
                records[3] = KnownBodies.record(y, 0.3 * Math.sqrt(RATE / 2), random);
                ResponseMatrix h = ResponseMatrix.of(KnownBodies.spectra(RATE, SEGMENT, records), 3, Excited.USUAL);
                ResponseMatrix first = ResponseMatrix.of(KnownBodies.spectra(RATE, SEGMENT, records[0], records[3]), 1,
                        Excited.USUAL);
                for (int k = 20; k < 480; k++) {
                    for (int i = 0; i < 3; i++) {
                        squares += Math.pow(h.h1(0, i).re()[k] - gain[i], 2);
                        stated += Math.pow(h.deviation(0, i)[k], 2);
                    }
                    alone += first.h1(0, 0).re()[k] - gain[0];
                    count++;
                }
            }
            System.out.printf(Locale.ROOT, "| %.2f | %.4f | %.4f | %+.3f |%n", shared * shared, Math.sqrt(squares / count / 3),
                    Math.sqrt(stated / count / 3), alone / count);
        }
    }
}
