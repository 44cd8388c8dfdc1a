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
            long t0 = System.nanoTime();
            Recording recording = new RecordingFile(folder.resolve("recording.csv.gz")).load();
            long t1 = System.nanoTime();
            Evidence evidence = new Evidence(model, recording);
            Candidate baseline = Baseline.of(evidence);
            Fitter fitter = new Fitter(evidence);
            double[] x = baseline.start();
            Fitter.State s = null;
            for (int i = 0; i < 3; i++) {
                Whitening w = evidence.whitening(baseline.at(x), evidence.fit());
                s = fitter.fit(baseline, x, w, 12, 1e-4);
                x = s.x();
            }
            Whitening h = evidence.whitening(baseline.at(x), evidence.heldOut());
            System.out.printf("%s rate %.4f noise %.5f chi %.3f hold %.3f read %.2f s fit %.2f s%n", name, recording.clock().rate(), evidence.inputNoise(), s.reduced(),
                    fitter.look(baseline, x, h).reduced(), (t1 - t0) / 1e9, (System.nanoTime() - t1) / 1e9);
        }
    }
}
