package wbv.export;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.body.Drive;
import wbv.body.Model;
import wbv.body.SensorFault;
import wbv.body.SensorFilter;
import wbv.body.law.Law;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.recording.Channel;
import wbv.recording.Recording;

/** The Python function gives what the simulator gives. */
class PythonTextTest {

    private static final Set<String> PAST_A_FILTER = Set.of("law 15, contact.bumpstop", "base by its velocity", "several at once");
    private static final double TOLERANCE = 1e-9;
    private static final String ALL = """
            import importlib.util, glob, struct, sys
            for path in sorted(glob.glob("model_*.py")):
                spec = importlib.util.spec_from_file_location(path[:-3], path)
                module = importlib.util.module_from_spec(spec)
                spec.loader.exec_module(module)
                rate, time, channels = module.read_recording("recording.csv")
                with open(path[:-3] + ".out", "w") as out:
                    try:
                        for values in module.simulate(rate, channels):
                            out.write(",".join(repr(float(value)) for value in values) + "\\n")
                    except Exception as fault:
                        import traceback
                        out.write(traceback.format_exc())
            """;

    @TempDir
    private Path folder;

    @Test
    void everyLawDriveAndFaultIsAmongTheCases() throws IOException {
        Set<Class<?>> seen = new HashSet<>();
        for (Model model : Cases.models()) {
            model.assembly().laws().forEach(at -> seen.add(at.law().getClass()));
            model.assembly().drives().forEach(at -> seen.add(at.drive().getClass()));
            model.assembly().outputs().forEach(output -> output.faults().forEach(fault -> seen.add(fault.getClass())));
        }
        assertEquals(List.of(), Stream.of(Law.class, Drive.class, SensorFault.class).flatMap(PythonTextTest::records)
                .filter(type -> !seen.contains(type)).toList());
    }

    private static Stream<Class<?>> records(Class<?> family) {
        return Arrays.stream(family.getPermittedSubclasses()).flatMap(type -> type.isRecord() ? Stream.of(type) : records(type));
    }

    @Test
    void itGivesWhatTheSimulatorGives() throws IOException, InterruptedException {
        assumeTrue(Cases.runs("python3", "-c", "import numpy"), "no python3 with numpy here: the Python function is not run");
        List<Model> models = new ArrayList<>(Cases.models());
        SensorFilter filter = new SensorFilter(List.of(0.1, 0.3, 0.4), List.of(1.0, 0.7, 0.1));
        Cases.models().stream().filter(model -> PAST_A_FILTER.contains(model.name())).map(model -> model.behind(Optional.of(filter)))
                .forEach(models::add);
        assertEquals(Cases.models().size() + PAST_A_FILTER.size(), models.size());
        Recording recording = lossy(Cases.recording(560, 60, 1));
        Cases.write(recording, folder.resolve("recording.csv"));
        for (int i = 0; i < models.size(); i++) {
            ExportFormat.PYTHON.write(models.get(i), folder.resolve(name(i) + ".py"));
        }
        Files.writeString(folder.resolve("all.py"), ALL);
        Cases.run(folder, "python3", "all.py");
        List<String> apart = new ArrayList<>();
        for (int i = 0; i < models.size(); i++) {
            double[][] expected = new Simulator(Excitation.asDeclared(models.get(i), recording, recording.length()))
                    .outputs(models.get(i).assembly());
            List<String> lines = Files.readAllLines(folder.resolve(name(i) + ".out"));
            for (int o = 0; o < expected.length; o++) {
                double difference = lines.get(0).startsWith("Traceback") ? Double.NaN : difference(expected[o], lines.get(o));
                if (!(difference < TOLERANCE)) {
                    apart.add(models.get(i).name() + ", output " + o + ": "
                            + (Double.isNaN(difference) ? String.join(" | ", lines) : difference));
                }
            }
        }
        assertTrue(apart.isEmpty(), String.join("\n", apart));
    }

    /** With a short gap in the base's acceleration and a pause in a force. */
    private static Recording lossy(Recording recording) {
        Map<Channel, double[]> values = new LinkedHashMap<>();
        recording.channels().forEach(channel -> values.put(channel, recording.values(channel).clone()));
        Arrays.fill(values.get(Channel.parse("platform.acc.z")), 100, 103, Double.NaN);
        Arrays.fill(values.get(Channel.parse("seat.force.z")), 200, 360, Double.NaN);
        return recording.with(values);
    }

    private static String name(int i) {
        return String.format("model_%03d", i);
    }

    /** Greatest difference over the root mean square. */
    private static double difference(double[] expected, String line) {
        double[] found = Arrays.stream(line.split(",")).mapToDouble(Double::parseDouble).toArray();
        double square = 0;
        double most = 0;
        for (int i = 0; i < expected.length; i++) {
            square += expected[i] * expected[i] / expected.length;
            most = Math.max(most, Math.abs(found[i] - expected[i]));
        }
        return most / Math.sqrt(square);
    }
}
