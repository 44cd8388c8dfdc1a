package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.body.Model;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Recording;

/** A slide that no spring holds, pushed by a measured force over friction that its model lacks, integrated here. */
class FreeBodyDiagnosisTest {

    private static final Channel FORCE = Channel.parse("slide.force.z");
    private static final Channel POSITION = Channel.parse("slide.pos.z");
    private static final double MASS = 12;
    private static final double FRICTION = 20;

    @ParameterizedTest
    @CsvSource({"100, 12, 2, 1.15, 0.9, 0", "250, 12, 3, 0.9, 1.1, 0.4", "1000, 6, 4, 1.05, 0.88, -0.2"})
    void frictionUnderASlideIsFound(double rate, double seconds, long seed, double massError, double dampingError, double speed) {
        Diagnosis d = diagnose(slide(MASS * massError, 15 * dampingError), record(rate, seconds, seed, FRICTION, speed));
        assertEquals(List.of("friction.coulomb"), d.missing().stream().map(Diagnosis.Named::mechanism).toList(), d.sentence());
        assertEquals(FRICTION, d.missing().get(0).parameters().get("friction_N"), 0.1 * FRICTION, d.sentence());
    }

    @Test
    void aSlideWithoutFrictionLacksNothing() {
        Diagnosis d = diagnose(slide(MASS * 1.1, 15 * 0.9), record(100, 10, 5, 0, 0.3));
        assertTrue(d.missing().isEmpty(), d.sentence());
    }

    static Diagnosis diagnose(Model model, Recording recording) {
        return Diagnoser.diagnose(new Question(model, recording, Optional.empty(), OptionalDouble.empty()), (step, share) -> { });
    }

    static Model slide(double mass, double damping) {
        return new Model("slide", Optional.empty(), 'z', new Model.Base("bench", Optional.empty()),
                List.of(new Model.Body("slide", mass, Optional.of(POSITION), List.of(), Optional.empty(), List.of())),
                List.of(new Model.Link("bench", "slide", 0, damping, Optional.empty(), List.of(), List.of())),
                List.of(new Model.Input("slide", FORCE)));
    }

    /** Semi-implicit Euler steps of 1/20000 s; the slide sticks where the push is less than its friction. Noise of 0.1 mm. */
    static Recording record(double rate, double seconds, long seed, double friction, double speed) {
        Random random = new Random(seed);
        double[] phase = random.doubles(40, 0, 2 * Math.PI).toArray();
        int n = (int) (seconds * rate);
        int fine = (int) Math.round(20000 / rate);
        double h = 1 / rate / fine;
        double[] u = new double[n];
        double[] y = new double[n];
        double x = speed == 0 ? 0 : 0.07;
        double v = speed;
        for (int j = 0; j < n; j++) {
            u[j] = push(j / rate, phase);
            y[j] = x + 1e-4 * random.nextGaussian();
            for (int i = 0; i < fine; i++) {
                double free = v + h / MASS * (push(j / rate + i * h, phase) - 15 * v);
                double most = h / MASS * friction;
                v = Math.abs(free) <= most ? 0 : free - Math.copySign(most, free);
                x += h * v;
            }
        }
        return new Recording(new Clock(0, rate), Map.of(FORCE, u, POSITION, y), Metadata.NONE);
    }

    private static double push(double t, double[] phase) {
        double sum = 0;
        for (int k = 0; k < phase.length; k++) {
            sum += 15 * Math.sin(2 * Math.PI * (0.3 + 0.15 * k) * t + phase[k]);
        }
        return Math.min(1, t) * sum;
    }
}
