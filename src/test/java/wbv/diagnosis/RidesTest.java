package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import wbv.body.Model;
import wbv.body.law.CubicSpring;
import wbv.body.law.Law;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.Recording;

/** Several recordings of one subject, fitted together and proven on one that took no part. */
class RidesTest {

    private static final double RATE = 60;
    private static final Channel BASE = Channel.parse("platform.acc.z");
    private static final Channel HEAD = Channel.parse("head.acc.z");

    @Test
    void recordingsLieEndToEndWithAPauseBetween() {
        Recording a = new Recording(new Clock(10, RATE), Map.of(BASE, filled(600, 1), HEAD, filled(600, 2)), Metadata.NONE);
        Recording b = new Recording(new Clock(500, RATE), Map.of(BASE, filled(300, 3)), Metadata.NONE);
        Rides rides = Rides.of(fitted("a", a), Optional.of(Map.entry("b", b)));
        assertEquals(List.of(BASE), rides.recording().channels());
        assertEquals(600 + 240 + 300, rides.recording().length());
        double[] joined = rides.recording().values(BASE);
        assertArrayEquals(filled(600, 1), Arrays.copyOf(joined, 600));
        assertTrue(Arrays.stream(joined, 600, 840).allMatch(Double::isNaN));
        assertArrayEquals(filled(300, 3), Arrays.copyOfRange(joined, 840, 1140));
        assertEquals(10 + 840 / RATE, rides.provedFrom().orElseThrow(), 1e-9);
        assertEquals(500, rides.provedFrom().orElseThrow() - rides.moved(), 1e-9);
    }

    @Test
    void oneAloneIsItself() {
        Recording a = new Recording(new Clock(10, RATE), Map.of(BASE, filled(600, 1)), Metadata.NONE);
        assertEquals(new Rides(a, OptionalDouble.empty(), 0), Rides.of(fitted("a", a), Optional.empty()));
    }

    @Test
    void whatDoesNotGoTogetherIsSaid() {
        Recording a = new Recording(new Clock(0, RATE), Map.of(BASE, filled(600, 1)), Metadata.NONE);
        Recording fast = new Recording(new Clock(0, 100), Map.of(BASE, filled(600, 1)), Metadata.NONE);
        Recording brief = new Recording(new Clock(0, RATE), Map.of(BASE, filled(60, 1)), Metadata.NONE);
        Recording other = new Recording(new Clock(0, RATE), Map.of(HEAD, filled(600, 1)), Metadata.NONE);
        assertEquals("fast.csv: is sampled at 100 Hz, a.csv at 60 Hz: they need one rate", refused(a, "fast.csv", fast));
        assertEquals("brief.csv: lasts 1.00 s; one of several recordings needs at least 5 s", refused(a, "brief.csv", brief));
        assertEquals("a.csv: has no channel in common with other.csv", refused(a, "other.csv", other));
    }

    private static String refused(Recording a, String name, Recording b) {
        Map<String, Recording> both = fitted("a.csv", a);
        both.put(name, b);
        return assertThrows(DataFault.class, () -> Rides.of(both, Optional.empty())).getMessage();
    }

    /**
     * A spring that hardens, at three levels: two are fitted, and the third, twice as strong and farther out on the law, is met nearly to
     * the noise.
     */
    @Tag("slow")
    @Test
    void aLawThatTwoLevelsShowHoldsAtAThird() {
        Map<String, Recording> fitted = fitted("quiet", ride(0.4, 1));
        fitted.put("usual", ride(0.8, 2));
        Rides rides = Rides.of(fitted, Optional.of(Map.entry("strong", ride(1.6, 3))));
        Question question = new Question(model(1.06, List.of()), rides.recording(), Optional.empty(), OptionalDouble.empty())
                .proved(rides.provedFrom());
        Diagnosed found = Diagnoser.examine(question, (step, share) -> {});
        assertEquals("stiffness.hardening", found.diagnosis().missing().get(0).mechanism(), found.diagnosis().sentence());
        found.diagnosis().fit().nrmseAfter().forEach((channel, after) -> {
            double floor = found.diagnosis().fit().nrmseFloor().get(channel);
            assertTrue(after < 1.6 * floor, channel + " " + after + ", noise " + floor);
            assertTrue(found.diagnosis().fit().nrmseBefore().get(channel) > 3 * after,
                    channel + " before " + found.diagnosis().fit().nrmseBefore().get(channel));
        });
        double[] time = found.predicted().earlier(rides.moved()).time();
        assertTrue(time[0] >= 1 && time[0] < 4 && time[time.length - 1] > 25 && time[time.length - 1] < 30,
                time[0] + " to " + time[time.length - 1]);
    }

    private static Map<String, Recording> fitted(String name, Recording recording) {
        return new LinkedHashMap<>(Map.of(name, recording));
    }

    private static double[] filled(int length, double value) {
        double[] out = new double[length];
        Arrays.fill(out, value);
        return out;
    }

    private static Model model(double off, List<Law> laws) {
        return new Model("two", Optional.empty(), 'z', new Model.Base("platform", Optional.of(BASE)),
                List.of(body("sternum", 40), body("head", 6)), List.of(
                        new Model.Link("platform", "sternum", off * 45000, 1200 / off, Optional.empty(), laws, List.of()),
                        new Model.Link("sternum", "head", 22000 / off, off * 160, Optional.empty(), List.of(), List.of())));
    }

    private static Model.Body body(String name, double mass) {
        return new Model.Body(name, mass, Optional.of(Channel.parse(name + ".acc.z")), List.of(), Optional.empty(), List.of());
    }

    /** Half a minute, 0.5 to 15 Hz. @param level of the base [m/s2] */
    private static Recording ride(double level, int seed) {
        Random random = new Random(seed);
        int n = 1800;
        double[] base = new double[n];
        for (int k = 0; k < 200; k++) {
            double f = 0.5 + 14.5 * k / 200;
            double phase = 2 * Math.PI * random.nextDouble();
            for (int i = 0; i < n; i++) {
                base[i] += level * 0.1 * Math.min(1, i / RATE) * Math.sin(2 * Math.PI * f * i / RATE + phase);
            }
        }
        Model truth = model(1, List.of(new CubicSpring(1.5e9)));
        double[][] outputs = new Simulator(new Excitation(RATE, base, Map.of())).outputs(truth.assembly());
        Map<Channel, double[]> values = new LinkedHashMap<>();
        values.put(BASE, noisy(base, random));
        for (int o = 0; o < outputs.length; o++) {
            values.put(truth.outputs().get(o), noisy(outputs[o], random));
        }
        return new Recording(new Clock(0, RATE), values, Metadata.NONE);
    }

    private static double[] noisy(double[] x, Random random) {
        return Arrays.stream(x).map(value -> value + 0.01 * random.nextGaussian()).toArray();
    }
}
