package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.body.Model;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.search.MassScale;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Recording;

/** A chain of three of which one mass alone was given wrong: motion shows ratios of masses, and the fewest wrong numbers are that one. */
class WrongNumbersTest {

    private static final double RATE = 60;
    private static final int N = 3600;
    private static final double NOISE = 0.02;
    /** Which of the fitted numbers it is, and the standard deviation of its logarithm with the torso's held [1]. */
    private static final int SEAT_MASS = 6;
    private static final double DEVIATION = 0.0245;
    private static final List<String> BODIES = List.of("seat", "torso", "head");

    private static Channel channel(String place) {
        return Channel.parse(place + ".acc.z");
    }

    private static Model model(List<Double> masses) {
        List<Model.Body> bodies = IntStream.range(0, 3).mapToObj(b -> new Model.Body(BODIES.get(b), masses.get(b),
                Optional.of(channel(BODIES.get(b))), List.of(), Optional.empty(), List.of())).toList();
        return new Model("chain", Optional.empty(), 'z', new Model.Base("platform", Optional.of(channel("platform"))), bodies,
                List.of(link("platform", "seat", 60e3, 1500), link("seat", "torso", 50e3, 1200), link("torso", "head", 25e3, 200)));
    }

    private static Model.Link link(String from, String to, double stiffness, double damping) {
        return new Model.Link(from, to, stiffness, damping, Optional.empty(), List.of(), List.of());
    }

    private static Recording recording(Random random) {
        DoubleUnaryOperator ride = Bench.tones(190, 0.5, 0.08, 0.08, random);
        double[] base = IntStream.range(0, N).mapToDouble(j -> ride.applyAsDouble(j / RATE)).toArray();
        double[][] out = new Simulator(new Excitation(RATE, base, Map.of())).outputs(model(List.of(12.0, 44.0, 5.5)).assembly());
        Map<Channel, double[]> channels = new LinkedHashMap<>();
        channels.put(channel("platform"), Bench.noisy(base, NOISE, random));
        IntStream.range(0, 3).forEach(b -> channels.put(channel(BODIES.get(b)), Bench.noisy(out[b], NOISE, random)));
        return new Recording(new Clock(0, RATE), channels, Metadata.NONE);
    }

    /** The heaviest is the one that a fit holds. */
    @ParameterizedTest
    @CsvSource({"12, 32, 5.5, torso, 32.00", "12, 44, 4, head, 4.000", "17, 44, 5.5, seat, 17.00"})
    void aMassThatIsWrongByItselfIsNamedByItself(double seat, double torso, double head, String wrong, String given) {
        for (long seed = 1; seed <= 4; seed++) {
            Evidence evidence = new Evidence(model(List.of(seat, torso, head)), recording(new Random(seed)));
            Fitter.State base = Inquiry.of(evidence, (step, share) -> {}).base();
            String words = new WrongNumbers(evidence, base, MassScale.of(evidence, base)).words();
            assertTrue(words.matches(" Surely wrong(, if \\S+ weighs \\S+ kg as given)?: mass of " + wrong + ", given " + given
                    + " kg, found [0-9.]+ kg\\."), words);
        }
    }

    /**
     * Where all numbers are right they are found so, and what is found is likelier than they are by what eight numbers gain from noise:
     * twice the logarithm is χ² with as many degrees of freedom. With gains of what sensors read, their noise in it, a mass was 6 % off,
     * and the gain 36.
     */
    @Test
    void noiseIsNoGainOfASensor() {
        int seeds = 16;
        double off = 0;
        double gained = 0;
        for (long seed = 1; seed <= seeds; seed++) {
            Evidence evidence = new Evidence(model(List.of(12.0, 44.0, 5.5)), recording(new Random(seed)));
            Fitter.State base = Inquiry.of(evidence, (step, share) -> {}).base();
            double[] right = base.candidate().start();
            off += base.x()[SEAT_MASS] / seeds;
            gained += (new Fitter(evidence).look(base.candidate(), right, base.frame()).cost() - base.cost()) / seeds;
        }
        double three = 3 * DEVIATION / Math.sqrt(seeds);
        assertEquals(0, off, three);
        assertEquals(8, gained, 3 * Math.sqrt(2 * 8.0 / seeds));
    }
}
