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
                s = fitter.fit(baseline, x, fitter.frame(baseline, x, evidence.fit()), 12, 1e-4);
                x = s.x();
            }
            Fitter.Frame fw = fitter.frame(baseline, x, evidence.fit());
            s = fitter.lookWithSlopes(baseline, x, fw);
            long t2 = System.nanoTime();
            Motion motion = new Motion(evidence, baseline.at(x));
            Bank bank = new Bank(evidence, baseline.at(x), motion, Lines.of(s.residual(), evidence.fit()));
            java.util.List<Screening.Score> scores = new Screening(evidence, s, motion).scores(bank.hypotheses());
            System.out.printf("  screen %.2f s of %d:", (System.nanoTime() - t2) / 1e9, bank.hypotheses().size());
            for (int i = 0; i < 6; i++) {
                System.out.printf(" %s %.0f", scores.get(i).hypothesis().name(), scores.get(i).gain());
            }
            System.out.println();
            if (s.reduced() > 1.2) {
                long t3 = System.nanoTime();
                Refinement refinement = new Refinement(evidence);
                java.util.List<Fitter.State> fits = refinement.refit(s, scores, fw);
                System.out.printf("  refit %.2f s:", (System.nanoTime() - t3) / 1e9);
                for (int i = 0; i < Math.min(6, fits.size()); i++) {
                    System.out.printf(" %s %.2f", fits.get(i).candidate().added().get(0).name(), fits.get(i).reduced());
                }
                System.out.println();
                for (int i = 0; i < 2; i++) {
                    Fitter.State p = refinement.polish(fits.get(i));
                    System.out.printf("  polish %.2f s: %s chi %.3f hold %.3f", (System.nanoTime() - t3) / 1e9, p.candidate().added().get(0).name(), p.reduced(), refinement.heldOut(p));
                    for (int k : p.candidate().added().get(0).positions(p.candidate())) {
                        System.out.printf(" %s %.6g", p.candidate().knobs().get(k).name(), p.candidate().knobs().get(k).value(p.x()[k]));
                    }
                    System.out.println();
                }
            }
            System.out.printf("%s rate %.4f noise %.5f chi %.3f hold %.3f read %.2f s all %.2f s%n", name, recording.clock().rate(), evidence.inputNoise(), s.reduced(),
                    new Refinement(evidence).heldOut(s), (t1 - t0) / 1e9, (System.nanoTime() - t1) / 1e9);
        }
    }
}
