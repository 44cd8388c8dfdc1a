package wbv.diagnosis.fit;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import wbv.body.Assembly;
import wbv.diagnosis.Bench;
import wbv.diagnosis.algebra.DampedEquations;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.recording.Channel;
import wbv.signal.ScalarProduct;

/** Where a fit of something that changes at a moment ends, from moments on both sides of the true one. */
class DescentTest {

    private static final Channel FORCE = Channel.parse("mass.force.z");
    private static final Channel POSITION = Channel.parse("mass.pos.z");
    private static final double SECONDS = 30;
    /** Relative gain of a step below which the fits end. */
    private static final double TOLERANCE = 1e-4;

    /** What has no kink is at its best there, though no step that moves the moment too lowers the cost. */
    @Test
    void nothingIsLeftToGainBesideAMoment() {
        Evidence evidence = softening();
        Fitter fitter = new Fitter(evidence);
        Candidate plain = Baseline.of(evidence);
        Fitter.Frame frame = fitter.frame(plain, plain.start(), evidence.fit());
        Assembly given = plain.at(plain.start());
        Hypothesis change = evidence.library().hypotheses(FittedScene.of(evidence, given, Motion.measured(evidence, given))).stream()
                .filter(hypothesis -> hypothesis.mechanism().equals("drift.step")).findFirst().orElseThrow();
        Candidate with = plain.with(change);
        for (double moment = 9; moment < 16; moment += 0.25) {
            double[] start = plain.extended(plain.start(), with, change, new double[] {moment, 0.9, 0.9});
            Fitter.State end = fitter.fit(with, start, frame, 30, TOLERANCE);
            assertTrue(gain(fitter.lookWithSlopes(with, end.x(), frame)) < 10 * TOLERANCE * end.cost(), "from " + moment + " s");
        }
    }

    /** By how much the rest would lower the cost where moments stay, as the curvature has it. */
    private static double gain(Fitter.State end) {
        Normal normal = new Normal(end);
        boolean[] held = end.held();
        for (int i = 0; i < held.length; i++) {
            held[i] |= end.candidate().knobs().get(i).isMoment();
        }
        double[] step = DampedEquations.solve(normal.curvature(), normal.gradient(), held, 0);
        // The cost is twice what has this gradient.
        return ScalarProduct.of(step, normal.gradient());
    }

    /** 2 kg on 8 kN/m, of which a third goes in two seconds, under forty tones up to 20 Hz; 0.3 % noise. */
    private static Evidence softening() {
        Random random = new Random(1);
        DoubleUnaryOperator push = Bench.tones(40, 0.3, 0.4925, 2.5, random);
        Bench bench = new Bench(200, SECONDS, 50, 2).run((t, x, v, out) -> {
            double gone = Math.max(0, Math.min(1, (t - 0.4 * SECONDS) / 2)) / 3;
            out[0] = push.applyAsDouble(t) - 8000 * (1 - gone) * x[0] - 25 * v[0];
        });
        return new Evidence(Bench.oscillator(2, 7000, 30, POSITION), bench.recording(FORCE, bench.sampled(push), POSITION,
                Bench.noisyBy(0.003, bench.sampled(bench.position(0)), random)));
    }
}
