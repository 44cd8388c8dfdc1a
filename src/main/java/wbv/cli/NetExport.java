package wbv.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import wbv.network.OnnxExport;
import wbv.network.TrainedNetwork;
import wbv.recording.AtomicFile;

/** {@code wbv net export}: a model for other engines. */
@Command(name = "export", mixinStandardHelpOptions = true,
        description = "Writes a model as ONNX: in, images as wbv makes them; out, damping ratio and natural pulsation of each "
                + "mode and their standard deviations. Needs no library of PyTorch.",
        footer = {"", "Example:", "  wbv net export --modes 1 --out model.onnx"})
final class NetExport implements Callable<Integer> {

    @Option(names = "--model", paramLabel = "FILE", description = "model of 'wbv net train' (the one that comes with wbv)")
    private Optional<Path> file = Optional.empty();

    @Option(names = "--modes", paramLabel = "N", defaultValue = "1",
            description = "modes of the body, 1 or 2, where no model is named (${DEFAULT-VALUE})")
    private int modes;

    @Option(names = "--out", paramLabel = "FILE", defaultValue = "model.onnx", description = "the new file (${DEFAULT-VALUE})")
    private Path out;

    @Mixin
    private Answer answer;

    @Override
    public Integer call() throws IOException {
        byte[] bytes = OnnxExport.of(file.isPresent() ? TrainedNetwork.read(file.get()) : TrainedNetwork.shipped(modes));
        AtomicFile.write(out, bytes);
        answer.print("Wrote " + out + "\n", new Answer.Written(out.toString()));
        return 0;
    }
}
