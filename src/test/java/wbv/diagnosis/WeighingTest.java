package wbv.diagnosis;

import wbv.diagnosis.mechanism.Library;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import wbv.body.Assembly;
import wbv.body.CubicSpring;
import wbv.body.Excitation;
import wbv.body.Law;
import wbv.body.LawAt;
import wbv.body.Model;
import wbv.body.QuadraticDamping;
import wbv.body.SensorFault;
import wbv.body.Simulator;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Recording;
import wbv.diagnosis.mechanism.Hypothesis;

/** Hypotheses weighed on recordings of which the truth is known: a seat, a torso that stirs and a head, sensors with noise and gains, numbers a tenth off. */
@Tag("exam")
class WeighingTest {

    private static final double RATE = 60;
    private static final int SAMPLES = 1500;
    private static final double NOISE = 0.02;
    private static final double STIRRING = 1.5;
    private static final int LINK = 1;
    private static final Channel BASE = Channel.parse("platform.acc.z");
    private static final List<Channel> OUTPUTS = List.of(Channel.parse("seat.acc.z"), Channel.parse("sternum.acc.z"), Channel.parse("head.acc.z"));
    /** A gain as a fault is no better than as a small error. */
    private static final Hypothesis GAIN = new Hypothesis(Library.standard().of("sensor.gain").orElseThrow(), "head.acc.z", "", List.of(new Hypothesis.Addition.AtSensor(2, new SensorFault.Gain(1.02))),
            Hypothesis.Number.named(SensorFault.Gain.class, List.of(Hypothesis.Number.sum(0.01, 0.3, 3))), List.of(Hypothesis.Start.fixed(1)));
    static final Hypothesis CUBIC = hypothesis(new CubicSpring(2e9), Hypothesis.Number.sum(2e9, 0, 1e13));
    private static final Hypothesis QUADRATIC = hypothesis(new QuadraticDamping(5e3), Hypothesis.Number.sum(5e3, 0, 1.5e6));

    private static Hypothesis hypothesis(Law law, Hypothesis.Number number) {
        return new Hypothesis(Library.standard().of(law.mechanism()).orElseThrow(), "seat-torso", "", List.of(new Hypothesis.Addition.InLink(LINK, law)),
                Hypothesis.Number.named(law.getClass(), List.of(number)), List.of(Hypothesis.Start.scaled(number.unit())));
    }

    private static Model chain(double wrong) {
        double[] mass = {12, 45, 5};
        List<String> names = List.of("seat", "torso", "head");
        List<Model.Body> bodies = IntStream.range(0, 3).mapToObj(b -> new Model.Body(names.get(b), mass[b], Optional.of(OUTPUTS.get(b)), List.of(),
                Optional.empty(), List.of())).toList();
        return new Model("chain", Optional.empty(), 'z', new Model.Base("platform", Optional.of(BASE)), bodies,
                List.of(link("platform", "seat", 90e3 * (1 + wrong), 1200), link("seat", "torso", 75e3, 1500 * (1 - wrong)), link("torso", "head", 20e3, 150)));
    }

    private static Model.Link link(String from, String to, double stiffness, double damping) {
        return new Model.Link(from, to, stiffness, damping, Optional.empty(), List.of(), List.of());
    }

    static Evidence evidence(List<LawAt> laws, double wrong, long seed) {
        Random random = new Random(seed);
        double[] base = banded(random, 0.5, 15, 1);
        Excitation excitation = new Excitation(RATE, base, Map.of());
        Assembly linear = chain(0).assembly();
        Simulator simulator = new Simulator(excitation);
        double[][] y = simulator.run(new Assembly(linear.structure(), laws, List.of(), linear.outputs()), false).outputs();
        double[][] way = simulator.linearised(linear).ofBodyForce(1);
        double[] stir = excitation.spectrum(stirring(random));
        Map<Channel, double[]> channels = new LinkedHashMap<>();
        channels.put(BASE, noisy(base, 1, random));
        for (int o = 0; o < y.length; o++) {
            Remainder.add(y[o], way[o], stir);
            channels.put(OUTPUTS.get(o), noisy(excitation.series(y[o]), 1 + 0.01 * random.nextGaussian(), random));
        }
        return new Evidence(chain(wrong), new Recording(new Clock(0, RATE), channels, Metadata.NONE), OptionalDouble.of(NOISE));
    }

    private static double[] banded(Random random, double low, double high, double rms) {
        double[] out = new double[SAMPLES];
        int sines = Math.max(1, (int) Math.round(20 * (high - low)));
        for (int s = 0; s < sines; s++) {
            double f = low + (high - low) * (s + random.nextDouble()) / sines;
            double phase = 2 * Math.PI * random.nextDouble();
            for (int i = 0; i < SAMPLES; i++) {
                out[i] += rms * Math.sqrt(2.0 / sines) * Math.sin(2 * Math.PI * f * i / RATE + phase) * Math.min(1, Math.max(0, (i - 60) / 60.0));
            }
        }
        return out;
    }

    /** Most of it below some hertz, not quite where it is expected. */
    private static double[] stirring(Random random) {
        double[] out = new double[SAMPLES];
        for (double f = 0.4; f < 15; f += 0.05) {
            double[] part = banded(random, f, f + 0.05, 1 / Math.sqrt(1 + Math.pow(f / 4.5, 4)));
            Arrays.setAll(out, i -> out[i] + part[i]);
        }
        double rms = Motion.rms(out, SAMPLES);
        return Arrays.stream(out).map(v -> STIRRING / rms * v).toArray();
    }

    private static double[] noisy(double[] x, double gain, Random random) {
        return Arrays.stream(x).map(v -> gain * v + NOISE * random.nextGaussian()).toArray();
    }

    /** Weights of the values alone and of hypotheses, each fitted from where a search would begin. */
    private static final class Case {
        private final Weighing weighing;
        private final Candidate baseline;
        private final double[] x;
        private final double values;

        Case(Evidence evidence) {
            baseline = Baseline.of(evidence);
            weighing = new Weighing(evidence, baseline, Priors.USUAL);
            x = new Search(evidence, (step, share) -> { }).base(baseline).x();
            values = weighing.of(baseline, x, Weighing.ROUNDS).log();
        }

        double nothing() {
            return weighing.nothing().log() - values;
        }

        Weighing.Weight of(Hypothesis hypothesis) {
            Candidate with = baseline.with(hypothesis);
            return weighing.of(with, baseline.extended(x, with, hypothesis, hypothesis.starts().get(0).values()), Weighing.ROUNDS);
        }

        Weighing.Weight beside(Hypothesis hypothesis, double[] start) {
            return weighing.withFree(baseline.with(hypothesis), start, new Place(Place.Kind.LINK, LINK), Weighing.ROUNDS);
        }

        double free(Place place) {
            return weighing.withFree(baseline, x, place, Weighing.ROUNDS).log() - values;
        }
    }

    /** Where nothing is missing the stirring is known for what it is, and no law and no force at any place gains more than chance. */
    @Test
    void nullsStayNulls() {
        for (long seed = 1; seed <= 2; seed++) {
            Evidence evidence = evidence(List.of(), 0, seed);
            Case nothing = new Case(evidence);
            assertTrue(nothing.nothing() > 5, "exact numbers need no others: " + nothing.nothing());
            Weighing.Weight cubic = nothing.of(CUBIC);
            assertTrue(cubic.log() - nothing.values < 2, "cubic " + (cubic.log() - nothing.values));
            double gain = nothing.of(GAIN).log() - nothing.values;
            assertTrue(gain < 0 && gain > -10, "gain " + gain);
            assertEquals(0, Math.log(Math.hypot(cubic.own(), cubic.riding()) / STIRRING), Math.log(2), "stirring");
            for (Place place : List.of(new Place(Place.Kind.LINK, LINK), new Place(Place.Kind.SENSOR, 2), new Place(Place.Kind.BODY, 2))) {
                double free = nothing.free(place);
                assertTrue(free < 2 && free > -25, place + " " + free);
            }
        }
    }

    /** The law that acts wins over values, over another law and over a force of none, and leaves little of a free force beside it. */
    @Test
    void theLawThatActsIsWorthMost() {
        Case cubic = new Case(evidence(List.of(new LawAt(LINK, new CubicSpring(8e9))), 0.1, 4));
        Weighing.Weight right = cubic.of(CUBIC);
        double gain = right.log() - cubic.values;
        assertTrue(gain > 30, "gain " + gain);
        assertTrue(cubic.nothing() < -30, "numbers are a tenth off: " + cubic.nothing());
        Weighing.Weight wrong = cubic.of(QUADRATIC);
        assertTrue(right.log() > wrong.log() + 20, right.log() + ", damping " + wrong.log());
        assertTrue(gain > cubic.free(new Place(Place.Kind.LINK, LINK)) + 10);
        Weighing.Weight both = cubic.beside(CUBIC, right.fit().x());
        assertTrue(both.log() < right.log() + 2, "with a free force " + (both.log() - right.log()));
        assertTrue(both.left() < 0.3, "left " + both.left());
    }
}
