package wbv.diagnosis.learn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.body.Assembly;
import wbv.body.Structure;
import wbv.body.simulate.Excitation;

class LatentForceTest {

    /** Two seconds at 8300 Hz are 1200 periods of a bench, and were too short for its force to be known anywhere. */
    @ParameterizedTest
    @CsvSource({"60, 7200, 0.979", "8300, 16600, 0.9", "100, 1000, 0.9"})
    void itIsKnownButForItsEnds(double rate, int samples, double share) {
        Excitation whole = new Excitation(rate, new double[samples], Map.of());
        boolean[] counted = new boolean[samples];
        Arrays.fill(counted, true);
        counted[samples / 2] = false;
        Assembly bare = new Assembly(
                new Structure(new int[] {-1}, new int[] {0}, new double[] {1e4}, new double[] {1e2}, new double[] {10}), List.of(),
                List.of(), List.of());
        double[] none = new double[2 * whole.omega().length];
        LatentForce force = new LatentForce(whole, counted, bare, new LatentForce.Estimate(none, none, none, none, new double[0], 1, 1));
        assertEquals(share, IntStream.range(0, samples).filter(force::known).count() / (double) samples, 5e-3);
        assertFalse(force.known(0) || force.known(samples - 1) || force.known(samples / 2));
    }
}
