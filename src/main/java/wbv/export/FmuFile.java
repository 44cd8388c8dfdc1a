package wbv.export;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import wbv.body.Model;

/**
 * A model as functional mock-up unit for co-simulation, FMI 3.0: description, C source, and the binary of this machine where a compiler is
 * found.
 */
final class FmuFile {

    private static final List<String> COMPILERS = List.of("cc", "gcc", "clang");

    /**
     * @param bytes of the archive
     * @param remark whether it has a binary
     */
    record Made(byte[] bytes, String remark) {}

    private FmuFile() {}

    static Made of(Model model) throws IOException {
        CSource source = new CSource(model);
        String identifier = model.name().replaceAll("[^A-Za-z0-9]+", "_").replaceAll("^(?=[^A-Za-z])", "m");
        String token = UUID.nameUUIDFromBytes(source.parameters().toString().getBytes(StandardCharsets.UTF_8)).toString();
        String code = source.text(token);
        Optional<byte[]> binary = compiled(code);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(out)) {
            put(zip, "modelDescription.xml", description(model, source, identifier, token).getBytes(StandardCharsets.UTF_8));
            put(zip, "sources/" + identifier + ".c", code.getBytes(StandardCharsets.UTF_8));
            put(zip, "sources/buildDescription.xml", ("""
                    <?xml version="1.0" encoding="UTF-8"?>
                    <fmiBuildDescription fmiVersion="3.0">
                      <BuildConfiguration modelIdentifier="%s">
                        <SourceFileSet language="C99">
                          <SourceFile name="%s.c"/>
                        </SourceFileSet>
                      </BuildConfiguration>
                    </fmiBuildDescription>
                    """).formatted(identifier, identifier).getBytes(StandardCharsets.UTF_8));
            if (binary.isPresent()) {
                put(zip, "binaries/" + platform() + "/" + identifier + ending(), binary.get());
            }
        }
        return new Made(out.toByteArray(), binary.isPresent() ? "with source and a binary for " + platform()
                : "with source only: no C compiler (" + String.join(", ", COMPILERS) + ") is found here");
    }

    private static void put(ZipOutputStream zip, String name, byte[] bytes) throws IOException {
        ZipEntry entry = new ZipEntry(name);
        entry.setTime(0);   // the same model makes the same file
        zip.putNextEntry(entry);
        zip.write(bytes);
        zip.closeEntry();
    }

    private static String system() {
        return System.getProperty("os.name").toLowerCase(Locale.ROOT);
    }

    private static String platform() {
        String arch = System.getProperty("os.arch");
        return (arch.equals("amd64") ? "x86_64" : arch) + "-"
                + (system().contains("win") ? "windows" : system().contains("mac") ? "darwin" : "linux");
    }

    private static String ending() {
        return system().contains("win") ? ".dll" : system().contains("mac") ? ".dylib" : ".so";
    }

    /** The library that this machine's compiler makes of the source; nothing where there is none. */
    private static Optional<byte[]> compiled(String code) throws IOException {
        Path folder = Files.createTempDirectory("wbv-fmu");
        try {
            Path source = Files.writeString(folder.resolve("model.c"), code);
            Path library = folder.resolve("model" + ending());
            for (String compiler : COMPILERS) {
                try {
                    Process process = new ProcessBuilder(compiler, "-std=c99", "-O2", "-w", "-ffp-contract=off", "-fvisibility=hidden",
                            "-shared", "-fPIC", "-o", library.toString(), source.toString(), "-lm").redirectErrorStream(true)
                            .redirectOutput(folder.resolve("log").toFile()).start();
                    if (process.waitFor() == 0) {
                        return Optional.of(Files.readAllBytes(library));
                    }
                    throw new IllegalStateException(compiler + " does not take the source: " + Files.readString(folder.resolve("log")));
                } catch (IOException absent) {
                    continue;   // another one may be there
                } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                    return Optional.empty();
                }
            }
            return Optional.empty();
        } finally {
            for (String name : List.of("model.c", "log", "model" + ending())) {
                Files.deleteIfExists(folder.resolve(name));
            }
            Files.delete(folder);
        }
    }

    private static String description(Model model, CSource source, String identifier, String token) {
        StringBuilder out = new StringBuilder();
        out.append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiModelDescription fmiVersion=\"3.0\" modelName=\"")
                .append(escaped(model.name()))
                .append("\" instantiationToken=\"").append(token)
                .append("\" variableNamingConvention=\"flat\" generationTool=\"wbv\" description=\"")
                .append(escaped("An input set before a step is that at the step's end; between steps it runs straight. "
                        + model.source().orElse("")))
                .append("\">\n  <CoSimulation modelIdentifier=\"").append(identifier)
                .append("\" canHandleVariableCommunicationStepSize=\"true\" canBeInstantiatedOnlyOncePerProcess=\"false\"/>\n")
                .append("  <DefaultExperiment startTime=\"0\" stepSize=\"").append(1.0 / 240).append("\"/>\n  <ModelVariables>\n")
                .append("    <Float64 name=\"time\" valueReference=\"0\" causality=\"independent\" variability=\"continuous\" "
                        + "description=\"[s]\"/>\n");
        int reference = 1;
        for (Map.Entry<String, String> input : source.signals().units().entrySet()) {
            variable(out, input.getKey(), reference++, "input", "continuous", Optional.of(0.0), "[" + input.getValue() + "]");
        }
        int firstOutput = reference;
        for (wbv.recording.Channel output : model.outputs()) {
            variable(out, source.signals().units().containsKey(output.toString()) ? output + " simulated" : output.toString(), reference++,
                    "output", "continuous", Optional.empty(), "[" + output.quantity().unit() + "]");
        }
        int outputs = reference;
        List<wbv.body.LawAt> laws = model.assembly().laws();
        for (int i = 0; i < laws.size(); i++) {
            variable(out, "law_" + i + ".force", reference++, "local", "continuous", Optional.empty(),
                    "[N] " + laws.get(i).law().mechanism() + " in " + Names.of(model).links().get(laws.get(i).link()));
        }
        for (Map.Entry<String, Double> parameter : source.parameters().entrySet()) {
            variable(out, parameter.getKey(), reference++, "parameter", "fixed", Optional.of(parameter.getValue()), "");
        }
        out.append("  </ModelVariables>\n  <ModelStructure>\n");
        for (String kind : List.of("Output", "InitialUnknown")) {
            for (int i = firstOutput; i < outputs; i++) {
                out.append("    <").append(kind).append(" valueReference=\"").append(i).append("\"/>\n");
            }
        }
        return out.append("  </ModelStructure>\n</fmiModelDescription>\n").toString();
    }

    private static void variable(StringBuilder out, String name, int reference, String causality, String variability,
            Optional<Double> start, String description) {
        out.append("    <Float64 name=\"").append(escaped(name)).append("\" valueReference=\"").append(reference).append("\" causality=\"")
                .append(causality)
                .append("\" variability=\"").append(variability).append('"');
        start.ifPresent(value -> out.append(" start=\"").append(value).append('"'));
        out.append(description.isEmpty() ? "" : " description=\"" + escaped(description) + "\"").append("/>\n");
    }

    private static String escaped(String text) {
        return Names.plain(text).replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }
}
