package wbv.cli;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code wbv states}: idle, riding, rocking and jerk, recognised and forecast. */
@Command(name = "states", mixinStandardHelpOptions = true, synopsisSubcommandLabel = "(train | apply)",
        subcommands = {StatesTrain.class, StatesApply.class},
        description = "Recognises states of motion (idle, riding, rocking, jerk of seat and head up or down) sample by sample, and "
                + "forecasts jerk, by mixtures and a hidden Markov model.",
        footer = {"", "Example:", "  wbv states train data/arff/states-train.arff data/arff/states-bare.arff \\", "      --out model",
            "  wbv states apply data/arff/states-other.arff --model model/model.json \\",
            "      --out out"})
final class States implements Runnable {

    @Spec
    private CommandSpec spec;

    @Override
    public void run() {
        throw new ParameterException(spec.commandLine(), "say what to do: train or apply");
    }
}
