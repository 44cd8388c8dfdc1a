package wbv.export;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import wbv.body.LawAt;
import wbv.body.Model;
import wbv.body.SensorFault;
import wbv.body.law.Law;
import wbv.body.number.Modulator;
import wbv.body.simulate.FreeRun;
import wbv.recording.DataFault;

/** The unit describes itself, and its laws do what the free run does. */
class FmuFileTest {

    private static final int STEPS = 1500;
    private static final double STEP = 1.0 / 240;
    /** Drives each unit of the folder as an importer does. */
    private static final String IMPORTER = """
            import ctypes, glob, re, zipfile
            names = open("inputs.csv").readline().strip().split(",")
            rows = [[float(value) for value in line.split(",")] for line in list(open("inputs.csv"))[1:]]
            for path in sorted(glob.glob("*.fmu")):
                archive = zipfile.ZipFile(path)
                library = [name for name in archive.namelist() if name.startswith("binaries/")][0]
                text = archive.read("modelDescription.xml").decode()
                open(path + ".so", "wb").write(archive.read(library))
                unit = ctypes.CDLL("./" + path + ".so")
                unit.fmi3InstantiateCoSimulation.restype = ctypes.c_void_p
                token = re.search('instantiationToken="([^"]*)"', text).group(1)
                no = ctypes.c_ubyte(0)
                s = ctypes.c_void_p(unit.fmi3InstantiateCoSimulation(b"x", token.encode(), None, no, no, no, no, None, ctypes.c_size_t(0),
                                                                       None, None, None))
                forces = [int(each) for each in re.findall(r'name="law_\\d+\\.force" valueReference="(\\d+)"', text)]
                references = (ctypes.c_uint * len(forces))(*forces)
                values = (ctypes.c_double * len(forces))()
                found = [re.search(f'name="{re.escape(name)}" valueReference="(\\d+)"', text) for name in names]
                taken = [k for k in range(len(names)) if found[k]]
                inputs = (ctypes.c_uint * len(taken))(*[int(found[k].group(1)) for k in taken])
                many = ctypes.c_size_t(len(taken))
                flag, reached = ctypes.c_ubyte(0), ctypes.c_double(0)
                with open(path + ".txt", "w") as out:
                    for i, row in enumerate(rows):
                        assert unit.fmi3SetFloat64(s, inputs, many, (ctypes.c_double * len(taken))(*[row[k] for k in taken]), many) == 0
                        if i == 0:
                            assert unit.fmi3EnterInitializationMode(s, no, ctypes.c_double(0), ctypes.c_double(0), no,
                                                                    ctypes.c_double(0)) == 0
                            assert unit.fmi3ExitInitializationMode(s) == 0
                        else:
                            assert unit.fmi3DoStep(s, ctypes.c_double((i - 1) * STEP), ctypes.c_double(STEP), no, ctypes.byref(flag),
                                                   ctypes.byref(flag), ctypes.byref(flag), ctypes.byref(reached)) == 0
                        n = ctypes.c_size_t(len(forces))
                        assert unit.fmi3GetFloat64(s, references, n, values, n) == 0
                        out.write(" ".join(repr(each) for each in values) + "\\n")
                unit.fmi3FreeInstance(s)
            """;

    @TempDir
    private Path folder;

    @Tag("slow")
    @Test
    void itsLawsDoWhatTheFreeRunDoes() throws IOException, InterruptedException {
        assumeTrue(Cases.runs("python3", "--version"), "no python3 here: no unit is run");
        assumeTrue(Cases.runs("cc", "--version"), "no C compiler here: no unit is run");
        List<Law> laws = Cases.models().stream().flatMap(model -> model.links().stream()).flatMap(link -> link.laws().stream()).distinct()
                .filter(law -> law.modulator() instanceof Modulator.None).toList();
        double[] acceleration = IntStream.range(0, STEPS)
                .mapToDouble(i -> Math.min(1, i / 100.0) * (Math.sin(0.11 * i) + Math.sin(0.047 * i + 1) + 0.7 * Math.sin(0.23 * i)))
                .toArray();
        inputs("platform.acc.z", acceleration);
        Map<String, Model> models = new TreeMap<>();
        for (Law law : laws) {
            String name = String.format("law_%02d.fmu", models.size());
            models.put(name, with(law));
            ExportFormat.FMU.write(models.get(name), folder.resolve(name));
        }
        Files.writeString(folder.resolve("importer.py"), "STEP = " + STEP + "\n" + IMPORTER);
        Cases.run(folder, "python3", "importer.py");
        for (Map.Entry<String, Model> each : models.entrySet()) {
            List<LawAt> own = each.getValue().assembly().laws();
            double[][] expected = new FreeRun(each.getValue().assembly().structure(), own, STEP, false)
                    .run(acceleration, new double[0][], false).force();
            List<String> lines = Files.readAllLines(folder.resolve(each.getKey() + ".txt"));
            for (int i = 0; i < own.size(); i++) {
                double size = Arrays.stream(expected[i]).map(Math::abs).max().orElseThrow();
                assertTrue(size > 0, own.get(i) + " does nothing here");
                for (int j = 0; j < STEPS; j++) {
                    assertEquals(expected[i][j], Double.parseDouble(lines.get(j).split(" ")[i]), 1e-7 * size, own.get(i) + " at step " + j);
                }
            }
        }
    }

    /** Whether the base carries the lowest link up or rotation lifts its lower end, from wherever that is: its law cannot tell. */
    @Tag("slow")
    @Test
    void liftingTheLowestLinkIsMovingTheBase() throws IOException, InterruptedException {
        assumeTrue(Cases.runs("python3", "--version"), "no python3 here: no unit is run");
        assumeTrue(Cases.runs("cc", "--version"), "no C compiler here: no unit is run");
        Model risen = named("several at once");
        double arm = 0.1;
        double w = 2 * Math.PI * 1.7;
        double[] angle = IntStream.range(0, STEPS).mapToDouble(i -> 0.2 - 0.05 * Math.cos(w * i * STEP)).toArray();
        double[] rate = IntStream.range(0, STEPS).mapToDouble(i -> 0.05 * w * Math.sin(w * i * STEP)).toArray();
        double[] spin = IntStream.range(0, STEPS).mapToDouble(i -> 0.05 * w * w * Math.cos(w * i * STEP)).toArray();
        List<LawAt> laws = risen.assembly().laws();
        ExportFormat.FMU.write(risen, folder.resolve("risen.fmu"));
        inputs("platform.acc.z,angle of platform.gyr.y,platform.gyr.y", new double[STEPS], angle, rate);
        Files.writeString(folder.resolve("importer.py"), "STEP = " + STEP + "\n" + IMPORTER);
        Cases.run(folder, "python3", "importer.py");
        List<String> lines = Files.readAllLines(folder.resolve("risen.fmu.txt"));
        ExportFormat.FMU.write(withoutRotation(risen), folder.resolve("risen.fmu"));
        inputs("platform.acc.z", Arrays.stream(spin).map(a -> arm * a).toArray());
        Cases.run(folder, "python3", "importer.py");
        List<String> carried = Files.readAllLines(folder.resolve("risen.fmu.txt"));
        for (int i = 0; i < laws.size(); i++) {
            int law = i;
            double[] expected = carried.stream().mapToDouble(line -> Double.parseDouble(line.split(" ")[law])).toArray();
            double size = Arrays.stream(expected).map(Math::abs).max().orElseThrow();
            assertTrue(size > 1, laws.get(i) + " does nothing here");
            for (int j = 0; j < STEPS; j++) {
                assertEquals(expected[j], Double.parseDouble(lines.get(j).split(" ")[i]), 1e-2 * size, laws.get(i) + " at step " + j);
            }
        }
    }

    private static Model withoutRotation(Model model) {
        List<Model.Link> links = model.links().stream().map(link -> new Model.Link(link.from(), link.to(), link.stiffness(), link.damping(),
                link.sensor(), link.laws(), List.of())).toList();
        return new Model(model.name(), model.source(), model.axis(), model.base(), model.bodies(), links);
    }

    private void inputs(String names, double[]... columns) throws IOException {
        List<String> lines = new ArrayList<>(List.of(names));
        for (int i = 0; i < columns[0].length; i++) {
            int row = i;
            lines.add(Arrays.stream(columns).map(column -> Double.toString(column[row])).collect(Collectors.joining(",")));
        }
        Files.write(folder.resolve("inputs.csv"), lines);
    }

    /**
     * A chain with a law in the link that the models have theirs in, between two that remember: whatever else the file of models holds, and
     * in which order.
     */
    private static Model with(Law law) throws IOException {
        Model chain = named("linear");
        List<List<Law>> laws = List.of(named("law 12, hysteresis").links().get(1).laws(), List.of(law),
                named("law 10, friction.coulomb").links().get(1).laws());
        List<Model.Link> links = new ArrayList<>();
        for (int l = 0; l < 3; l++) {
            Model.Link link = chain.links().get(l);
            links.add(new Model.Link(link.from(), link.to(), link.stiffness(), link.damping(), link.sensor(), laws.get(l), List.of()));
        }
        return new Model(chain.name(), chain.source(), chain.axis(), chain.base(), chain.bodies(), links);
    }

    @Test
    void itDescribesEveryInputOutputAndNumber() throws Exception {
        for (Model model : List.of(named("several at once"), named("damper on a bench, by position"))) {
            CSource source = new CSource(model);
            Map<String, byte[]> entries = entries(FmuFile.of(model).bytes());
            Document description = DocumentBuilderFactory.newInstance().newDocumentBuilder()
                    .parse(new ByteArrayInputStream(entries.get("modelDescription.xml")));
            assertEquals("3.0", description.getDocumentElement().getAttribute("fmiVersion"));
            Map<String, Integer> kinds = new TreeMap<>();
            for (int i = 0; i < description.getElementsByTagName("Float64").getLength(); i++) {
                Element variable = (Element) description.getElementsByTagName("Float64").item(i);
                assertEquals(i, Integer.parseInt(variable.getAttribute("valueReference")));
                kinds.merge(variable.getAttribute("causality"), 1, Integer::sum);
            }
            assertEquals(Map.of("independent", 1, "input", source.signals().names().size(), "output", model.outputs().size(), "local",
                    model.assembly().laws().size(), "parameter", source.parameters().size()), kinds);
            assertTrue(entries.keySet().stream().anyMatch(name -> name.startsWith("sources/") && name.endsWith(".c")),
                    entries.keySet().toString());
        }
    }

    @Test
    void aSensorThatReadsEarlyIsRefusedByName() throws IOException {
        Model chain = named("linear");
        List<Model.Body> bodies = new ArrayList<>(chain.bodies());
        Model.Body head = bodies.remove(2);
        bodies.add(new Model.Body(head.name(), head.mass(), head.sensor(), List.of(new SensorFault.Delay(-0.01, 0)), head.hidden(),
                head.forces()));
        Model early = new Model(chain.name(), chain.source(), chain.axis(), chain.base(), bodies, chain.links());
        Path file = folder.resolve("early.fmu");
        DataFault fault = assertThrows(DataFault.class, () -> ExportFormat.FMU.write(early, file));
        assertTrue(fault.getMessage().contains("head.acc.z") && fault.getMessage().contains("--to python"), fault.getMessage());
        assertTrue(Files.notExists(file));
        ExportFormat.PYTHON.write(early, folder.resolve("early.py"));
    }

    private static Model named(String name) throws IOException {
        return Cases.models().stream().filter(model -> model.name().equals(name)).findFirst().orElseThrow();
    }

    private static Map<String, byte[]> entries(byte[] archive) throws IOException {
        Map<String, byte[]> out = new TreeMap<>();
        try (ZipInputStream zip = new ZipInputStream(new ByteArrayInputStream(archive))) {
            for (ZipEntry entry = zip.getNextEntry(); entry != null; entry = zip.getNextEntry()) {
                out.put(entry.getName(), zip.readAllBytes());
            }
        }
        return out;
    }
}
