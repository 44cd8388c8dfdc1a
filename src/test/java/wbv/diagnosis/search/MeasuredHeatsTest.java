package wbv.diagnosis.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.Set;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.diagnosis.Bench;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.recording.Channel;

/** Two masses in a row, stepped by {@link Bench}, of which two things are concealed at once: the pair that comes first has both names. */
class MeasuredHeatsTest {

    private static final double[] MASS = {2, 1};
    private static final double[] STIFFNESS = {8000, 3000};
    private static final double[] DAMPING = {12, 5};
    private static final double TYPICAL = 0.005;
    /** When a link changes [s]. */
    private static final double GOES = 3;

    private record Asked(Evidence evidence, Search search, Fitter.State base) {

        MeasuredHeats heats(Motion motion) {
            return new MeasuredHeats(evidence, base, motion, search.hypotheses(base));
        }

        Motion motion() {
            return Motion.measured(evidence, base.candidate().at(base.x()));
        }
    }

    /**
     * @param cubic of the lower spring, over what would double it at the typical deflection [1]
     * @param drag  of the upper link with the square of the speed [N s²/m²]
     * @param gain  of the upper sensor [1]
     * @param lost  part of the lower spring and dashpot that goes at {@link #GOES} [1]
     */
    private static Asked asked(long seed, double cubic, double drag, double gain, double lost) {
        Random random = new Random(seed);
        DoubleUnaryOperator push = Bench.tones(40, 4, 0.25, 14, random);
        Bench bench = new Bench(200, 20, 10, MASS).run((t, x, v, out) -> {
            double r = x[1] - x[0];
            double u = v[1] - v[0];
            double upper = STIFFNESS[1] * r + DAMPING[1] * u + drag * u * Math.abs(u);
            double s = x[0] / TYPICAL;
            double kept = t < GOES ? 1 : 1 - lost;
            out[0] = push.applyAsDouble(t) - kept * (STIFFNESS[0] * x[0] * (1 + cubic * s * s) + DAMPING[0] * v[0]) + upper;
            out[1] = -upper;
        });
        double[] lower = bench.sampled(bench.acceleration(0));
        double[] upper = Arrays.stream(bench.sampled(bench.acceleration(1))).map(a -> gain * a).toArray();
        double noise = 0.003 * Math.sqrt(Arrays.stream(lower).map(a -> a * a).average().orElseThrow());
        Channel first = Channel.parse("mass.acc.z");
        Channel second = Channel.parse("load.acc.z");
        Model model = ModelFile.parse("{\"name\": \"bench\", \"subject\": \"rig\", \"base\": {\"name\": \"ground\", \"sensor\": null}, "
                + "\"inputs\": [{\"body\": \"mass\", \"sensor\": \"mass.force.z\"}], \"bodies\": ["
                + "{\"name\": \"mass\", \"mass_kg\": 2, \"sensor\": \"mass.acc.z\"}, "
                + "{\"name\": \"load\", \"mass_kg\": 1, \"sensor\": \"load.acc.z\"}], \"links\": ["
                + "{\"from\": \"ground\", \"to\": \"mass\", \"stiffness_N_per_m\": 7000, \"damping_Ns_per_m\": 15}, "
                + "{\"from\": \"mass\", \"to\": \"load\", \"stiffness_N_per_m\": 3400, \"damping_Ns_per_m\": 4}]}", "bench");
        Evidence evidence = new Evidence(model, bench.recording("mass.force.z", bench.sampled(push), first,
                Bench.noisy(lower, noise, random), second, Bench.noisy(upper, noise, random)), OptionalDouble.of(noise),
                OptionalDouble.empty());
        Search search = new Search(evidence, (step, share) -> {});
        return new Asked(evidence, search, search.base(Baseline.of(evidence)));
    }

    private static Set<String> claims(Fitter.State fit) {
        return fit.candidate().added().stream().map(Hypothesis::claim).collect(Collectors.toSet());
    }

    private static MeasuredHeats.Found pair(Asked asked) {
        assertTrue(asked.base().reduced() > 100, "the linear model is far off: " + asked.base().reduced());
        Twins twins = Twins.of(asked.evidence(), asked.base().candidate());
        MeasuredHeats.Found found = asked.heats(asked.motion()).two(both -> true, twins).orElseThrow();
        assertTrue(Refinement.explained(asked.base(), found.fit()) > 0.99, found.fit().reduced() + " left");
        assertTrue(found.isAlone(), "nothing else leaves as little");
        return found;
    }

    @Test
    void aSpringThatHardensBesideAFalseGain() {
        assertEquals(Set.of("stiffness.hardening@ground-mass", "sensor.gain@load.acc.z"), claims(pair(asked(4, 0.5, 0, 0.85, 0)).fit()));
    }

    /** The fit without it has a spring of what it is in the mean, less than the whole of what goes. */
    @Test
    void aSpringThatLosesNearlyAllOfItselfBesideDrag() {
        assertEquals(Set.of("drift.step@ground-mass", "damping.quadratic@mass-load"), claims(pair(asked(5, 0, 30, 1, 0.95)).fit()));
    }

    /** As the pair moves, what one part is beside the other is found at once, its plain form among all others. */
    @Test
    void besideOnePartTheOtherIsFound() {
        Asked asked = asked(2, 0.5, 30, 1, 0);
        Fitter.State pair = pair(asked).fit();
        assertEquals(Set.of("stiffness.hardening@ground-mass", "damping.quadratic@mass-load"), claims(pair));
        Hypothesis drag = pair.candidate().added().stream().filter(h -> h.mechanism().equals("damping.quadratic")).findFirst()
                .orElseThrow();
        Candidate without = asked.base().candidate().with(drag);
        double[] x = asked.base().candidate().alone(pair.candidate(), pair.x(), without, drag);
        Fitter.State left = asked.search().fitter().lookWithSlopes(without, x, pair.frame());
        Motion motion = Motion.simulated(asked.evidence(), pair.candidate().at(pair.x()));
        List<Hypothesis> all = asked.search().hypotheses(asked.base()).stream().filter(h -> !h.claim().equals(drag.claim())).toList();
        List<Fitter.State> best = new MeasuredHeats(asked.evidence(), left, motion, all).best(2);
        assertEquals("stiffness.hardening@ground-mass", best.get(0).candidate().last().claim());
        assertTrue(best.get(1).reduced() > 2 * best.get(0).reduced(), best.get(1).reduced() + " next");
    }

    /** A pair of which one part is wrong, and at the wrong place, becomes the right one, since either is sought beside the other. */
    @Test
    void aWrongPartGivesWay() {
        Asked asked = asked(2, 0.5, 30, 1, 0);
        PairRivals rivals = new PairRivals(asked.evidence(), asked.search(), asked.base());
        Fitter.State wrong = wrong(asked, "damping.quadratic@mass-load", "sensor.gain@mass.acc.z");
        Fitter.State right = rivals.inTurn(wrong);
        assertEquals(Set.of("stiffness.hardening@ground-mass", "damping.quadratic@mass-load"), claims(right));
        assertTrue(Refinement.excess(right.reduced()) < 0.1 * Refinement.excess(wrong.reduced()), right.reduced() + " left");
    }

    /** Both parts wrong: which is replaced first does not matter. */
    @Test
    void twoWrongPartsGiveWay() {
        Asked asked = asked(3, 0.5, 30, 1, 0);
        PairRivals rivals = new PairRivals(asked.evidence(), asked.search(), asked.base());
        Fitter.State wrong = wrong(asked, "damping.quadratic@ground-mass", "sensor.gain@load.acc.z");
        assertEquals(Set.of("stiffness.hardening@ground-mass", "damping.quadratic@mass-load"), claims(rivals.inTurn(wrong)));
    }

    private static Fitter.State wrong(Asked asked, String... claims) {
        Candidate both = asked.base().candidate();
        double[] x = asked.base().x();
        for (String claim : claims) {
            Hypothesis part = asked.search().hypotheses(asked.base()).stream().filter(h -> h.claim().equals(claim)).findFirst()
                    .orElseThrow();
            Candidate with = both.with(part);
            x = both.extended(x, with, part, part.starts().get(0).values());
            both = with;
        }
        return asked.search().refinement().polish(both, x);
    }
}
