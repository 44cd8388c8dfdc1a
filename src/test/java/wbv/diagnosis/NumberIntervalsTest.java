package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.body.Model;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.learn.LawLearnerTest;
import wbv.diagnosis.search.MassScale;
import wbv.diagnosis.search.Priors;
import wbv.diagnosis.search.Search;
import wbv.recording.Channel;
import wbv.recording.Recording;

/** Where nothing is missing, the numbers of a model are as far from the true ones as their intervals say. */
class NumberIntervalsTest {

    private static final int DRAWS = 16;
    private static final double GAIN = 0.01;
    private static final double WEIGHED = 1e-3;
    /** Of the links and of the head, in the order of the fit's numbers. */
    private static final double[] TRUE = {50000, 900, 22000, 160, 6};

    /**
     * Numbers are given a fifth off, masses a tenth or weighed to a thousandth; each sensor's gain is a hundredth off. Errors are as large
     * as the intervals say, within what chance does to so many draws, of which the numbers of one go together.
     */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void errorsAreAsLargeAsIntervalsSay(boolean weighed) {
        Random random = new Random(5);
        Model truth = LawLearnerTest.model(List.of());
        Recording recorded = LawLearnerTest.recording(truth);
        double[] square = new double[DRAWS];
        for (int draw = 0; draw < DRAWS; draw++) {
            Evidence evidence = new Evidence(given(truth, random, weighed), misread(recorded, random));
            Fitter.State fit = new Search(evidence, (step, share) -> {}).base(Baseline.of(evidence));
            Fitter.State shown = MassScale.of(evidence, new Fitter(evidence).lookWithSlopes(fit.candidate(), fit.x(), fit.frame()))
                    .applied(fit);
            NumberIntervals intervals = NumberIntervals.of(evidence, shown).orElseThrow();
            for (int i = 0; i < TRUE.length; i++) {
                square[draw] += Math.pow(deviations(intervals.of(i).orElseThrow(), TRUE[i]), 2) / TRUE.length;
            }
            double torso = shown.candidate().template().structure().mass()[0];
            assertTrue(Math.abs(deviations(intervals.ofHeld(torso).orElseThrow(), 45)) < 4);
        }
        expectAsSaid(square);
    }

    /** A mass on a spring that a measured force pushes: all three numbers are known, as well as the gains of force and position. */
    @Test
    void errorsOfAPushedBenchAreAsLargeAsIntervalsSay() {
        Random random = new Random(6);
        double[] square = new double[DRAWS];
        for (int draw = 0; draw < DRAWS; draw++) {
            DoubleUnaryOperator push = Bench.tones(40, 0.5, 0.49, 3.4, random);
            Bench bench = new Bench(200, 30, 4, 2).run((t, x, v, out) -> out[0] = push.applyAsDouble(t) - 25 * v[0] - 8000 * x[0]);
            Channel place = Channel.parse("mass.pos.z");
            Recording recorded = misread(bench.recording("mass.force.z", Bench.noisyBy(0.003, bench.sampled(push), random), place,
                    Bench.noisyBy(0.003, bench.sampled(bench.position(0)), random)), random);
            double[] truth = {8000, 25, 2};
            double[] off = random.doubles(3).map(any -> Math.exp(0.2 * random.nextGaussian())).toArray();
            Evidence evidence = new Evidence(Bench.oscillator(off[0] * truth[2], off[1] * truth[0], off[2] * truth[1], place), recorded);
            Fitter.State fit = new Search(evidence, (step, share) -> {}).base(Baseline.of(evidence));
            NumberIntervals intervals = NumberIntervals.of(evidence, fit).orElseThrow();
            for (int i = 0; i < truth.length; i++) {
                square[draw] += Math.pow(deviations(intervals.of(i).orElseThrow(), truth[i]), 2) / truth.length;
            }
        }
        expectAsSaid(square);
    }

    /** @param square mean square of errors over deviations, by draw */
    private static void expectAsSaid(double[] square) {
        double rms = Math.sqrt(Arrays.stream(square).average().orElseThrow());
        double low = Math.sqrt(new ChiSquaredDistribution(DRAWS).inverseCumulativeProbability(0.001) / DRAWS);
        double high = Math.sqrt(new ChiSquaredDistribution(DRAWS).inverseCumulativeProbability(0.999) / DRAWS);
        assertTrue(rms > low && rms < high, "errors are " + rms + " times what intervals say, " + low + " to " + high + " expected");
    }

    /** By how many of its standard deviations an interval misses a number. */
    private static double deviations(Interval interval, double truth) {
        double half = (Math.log(interval.high()) - Math.log(interval.low())) / 2;
        return (Math.log(truth) - (Math.log(interval.high()) + Math.log(interval.low())) / 2) / (half / Interval.Z);
    }

    private static Model given(Model truth, Random random, boolean weighed) {
        OptionalDouble within = weighed ? OptionalDouble.of(WEIGHED) : OptionalDouble.empty();
        double off = weighed ? WEIGHED / 2 : Priors.MASS;
        return new Model(truth.name(), Optional.empty(), truth.axis(), truth.base(),
                truth.bodies().stream().map(body -> new Model.Body(body.name(), body.mass() * Math.exp(off * random.nextGaussian()),
                        body.sensor(), List.of(), Optional.empty(), List.of(), false, Map.of(), Optional.empty(), false, Optional.empty(),
                        within)).toList(),
                truth.links().stream().map(link -> link.completed(link.stiffness() * Math.exp(0.2 * random.nextGaussian()),
                        link.damping() * Math.exp(0.2 * random.nextGaussian()), List.of(), List.of(), List.of())).toList());
    }

    private static Recording misread(Recording recorded, Random random) {
        Map<Channel, double[]> values = new LinkedHashMap<>();
        recorded.channels().forEach(channel -> {
            double gain = 1 + GAIN * random.nextGaussian();
            values.put(channel, Arrays.stream(recorded.values(channel)).map(x -> gain * x).toArray());
        });
        return recorded.with(values);
    }
}
