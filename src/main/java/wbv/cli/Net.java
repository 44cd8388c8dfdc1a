package wbv.cli;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code wbv net}: networks that read damping ratio and natural frequency from spectrograms. */
@Command(name = "net", mixinStandardHelpOptions = true, synopsisSubcommandLabel = "train|evaluate|predict|export",
        description = "Networks that read a body's damping ratio and natural frequency from 3.65 s of motion. Needs "
                + "PyTorch's library (linux-x86_64, osx-aarch64, win-x86_64), which comes with the build and unpacks to "
                + "430 MB when first used.",
        subcommands = {NetTrain.class, NetEvaluate.class, NetPredict.class, NetExport.class},
        footer = {"", "Examples:", "  wbv net predict data/arff/one-dof-linear.arff --input platform.acc.z \\",
            "      --output head.acc.z --out out",
            "  wbv net evaluate --out out",
            "  wbv net train --bodies 1-dof --network pooled --images 2046 --out out"})
final class Net implements Runnable {

    @Spec
    private CommandSpec spec;

    @Override
    public void run() {
        throw new ParameterException(spec.commandLine(), "say what to do: train, evaluate, predict or export");
    }
}
