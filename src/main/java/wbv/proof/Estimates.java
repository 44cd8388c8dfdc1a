package wbv.proof;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Parameters that a key and an answer mean alike. */
final class Estimates {

    private Estimates() { }

    /** A value and what was found for it. */
    record Estimate(String key, double truth, double found, double std) { }

    static List<Estimate> of(Truth.Concealed truth, Answer.Name name) {
        List<Estimate> out = new ArrayList<>();
        Map<String, Double> found = name.parameters();
        for (Map.Entry<String, Double> each : truth.parameters().entrySet()) {
            String key = each.getKey();
            if (key.equals("amplitude_N") && found.containsKey("cosine_N")) {
                double amplitude = Math.hypot(found.get("cosine_N"), found.get("sine_N"));
                double std = (Math.abs(found.get("cosine_N")) * std(name, "cosine_N") + Math.abs(found.get("sine_N")) * std(name,
                        "sine_N"))
                        / Math.max(1e-12, amplitude);
                out.add(new Estimate(key, each.getValue(), amplitude, std));
            }
            for (String other : found.keySet()) {
                boolean pitch = key.equals("lever_arm_m") && other.startsWith("lever_arm_m") && other.endsWith("gyr.y");
                if (other.equals(key) || pitch) {
                    // Which way an arm points is a matter of axes.
                    double value = pitch ? Math.abs(found.get(other)) : found.get(other);
                    out.add(new Estimate(key, each.getValue(), value, std(name, other)));
                }
            }
        }
        return out;
    }

    private static double std(Answer.Name name, String key) {
        return name.std().getOrDefault(key, Double.NaN);
    }
}
