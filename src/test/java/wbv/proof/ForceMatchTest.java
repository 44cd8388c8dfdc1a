package wbv.proof;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import wbv.body.Model;
import wbv.body.law.CubicSpring;
import wbv.body.law.Law;
import wbv.diagnosis.Diagnosis;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Quantity;
import wbv.recording.Recording;

class ForceMatchTest {

    private static final int N = 3000;
    private static final double RATE = 60;

    private static double[] series(IntToDoubleFunction of) {
        return IntStream.range(0, N).mapToDouble(of).toArray();
    }

    private static double sine(double hertz, int i) {
        return Math.sin(2 * Math.PI * hertz * i / RATE);
    }

    private static LawForce answer(double from, double to, double[] x) {
        return new LawForce("seat-torso", RATE, from, to, Arrays.stream(x).boxed().toList(), List.of());
    }

    private static final ForceMatch TRUTH = new ForceMatch(RATE, series(i -> 5 * sine(3, i) * sine(1.7, i)), series(i -> 1e-3 * sine(3, i)),
            series(i -> 0.02 * sine(3.01, i + 5)));

    /**
     * A stiffness, a damping, a load and what is too slow to be told from rest are no part of it; nor is anything before the held-out
     * stretch.
     */
    @Test
    void anAnswerIsAlikeWhateverLinearPartItHas() {
        double[] told = series(i -> 2 * TRUTH.force()[i] + 3e4 * TRUTH.extension()[i] - 700 * TRUTH.speed()[i] + 40 + 30 * sine(0.3, i)
                + (i < 600 ? 8 * sine(7, i) : 0));
        assertEquals(1, TRUTH.correlation(answer(25, 45, told)), 2e-3);
        assertEquals(-1, TRUTH.correlation(answer(25, 45, series(i -> -told[i]))), 2e-3);
        assertTrue(TRUTH.correlation(answer(0, 12, told)) < 0.99);
    }

    /** Half signal, half something else of the same power: 1/√2. What is unlike is not; what is nothing is not a number. */
    @Test
    void anAnswerIsAlikeByThePartThatIsRight() {
        double power = 25 / 4.0;
        double[] half = series(i -> TRUTH.force()[i] + Math.sqrt(2 * power) * sine(11, i));
        assertEquals(Math.sqrt(0.5), TRUTH.correlation(answer(20, 49, half)), 0.02);
        Random random = new Random(4);
        assertEquals(0, TRUTH.correlation(answer(20, 49, series(i -> random.nextGaussian()))), 0.2);
        assertTrue(Double.isNaN(TRUTH.correlation(answer(20, 49, new double[N]))));
        assertTrue(Double.isNaN(TRUTH.correlation(answer(20, 20.5, half))));
    }

    @Test
    void aForceIsReadAsItWasWritten() {
        ForceMatch read = ForceMatch.parse("time_s,force_N,extension_m,rate_m_per_s\n0.000000,1,2e-3,3\n0.016667,4,5,6\n0.033333,7,8,9\n");
        assertEquals(60, read.rate(), 1e-3);
        assertEquals(List.of(1.0, 4.0, 7.0), Arrays.stream(read.force()).boxed().toList());
        assertEquals(2e-3, read.extension()[0]);
        assertEquals(9, read.speed()[2]);
    }

    private static Model model(List<Law> laws) {
        return new Model("one", Optional.empty(), 'z',
                new Model.Base("platform", Optional.of(new Channel("platform", Quantity.ACCELERATION, 'z'))),
                List.of(new Model.Body("torso", 50, Optional.of(new Channel("torso", Quantity.ACCELERATION, 'z')), List.of(),
                        Optional.empty(), List.of())),
                List.of(new Model.Link("platform", "torso", 5e4, 1500, Optional.empty(), laws, List.of())));
    }

    private static Diagnosis found(Model model) {
        Diagnosis.Named named = new Diagnosis.Named("stiffness.hardening", "platform-torso", 0.9, Map.of(), Map.of(), 1);
        return new Diagnosis(Diagnosis.Verdict.MISSING_PHYSICS, "", List.of(), List.of(named), List.of(), "",
                new Diagnosis.Fit(1, 1, 1, 1, 1, new double[] {30, 45}, List.of(), List.of(), Map.of()), List.of(), model,
                Optional.empty());
    }

    /** Moved so slowly that it stands in balance: k r + k3 r³ = -m a, and k3 r³ is the law's. */
    @Test
    void theForceOfAnAnswerIsWhatItsNewLawsCarry() {
        double k3 = 5e9;
        double[] base = series(i -> 3 * Math.sin(2 * Math.PI * 0.1 * i / RATE) * Math.sin(Math.PI * i / N));
        Recording recording = new Recording(new Clock(100, RATE),
                new java.util.LinkedHashMap<>(Map.of(new Channel("platform", Quantity.ACCELERATION, 'z'), base)), Metadata.NONE);
        LawForce force = LawForce.of(found(model(List.of(new CubicSpring(k3)))), model(List.of()), recording).orElseThrow();
        assertEquals("platform-torso", force.where());
        assertEquals(30, force.from());
        List<Double> misses = new ArrayList<>();
        for (int i = 200; i < N - 200; i++) {
            double r = 0;
            for (int step = 0; step < 50; step++) {
                r -= (5e4 * r + k3 * r * r * r + 50 * base[i]) / (5e4 + 3 * k3 * r * r);
            }
            misses.add(Math.abs(force.newtons().get(i) - k3 * r * r * r));
        }
        double most = force.newtons().stream().mapToDouble(Math::abs).max().orElse(0);
        assertTrue(most > 20, "the law must act: " + most);
        assertEquals(0, misses.stream().mapToDouble(x -> x).max().orElse(9), 0.03 * most);
        assertTrue(LawForce.of(found(model(List.of(new CubicSpring(k3)))), model(List.of(new CubicSpring(2 * k3))), recording).isEmpty(),
                "what the question had already is no answer");
        assertTrue(LawForce.of(found(model(List.of())), model(List.of()), recording).isEmpty());
    }
}
