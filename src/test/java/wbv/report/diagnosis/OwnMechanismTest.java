package wbv.report.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.body.Assembly;
import wbv.body.LawAt;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.body.law.LearnedTerm;
import wbv.body.number.Modulator;
import wbv.body.number.Shape;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.Diagnosed;
import wbv.diagnosis.Diagnoser;
import wbv.diagnosis.Diagnosis;
import wbv.diagnosis.Question;
import wbv.diagnosis.mechanism.Family;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Library;
import wbv.diagnosis.mechanism.Mechanism;
import wbv.diagnosis.mechanism.Scene;
import wbv.diagnosis.mechanism.Start;
import wbv.diagnosis.picture.Pictures;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Recording;
import wbv.result.OutputFolder;

/** A mechanism that stands in this file and nowhere else: found among all others, named in its own words, and written. */
class OwnMechanismTest {

    private static final double RATE = 60;
    private static final int SAMPLES = 2400;
    private static final double NOISE = 0.01;
    private static final int LINK = 1;
    private static final Channel BASE = Channel.parse("platform.acc.z");
    private static final Channel SEAT = Channel.parse("seat.acc.z");
    private static final Channel TORSO = Channel.parse("sternum.acc.z");
    private static final Model MODEL = new Model("chain", Optional.empty(), 'z', new Model.Base("platform", Optional.of(BASE)),
            List.of(body("seat", 15, SEAT), body("torso", 40, TORSO)),
            List.of(link("platform", "seat", 70e3, 900), link("seat", "torso", 45e3, 800)));
    private static final LearnedTerm TRUTH = new LearnedTerm(Shape.parse("r^2 v"), Modulator.NONE, 1.5e9);

    @TempDir
    Path folder;

    /** A dashpot that grips as it is bent, which no library has: c r² v. */
    private record Cushion() implements Mechanism.Custom {
        @Override
        public Entry entry() {
            return new Entry("toy.cushion", Family.LOSS, "The cushion %s grips");
        }

        @Override
        public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
            double usual = 0.1 * link.damping() / (link.deflection() * link.deflection());
            return List.of(Hypothesis.law(this, link, "", new LearnedTerm(TRUTH.shape(), Modulator.NONE, usual),
                    List.of(Hypothesis.Number.sum(usual, -100 * usual, 100 * usual)), List.of(Start.scaled(usual))));
        }
    }

    @Tag("slow")
    @Test
    void isFoundNamedAndWritten() throws IOException {
        Diagnosed found = Diagnoser.examine(Question.of(MODEL, recording()).with(Library.standard().with(new Cushion())),
                (step, share) -> {});
        Diagnosis diagnosis = found.diagnosis();
        assertEquals(List.of("toy.cushion"), diagnosis.missing().stream().map(Diagnosis.Named::mechanism).toList(), diagnosis.sentence());
        assertEquals("seat-torso", diagnosis.missing().get(0).where());
        assertTrue(diagnosis.sentence().startsWith("The cushion seat-torso grips"), diagnosis.sentence());
        assertEquals(TRUTH.coefficient(), diagnosis.missing().get(0).parameters().get("coefficient_N"), 0.05 * TRUTH.coefficient());
        assertFalse(Pictures.of(found).portraits().isEmpty());

        try (OutputFolder out = OutputFolder.at(folder)) {
            DiagnosisReport.write(diagnosis, Pictures.of(found), Map.of(), out);
            out.publish();
        }
        JsonNode json = new ObjectMapper().readTree(folder.resolve("diagnosis.json").toFile());
        assertEquals("toy.cushion", json.at("/missing/0/mechanism").asText());
        assertTrue(Files.readString(folder.resolve("report.html")).contains("toy.cushion"));
        Model written = ModelFile.parse(ModelFile.text(diagnosis.model()), "model.json");
        assertEquals(TRUTH.getClass(), written.links().get(LINK).laws().get(0).getClass());
    }

    private static Recording recording() {
        Random random = new Random(11);
        double[] base = new double[SAMPLES];
        int sines = 300;
        for (int s = 0; s < sines; s++) {
            double f = 2 + 7 * random.nextDouble();
            double phase = 2 * Math.PI * random.nextDouble();
            for (int i = 0; i < SAMPLES; i++) {
                base[i] += 0.5 * Math.sqrt(2.0 / sines) * Math.sin(2 * Math.PI * f * i / RATE + phase);
            }
        }
        Excitation excitation = new Excitation(RATE, base, Map.of());
        Assembly linear = MODEL.assembly();
        Assembly truth = new Assembly(linear.structure(), List.of(new LawAt(LINK, TRUTH)), List.of(), linear.outputs());
        double[][] outputs = new Simulator(excitation).outputs(truth);
        Map<Channel, double[]> channels = new LinkedHashMap<>();
        channels.put(BASE, noisy(base, random));
        channels.put(SEAT, noisy(outputs[0], random));
        channels.put(TORSO, noisy(outputs[1], random));
        return new Recording(new Clock(0, RATE), channels, Metadata.NONE);
    }

    private static double[] noisy(double[] x, Random random) {
        double[] out = x.clone();
        for (int i = 0; i < out.length; i++) {
            out[i] += NOISE * random.nextGaussian();
        }
        return out;
    }

    private static Model.Body body(String name, double mass, Channel sensor) {
        return new Model.Body(name, mass, Optional.of(sensor), List.of(), Optional.empty(), List.of());
    }

    private static Model.Link link(String from, String to, double stiffness, double damping) {
        return new Model.Link(from, to, stiffness, damping, Optional.empty(), List.of(), List.of());
    }
}
