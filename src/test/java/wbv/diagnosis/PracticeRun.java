package wbv.diagnosis;

import java.nio.file.Path;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.recording.Recording;
import wbv.recording.RecordingFile;

final class PracticeRun {

    public static void main(String[] cases) throws Exception {
        for (String name : cases) {
            Path folder = Path.of("../shared/practice", name);
            Model model = ModelFile.read(folder.resolve("model.json"));
            Recording recording = new RecordingFile(folder.resolve("recording.csv.gz")).load();
            long t1 = System.nanoTime();
            Diagnosis d = Diagnoser.diagnose(model, recording, (s, f) -> { });
            System.out.printf("%s %.1f s %s: %s%n", name, (System.nanoTime() - t1) / 1e9, d.verdict().word(), d.sentence());
            System.out.println("    " + d.fit());
            for (Diagnosis.Named n : d.missing()) System.out.println("    missing " + n);
            for (Diagnosis.Named n : d.alternatives().subList(0, Math.min(2, d.alternatives().size()))) System.out.println("    or " + n);
            for (Diagnosis.Latent n : d.latent()) System.out.println("    latent " + n);
        }
    }
}
