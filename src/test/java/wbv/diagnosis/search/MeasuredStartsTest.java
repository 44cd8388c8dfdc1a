package wbv.diagnosis.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.body.Assembly;
import wbv.body.Model;
import wbv.diagnosis.Bench;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.FittedScene;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Projection;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Library;
import wbv.recording.Channel;

/** Strong laws in a resonance, of oscillators that {@link Bench} steps, begin at about what they are, as does the spring beside them. */
class MeasuredStartsTest {

    private static final double MASS = 2;
    private static final double STIFFNESS = 8000;
    private static final double DAMPING = 10;

    private record Strong(Evidence evidence, Fitter.State base, double typical) {
        Motion motion() {
            return Motion.measured(evidence, base.candidate().at(base.x()));
        }
    }

    /** @param law as a part of k times the typical deflection, by deflections over that [1] */
    private static Strong strong(long seed, String quantity, DoubleUnaryOperator law) {
        return strong(seed, quantity, law, 0);
    }

    /** @param drag with the square of the speed [N s²/m²] */
    private static Strong strong(long seed, String quantity, DoubleUnaryOperator law, double drag) {
        Random random = new Random(seed);
        double typical = 0.01;
        DoubleUnaryOperator push = Bench.tones(60, 4, 0.25, 14, random);
        Bench bench = new Bench(200, 40, 10, MASS).run((t, x, v, out) -> out[0] = push.applyAsDouble(t) - DAMPING * v[0]
                - drag * v[0] * Math.abs(v[0]) - STIFFNESS * x[0] - STIFFNESS * typical * law.applyAsDouble(x[0] / typical));
        Channel sensor = Channel.parse("mass." + quantity + ".z");
        double[] read = quantity.equals("pos") ? bench.position(0) : quantity.equals("vel") ? bench.velocity(0) : bench.acceleration(0);
        Model model = Bench.oscillator(MASS, 1.2 * STIFFNESS, 0.8 * DAMPING, sensor);
        double[] sampled = bench.sampled(read);
        double noise = 0.003 * Math.sqrt(Arrays.stream(sampled).map(x -> x * x).average().orElseThrow());
        Evidence evidence = new Evidence(model, bench.recording("mass.force.z", bench.sampled(push), sensor,
                Bench.noisy(sampled, noise, random)), OptionalDouble.of(noise), OptionalDouble.empty());
        return new Strong(evidence, new Search(evidence, (step, share) -> {}).base(Baseline.of(evidence)), typical);
    }

    private static Hypothesis hypothesis(Strong strong, String mechanism, String form) {
        Assembly fitted = strong.base().candidate().at(strong.base().x());
        return Library.standard().hypotheses(FittedScene.of(strong.evidence(), fitted, strong.motion())).stream()
                .filter(h -> h.mechanism().equals(mechanism) && h.form().equals(form)).findFirst().orElseThrow();
    }

    private static Assembly begun(Strong strong, String mechanism, double number, double within) {
        Hypothesis hypothesis = hypothesis(strong, mechanism, "");
        Candidate with = strong.base().candidate().with(hypothesis);
        double[] x = begun(strong, with, hypothesis);
        assertEquals(0, Math.log(with.values(hypothesis, x)[0] / number), within, mechanism);
        return with.at(x);
    }

    private static double[] begun(Strong strong, Candidate with, Hypothesis hypothesis) {
        Screening screening = new Screening(strong.evidence(), strong.base(), strong.motion());
        return new MeasuredStarts(screening.directions(), strong.base(),
                new AlongMeasured(screening.directions(), strong.base(), strong.motion(), Projection.ofAll(strong.base())))
                .of(with, hypothesis).orElseThrow();
    }

    private static void begins(Strong strong, String mechanism, double number, double within) {
        assertTrue(strong.base().reduced() > 1000, "the linear model is far off: " + strong.base().reduced());
        double begun = begun(strong, mechanism, number, within).structure().stiffness()[0] / STIFFNESS;
        double fitted = strong.base().candidate().at(strong.base().x()).structure().stiffness()[0] / STIFFNESS;
        assertEquals(1, begun, 0.12, "stiffness");
        assertTrue(Math.abs(Math.log(fitted)) > 2 * Math.abs(Math.log(begun)), "nearer than what was fitted without it: " + fitted);
    }

    /** What the model has already goes along the measured motion, too: a cube that was fitted beside no drag is far off. */
    @ParameterizedTest
    @CsvSource({"1,acc", "2,acc", "3,vel", "4,vel", "5,pos", "6,pos"})
    void aSecondLawIsAsStrongAsItIs(long seed, String quantity) {
        double drag = 60;
        Strong alone = strong(seed, quantity, u -> u * u * u, drag);
        Search search = new Search(alone.evidence(), (step, share) -> {});
        Fitter.State cube = search.best(alone.base(), Whereabouts.anywhere(alone.evidence(), alone.base().candidate())
                .only(h -> h.mechanism().equals("stiffness.hardening") && h.form().isEmpty())).orElseThrow();
        assertTrue(cube.reduced() > 100, "a cube alone is far off: " + cube.reduced());
        begun(new Strong(alone.evidence(), search.sloped(cube.candidate(), cube.x()), alone.typical()), "damping.quadratic", drag, 0.15);
    }

    @ParameterizedTest
    @CsvSource({"1,acc", "2,acc", "3,vel", "4,vel", "5,pos", "6,pos"})
    void aCubeIsAsStrongAsItIs(long seed, String quantity) {
        Strong strong = strong(seed, quantity, u -> u * u * u);
        begins(strong, "stiffness.hardening", STIFFNESS / strong.typical() / strong.typical(), 0.1);
    }

    @ParameterizedTest
    @CsvSource({"1,acc", "2,acc", "3,vel", "4,vel", "5,pos", "6,pos"})
    void aSpringThatSoftensBeginsWhereItsKneeIs(long seed, String quantity) {
        Strong strong = strong(seed, quantity, u -> u / Math.sqrt(1 + u * u / 4) - u);
        begins(strong, "stiffness.softening", 2 * strong.typical(), 0.1);
    }

    /** Its knee lies between two of those that it is looked at with. */
    @ParameterizedTest
    @CsvSource({"1,acc", "2,acc", "3,vel", "4,vel", "5,pos", "6,pos"})
    void aSpringThatHardensFromAKneeOnHasIt(long seed, String quantity) {
        Strong strong = strong(seed, quantity, u -> 4 * u * u * u / (1 + u * u));
        Hypothesis hypothesis = hypothesis(strong, "stiffness.hardening", "knee");
        Candidate with = strong.base().candidate().with(hypothesis);
        double[] values = with.values(hypothesis, begun(strong, with, hypothesis));
        assertEquals(0, Math.log(values[0] / (4 * STIFFNESS)), 0.1, "added stiffness");
        assertEquals(0, Math.log(values[1] / strong.typical()), 0.1, "knee");
    }
}
