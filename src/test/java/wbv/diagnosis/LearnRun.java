package wbv.diagnosis;

import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.learn.LawLearner;
import wbv.diagnosis.learn.Sentence;
import wbv.diagnosis.learn.LearnedWords;
import wbv.diagnosis.search.Locator;
import wbv.diagnosis.search.Search;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;

/** Shows what is learned on a case, sentence by sentence: {@code LearnRun FOLDER...}, each with recording.csv.gz and model.json. */
final class LearnRun {

    private LearnRun() {}

    public static void main(String[] folders) throws Exception {
        for (String folder : folders) {
            Model model = ModelFile.read(Path.of(folder, "model.json"));
            Recording recording = new RecordingFile(Path.of(folder, "recording.csv.gz")).load();
            long start = System.nanoTime();
            Diagnosed found = Diagnoser.examine(Question.of(model, recording), (step, share) -> {});
            System.out.printf(Locale.ROOT, "%s %.1f s %s: %s%n", folder, (System.nanoTime() - start) / 1e9, found.diagnosis().verdict(),
                    found.diagnosis().sentence());
            Evidence evidence = found.evidence;
            Search search = new Search(evidence, (step, share) -> {});
            Candidate baseline = Baseline.of(evidence);
            Fitter.State base = search.base(baseline);
            List<Known.Ignoring> places = new Locator(evidence, baseline).singles(base.x());
            places.stream().limit(4).forEach(
                    place -> System.out.printf(Locale.ROOT, "   place %s %.3f%n", place.places().get(0).name(evidence), place.reduced()));
            start = System.nanoTime();
            List<Sentence> sentences = new LawLearner(evidence, search, base, places).sentences(base);
            System.out.printf(Locale.ROOT, "   learned in %.1f s; before %.3f, held out %.3f%n", (System.nanoTime() - start) / 1e9,
                    base.reduced(), search.refinement().heldOut(base));
            sentences.stream().sorted(Comparator.comparingDouble(Sentence::evidence).reversed()).limit(8)
                    .forEach(each -> System.out.printf(Locale.ROOT,
                            "   %9.1f nat  left %8.3f held out %8.3f  %s%n", each.evidence(), each.fit().reduced(),
                            search.refinement().heldOut(each.fit()), LearnedWords.of(model, each.fit())));
            Sentence first = sentences.get(0);
            Fitter.State polished = search.refinement().polish(first.fit());
            System.out.printf(Locale.ROOT, "   polished left %8.3f held out %8.3f  %s%n", polished.reduced(),
                    search.refinement().heldOut(polished), LearnedWords.of(model, polished));
        }
    }
}
