package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.body.Model;
import wbv.body.ModelFile;

/** Models by name, and simulations of which only the outputs are given. The recordings are another engine's. */
class DiagnoseSimulationTest {

    private static final Path CASES = Path.of("data/arff/concealed");

    @TempDir
    private Path folder;

    /** The same name, at the same place, as with the model that made the simulation. */
    @Tag("slow")
    @Test
    void theSofteningIsNamedFromASimulationsOutputsAlone() throws IOException {
        Run run = diagnosed("003");
        JsonNode diagnosis = json("diagnosis.json");
        assertEquals("missing-physics", diagnosis.get("verdict").asText(), run.out());
        assertEquals(1, diagnosis.get("missing").size(), run.out());
        assertEquals("stiffness.softening", diagnosis.get("missing").get(0).get("mechanism").asText());
        assertEquals("platform-pelvis", diagnosis.get("missing").get(0).get("where").asText());
        assertTrue(run.out().contains("55.0 kg is assumed") && run.out().contains("misses"), run.out());
        assertTrue(diagnosis.get("provenance").get("model").asText().contains("misses"));
    }

    @Test
    void nothingIsMissingWhereTheSimulationIsRight() throws IOException {
        Run run = diagnosed("001");
        assertEquals("nothing-missing", json("diagnosis.json").get("verdict").asText(), run.out());
        Model truth = ModelFile.read(CASES.resolve("001/model.json"));
        Model surrogate = ModelFile.read(folder.resolve("out/surrogate.json"));
        for (int l = 0; l < truth.links().size(); l++) {
            assertEquals(truth.links().get(l).stiffness() / truth.mass(), surrogate.links().get(l).stiffness() / surrogate.mass(),
                    1e-3 * truth.links().get(l).stiffness() / truth.mass());
        }
    }

    private Run diagnosed(String name) {
        String recording = CASES.resolve(name + "/recording.csv.gz").toString();
        String simulation = folder.resolve("simulation.csv").toString();
        assertEquals(0, Run.of("simulate", "--model", CASES.resolve(name + "/model.json").toString(), "--input", recording,
                "--out",
                simulation).code());
        Run run = Run.of("diagnose", recording, "--simulation", simulation, "--out", folder.resolve("out").toString());
        assertEquals(0, run.code(), run.err());
        return run;
    }

    private JsonNode json(String file) throws IOException {
        return new ObjectMapper().readTree(folder.resolve("out").resolve(file).toFile());
    }

    /** The rig's body has 5 Hz too, and another damping ratio. */
    @Test
    void aPublishedModelIsHeldAgainstARecording() throws IOException {
        Run run = Run.of("diagnose", "data/arff/one-dof-linear.arff", "--model", "fairley-griffin-1989-1dof", "--out",
                folder.resolve("out").toString());
        assertEquals(0, run.code(), run.err());
        assertTrue(run.out().startsWith("parameters-only"), run.out());
        Model.Link link = ModelFile.read(folder.resolve("out/model.json")).links().get(0);
        assertEquals(5, Math.sqrt(link.stiffness() / 55) / (2 * Math.PI), 0.05);
        assertEquals(0.35, link.damping() / (2 * Math.sqrt(link.stiffness() * 55)), 0.01);
    }

    @Test
    void sensorsOfAPublishedModelThatWereNotThereAreLeftOutAndNamed() throws IOException {
        Run run = Run.of("diagnose", "data/arff/one-dof-linear.arff", "--model", "allen-1978-2dof", "--out",
                folder.resolve("out").toString());
        assertEquals(0, run.code(), run.err());
        assertTrue(run.out().startsWith("allen-1978-2dof has sensors that the recording lacks, which are left out: [sternum.acc.z]"),
                run.out());
    }

    @Test
    void publishedModelsAreListedAndRun() throws IOException {
        Run list = Run.of("simulate", "--models");
        assertEquals(0, list.code(), list.err());
        assertEquals(8, list.out().lines().count());
        assertTrue(list.out().lines().allMatch(line -> line.matches("\\S+ +\\d bod(y|ies), [\\d.]+ kg\\. .*(assumed|seen in).*")),
                list.out());
        Path file = folder.resolve("simulated.csv");
        assertEquals(0, Run.of("simulate", "--model", "wan-schimmels-1995-4dof", "--input", "data/arff/one-dof-linear.arff",
                "--out",
                file.toString()).code());
        assertTrue(Files.readAllLines(file).contains("t,pelvis.acc.z,sternum.acc.z,head.acc.z"));
    }

    /** A file of that name is the user's own. */
    @Test
    void aFileGoesBeforeAPublishedModel() throws IOException {
        Path file = Files.writeString(folder.resolve("allen-1978-2dof"), "no model");
        Run run = Run.of("simulate", "--model", file.toString(), "--input", "data/arff/one-dof-linear.arff", "--out",
                folder.resolve("simulated.csv").toString());
        assertEquals(1, run.code());
        assertTrue(run.err().contains("allen-1978-2dof:1: is not JSON"), run.err());
        assertFalse(Files.exists(folder.resolve("simulated.csv")));
    }
}
