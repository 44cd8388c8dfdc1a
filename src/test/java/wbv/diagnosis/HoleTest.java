package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.body.Model;
import wbv.recording.Channel;
import wbv.recording.Recording;

/** A recording that nobody wrote for a hundred seconds, of a bench of which nothing is left out but its numbers. */
class HoleTest {

    private static final Channel TABLE = Channel.parse("table.acc.z");
    private static final Channel FRAME = Channel.parse("frame.acc.z");
    private static final double RATE = 100;
    private static final double MASS = 60;
    private static final double NOISE = 0.02;

    /** What a hole is bridged by is no motion: neither a fault of a sensor nor a law is told of it. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    @Tag("slow")
    void nothingIsMissingAboutAHole(long seed) {
        Random random = new Random(seed);
        DoubleUnaryOperator table = Bench.tones(60, 0.5, 0.3131, 0.6, random);
        Bench bench = new Bench(RATE, 60, 40, MASS)
                .run((t, x, v, out) -> out[0] = -24_000 * x[0] - 500 * v[0] - MASS * table.applyAsDouble(t));
        double[] base = bench.sampled(table);
        double[] frame = bench.sampled(bench.acceleration(0));
        Arrays.setAll(frame, i -> frame[i] + base[i]);
        Recording written = bench.recording(TABLE, holed(Bench.noisy(base, NOISE, random)), FRAME,
                holed(Bench.noisy(frame, NOISE, random)));
        assertEquals(Diagnosis.Verdict.PARAMETERS_ONLY, Bench.diagnosed(model(), written).verdict());
    }

    /** The clock leaps by a hundred seconds, and three times nothing was written for a while. */
    private static double[] holed(double[] series) {
        double[] x = series.clone();
        for (double[] gap : new double[][] {{5, 5.3}, {17.2, 19.2}, {41, 42}}) {
            Arrays.fill(x, (int) (gap[0] * RATE), (int) (gap[1] * RATE), Double.NaN);
        }
        int hole = (int) (100 * RATE);
        double[] out = new double[x.length + hole];
        Arrays.fill(out, Double.NaN);
        System.arraycopy(x, 0, out, 0, 3500);
        System.arraycopy(x, 3500, out, 3500 + hole, x.length - 3500);
        return out;
    }

    private static Model model() {
        return new Model("bench", Optional.empty(), 'z', new Model.Base("table", Optional.of(TABLE)),
                List.of(Bench.body("frame", MASS, Optional.of(FRAME))),
                List.of(Bench.link("table", "frame", 22_000, 540, Optional.empty())), List.of(),
                Optional.of(Model.Subject.RIG), List.of());
    }
}
