package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.random.RandomGeneratorFactory;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import wbv.body.Model;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Readings;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Recording;
import wbv.signal.ScalarProduct;

/** One body on a platform, with or without a tone that the model lacks. */
class HeldOutTest {

    private static final double RATE = 60;
    private static final int SAMPLES = 9000;
    private static final double NOISE = 0.01;
    private static final Channel BASE = Channel.parse("platform.acc.z");
    private static final Channel BODY = Channel.parse("seat.acc.z");
    private static final Model MODEL = new Model("one", Optional.empty(), 'z', new Model.Base("platform", Optional.of(BASE)),
            List.of(new Model.Body("seat", 50, Optional.of(BODY), List.of(), Optional.empty(), List.of())),
            List.of(new Model.Link("platform", "seat", 50e3, 900, Optional.empty(), List.of(), List.of())));

    private static Evidence evidence(double tone) {
        Random random = new Random(3);
        double[] base = new double[SAMPLES];
        for (int s = 0; s < 400; s++) {
            double f = 1 + 8 * random.nextDouble();
            double phase = 2 * Math.PI * random.nextDouble();
            for (int i = 0; i < SAMPLES; i++) {
                base[i] += 0.5 * Math.sqrt(2.0 / 400) * Math.sin(2 * Math.PI * f * i / RATE + phase);
            }
        }
        Excitation excitation = new Excitation(RATE, base, Map.of());
        double[] y = excitation.series(new Simulator(excitation).run(MODEL.assembly(), false).outputs()[0]);
        for (int i = 0; i < SAMPLES; i++) {
            y[i] += tone * Math.sin(2 * Math.PI * 7 * i / RATE) + NOISE * random.nextGaussian();
            base[i] += NOISE * random.nextGaussian();
        }
        Map<Channel, double[]> channels = new LinkedHashMap<>(Map.of(BASE, base));
        channels.put(BODY, y);
        return new Evidence(MODEL, new Recording(new Clock(0, RATE), channels, Metadata.NONE));
    }

    /** The model as given, its stiffness times a factor. */
    private static Fitter.State state(Evidence evidence, double factor) {
        Candidate candidate = Baseline.of(evidence);
        double[] x = candidate.start();
        x[0] = Math.log(factor);
        Fitter fitter = new Fitter(evidence);
        return fitter.look(candidate, x, fitter.frame(candidate, x, evidence.fit()));
    }

    /** The same with a sensor that has no error, since gain and delay would take a part of a tone for theirs. */
    private static Fitter.State perfect(Fitter.State state) {
        return new Fitter.State(state.candidate(), state.x(), state.cost(), state.square(), state.raw(), new double[state.errors().length],
                state.slopes(), state.frame());
    }

    private static List<Diagnosis.Proof> proofs(Evidence evidence, Fitter.State before, Fitter.State after) {
        return new HeldOut(evidence, RandomGeneratorFactory.of("L64X128MixRandom").create(5)).of(before, after);
    }

    @Test
    void theWholeErrorIsTheRootMeanSquareOverTheSignals() {
        Evidence evidence = evidence(0.1);
        Fitter.State state = state(evidence, 1.3);
        double[] simulated = new Readings(evidence).of(state)[0];
        double error = 0;
        double signal = 0;
        for (int i = evidence.heldOut().start(); i < evidence.heldOut().start() + evidence.heldOut().length(); i++) {
            error += Math.pow(evidence.measured(0)[i] - simulated[i], 2);
            signal += Math.pow(evidence.measured(0)[i], 2);
        }
        assertEquals(Math.sqrt(error / signal), proofs(evidence, state, state).get(0).before().value(), 1e-12);
    }

    /** Parseval: what the bands hold together is what the spectrum holds. */
    @Test
    void theSquaresOfTheBandsAddUp() {
        Evidence evidence = evidence(0.1);
        Fitter.State state = state(evidence, 1.3);
        double[] simulated = new Readings(evidence).of(state)[0];
        double[] error = IntStream.range(0, SAMPLES).mapToDouble(i -> evidence.measured(0)[i] - simulated[i]).toArray();
        double[] e = evidence.heldOut().spectrum(error, evidence.valid(0));
        double[] y = evidence.heldOut().spectrum(evidence.measured(0), evidence.valid(0));
        List<Diagnosis.Proof> bands = proofs(evidence, state, state).subList(1, 5);
        assertEquals(ScalarProduct.of(e, e) / ScalarProduct.of(y, y),
                bands.stream().mapToDouble(p -> Math.pow(p.before().value(), 2)).sum(),
                1e-9);
        assertEquals(1, bands.stream().mapToDouble(Diagnosis.Proof::signal).sum(), 1e-9);
        assertArrayEquals(new double[] {2, 5, 10}, bands.stream().skip(1).mapToDouble(p -> p.band()[0]).toArray());
    }

    @Test
    void aToneThatTheModelLacksIsMissedInItsBandAlone() {
        Evidence evidence = evidence(0.1);
        Fitter.State state = perfect(state(evidence, 1));
        for (Diagnosis.Proof band : proofs(evidence, state, state).subList(1, 5)) {
            boolean own = band.band()[0] <= 7 && 7 < band.band()[1];
            assertEquals(own, band.before().value() > 1.3 * band.floor(), band.toString());
            assertTrue(own || band.before().value() < 1.1 * band.floor(), band.toString());
        }
    }

    @Test
    void whatWentIsCountedAboveTheNoise() {
        Evidence evidence = evidence(0);
        Diagnosis.Proof all = proofs(evidence, state(evidence, 1.3), state(evidence, 1)).get(0);
        assertEquals(1, all.removed().value(), 0.01);
        assertTrue(all.removed().low() > 0.98, all.toString());
        Diagnosis.Proof half = proofs(evidence, state(evidence, 1.3), state(evidence, 1.15)).get(0);
        assertTrue(half.removed().low() < half.removed().value() && half.removed().value() < half.removed().high(),
                half.toString());
        assertTrue(half.removed().high() < 0.95, half.toString());
        assertTrue(Double.isNaN(proofs(evidence, state(evidence, 1), state(evidence, 1)).get(0).removed().value()),
                "nothing to remove");
    }

    /**
     * Error and signal that are stationary and Gaussian: the logarithm of the ratio of their root mean squares has the variance
     * 1/(2n) + 1/(2m), with n and m twice bandwidth times duration (Bendat and Piersol).
     */
    @Test
    void theIntervalIsAsWideAsStationaryNoiseMakesIt() {
        Evidence evidence = evidence(0);
        Fitter.State state = state(evidence, 1);
        Diagnosis.Ranged ranged = proofs(evidence, state, state).get(0).after();
        double seconds = evidence.heldOut().length() / RATE;
        double expected = 2 * 1.645 * Math.sqrt(1 / (4 * 30 * seconds) + 1 / (4 * 8 * seconds));
        double width = Math.log(ranged.high() / ranged.low());
        assertTrue(width > 0.5 * expected && width < 2 * expected, width + ", expected about " + expected);
        assertTrue(ranged.low() < ranged.value() && ranged.value() < ranged.high(), ranged.toString());
    }

    @Test
    void theSameDataGiveTheSameIntervals() {
        Evidence evidence = evidence(0.1);
        Fitter.State state = state(evidence, 1.3);
        assertEquals(Arrays.toString(proofs(evidence, state, state).stream().map(p -> p.before() + " " + p.removed()).toArray()),
                Arrays.toString(proofs(evidence, state, state).stream().map(p -> p.before() + " " + p.removed()).toArray()));
    }
}
