package wbv.diagnosis;

import wbv.diagnosis.mechanism.Library;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import wbv.body.Assembly;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.proof.Suite;
import wbv.recording.Recording;
import wbv.rig.concealed.ConcealedCase;
import wbv.rig.concealed.Concealer;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * The evidence of every hypothesis beside today's verdict: on a sample of the proof's questions of one seed, each hypothesis that today's search
 * comes upon is weighed, and the posterior read. Prints one line for each hypothesis and case, tab-separated, to be counted afterwards.
 */
final class ShadowRun {

    private static final int WEIGHED = 6;
    /** How many of all are weighed to the end. */
    private static final int LEADING = 3;
    private static final double[] TEMPERATURES = {1, 2, 4, 8};

    private ShadowRun() { }

    /** @param args seed, first and last question of the sample */
    public static void main(String[] args) throws IOException {
        List<Suite.Question> sample = sample(Long.parseLong(args[0]));
        for (Suite.Question question : sample.subList(Integer.parseInt(args[1]) - 1, Math.min(sample.size(), Integer.parseInt(args[2])))) {
            try {
                run(question);
            } catch (RuntimeException wrong) {
                System.out.println("FAILED\t" + question.id() + "\t" + wrong);
                wrong.printStackTrace();
            }
        }
    }

    /** Of a shuffled suite: listed at full and at three tenths of the strength, nulls, unlisted and pairs as they come. */
    static List<Suite.Question> sample(long seed) {
        Map<String, Integer> room = new LinkedHashMap<>(Map.of("LISTED1.0", 14, "LISTED0.3", 10, "NOTHING1.0", 10, "UNLISTED", 4, "PAIR1.0", 2));
        List<Suite.Question> out = new ArrayList<>();
        for (Suite.Question question : Suite.full(seed).questions()) {
            String kind = question.group() == Suite.Group.UNLISTED ? "UNLISTED" : question.group().name() + question.spec().strength();
            if (room.getOrDefault(kind, 0) > 0) {
                room.merge(kind, -1, Integer::sum);
                out.add(question);
            }
        }
        // Nulls and plain effects first, in turns, so that a part of the sample is a fair one too.
        Map<String, Integer> seen = new LinkedHashMap<>();
        Map<Suite.Question, Integer> turn = new LinkedHashMap<>();
        out.forEach(question -> turn.put(question, seen.merge(question.group().name() + question.spec().strength(), 1, Integer::sum)));
        return out.stream().sorted(Comparator.comparingInt(turn::get)).toList();
    }

    private static void run(Suite.Question question) throws IOException {
        ConcealedCase made = Concealer.make(question.spec());
        JsonNode key = new ObjectMapper().readTree(made.key());
        Path file = Files.createTempFile("model", ".json");
        Files.writeString(file, made.model());
        Model model = ModelFile.read(file);
        Files.delete(file);
        List<String> truth = new ArrayList<>();
        key.path("mechanisms").forEach(each -> truth.add(each.path("mechanism").asText() + "@" + each.path("where").asText() + "[" + each.path("form").asText() + "]"));
        print("CASE", question.id(), question.group(), question.spec().strength(), key.path("setting").asText(), String.join("+", truth),
                key.path("linear_chi2").asDouble());
        long start = System.nanoTime();
        Diagnosed today = Diagnoser.examine(Question.of(model, made.recording()), (step, share) -> { });
        Diagnosis d = today.diagnosis();
        print("TODAY", question.id(), d.verdict().word(), d.missing().stream().map(n -> n.mechanism() + "@" + n.where()).collect(Collectors.joining("+")),
                d.missing().isEmpty() ? Double.NaN : d.missing().get(0).probability(), (System.nanoTime() - start) / 1e9);
        weigh(question, model, made.recording(), today);
    }

    private static void weigh(Suite.Question question, Model model, Recording recording, Diagnosed today) {
        long start = System.nanoTime();
        Priors priors = Priors.USUAL;
        Evidence evidence = new Evidence(model, recording);
        Candidate baseline = Baseline.of(evidence);
        Search search = new Search(evidence, (step, share) -> { });
        Fitter.State base = search.base(baseline);
        List<Fitter.State> leaders = leaders(today.evidence, baseline, today);
        double searched = (System.nanoTime() - start) / 1e9;
        start = System.nanoTime();
        Assembly fitted = base.candidate().at(base.x());
        List<Hypothesis> library = evidence.library().hypotheses(FittedScene.of(evidence, fitted, new Motion(evidence, fitted), Lines.of(base.residual(), evidence.fit())));
        HypothesisPrior prior = new HypothesisPrior(priors, library, Set.of("input.unmeasured"));
        Weighing weighing = new Weighing(evidence, baseline, priors);
        List<Posterior.Weighed> all = new ArrayList<>();
        all.add(new Posterior.Weighed(Claim.NOTHING, prior.noPhysics(), weighing.nothing().log()));
        Weighing.Weight values = weighing.of(baseline, base.x(), Weighing.ROUNDS);
        double zero = values.log();
        line(question, "values", values, zero, base);
        print("H", question.id(), "nothing", all.get(0).evidence() - zero);
        all.add(new Posterior.Weighed(Claim.VALUES, prior.noPhysics(), zero));
        Set<Place> places = Place.all(evidence).stream().map(place -> place.plain(baseline.template())).collect(Collectors.toCollection(LinkedHashSet::new));
        int bodies = (int) places.stream().filter(place -> place.kind() == Place.Kind.BODY).count();
        double[] x = values.fit().x();
        Map<Place, Weighing.Weight> free = new LinkedHashMap<>();
        places.forEach(place -> free.put(place, weighing.withFree(baseline, x, place, 0)));
        for (Place place : best(free)) {
            free.put(place, weighing.withFree(baseline, x, place, Weighing.ROUNDS));
        }
        free.forEach((place, weight) -> {
            line(question, "free@" + place.name(evidence), weight, zero, base);
            boolean push = place.kind() == Place.Kind.BODY;
            Claim claim = push ? Claim.named("input.unmeasured" + "@" + place.name(evidence)) : Claim.elseAt(place.name(evidence), "");
            all.add(new Posterior.Weighed(claim, push ? prior.beside(bodies) : prior.free(), weight.log()));
        });
        Map<Fitter.State, Weighing.Weight> laws = new LinkedHashMap<>();
        for (Fitter.State leader : leaders) {
            try {
                laws.put(leader, weighing.of(leader.candidate(), leader.x(), 1));
            } catch (RuntimeException wrong) {
                print("LOST", question.id(), leader.candidate().last().name(), wrong);
            }
        }
        for (Fitter.State leader : best(laws)) {
            laws.put(leader, weighing.of(leader.candidate(), laws.get(leader).fit().x(), Weighing.ROUNDS));
        }
        List<Fitter.State> leading = best(laws);
        laws.forEach((leader, with) -> {
            List<Hypothesis> parts = leader.candidate().added();
            String name = name(leader);
            String full = parts.stream().map(Hypothesis::name).collect(Collectors.joining("+"));
            line(question, full, with, zero, leader);
            all.add(new Posterior.Weighed(Claim.named(name), prior.named(parts), with.log()));
            if (leading.contains(leader)) {
                Place place = Place.ofLast(leader);
                Weighing.Weight both = weighing.withFree(leader.candidate(), with.fit().x(), Place.of(leader.candidate().last()), 2);
                line(question, full + " & free", both, zero, leader);
                all.add(new Posterior.Weighed(Claim.named(name), prior.freeBeside(parts) * both.within(), both.log()));
                // A tone and whatever else pushes the same body are one push.
                boolean push = parts.size() == 1 && parts.get(0).mechanism().equals("input.unmeasured");
                all.add(new Posterior.Weighed(push ? Claim.named(name) : Claim.elseAt(place.name(evidence), name),
                        prior.freeBeside(parts) * (1 - both.within()), both.log()));
            }
        });
        for (double temperature : TEMPERATURES) {
            Posterior posterior = Posterior.of(all, temperature);
            DecisionRule.Reading reading = new DecisionRule(priors).read(posterior);
            print("POST", question.id(), temperature, reading.verdict(), reading.claims().stream().map(c -> c.kind() + ":" + c.name() + (c.like().isEmpty() ? "" : "~" + c.like())).collect(Collectors.joining(",")),
                    reading.probability(), posterior.probabilities().entrySet().stream().limit(4)
                            .map(e -> String.format(Locale.ROOT, "%s:%s~%s=%.3f", e.getKey().kind(), e.getKey().name(), e.getKey().like(), e.getValue())).collect(Collectors.joining(" ")));
        }
        print("TIME", question.id(), searched, (System.nanoTime() - start) / 1e9);
    }

    private static <T> List<T> best(Map<T, Weighing.Weight> weights) {
        return weights.entrySet().stream().sorted(Comparator.comparingDouble(entry -> -entry.getValue().log())).limit(LEADING).map(Map.Entry::getKey).toList();
    }

    /**
     * What today's search comes upon, knowing of a sitter's force what it found: the best form of each mechanism at each place, and the answer
     * itself. Where it had no reason to search it is made to.
     */
    private static List<Fitter.State> leaders(Evidence evidence, Candidate baseline, Diagnosed today) {
        Map<String, Fitter.State> out = new LinkedHashMap<>();
        if (!today.chosen.candidate().added().isEmpty()) {
            // As it was found: what is shown has the scale that all masses tell, and simulates the same.
            Candidate found = baseline;
            for (Hypothesis part : today.chosen.candidate().added()) {
                found = found.with(part);
            }
            Fitter fitter = new Fitter(evidence);
            out.put(name(today.chosen), fitter.look(found, today.chosen.x(), evidence.fit()));
        }
        List<Fitter.State> all = today.fits.leaders();
        if (all.isEmpty()) {
            Search search = new Search(evidence, (step, share) -> { });
            Fitter.State base = search.base(baseline);
            all = search.leaders(base, Search.LEADERS, Whereabouts.found(evidence, baseline, base.x()));
        }
        for (Fitter.State fit : all) {
            if (out.size() < WEIGHED && !fit.failed()) {
                out.putIfAbsent(name(fit), fit);
            }
        }
        return List.copyOf(out.values());
    }

    private static String name(Fitter.State fit) {
        return fit.candidate().added().stream().map(h -> h.mechanism() + "@" + h.where()).sorted().distinct().collect(Collectors.joining("+"));
    }

    private static void line(Suite.Question question, String name, Weighing.Weight weight, double zero, Fitter.State before) {
        print("H", question.id(), name, weight.log() - zero, before.reduced(), weight.form(), weight.own(), weight.riding(), weight.scale(), weight.within(), weight.left());
    }

    private static void print(Object... parts) {
        StringBuilder line = new StringBuilder();
        for (Object part : parts) {
            line.append(line.isEmpty() ? "" : "\t").append(part instanceof Double number ? String.format(Locale.ROOT, "%.4g", number) : part);
        }
        System.out.println(line);
        System.out.flush();
    }
}
