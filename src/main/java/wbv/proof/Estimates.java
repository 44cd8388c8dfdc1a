package wbv.proof;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Parameters that a key and an answer mean alike. */
final class Estimates {

    private Estimates() {}

    /**
     * A value and what was found for it.
     *
     * @param low  end of the interval that was given, infinite where it was left open; NaN where none was given
     * @param high likewise
     * @param form whether the generator has the formula that the library has; what another formula calls by the same name is close at best
     */
    record Estimate(String key, double truth, double found, double low, double high, boolean form) {

        /** Whether the interval holds the truth, which a key rounds to four digits. */
        boolean covers() {
            double rounded = truth == 0 ? 0 : 0.5 * Math.pow(10, Math.floor(Math.log10(Math.abs(truth))) - 3);
            return low <= truth + rounded && truth - rounded <= high;
        }
    }

    static List<Estimate> of(Truth.Concealed truth, ProofAnswer.Name name) {
        List<Estimate> out = new ArrayList<>();
        boolean form = truth.mechanism().startsWith("sensor.") || truth.mechanism().startsWith("coupling.")
                || truth.mechanism().equals("mode.hidden") || truth.mechanism().equals("input.unmeasured");
        for (Map.Entry<String, Double> each : told(truth).entrySet()) {
            String key = each.getKey();
            for (String other : name.parameters().keySet()) {
                boolean pitch = key.equals("lever_arm_m") && other.startsWith("lever_arm_m") && other.endsWith("gyr.y");
                if (other.equals(key) || pitch) {
                    double value = name.parameters().get(other);
                    double low = name.low().getOrDefault(other, Double.NaN);
                    double high = name.high().getOrDefault(other, Double.NaN);
                    // Which way an arm points is a matter of axes.
                    boolean turned = pitch && value < 0;
                    out.add(new Estimate(key, each.getValue(), turned ? -value : value, turned ? -high : low,
                            turned ? -low : high, form));
                }
            }
        }
        return out;
    }

    /** A key's parameters with what follows from them. */
    private static Map<String, Double> told(Truth.Concealed truth) {
        Map<String, Double> out = new LinkedHashMap<>(truth.parameters());
        if (truth.mechanism().equals("mode.hidden") && out.containsKey("stiffness_N_per_m")) {
            double mass = out.get("mass_kg");
            double stiffness = out.get("stiffness_N_per_m");
            out.put("frequency_hz", Math.sqrt(stiffness / mass) / (2 * Math.PI));
            out.put("damping_ratio", out.get("damping_Ns_per_m") / (2 * Math.sqrt(stiffness * mass)));
        }
        if (truth.mechanism().equals("sensor.misalignment")) {
            out.computeIfAbsent("towards_x_rad", key -> out.get("angle_rad"));
        }
        return out;
    }
}
