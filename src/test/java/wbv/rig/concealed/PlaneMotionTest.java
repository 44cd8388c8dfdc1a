package wbv.rig.concealed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.rig.platform.Seeds;

/** What models in a plane make of a platform's motion, against bodies that turn by whole angles, integrated in steps of 1/4800 s. */
class PlaneMotionTest {

    private static final int EVERY = 8;

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void movesAsBodiesThatTurnByWholeAngles(long seed) {
        PlanarPerson person = PlanarPerson.draw(new Well19937c(seed));
        Shaking shaking = Shaking.of(Setting.PLANAR, 0.9, OptionalDouble.of(20), new Seeds(seed));
        int length = shaking.length();
        double[] x = UniformSeries.lines(length, 0.4, 8, -0.3, 0.4, new Well19937c(seed + 10));
        double[] pitch = UniformSeries.lines(length, 0.4, 6, -1, 0.006, new Well19937c(seed + 20));
        UniformSeries.fade(x, 1);
        UniformSeries.fade(pitch, 1);
        PlanarPlant.Base base = PlanarPlant.Base.of(x, shaking.z(), UniformSeries.rate(pitch));
        PlanarPlant.Trace trace = new PlanarPlant(new PlanarSetup(person), PlanarPlant.FINE).run(base);
        double rate = UniformSeries.RATE / EVERY;
        double[][] driven = {thinned(base.z()), thinned(base.x()), thinned(base.spin())};
        Model whole = ModelFile.parse(person.plane("plane").toString(), "plane.json");
        double[][] outputs = new Simulator(new Excitation(rate, driven, Map.of())).outputs(whole.assembly());
        double[][] small = new Simulator(new Excitation(rate, driven, Map.of())).outputs(ModelFile.parse(ModelFile.text(whole)
                .replaceFirst("(?s)(\"base\".*?\"further\"[^]]*\\]),\\s*\"at_m\"[^]]*\\]", "$1"), "small.json").assembly());
        for (int o = 0; o < outputs.length; o++) {
            String channel = whole.outputs().get(o).toString();
            int body = PlanarPerson.PLACES.indexOf(channel.substring(0, channel.indexOf('.'))) - 1;
            int felt = channel.endsWith(".acc.x") ? 0 : channel.endsWith(".acc.z") ? 1 : 2;
            double[] expected = thinned(trace.felt()[body][felt]);
            double error = error(expected, outputs[o]);
            assertTrue(error < 5e-3, channel + ": " + error + " of it is missed, and by small motions " + error(expected, small[o]));
            assertTrue(!channel.startsWith("head") || error < 0.3 * error(expected, small[o]),
                    channel + ": " + error + ", by small motions " + error(expected, small[o]));
        }
        assertEquals(9, outputs.length);
    }

    /** Part of a series that another misses, constants left out. */
    private static double error(double[] expected, double[] given) {
        int n = expected.length;
        double mean = IntStream.range(0, n).mapToDouble(i -> expected[i] - given[i]).average().orElseThrow();
        double off = IntStream.range(0, n).mapToDouble(i -> Math.pow(expected[i] - given[i] - mean, 2)).sum();
        return Math.sqrt(off / IntStream.range(0, n).mapToDouble(i -> expected[i] * expected[i]).sum());
    }

    private static double[] thinned(double[] series) {
        return IntStream.range(0, (series.length - 1) / EVERY).mapToDouble(i -> series[i * EVERY]).toArray();
    }
}
