package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ExportTest {

    private static final String MODEL = "data/arff/concealed/003/model.json";

    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource({"python, m.py", "modelica, m.mo", "mujoco, m.xml", "FMU, m.fmu"})
    void itWritesEveryFormat(String format, String name) throws IOException {
        Run run = Run.of("export", MODEL, "--to", format, "--out", folder.resolve(name).toString());
        assertEquals(0, run.code(), run.err());
        assertTrue(run.out().startsWith("Wrote " + folder.resolve(name)), run.out());
        assertTrue(Files.size(folder.resolve(name)) > 500);
    }

    @Test
    void aPublishedModelGoesByItsName() {
        Run run = Run.of("export", "wei-griffin-1998-1dof", "--to", "modelica", "--out", folder.resolve("m.mo").toString());
        assertEquals(0, run.code(), run.err());
    }

    @Test
    void aFormatThatIsNoneIsWrongUsage() {
        Run run = Run.of("export", MODEL, "--to", "simulink", "--out", folder.resolve("m").toString());
        assertEquals(2, run.code());
        assertTrue(run.err().contains("python") && run.err().contains("modelica"), run.err());
    }

    @Test
    void whatCannotGoThereIsNamedAndNothingIsLeftBehind() throws IOException {
        Run run = Run.of("export", "data/models/friction_damper.json", "--to", "mujoco", "--out", folder.resolve("m.xml").toString());
        assertEquals(1, run.code());
        assertTrue(run.err().contains("driven links") && run.err().contains("--to python"), run.err());
        assertEquals(1, run.err().lines().count(), run.err());
        try (Stream<Path> left = Files.list(folder)) {
            assertEquals(0, left.count());
        }
    }

    @Test
    void aModelWithoutSensorOrInputIsRefused() throws IOException {
        Path silent = Files.writeString(folder.resolve("silent.json"),
                Files.readString(Path.of(MODEL)).replaceAll("\"(pelvis|sternum|head)\\.acc\\.z\"", "null"));
        Run run = Run.of("export", silent.toString(), "--to", "python", "--out", folder.resolve("m.py").toString());
        assertEquals(1, run.code());
        assertTrue(run.err().contains("has no sensor"), run.err());
        Path still = Files.writeString(folder.resolve("still.json"),
                Files.readString(Path.of(MODEL)).replace("\"platform.acc.z\"", "null"));
        run = Run.of("export", still.toString(), "--to", "fmu", "--out", folder.resolve("m.fmu").toString());
        assertEquals(1, run.code());
        assertTrue(run.err().contains("has no input"), run.err());
    }
}
