package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.body.Model;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Readings;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Recording;

/** Nothing is missing only where neither the data fitted nor those held out show anything, and only of what the input moves. */
class BothWindowsTest {

    private static final Channel BASE = Channel.parse("platform.acc.z");
    private static final Channel HEAD = Channel.parse("head.acc.z");
    private static final double SECONDS = 40;
    private static final double NOISE = 0.02;
    private static final Model MODEL = new Model("sitter", Optional.empty(), 'z', new Model.Base("platform", Optional.of(BASE)),
            List.of(body("torso", 45, "sternum.acc.z"), body("head", 6, "head.acc.z")),
            List.of(link("platform", "torso", 50000, 900), link("torso", "head", 22000, 160)));

    private static Model.Body body(String name, double mass, String sensor) {
        return new Model.Body(name, mass, Optional.of(Channel.parse(sensor)), List.of(), Optional.empty(), List.of());
    }

    private static Model.Link link(String from, String to, double stiffness, double damping) {
        return new Model.Link(from, to, stiffness, damping, Optional.empty(), List.of(), List.of());
    }

    /** Something shook the head for some seconds: early, where the model is fitted, or late, where it is proved. */
    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"8, 14", "31, 38"})
    void anEventIsNeitherNothingNorALaw(double from, double to) {
        Diagnosis diagnosis = diagnosed(recording(60, 3, from, to, 0.25));
        double loud = Math.max(diagnosis.fit().before(), diagnosis.fit().heldBefore());
        assertTrue(loud > 2, diagnosis.sentence());
        assertEquals(Diagnosis.Verdict.CANNOT_TELL, diagnosis.verdict(), diagnosis.sentence());
        assertEquals(List.of(), diagnosis.missing());
        assertTrue(diagnosis.sentence().startsWith("Cannot tell whether anything is missing: the model leaves "), diagnosis.sentence());
        assertFalse(diagnosis.nextExperiment().isEmpty());
    }

    @Test
    void withoutTheEventNothingIsMissing() {
        Diagnosis diagnosis = diagnosed(recording(60, 3, 0, 0, 0));
        assertEquals(Diagnosis.Verdict.NOTHING_MISSING, diagnosis.verdict(), diagnosis.sentence());
    }

    /** Clocks scatter by the samples that they count, not by those that a fast recording is slowed down to. */
    @Test
    void scatterOfClocksGoesWithTheRecordedSample() {
        Evidence evidence = new Evidence(MODEL, recording(480, 4, 0, 0, 0));
        assertEquals(1.0 / 480, evidence.measured().sample(), 1e-12);
        assertEquals(60, evidence.recording().clock().rate(), 1e-9);
        Fitter fitter = new Fitter(evidence);
        Candidate baseline = Baseline.of(evidence);
        Fitter.State fit = fitter.look(baseline, baseline.start(), evidence.fit());
        Readings.errors(evidence, fit).values().forEach(errors -> errors
                .forEach((key, value) -> assertTrue(!key.equals("delay_s") || Math.abs(value) <= 0.3 / 480 + 1e-12, key + " " + value)));
        Diagnosis diagnosis = diagnosed(recording(480, 4, 0, 0, 0));
        assertEquals(Diagnosis.Verdict.NOTHING_MISSING, diagnosis.verdict(), diagnosis.sentence());
    }

    /** At 50 Hz noise is read between 12 and 18 Hz, where this ride still moves, and a head that is too stiff by a third shows. */
    @Test
    void motionWhereNoiseIsReadIsNoNoise() {
        Recording recording = ride(50, 5, 20);
        Evidence evidence = new Evidence(MODEL, recording);
        assertEquals(NOISE, evidence.measured().inputNoise(), 0.25 * NOISE);
        Model stiff = new Model("stiff", Optional.empty(), 'z', MODEL.base(), MODEL.bodies(), List.of(MODEL.links().get(0),
                link("torso", "head", 1.3 * 22000, 160)));
        Diagnosis diagnosis = diagnosed(stiff, recording);
        assertEquals(Diagnosis.Verdict.PARAMETERS_ONLY, diagnosis.verdict(), diagnosis.sentence());
        assertEquals(22000.0 / 50000, diagnosis.model().links().get(1).stiffness() / diagnosis.model().links().get(0).stiffness(), 0.01);
    }

    private static Diagnosis diagnosed(Recording recording) {
        return diagnosed(MODEL, recording);
    }

    private static Diagnosis diagnosed(Model model, Recording recording) {
        return Diagnoser.diagnose(model, recording, (step, share) -> {});
    }

    /** A ride up to 11 Hz, the head shaken besides by noise of its own between two moments. */
    private static Recording recording(double rate, long seed, double from, double to, double size) {
        Recording ride = ride(rate, seed, 11);
        Random random = new Random(seed + 100);
        Map<Channel, double[]> values = new LinkedHashMap<>();
        double[] slow = {0};
        ride.channels().forEach(channel -> {
            double[] x = ride.values(channel).clone();
            for (int i = 0; channel.equals(HEAD) && i < x.length; i++) {
                slow[0] += 0.4 * (random.nextGaussian() - slow[0]);
                x[i] += i >= from * rate && i < to * rate ? size * slow[0] : 0;
            }
            values.put(channel, x);
        });
        return new Recording(ride.clock(), values, Metadata.NONE);
    }

    /** @param highest frequency of the ride [Hz] */
    private static Recording ride(double rate, long seed, double highest) {
        Random random = new Random(seed);
        int n = (int) (SECONDS * rate);
        int lines = (int) (highest / 0.07);
        double[] phase = random.doubles(lines, 0, 2 * Math.PI).toArray();
        double[] base = new double[n];
        for (int i = 0; i < n; i++) {
            for (int k = 1; k < lines; k++) {
                base[i] += 0.1 * Math.min(1, i / rate / 2) * Math.sin(2 * Math.PI * 0.07 * (k + 0.3) * i / rate + phase[k]);
            }
        }
        double[][] outputs = new Simulator(new Excitation(rate, base, Map.of())).outputs(MODEL.assembly());
        Map<Channel, double[]> values = new LinkedHashMap<>();
        values.put(BASE, noisy(base, random));
        for (int o = 0; o < outputs.length; o++) {
            values.put(MODEL.outputs().get(o), noisy(outputs[o], random));
        }
        return new Recording(new Clock(0, rate), values, Metadata.NONE);
    }

    private static double[] noisy(double[] x, Random random) {
        return Arrays.stream(x).map(value -> value + NOISE * random.nextGaussian()).toArray();
    }
}
