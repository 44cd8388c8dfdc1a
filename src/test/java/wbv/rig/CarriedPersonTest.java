package wbv.rig;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A carried person is the rig's own person, whose axes do not mix, on a platform that moves as the frame does. */
class CarriedPersonTest {

    private static final double H = 1e-3;

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void moveAsTheRigsPersonDoes(int subject) {
        Effects effects = Effects.NONE.with(Effect.CUSHION).with(Effect.SOFTENING);
        Sitter.Person sitter = new Sitter.Person(Subject.of(subject));
        Plant rig = Plant.of(sitter, effects, H, 0);
        CarriedPerson carried = new CarriedPerson(Subject.of(subject), H);
        int n = carried.bodies();
        double[] state = new double[2 * n];
        double[] a = new double[n];
        PlaceMotion platform = new PlaceMotion();
        double before = 0;
        double differences = 0;
        double squares = 0;
        for (int i = 1; i <= 5000; i++) {
            double t = i * H;
            double now = 2 * Math.sin(2 * Math.PI * 2.3 * t) + Math.sin(2 * Math.PI * 5.1 * t) + 0.5 * Math.sin(2 * Math.PI * 11 * t);
            platform.acceleration[2] = now;
            rig.step(platform);
            carried.feel(now);
            step(carried, state, before, now);
            carried.act(state, 0, n, a);
            before = now;
            double head = rig.motion(sitter.places().indexOf("head")).acceleration[2];
            differences += (a[carried.head()] - head) * (a[carried.head()] - head);
            squares += head * head;
            assertEquals(rig.motion(sitter.places().indexOf("seat")).acceleration[2], a[carried.seat()], 0.02, "seat at " + t + " s");
        }
        assertEquals(0, Math.sqrt(differences / squares), 1e-3);
    }

    /** Runge-Kutta's fourth order in quarters of a step, the frame's acceleration a line between its ends. */
    private static void step(CarriedPerson carried, double[] state, double before, double now) {
        int n = carried.bodies();
        int parts = 4;
        for (int p = 0; p < parts; p++) {
            double h = H / parts;
            double[] at = {(double) p / parts, (p + 0.5) / parts, (p + 0.5) / parts, (p + 1.0) / parts};
            double[] sum = state.clone();
            double[] trial = state.clone();
            for (int stage = 0; stage < 4; stage++) {
                double[] a = new double[n];
                carried.act(trial, 0, n, a);
                double frame = before + (now - before) * at[stage];
                double weight = stage == 0 || stage == 3 ? h / 6 : h / 3;
                double ahead = stage == 2 ? h : h / 2;
                double[] next = state.clone();
                for (int i = 0; i < n; i++) {
                    sum[i] += weight * trial[n + i];
                    sum[n + i] += weight * (a[i] - frame);
                    next[i] += ahead * trial[n + i];
                    next[n + i] += ahead * (a[i] - frame);
                }
                trial = next;
            }
            System.arraycopy(sum, 0, state, 0, state.length);
        }
    }

    /** A mass that is shaken slowly is all there; the trunk goes with it. */
    @Test
    void slowlyShakenHeIsHisMass() {
        CarriedPerson carried = new CarriedPerson(Subject.of(1), H);
        double[] response = new double[4];
        carried.respond(0.01, response);
        assertEquals(0.84 * Subject.of(1).mass(), carried.carriedMass(), 1e-9);
        assertEquals(carried.carriedMass(), response[0], 0.01);
        assertEquals(1, response[2], 1e-3);
    }
}
