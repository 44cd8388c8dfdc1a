package wbv.rig;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The linear sitters against closed forms and published numbers. */
class LinearSitterTest {

    private static final double H = 0.001;

    @ParameterizedTest
    @CsvSource({"0.1,5", "0.2,5", "0.35,5", "0.475,5", "0.7,3", "1.0,4", "1.4,4"})
    void transmissibilityIsTheClosedForm(double zeta, double f0) {
        for (double f : new double[] {0.5, 2, 4, 5, 7.07, 9}) {
            double r = f / f0;
            double expected = Math.sqrt((1 + 4 * zeta * zeta * r * r)
                    / (Math.pow(1 - r * r, 2) + 4 * zeta * zeta * r * r));
            double gain = gain(new Sitter.OneDof(zeta, f0, Optional.empty()), 2, f);
            assertEquals(expected, gain, 1e-3 * expected, "at " + f + " Hz");
        }
    }

    /** REFERENCE: |STHT| of the series set ascribed to Allen, from the mass-matrix solution. */
    @ParameterizedTest
    @CsvSource({"2,1.129444", "5,1.458062", "10,1.279637"})
    void twoMassesInSeriesMatchTheMassMatrixSolution(double f, double expected) {
        assertEquals(expected, gain(Sitter.TwoDof.allen(Optional.empty()), 3, f), 1e-3 * expected);
    }

    @Test
    void modesOfTheSeriesSetAreThePublishedOnes() {
        double[] truth = new double[4];
        Plant.of(Sitter.TwoDof.allen(Optional.empty()), Effects.NONE, H, 0).parameters(truth);
        // REFERENCE section 2: 5.87 Hz, 0.681; 14.34 Hz, 0.388
        assertArrayEquals(new double[] {0.681, 5.87, 0.388, 14.34},
                new double[] {truth[0], truth[1] / (2 * Math.PI), truth[2], truth[3] / (2 * Math.PI)}, 0.005);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.8, 1.25})
    void stiffnessStepChangesFrequencyAndDampingRatioAtItsTime(double factor) {
        RigRun run = RigSpec.oneDof(0.4, 5, 1, 20, 3).withStiffnessStep(factor, 10).run();
        double[] row = new double[3];
        double[] truth = new double[2];
        while (run.read(row)) {
            run.parameters(truth);
            double k = row[0] <= 10 ? 1 : factor;
            assertEquals(0.4 / Math.sqrt(k), truth[0], 1e-12, "damping ratio at " + row[0]);
            assertEquals(10 * Math.PI * Math.sqrt(k), truth[1], 1e-12 * 40, "natural frequency at " + row[0]);
        }
    }

    @Test
    void otherDirectionsFollowThePlatform() {
        Plant plant = Plant.of(new Sitter.OneDof(0.3, 5, Optional.empty()), Effects.NONE, H, 0);
        PlaceMotion platform = new PlaceMotion();
        platform.acceleration[0] = 1;
        platform.rate[1] = 2;
        plant.step(platform);
        assertEquals(1, plant.motion(2).acceleration[0]);
        assertEquals(2, plant.motion(2).rate[1]);
    }

    /** Amplitude of the head for a steady unit sine of the platform, after 20 s, by projection on whole periods. */
    private static double gain(Sitter sitter, int head, double f) {
        Plant plant = Plant.of(sitter, Effects.NONE, H, 0);
        PlaceMotion platform = new PlaceMotion();
        int steps = (int) Math.round(Math.round(20 * f) / f / H);
        double re = 0;
        double im = 0;
        int warm = 20000;
        for (int k = 1; k <= warm + steps; k++) {
            double phase = 2 * Math.PI * f * k * H;
            platform.acceleration[2] = Math.sin(phase);
            plant.step(platform);
            if (k > warm) {
                re += plant.motion(head).acceleration[2] * Math.sin(phase);
                im += plant.motion(head).acceleration[2] * Math.cos(phase);
            }
        }
        return 2 * Math.hypot(re, im) / steps;
    }
}
