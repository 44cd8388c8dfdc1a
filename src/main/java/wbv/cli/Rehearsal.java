package wbv.cli;

import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Path;
import wbv.task.AdmittedClasses;

/** Goes once through what most commands need, in silence: the launcher's training of an archive of classes. */
public final class Rehearsal {

    private Rehearsal() {}

    /** @param arguments the folder of the shipped recordings, and one for results */
    public static void main(String[] arguments) {
        AdmittedClasses.enforce();
        Path data = Path.of(arguments[0]);
        String ride = data.resolve("one-dof-linear.arff").toString();
        Path concealed = data.resolve("concealed/001");
        String out = arguments[1];
        PrintWriter nowhere = new PrintWriter(Writer.nullWriter());
        Main.run(nowhere, nowhere, "--help");
        Main.run(nowhere, nowhere, "analyze", ride, "--out", out);
        Main.run(nowhere, nowhere, "exposure", ride, "--seat", "platform", "--out", out);
        Main.run(nowhere, nowhere, "diagnose", concealed.resolve("recording.csv.gz").toString(), "--model",
                concealed.resolve("model.json").toString(), "--out", out);
    }
}
