package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.body.Assembly;
import wbv.body.LawAt;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.body.law.MaxwellArm;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;

/** A stiffness that would have to be several times the given one, on a recording of another engine in which nothing is missing. */
class ImitatedNumberTest {

    private static final Path NULL_CASE = Path.of("data/arff/concealed/001");
    private static final int LINK = 1;

    private final Model model = read();
    private final Recording recording = recording();

    private static Model read() {
        try {
            return ModelFile.read(NULL_CASE.resolve("model.json"));
        } catch (java.io.IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }

    private static Recording recording() {
        try {
            return new RecordingFile(NULL_CASE.resolve("recording.csv.gz")).load();
        } catch (java.io.IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }

    /** A number that was given wrong leaves nothing that a memory could explain. */
    @ParameterizedTest
    @CsvSource({"0.3, 1", "0.3, 0.5", "3, 1"})
    void aNumberThatWasGivenWrongIsNoPhysics(double stiffness, double damping) {
        Diagnosis diagnosis = Diagnoser.diagnose(wrong(LINK, stiffness, damping), recording, (step, share) -> {});
        assertEquals(Diagnosis.Verdict.PARAMETERS_ONLY, diagnosis.verdict(), diagnosis.sentence());
    }

    private Model wrong(int which, double stiffness, double damping) {
        List<Model.Link> links = new ArrayList<>(model.links());
        Model.Link link = links.get(which);
        links.set(which, new Model.Link(link.from(), link.to(), stiffness * link.stiffness(), damping * link.damping(), link.sensor(),
                link.laws(), link.drives(), link.faults()));
        return new Model(model.name(), model.source(), model.axis(), model.base(), model.bodies(), links, model.inputs());
    }

    /** An arm that relaxes slowly against the shaking is hardly more than a stiffer spring; the numbers of the others give it away. */
    @Tag("slow")
    @Test
    void aMemoryThatASpringNearlyImitatesIsNamed() {
        Excitation excitation = Excitation.of(model, recording, recording.length());
        Simulator simulator = new Simulator(excitation);
        Assembly plain = model.assembly();
        Assembly remembering = new Assembly(plain.structure(), List.of(new LawAt(LINK, new MaxwellArm(180_000, 0.06))), plain.drives(),
                plain.outputs());
        double[][] without = simulator.run(plain, false).outputs();
        double[][] with = simulator.run(remembering, false).outputs();
        Map<Channel, double[]> values = new LinkedHashMap<>();
        recording.channels().forEach(channel -> values.put(channel, recording.values(channel).clone()));
        for (int o = 0; o < with.length; o++) {
            double[] more = excitation.series(with[o]);
            double[] less = excitation.series(without[o]);
            double[] y = values.get(model.outputs().get(o));
            for (int i = 0; i < y.length; i++) {
                y[i] += more[i] - less[i];
            }
        }
        Diagnosis diagnosis = Diagnoser.diagnose(model, new Recording(recording.clock(), values, recording.metadata()),
                (step, share) -> {});
        assertEquals("memory.viscoelastic", diagnosis.missing().get(0).mechanism(), diagnosis.sentence());
        assertEquals("seat-torso", diagnosis.missing().get(0).where());
        assertEquals("parameters", diagnosis.alternatives().get(0).mechanism(), diagnosis.sentence());
        Interval arm = diagnosis.missing().get(0).intervals().get("arm_stiffness_N_per_m");
        assertTrue(arm.low() < 180_000 && 180_000 < arm.high(), diagnosis.sentence());
    }
}
