package wbv.diagnosis.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import org.junit.jupiter.api.Test;
import wbv.body.Model;
import wbv.body.law.AsymmetricSpring;
import wbv.body.law.Law;
import wbv.body.law.QuadraticDamping;
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

/** A law is begun as strong as half of what its link carries, and twice that, with either sign if it may have it. */
class StrongStartsTest {

    private static final double STIFFNESS = 90e3;
    private static final double DAMPING = 1200;
    private static final Channel BASE = Channel.parse("platform.acc.z");
    private static final Channel SEAT = Channel.parse("seat.acc.z");

    private final Evidence evidence = evidence();
    private final Fitter.State base = new Search(evidence, (step, share) -> {}).base(Baseline.of(evidence));
    private final Motion motion = new Motion(evidence, base.candidate().at(base.x()));
    private final StrongStarts strong = new StrongStarts(new Screening(evidence, base, motion));

    /** A mass on a spring that is shaken at random. */
    private static Evidence evidence() {
        Model model = new Model("mass", Optional.empty(), 'z', new Model.Base("platform", Optional.of(BASE)),
                List.of(new Model.Body("seat", 60, Optional.of(SEAT), List.of(), Optional.empty(), List.of())),
                List.of(new Model.Link("platform", "seat", STIFFNESS, DAMPING, Optional.empty(), List.of(), List.of())));
        double[] shaken = new Random(5).doubles(1200, -1, 1).toArray();
        Map<Channel, double[]> channels = new LinkedHashMap<>();
        channels.put(BASE, shaken);
        channels.put(SEAT, new Simulator(new Excitation(60, shaken, Map.of())).outputs(model.assembly())[0]);
        return new Evidence(model, new Recording(new Clock(0, 60), channels, Metadata.NONE), OptionalDouble.of(0.05),
                OptionalDouble.empty());
    }

    private static Hypothesis hypothesis(Law law, double unit, double low, double high) {
        return new Hypothesis(Library.standard().of(law.mechanism()).orElseThrow(), "platform-seat", "",
                List.of(new Addition.InLink(0, law)),
                Hypothesis.Number.named(law.getClass(), List.of(Hypothesis.Number.sum(unit, low, high))),
                List.of(Start.scaled(unit)));
    }

    private static double rms(double[] x) {
        return Math.sqrt(Arrays.stream(x).map(v -> v * v).average().orElseThrow());
    }

    /** Of a square, but for the first sample, at which no law acts yet. */
    private static double rmsOfSquares(double[] x) {
        double[] squares = Arrays.stream(x).map(v -> v * v).toArray();
        squares[0] = 0;
        return rms(squares);
    }

    /** What the fitted spring and dashpot carry [N]. */
    private double carried() {
        return rms(motion.load(0));
    }

    @Test
    void aLawOfEitherSignIsBegunWithBoth() {
        List<double[]> starts = strong.of(hypothesis(new QuadraticSpring(1e6), 1e6, -1e12, 1e12));
        double square = rmsOfSquares(motion.displacement(0));
        double[] shares = starts.stream().mapToDouble(values -> values[0] * square / carried()).toArray();
        assertEquals(4, shares.length);
        double[] expected = {-2, -0.5, 0.5, 2};
        for (int i = 0; i < expected.length; i++) {
            assertEquals(expected[i], shares[i], 2e-9);
        }
    }

    @Test
    void dampingIsBegunPositive() {
        List<double[]> starts = strong.of(hypothesis(new QuadraticDamping(100), 100, 0, 1e9));
        double square = rmsOfSquares(motion.velocity(0));
        assertEquals(List.of(0.5, 2.0), starts.stream().map(values -> Math.rint(1e6 * values[0] * square / carried()) / 1e6).toList());
    }

    @Test
    void noStartIsBeyondWhatTheLawMayBe() {
        List<double[]> starts = strong.of(hypothesis(new AsymmetricSpring(0.1), 0.1, -0.97, 12));
        assertTrue(starts.stream().allMatch(values -> values[0] >= -0.97 && values[0] <= 12));
        assertTrue(starts.stream().anyMatch(values -> values[0] > 2), "as stiff as that in compression it carries twice as much");
    }
}
