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
        int draws = Integer.parseInt(args[1].split("-")[args[1].split("-").length - 1]);
        int first = args[1].contains("-") ? Integer.parseInt(args[1].split("-")[0]) : 0;
        for (int a = 2; a < args.length; a++) {
            for (int i = first; i < draws; i++) {
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
        Path cache = at.resolve("fit.txt");
        Fitter.State best;
        if (Files.exists(cache)) {
            List<String> lines = Files.readAllLines(cache);
            double[] before = java.util.Arrays.stream(lines.get(1).split(" ")).mapToDouble(Double::parseDouble).toArray();
            double[] after = java.util.Arrays.stream(lines.get(2).split(" ")).mapToDouble(Double::parseDouble).toArray();
            Candidate with = bank.stream().filter(each -> each.name().equals(lines.get(0))).map(baseline::with)
                    .filter(c -> java.util.stream.IntStream.range(0, after.length).allMatch(i -> after[i] >= c.knobs().get(i).low() && after[i] <= c.knobs().get(i).high()))
                    .findFirst().orElseThrow();
            Fitter f = new Fitter(evidence);
            if (lines.get(3).equals("true")) {
                evidence = evidence.with(BodyForce.in(evidence, f.look(with, before, f.frame(with, before, evidence.fit()))).orElseThrow());
            }
            Fitter g = new Fitter(evidence);
            best = g.look(with, after, g.frame(with, after, evidence.fit()));
        } else {
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
            best = polished.get(0);
            double[] before = best.x();
            Fitter f = new Fitter(evidence);
            Optional<BodyForce> rest = best.reduced() < 1.2 ? Optional.empty() : BodyForce.in(evidence, f.look(best.candidate(), before, f.frame(best.candidate(), before, evidence.fit())));
            boolean forced = rest.isPresent() && rest.get().ordinary(evidence);
            if (forced) {
                evidence = evidence.with(rest.get());
                best = new Refinement(evidence).polish(best);
            }
            Files.writeString(cache, best.candidate().added().get(0).name() + "\n" + text(before) + "\n" + text(best.x()) + "\n" + forced + "\n");
        }
        if (System.getProperty("errors") != null) {
            for (int i = 0; i < best.errors().length; i++) {
                if (Math.abs(best.errors()[i]) > 1) {
                    System.out.printf("    %s %.2f%n", best.frame().nuisances().name(i), best.errors()[i]);
                }
            }
            for (int i = 0; i < best.x().length; i++) {
                System.out.printf("    %s %.4g x %.3f%n", best.candidate().knobs().get(i).name(), best.candidate().knobs().get(i).value(best.x()[i]), best.x()[i]);
            }
            int m = evidence.outputs().size();
            double[] power = new double[m * 8];
            Window w = evidence.fit();
            for (int line = 0; line < w.lines(); line++) for (int o = 0; o < m; o++) {
                int q = best.frame().whitening().index(line, o);
                power[o * 8 + line * 8 / w.lines()] += (best.residual()[q] * best.residual()[q] + best.residual()[q + 1] * best.residual()[q + 1]) / 2 / w.lines() * 8;
            }
            for (int o = 0; o < m; o++) System.out.println("    " + evidence.outputs().get(o) + " " + java.util.stream.DoubleStream.of(java.util.Arrays.copyOfRange(power, 8 * o, 8 * o + 8)).mapToObj(v -> String.format("%.2f", v)).toList() + " of bands up to 22 Hz; body force " + evidence.bodyForce().map(f -> f.rms()));
        }
        if (System.getProperty("errors") != null) {
            System.out.println("    stirring " + key.get("stirring_N") + " " + " places " + new Locator(evidence).places(best.candidate(), best.x()).stream().limit(4).toList());
        }
        long t1;
        Map<String, Double> truths = new TreeMap<>();
        truth.get("parameters").fields().forEachRemaining(e -> truths.put(e.getKey(), e.getValue().asDouble()));
        if (truths.containsKey("stiffness_N_per_m")) {
            double m = truths.get("mass_kg");
            double k = truths.get("stiffness_N_per_m");
            truths.put("frequency_hz", Math.sqrt(k / m) / 2 / Math.PI);
            truths.put("damping_ratio", truths.get("damping_Ns_per_m") / 2 / Math.sqrt(k * m));
        }
        if (truths.containsKey("angle_rad")) {
            truths.put("towards_x_rad", truths.get("angle_rad"));
        }
        if (truths.containsKey("end_delay_s")) {
            truths.put("drift_s_per_s", truths.get("end_delay_s") / recording.length() * recording.clock().rate());
        }
        t1 = System.nanoTime();
        Fitter probe = new Fitter(evidence);
        for (int i = 0; i < 3; i++) {
            probe.look(best.candidate(), best.x(), best.frame());
        }
        long t2 = System.nanoTime();
        probe.lookWithSlopes(best.candidate(), best.x(), best.frame());
        long t3 = System.nanoTime();
        new Values(evidence, best);
        long t4 = System.nanoTime();
        System.out.printf("look %.3f slopes %.3f settle %.3f%n", (t2 - t1) / 3e9, (t3 - t2) / 1e9, (t4 - t3) / 1e9);
        t1 = System.nanoTime();
        Values values = new Values(evidence, best);
        Diagnosis.Named named = values.named(best.candidate().added().get(0), 1);
        double seconds = (System.nanoTime() - t1) / 1e9;
        if (System.getProperty("along") != null) {
            int i = Integer.getInteger("along");
            for (double d : new double[] {-1, -0.3, -0.1, -0.03, -0.01, 0, 0.01, 0.03, 0.1, 0.3, 1}) {
                double[] x = best.x().clone();
                x[x.length - 1 - i] += d;
                System.out.printf("    %g %.2f%n", d, new Fitter(evidence).look(best.candidate(), x, best.frame()).cost() - best.cost());
            }
        }
        double heaviest = model.bodies().stream().mapToDouble(Model.Body::mass).max().orElseThrow();
        int hb = 0;
        while (model.bodies().get(hb).mass() != heaviest) {
            hb++;
        }
        System.out.printf("scale %.4f +- %.4f true %.4f%n", values.state().candidate().template().structure().mass()[hb] / heaviest,
                MassScale.of(evidence, new Fitter(evidence).lookWithSlopes(best.candidate(), best.x(), best.frame())).deviation(),
                key.get("true_linear_model").get("bodies").get(hb).get("mass_kg").asDouble() / heaviest);
        for (Map.Entry<String, Double> entry : named.parameters().entrySet()) {
            String name = entry.getKey();
            double t = truths.getOrDefault(name.startsWith("lever_arm_m") && name.endsWith("gyr.y") ? "lever_arm_m" : name, Double.NaN);
            double v = entry.getValue();
            Interval i = named.intervals().get(name);
            if (name.startsWith("lever_arm_m") && v < 0) {
                v = -v;
                i = new Interval(-i.high(), -i.low(), i.from());
            }
            System.out.printf("%s,%s,%s,%s,%.4g,%.3f,%.3f,%.3f,%s,%.5g,%.5g,%.5g,%.5g,%s,%s,%.2f%n", id, setting.word(), truth.get("form").asText().replace(',', ' '),
                    best.candidate().added().get(0).form(), key.get("linear_chi2").asDouble(), base.reduced(), best.reduced(), values.state().reduced(), name, t, v, i.low(), i.high(), i.from(),
                    Double.isNaN(t) ? "" : i.contains(t) ? "in" : "OUT", seconds);
        }
    }

    private static String text(double[] x) {
        return java.util.Arrays.stream(x).mapToObj(Double::toString).collect(java.util.stream.Collectors.joining(" "));
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
