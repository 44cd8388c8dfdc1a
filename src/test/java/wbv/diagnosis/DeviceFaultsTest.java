package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.body.Assembly;
import wbv.body.ModelFile;
import wbv.body.SensorFault;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.FittedScene;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Library;
import wbv.rig.concealed.ConcealedCase;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Concealer;
import wbv.rig.concealed.Setting;

/** An IMU is one device: its channels have one clock and one mounting. */
class DeviceFaultsTest {

    private static ConcealedCase concealed(String word, boolean exact, long seed) {
        return Concealer.make(new ConcealedSpec("device", word.isEmpty() ? List.of() : List.of(word), 1, Setting.JOINTED, exact, seed));
    }

    private static Evidence evidence(ConcealedCase made) {
        return new Evidence(ModelFile.parse(made.model(), "model.json"), made.recording());
    }

    private static List<Hypothesis> hypotheses(Evidence evidence, Candidate baseline) {
        Assembly given = baseline.at(baseline.start());
        return Library.standard().hypotheses(FittedScene.of(evidence, given, Motion.measured(evidence, given)));
    }

    @Tag("slow")
    @Test
    void itsChannelsAreLateAndTurnedTogether() {
        Evidence evidence = evidence(concealed("", true, 80));
        Candidate baseline = Baseline.of(evidence);
        List<Hypothesis> all = hypotheses(evidence, baseline);
        for (Map.Entry<String, double[]> each : Map
                .of("sensor.delay@head", new double[] {0.012, 0}, "sensor.misalignment@head", new double[] {0.15}).entrySet()) {
            Hypothesis hypothesis = all.stream().filter(h -> h.name().equals(each.getKey())).findFirst().orElseThrow();
            assertEquals(Place.Kind.DEVICE, Place.of(hypothesis).kind());
            assertTrue(Place.andDevices(evidence).contains(Place.of(hypothesis)), "and it can be ignored as a whole");
            Candidate with = baseline.with(hypothesis);
            double[] x = baseline.extended(baseline.start(), with, hypothesis, each.getValue());
            List<SensorFault> faults = with.at(x).outputs().stream().flatMap(output -> output.faults().stream()).toList();
            if (each.getKey().startsWith("sensor.delay")) {
                assertEquals(List.of(new SensorFault.Delay(0.012, 0), new SensorFault.Delay(0.012, 0), new SensorFault.Delay(0.012, 0)),
                        faults);
            } else {
                // What one axis gains of the other, that loses of it.
                assertEquals(List.of(0.15, -0.15),
                        faults.stream().map(fault -> ((SensorFault.Turned) fault).angle()).sorted((a, b) -> Double.compare(b, a)).toList());
            }
            slopesAreDifferences(evidence, with, x);
        }
        assertTrue(all.stream().noneMatch(h -> h.mechanism().equals("sensor.delay") && Place.of(h).kind() == Place.Kind.SENSOR));
    }

    private static void slopesAreDifferences(Evidence evidence, Candidate with, double[] x) {
        Simulator simulator = new Simulator(evidence.excitation());
        int own = baselineKnobs(with);
        double h = 1e-4;
        Simulator.Response there = simulator.run(with.at(x), true);
        double[][] slope = with.slope(there.slopes(), own);
        double[] more = x.clone();
        double[] less = x.clone();
        more[own] += h;
        less[own] -= h;
        double[][] high = simulator.run(with.at(more), false, there.bends()).outputs();
        double[][] low = simulator.run(with.at(less), false, there.bends()).outputs();
        double unit = with.knobs().get(own).slope(x[own]);
        for (int o = 0; o < high.length; o++) {
            double size = Math.sqrt(Arrays.stream(high[o]).map(value -> value * value).sum());
            double[] difference = new double[high[o].length];
            for (int k = 0; k < difference.length; k++) {
                difference[k] = (high[o][k] - low[o][k]) / (2 * h * unit);
            }
            assertArrayEquals(difference, slope[o], 1e-4 * size);
        }
    }

    /** Index of the first number that is not the model's. */
    private static int baselineKnobs(Candidate with) {
        return with.positions(with.last())[0];
    }

    @ParameterizedTest
    @Tag("exam")
    @CsvSource({"sensor.misalignment, true, 82", "sensor.delay, false, 81"})
    void aWholeDeviceIsAtFault(String word, boolean exact, long seed) throws Exception {
        ConcealedCase made = concealed(word, exact, seed);
        Diagnosis diagnosis = Diagnoser.diagnose(ModelFile.parse(made.model(), "model.json"), made.recording(), (step, share) -> {});
        assertEquals(List.of(word), diagnosis.missing().stream().map(Diagnosis.Named::mechanism).toList(), diagnosis.sentence());
        assertTrue(made.key().contains("\"" + diagnosis.missing().get(0).where() + ".acc.z\""), made.key() + diagnosis.sentence());
    }
}
