package wbv.diagnosis;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import wbv.body.Assembly;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.recording.Recording;
import wbv.recording.RecordingFile;
import wbv.rig.concealed.ConcealedCase;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Concealer;
import wbv.rig.concealed.Setting;

/** How often the truth lies inside the interval of a number, for the right hypothesis: folder, draws, mechanisms. */
final class CoverageRun {

    public static void main(String[] args) throws Exception {
        Path folder = Path.of(args[0]);
        int draws = Integer.parseInt(args[1]);
        for (int a = 2; a < args.length; a++) {
            for (int i = 0; i < draws; i++) {
                String word = args[a];
                double strength = i % 2 == 0 ? 1 : 0.3;
                Setting setting = i % 4 == 3 ? Setting.FIELD : word.equals("coupling.rotation") ? Setting.ROTATION : Setting.RIG;
                ConcealedSpec spec = new ConcealedSpec(word + i, List.of(word), strength, setting, false, 977L * i + word.hashCode());
                Path at = folder.resolve(word + "-" + i);
                if (!Files.exists(at.resolve("key.json"))) {
                    ConcealedCase made = Concealer.make(spec);
                    made.write(at);
                    Files.writeString(at.resolve("key.json"), made.key());
                }
                one(at, word + "-" + i, setting);
            }
        }
    }

    private static void one(Path at, String id, Setting setting) throws Exception {
        JsonNode key = new ObjectMapper().readTree(Files.readString(at.resolve("key.json")));
        JsonNode truth = key.get("mechanisms").get(0);
        Model model = ModelFile.read(at.resolve("model.json"));
        Recording recording = new RecordingFile(at.resolve("recording.csv.gz")).load();
        Evidence evidence = new Evidence(model, recording);
        Candidate baseline = Baseline.of(evidence);
        Fitter.State base = fit(evidence, baseline);
        Motion motion = new Motion(evidence, baseline.at(base.x()));
        Assembly fitted = baseline.at(base.x());
        List<Hypothesis> bank = new Bank(evidence, fitted, motion, Lines.of(base.residual(), evidence.fit())).hypotheses().stream()
                .filter(h -> h.mechanism().equals(truth.get("mechanism").asText()) && h.where().equals(truth.get("where").asText())).toList();
        if (bank.isEmpty()) {
            System.out.println(id + ",none");
            return;
        }
        List<Fitter.State> fits = new ArrayList<>(new Refinement(evidence).refit(base, new Screening(evidence, base, motion).scores(bank)));
        if (fits.isEmpty()) {
            System.out.println(id + ",none");
            return;
        }
        Refinement refinement = new Refinement(evidence);
        List<Fitter.State> polished = new ArrayList<>();
        for (Fitter.State each : fits.subList(0, Math.min(3, fits.size()))) {
            polished.add(refinement.polish(each));
        }
        polished.sort(Comparator.comparingDouble(Fitter.State::reduced));
        Fitter.State best = polished.get(0);
        Optional<BodyForce> rest = best.reduced() < 1.2 ? Optional.empty() : BodyForce.in(evidence, best);
        if (rest.isPresent() && rest.get().ordinary(evidence)) {
            evidence = evidence.with(rest.get());
            best = new Refinement(evidence).polish(best);
            base = fit(evidence, baseline);
        }
        long t1 = System.nanoTime();
        Diagnosis.Named named = new Values(evidence).named(best, best.candidate().added().get(0), 1);
        double seconds = (System.nanoTime() - t1) / 1e9;
        Map<String, Double> truths = new TreeMap<>();
        truth.get("parameters").fields().forEachRemaining(e -> truths.put(e.getKey(), e.getValue().asDouble()));
        if (truths.containsKey("stiffness_N_per_m")) {
            double m = truths.get("mass_kg");
            double k = truths.get("stiffness_N_per_m");
            truths.put("frequency_hz", Math.sqrt(k / m) / 2 / Math.PI);
            truths.put("damping_ratio", truths.get("damping_Ns_per_m") / 2 / Math.sqrt(k * m));
        }
        for (Map.Entry<String, Double> entry : named.parameters().entrySet()) {
            String name = entry.getKey();
            double t = truths.getOrDefault(name.startsWith("lever_arm_m") && name.endsWith("gyr.y") ? "lever_arm_m" : name, Double.NaN);
            double v = name.startsWith("lever_arm_m") ? Math.abs(entry.getValue()) : entry.getValue();
            double s = named.std().get(name);
            System.out.printf("%s,%s,%s,%s,%.4g,%.3f,%.3f,%s,%.5g,%.5g,%.3g,%.2f,%.3f%n", id, setting.word(), truth.get("form").asText().replace(',', ' '),
                    best.candidate().added().get(0).form(), key.get("linear_chi2").asDouble(), base.reduced(), best.reduced(), name, t, v, s / Math.abs(v), (v - t) / s, seconds);
        }
    }

    private static Fitter.State fit(Evidence evidence, Candidate baseline) {
        Fitter fitter = new Fitter(evidence);
        double[] x = baseline.start();
        for (int round = 0; round < 3; round++) {
            x = fitter.fit(baseline, x, fitter.frame(baseline, x, evidence.fit()), 12, 1e-4).x();
        }
        return fitter.lookWithSlopes(baseline, x, fitter.frame(baseline, x, evidence.fit()));
    }
}
