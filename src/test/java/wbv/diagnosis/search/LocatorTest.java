package wbv.diagnosis.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.Motion;
import wbv.rig.concealed.ConcealedCase;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Concealer;
import wbv.rig.concealed.Setting;

/** The places of what is concealed are found without its name, by evidence that ignores them. */
class LocatorTest {

    @TempDir
    private Path folder;

    private ConcealedCase made(List<String> words, long seed) {
        return Concealer.make(new ConcealedSpec("places", words, 1, Setting.RIG, false, seed));
    }

    private Evidence evidence(ConcealedCase made) throws Exception {
        Path file = Files.writeString(folder.resolve("model.json"), made.model(), StandardCharsets.UTF_8);
        Model model = ModelFile.read(file);
        return new Evidence(model, made.recording());
    }

    private static Set<String> truth(ConcealedCase made) throws Exception {
        Set<String> out = new HashSet<>();
        for (JsonNode each : new ObjectMapper().readTree(made.key()).path("mechanisms")) {
            out.add(each.path("where").asText());
        }
        return out;
    }

    private static double[] fitted(Evidence evidence, Candidate baseline) {
        return new Search(evidence, (step, share) -> {}).base(baseline).x();
    }

    @Tag("slow")
    @Test
    void twoPlacesAreFoundTogether() throws Exception {
        ConcealedCase made = made(List.of("friction.coulomb", "sensor.mount"), 3);
        Evidence evidence = evidence(made);
        Candidate baseline = Baseline.of(evidence);
        Evidence brief = evidence.brief().orElseThrow();
        Locator locator = new Locator(brief, baseline);
        List<Known.Ignoring> pairs = locator.pairs(locator.singles(fitted(evidence, baseline)));
        // Beside a force in one of its links, one in the other moves a body as any fault of its sensor reads: such pairs leave the same.
        List<Set<String>> alike = pairs.stream().filter(pair -> pair.reduced() < 1.02 * pairs.get(0).reduced())
                .map(pair -> pair.places().stream().map(place -> place.name(evidence)).collect(Collectors.toSet())).toList();
        assertTrue(alike.contains(truth(made)), alike + ", truth " + truth(made));
        Set<String> about = Set.of("platform-pelvis", "pelvis-torso", "torso", "pelvis.acc.z");
        assertTrue(alike.stream().allMatch(about::containsAll), alike.toString());
    }

    /** Whatever enters at a place that is ignored, nothing but noise is left; anywhere else it shows. */
    @Tag("slow")
    @Test
    void whatIsIgnoredLeavesOnlyNoise() throws Exception {
        ConcealedCase made = made(List.of("friction.coulomb"), 2);
        Evidence evidence = evidence(made);
        Candidate baseline = Baseline.of(evidence);
        Search search = new Search(evidence, (step, share) -> {});
        Fitter.State base = search.base(baseline);
        List<Known.Ignoring> singles = new Locator(evidence, baseline).singles(base.x());
        assertEquals(truth(made), Set.of(singles.get(0).places().get(0).name(evidence)));
        assertTrue(singles.get(0).reduced() - 1 < 0.02 * (base.reduced() - 1), singles.get(0).reduced() + " of " + base.reduced());
        assertTrue(singles.get(1).reduced() - 1 > 0.1 * (base.reduced() - 1), singles.get(1).reduced() + " of " + base.reduced());
    }

    /** The part on which hypotheses are tried first is the loudest, and its clock is its own. */
    @Test
    void thePartIsTheLoudest() throws Exception {
        Evidence evidence = evidence(made(List.of(), 1));
        Evidence brief = evidence.brief().orElseThrow();
        double[] whole = evidence.excitation().series(evidence.excitation().baseSpectrum());
        double[] part = brief.excitation().series(brief.excitation().baseSpectrum());
        assertTrue(Motion.rms(part, part.length) >= Motion.rms(whole, whole.length));
        assertEquals(36, part.length / evidence.recording().clock().rate(), 0.1);
        int from = (int) Math
                .round((brief.recording().clock().start() - evidence.recording().clock().start()) * evidence.recording().clock().rate());
        assertEquals(evidence.measured(0)[from + 500], brief.measured(0)[500]);
        assertTrue(from + part.length <= evidence.fit().start() + evidence.fit().length());
    }
}
