import java.nio.file.Path;
import java.util.Locale;
import wbv.body.ModelFile;
import wbv.diagnosis.Diagnoser;
import wbv.diagnosis.Diagnosis;
import wbv.diagnosis.Question;
import wbv.recording.format.RecordingFile;

/**
 * What a model leaves out of a recording: the verdict, what is missing with its probability and its numbers, and the completed model.
 *
 * <pre>java -cp "target/wbv.jar:target/lib/*" examples/DiagnoseARecording.java</pre>
 */
public final class DiagnoseARecording {

    private DiagnoseARecording() {}

    /**
     * @param arguments a folder with recording.csv.gz and model.json; one of those that come with wbv, with a law concealed in it, if none
     *                  is named
     */
    public static void main(String[] arguments) throws Exception {
        Path folder = Path.of(arguments.length > 0 ? arguments[0] : "data/arff/concealed/003");
        Question question = Question.of(ModelFile.read(folder.resolve("model.json")),
                new RecordingFile(folder.resolve("recording.csv.gz")).load());
        Diagnosis diagnosis = Diagnoser.examine(question, (step, share) -> {}).diagnosis();
        System.out.println(diagnosis.verdict().word() + ": " + diagnosis.sentence());
        for (Diagnosis.Named each : diagnosis.missing()) {
            System.out.printf(Locale.ROOT, "%s at %s, probability %.2f: %s%n", each.mechanism(), each.where(), each.probability(),
                    each.parameters());
        }
        System.out.println("the completed model has " + diagnosis.model().links().stream().mapToInt(link -> link.laws().size()).sum()
                + " laws in its links");
    }
}
