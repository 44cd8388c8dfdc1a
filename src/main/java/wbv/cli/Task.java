package wbv.cli;

import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;
import wbv.task.TaskRunner;

/** {@code wbv task}: any MOA task by its string, with an honest exit code. */
@Command(name = "task", mixinStandardHelpOptions = true,
        description = "Runs a MOA task given as one string, as moa.DoTask does, but says what went wrong and exits with 1, 2 or 3 if it "
                + "did.",
        footer = {"", "Examples:", "  wbv task \"wbv.task.TrackBody -s (wbv.stream.RigStream -r 7)\"",
            "  wbv task \"EvaluatePrequentialRegression -l wbv.learn.AdwinKalman \\",
            "      -s (wbv.stream.RecordingStream -f data/arff/one-dof-linear.arff \\",
            "      -o head.acc.z) -i 7200 -f 1200\""})
final class Task implements Callable<Integer> {

    @Parameters(paramLabel = "TASK", arity = "1..*", description = "the task string; several words are joined by spaces")
    private List<String> words;

    @Override
    public Integer call() {
        return TaskRunner.run(String.join(" ", words), System.out, System.err);
    }
}
