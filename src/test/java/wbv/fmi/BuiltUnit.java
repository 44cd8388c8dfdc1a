package wbv.fmi;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.Assumptions;

/**
 * Builds functional mock-up units from the C of the test tree. Tests that need them are skipped, saying so, where there is no C compiler.
 */
public final class BuiltUnit {

    private static final Path SOURCE = Path.of("src/test/c").toAbsolutePath();

    /**
     * A model of the test tree.
     *
     * @param inputs and outputs with their units @param parameters by name: start value and unit, in the order of the source
     * @param states number of them @param indicators number of event indicators
     */
    public record Plan(String source, Map<String, String> inputs, Map<String, String> outputs, List<Parameter> parameters, int states,
            int indicators) {

        public Plan {
            inputs = new java.util.LinkedHashMap<>(inputs);
            outputs = new java.util.LinkedHashMap<>(outputs);
        }

        /** The same with other names of outputs. */
        public Plan outputs(Map<String, String> others) {
            return new Plan(source, inputs, others, parameters, states, indicators);
        }

        public Plan inputs(Map<String, String> others) {
            return new Plan(source, others, outputs, parameters, states, indicators);
        }

        /** The same with other start values. @param factor on the value of a parameter */
        public Plan off(String parameter, double factor) {
            return new Plan(source, inputs, outputs, parameters.stream().map(each -> each.name().equals(parameter)
                    ? new Parameter(each.name(), factor * each.start(), each.unit()) : each).toList(), states, indicators);
        }
    }

    public record Parameter(String name, double start, String unit) {}

    public static final Plan QUARTER_CAR = new Plan("quarter_car.c",
            ordered("platform.acc.z", "m/s2", "force.suspension", "N", "force.seat", "N"),
            ordered("axle.acc.z", "m/s2", "body.acc.z", "m/s2", "seat.acc.z", "m/s2"),
            List.of(new Parameter("axle.m", 40, "kg"), new Parameter("tyre.k", 160000, "N/m"), new Parameter("tyre.c", 300, "N.s/m"),
                    new Parameter("body.m", 250, "kg"), new Parameter("suspension.k", 22000, "N/m"),
                    new Parameter("suspension.c", 1500, "N.s/m"),
                    new Parameter("person.m", 60, "kg"), new Parameter("seat.k", 15000, "N/m"), new Parameter("seat.c", 700, "N.s/m")),
            6, 0);

    public static final Plan PLANAR_PERSON = new Plan("planar_person.c",
            ordered("platform_acc_x", "m/s2", "platform_acc_z", "m/s2", "platform_gyr_y", "rad/s"),
            ordered("sternum_acc_x", "m/s2", "sternum_acc_z", "m/s2", "sternum_gyr_y", "rad/s", "head_acc_x", "m/s2", "head_acc_z", "m/s2",
                    "head_gyr_y", "rad/s"),
            List.of(new Parameter("cushion_k", 60000, "N/m"), new Parameter("cushion_c", 900, "N.s/m"),
                    new Parameter("backrest_k", 15000, "N/m"),
                    new Parameter("backrest_c", 400, "N.s/m"), new Parameter("neck_k", 90, ""), new Parameter("neck_c", 3.5, "")),
            13, 0);

    public static final Plan BALL = new Plan("bouncing_ball.c", ordered("platform.acc.z", "m/s2"),
            ordered("ball.pos.z", "m", "ball.vel.z", "m/s"), List.of(new Parameter("g", 9.81, "m/s2")), 2, 1);

    private BuiltUnit() {}

    /** Names with units, in their order. */
    public static Map<String, String> ordered(String... namesAndUnits) {
        Map<String, String> out = new java.util.LinkedHashMap<>();
        for (int i = 0; i < namesAndUnits.length; i += 2) {
            out.put(namesAndUnits[i], namesAndUnits[i + 1]);
        }
        return out;
    }

    /** Skips the test where there is no C compiler. */
    public static void needsCompiler() {
        boolean found;
        try {
            found = new ProcessBuilder("cc", "--version").redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.DISCARD).start()
                    .waitFor() == 0;
        } catch (IOException | InterruptedException none) {
            found = false;
        }
        Assumptions.assumeTrue(found, "no C compiler 'cc': functional mock-up units are not built, and nothing is tested with them");
    }

    /**
     * A unit in a file of a folder.
     *
     * @param version 2 or 3 @param ways XML of how it is run, such as {@code <CoSimulation .../>}, without the identifier
     * @param defines for the compiler, such as {@code BUMP_STOP}
     */
    public static Path build(Path folder, String file, Plan plan, int version, List<String> ways, String... defines) throws IOException {
        needsCompiler();
        Path library = folder.resolve(file + ".so");
        List<String> command = new ArrayList<>(List.of("cc", "-std=c11", "-O2", "-fPIC", "-shared", "-DMODEL=\"" + plan.source() + "\""));
        if (Stream.of(defines).noneMatch(define -> define.startsWith("TOKEN"))) {
            command.add("-DTOKEN=\"wbv-test\"");
        }
        for (String define : defines) {
            command.add("-D" + define);
        }
        command.addAll(List.of(SOURCE.resolve("fmi" + version + ".c").toString(), "-o", library.toString(), "-lm"));
        try {
            Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
            String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            if (process.waitFor() != 0) {
                throw new IOException("the compiler says: " + said);
            }
        } catch (InterruptedException stopped) {
            throw new IOException(stopped);
        }
        return zipped(folder.resolve(file),
                Map.of("modelDescription.xml", description(plan, version, ways).getBytes(StandardCharsets.UTF_8),
                        "binaries/" + Binary.places(version, "unit").get(0), Files.readAllBytes(library)));
    }

    /** Units that this process has unpacked and not removed. */
    static long unpacked() throws IOException {
        try (Stream<Path> all = Files.list(Path.of(System.getProperty("java.io.tmpdir")))) {
            return all.filter(each -> each.getFileName().toString().startsWith(UnpackedFmu.PREFIX + ProcessHandle.current().pid() + "-"))
                    .count();
        }
    }

    static Path zipped(Path file, Map<String, byte[]> entries) throws IOException {
        try (OutputStream out = Files.newOutputStream(file); ZipOutputStream zip = new ZipOutputStream(out)) {
            for (Map.Entry<String, byte[]> entry : entries.entrySet()) {
                zip.putNextEntry(new ZipEntry(entry.getKey()));
                zip.write(entry.getValue());
            }
        }
        return file;
    }

    /** For co-simulation with steps of any length. */
    public static final List<String> STEPS = List.of("<CoSimulation canHandleVariableCommunicationStepSize=\"true\"/>");
    /** For co-simulation, with slopes of its inputs (FMI 2.0). */
    public static final List<
            String> SLOPES = List.of("<CoSimulation canHandleVariableCommunicationStepSize=\"true\" canInterpolateInputs=\"true\"/>");
    public static final List<String> DERIVATIVES = List.of("<ModelExchange/>");

    static String description(Plan plan, int version, List<String> ways) {
        StringBuilder xml = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiModelDescription fmiVersion=\"")
                .append(version)
                .append(".0\" modelName=\"").append(plan.source().replace(".c", "")).append(version
                        == 2 ? "\" guid=\"{wbv-test}\" numberOfEventIndicators=\""
                                + plan.indicators() + "\">\n" : "\" instantiationToken=\"{wbv-test}\">\n");
        ways.forEach(way -> xml.append(way.replaceFirst("(CoSimulation|ModelExchange)", "$1 modelIdentifier=\"unit\"")).append('\n'));
        xml.append("<UnitDefinitions>");
        Map.of("m/s2", "m=\"1\" s=\"-2\"", "mm/s2", "m=\"1\" s=\"-2\" factor=\"0.001\"", "N", "kg=\"1\" m=\"1\" s=\"-2\"", "m", "m=\"1\"",
                "m/s", "m=\"1\" s=\"-1\"",
                "rad/s", "rad=\"1\" s=\"-1\"", "kg", "kg=\"1\"", "N/m", "kg=\"1\" s=\"-2\"", "N.s/m", "kg=\"1\" s=\"-1\"")
                .forEach((name, base) -> xml.append("<Unit name=\"").append(name).append("\"><BaseUnit ").append(base).append("/></Unit>"));
        xml.append("</UnitDefinitions>\n<LogCategories><Category name=\"logStatusError\"/></LogCategories>\n<ModelVariables>\n");
        if (version == 3) {
            xml.append("<Float64 name=\"time\" valueReference=\"999\" causality=\"independent\" variability=\"continuous\"/>\n");
        }
        int place = 0;
        int index = 0;
        for (Map.Entry<String, String> input : plan.inputs().entrySet()) {
            xml.append(variable(version, input.getKey(), place++, "causality=\"input\" variability=\"continuous\"", " start=\"0\"",
                    input.getValue()));
            index++;
        }
        StringBuilder outputs = new StringBuilder();
        place = 100;
        for (Map.Entry<String, String> output : plan.outputs().entrySet()) {
            outputs.append(version == 2 ? "<Unknown index=\"" + ++index + "\"/>" : "<Output valueReference=\"" + place + "\"/>");
            xml.append(
                    variable(version, output.getKey(), place++, "causality=\"output\" variability=\"continuous\"", "", output.getValue()));
        }
        place = 200;
        for (Parameter each : plan.parameters()) {
            index++;
            xml.append(variable(version, each.name(), place++, "causality=\"parameter\" variability=\"tunable\"",
                    " start=\"" + each.start() + "\"", each.unit()));
        }
        StringBuilder derivatives = new StringBuilder();
        StringBuilder states = new StringBuilder();
        for (int s = 0; s < plan.states(); s++) {
            index += 2;
            xml.append(variable(version, "state" + s, 300 + s, "causality=\"local\" variability=\"continuous\"", "", ""));
            xml.append(variable(version, "der(state" + s + ")", 400 + s, "causality=\"local\" variability=\"continuous\"",
                    " derivative=\"" + (version == 2 ? index - 1 : 300 + s) + "\"", ""));
            states.append(
                    version == 2 ? "<Unknown index=\"" + (index - 1) + "\"/>" : "<InitialUnknown valueReference=\"" + (300 + s) + "\"/>");
            derivatives.append(version == 2 ? "<Unknown index=\"" + index + "\"/>"
                    : "<ContinuousStateDerivative valueReference=\"" + (400 + s) + "\"/>");
        }
        xml.append("</ModelVariables>\n<ModelStructure>");
        String unknowns = version
                == 2 ? "<Outputs>" + outputs + "</Outputs>" + (plan.states() > 0 ? "<Derivatives>" + derivatives + "</Derivatives>" : "")
                        + "<InitialUnknowns>" + outputs + states + derivatives + "</InitialUnknowns>"
                        : outputs.toString() + derivatives + outputs.toString().replace("<Output ", "<InitialUnknown ") + states
                                + derivatives.toString().replace("ContinuousStateDerivative", "InitialUnknown");
        return xml.append(unknowns).append("</ModelStructure>\n</fmiModelDescription>\n").toString();
    }

    private static String variable(int version, String name, int reference, String role, String value, String unit) {
        String declared = unit.isEmpty() ? "" : " unit=\"" + unit + "\"";
        String common = " name=\"" + name + "\" valueReference=\"" + reference + "\" " + role;
        return version == 2
                ? "<ScalarVariable" + common + (role.contains("parameter") ? " initial=\"exact\"" : "") + "><Real" + value + declared
                        + "/></ScalarVariable>\n"
                : "<Float64" + common + (role.contains("parameter") ? " initial=\"exact\"" : "") + value + declared + "/>\n";
    }
}
