package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import wbv.body.Assembly;
import wbv.body.CubicSpring;
import wbv.body.LawAt;
import wbv.body.Simulator;

/** The force that a formula may be wrong by, held to the law's own force as the free run has it. */
class FormDiscrepancyTest {

    @Test
    void itIsThePowerOfTheLawsForceWithoutSpringAndDashpot() {
        Evidence evidence = WeighingTest.evidence(List.of(new LawAt(1, new CubicSpring(8e9))), 0, 6);
        Candidate baseline = Baseline.of(evidence);
        Candidate with = baseline.with(WeighingTest.CUBIC);
        double[] x = baseline.extended(baseline.start(), with, WeighingTest.CUBIC, new double[] {8e9});
        Fitter fitter = new Fitter(evidence);
        Fitter.State fit = fitter.look(with, x, evidence.fit());
        Simulator simulator = new Simulator(evidence.excitation());
        Assembly full = with.at(x);
        FormDiscrepancy form = FormDiscrepancy.of(evidence, baseline, fit, WeighingTest.CUBIC, simulator.equivalent(full), way -> way, Priors.USUAL);
        assertEquals(new Place(Place.Kind.LINK, 1), form.place());
        assertArrayEquals(new double[] {0, 0.05, 0.1, 0.15}, form.shares(), 1e-12);
        double[] series = evidence.excitation().series(simulator.run(full, false).forces()[0]);
        boolean[] all = new boolean[series.length];
        Arrays.fill(all, true);
        double[] own = OwnForce.smoothed(evidence.fit(), evidence.fit().spectrum(series, all));
        // A cubic spring is stiffer where it swings far: around the resonance most of its force is a spring's, three times beyond it none is.
        double near = 0;
        double whole = 0;
        for (int line = 0; line < own.length; line++) {
            double f = evidence.fit().frequency(line);
            near += f > 3 && f < 6 ? form.force()[line] : 0;
            whole += f > 3 && f < 6 ? own[line] : 0;
        }
        assertTrue(near < 0.7 * whole && near > 0.02 * whole, near + " of " + whole);
        assertArrayEquals(Arrays.stream(form.force()).map(p -> 0.01 * p).toArray(), form.power(0.1), 1e-12);
    }

    /** A spectrum of one level stays at it, and a line is spread over a third of an octave. */
    @Test
    void smoothing() {
        Window window = new Window(0, 1200, 60);
        double[] level = new double[2 * window.lines()];
        Arrays.fill(level, 3);
        assertArrayEquals(Arrays.stream(new double[window.lines()]).map(v -> 9).toArray(), OwnForce.smoothed(window, level), 1e-9);
        double[] line = new double[2 * window.lines()];
        line[200] = 1;
        double[] spread = OwnForce.smoothed(window, line);
        double f = window.frequency(100);
        for (int i = 0; i < spread.length; i++) {
            boolean within = window.frequency(i) > f / 1.1 && window.frequency(i) < f * 1.1;
            boolean beyond = window.frequency(i) < f / 1.2 || window.frequency(i) > f * 1.2;
            assertTrue(!within || spread[i] > 0, "at " + window.frequency(i));
            assertTrue(!beyond || spread[i] == 0, "at " + window.frequency(i));
        }
    }
}
