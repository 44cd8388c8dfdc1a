package wbv.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import wbv.fmi.FmuSimulation;
import wbv.recording.Channel;
import wbv.recording.Recording;

/** Which variable of a functional mock-up unit is which channel, where its names do not say so. */
final class UnitOptions {

    @Option(names = "--map-input", paramLabel = "VARIABLE=CHANNEL",
            description = "of an FMU: the recorded channel that an input takes, where its name is not that "
                    + "of a channel (platform.acc.z or platform_acc_z)")
    private Map<String, String> inputs = new LinkedHashMap<>();

    @Option(names = "--map-output", paramLabel = "VARIABLE=CHANNEL",
            description = "of an FMU: the channel that an output or a local variable is")
    private Map<String, String> outputs = new LinkedHashMap<>();

    @Spec(Spec.Target.MIXEE)
    private CommandSpec spec;

    FmuSimulation open(Path file, Recording recording) throws IOException {
        return FmuSimulation.open(file, recording, channels(inputs), channels(outputs));
    }

    /** Whether any was given. */
    boolean given() {
        return !inputs.isEmpty() || !outputs.isEmpty();
    }

    private Map<String, Channel> channels(Map<String, String> names) {
        Map<String, Channel> out = new LinkedHashMap<>();
        names.forEach((variable, name) -> out.put(variable, Usage.channel(spec, name)));
        return out;
    }
}
