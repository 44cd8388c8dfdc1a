package wbv.diagnosis.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import org.apache.commons.math3.stat.inference.KolmogorovSmirnovTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import wbv.body.Model;
import wbv.body.law.AsymmetricSpring;
import wbv.body.law.Law;
import wbv.body.law.QuadraticSpring;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Library;
import wbv.diagnosis.mechanism.Start;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Recording;

/**
 * The score of a wrong hypothesis is χ² with one degree of freedom: over many recordings of a chain that lacks nothing, not in one of them.
 */
class ScreeningTest {

    private static final double RATE = 60;
    private static final int SAMPLES = 1100;
    private static final int RECORDINGS = 40;
    private static final double NOISE = 0.02;
    private static final double GAIN = 0.01;
    private static final Channel BASE = Channel.parse("platform.acc.z");
    private static final List<
            Channel> OUTPUTS = List.of(Channel.parse("seat.acc.z"), Channel.parse("sternum.acc.z"), Channel.parse("head.acc.z"));

    /** A seat, a torso and a head in a chain on a platform. */
    private static Model chain() {
        double[] mass = {12, 45, 5};
        List<String> names = List.of("seat", "torso", "head");
        List<Model.Body> bodies = IntStream.range(0, 3)
                .mapToObj(b -> new Model.Body(names.get(b), mass[b], Optional.of(OUTPUTS.get(b)), List.of(),
                        Optional.empty(), List.of()))
                .toList();
        return new Model("chain", Optional.empty(), 'z', new Model.Base("platform", Optional.of(BASE)), bodies,
                List.of(link("platform", "seat", 90e3, 1200), link("seat", "torso", 75e3, 1500), link("torso", "head", 20e3, 150)));
    }

    private static Model.Link link(String from, String to, double stiffness, double damping) {
        return new Model.Link(from, to, stiffness, damping, Optional.empty(), List.of(), List.of());
    }

    /** As sensors with noise and gains of their own send it: two seconds of rest, then random motion. */
    private static Recording recording(Random random) {
        double[] base = new double[SAMPLES];
        for (double f = 0.5; f < 18; f += 0.05) {
            double phase = 2 * Math.PI * random.nextDouble();
            for (int i = 0; i < SAMPLES; i++) {
                base[i] += 0.06 * Math.sin(2 * Math.PI * f * i / RATE + phase) * Math.min(1, Math.max(0, (i - 60) / 60.0));
            }
        }
        double[][] moved = new Simulator(new Excitation(RATE, base, Map.of())).outputs(chain().assembly());
        Map<Channel, double[]> channels = new LinkedHashMap<>();
        channels.put(BASE, noisy(base, 1, random));
        for (int o = 0; o < moved.length; o++) {
            channels.put(OUTPUTS.get(o), noisy(moved[o], 1 + GAIN * random.nextGaussian(), random));
        }
        return new Recording(new Clock(0, RATE), channels, Metadata.NONE);
    }

    private static double[] noisy(double[] x, double gain, Random random) {
        return Arrays.stream(x).map(v -> gain * v + NOISE * random.nextGaussian()).toArray();
    }

    private static Hypothesis hypothesis(int link, Law law, double value) {
        return new Hypothesis(Library.standard().of(law.mechanism()).orElseThrow(), "link " + link, "",
                List.of(new Addition.InLink(link, law)),
                Hypothesis.Number.named(law.getClass(), List.of(Hypothesis.Number.sum(value, -1000 * value, 1000 * value))),
                List.of(Start.scaled(value)));
    }

    @Tag("slow")
    @Test
    void scoresOfNullsAreChiSquared() {
        List<Hypothesis> asked = new ArrayList<>();
        for (int link = 0; link < 3; link++) {
            asked.add(hypothesis(link, new QuadraticSpring(1e6), 1e6));
            asked.add(hypothesis(link, new AsymmetricSpring(0.01), 0.01));
        }
        double[][] gains = new double[asked.size()][RECORDINGS];
        for (int seed = 0; seed < RECORDINGS; seed++) {
            Evidence evidence = new Evidence(chain(), recording(new Random(900 + seed)), OptionalDouble.of(NOISE), OptionalDouble.empty());
            Fitter.State base = new Search(evidence, (step, share) -> {}).base(Baseline.of(evidence));
            Motion motion = Motion.measured(evidence, base.candidate().at(base.x()));
            for (Screening.Score score : new Screening(evidence, base, motion).scores(asked)) {
                gains[asked.indexOf(score.hypothesis())][seed] = score.gain();
            }
        }
        ChiSquaredDistribution one = new ChiSquaredDistribution(1);
        double[] all = Arrays.stream(gains).flatMapToDouble(Arrays::stream).toArray();
        for (double[] own : gains) {
            assertTrue(new KolmogorovSmirnovTest().kolmogorovSmirnovTest(one, own) > 1e-3, Arrays.toString(own));
        }
        // Two forms in one link look alike; three links and so many recordings tell the mean to an eighth, one deviation.
        assertEquals(1, Arrays.stream(all).average().orElseThrow(), 0.4);
        long beyond = Arrays.stream(all).filter(gain -> gain > one.inverseCumulativeProbability(0.99)).count();
        assertTrue(beyond < 0.04 * all.length, beyond + " of " + all.length + " beyond the 99th percentile");
    }
}
