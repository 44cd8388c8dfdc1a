package wbv.diagnosis;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;

/** The numbers of a mechanism that was found, and how sure they are. */
final class Values {

    /** Accelerations know forces only up to the scale of the masses, which the user's model gives within about this part. */
    private static final double MASS_SCALE = 0.06;
    /** What a law's form and the sensors' small errors leave open of any other number. */
    private static final double FORM = 0.02;
    /** How sharp the moment of a change is taken to be [s]. */
    private static final double MOMENT = 0.05;

    private final Evidence evidence;

    Values(Evidence evidence) {
        this.evidence = evidence;
    }

    /** A hypothesis of a fit with its numbers. */
    Diagnosis.Named named(Fitter.State state, Hypothesis hypothesis, double probability) {
        double[][] covariance = covariance(state);
        Map<String, Double> values = new LinkedHashMap<>();
        Map<String, Double> std = new LinkedHashMap<>();
        int[] positions = hypothesis.positions(state.candidate());
        for (int i = 0; i < positions.length; i++) {
            Knob knob = state.candidate().knobs().get(positions[i]);
            String key = hypothesis.numbers().get(i).key();
            double x = state.x()[positions[i]];
            values.put(key, knob.value(x));
            boolean atBound = x <= knob.low() + 1e-6 || x >= knob.high() - 1e-6;
            double statistical = Math.sqrt(covariance[positions[i]][positions[i]] * Math.max(1, state.reduced())) * Math.abs(knob.slope(x));
            // The numbers of a hidden mass share the scale; the mass gets it below.
            boolean unscaled = !evidence.onRig() && !hypothesis.mechanism().equals("mode.hidden") && (key.contains("_N") || key.contains("_kg"));
            double scale = scatter(hypothesis, key).orElse((unscaled ? MASS_SCALE : FORM) * Math.abs(knob.value(x)));
            std.put(key, atBound ? Double.POSITIVE_INFINITY : Math.hypot(statistical, scale));
        }
        inTheFieldsTerms(hypothesis, values, std);
        return new Diagnosis.Named(hypothesis.mechanism(), hypothesis.where(), probability, values, std, state.reduced());
    }

    /**
     * What is open of a number beside what the fit knows, where it is not a part of the number itself: a sensor's fault comes on top of
     * the small errors that every sensor has; a moment is as sharp as what happened at it.
     */
    private OptionalDouble scatter(Hypothesis hypothesis, String key) {
        if (hypothesis.mechanism().equals("input.unmeasured") && key.equals("frequency_hz")) {
            return OptionalDouble.of(0);
        }
        if (key.startsWith("lever_arm_m") && hypothesis.blamesSensor()) {
            return OptionalDouble.of(Nuisances.ARM);
        }
        return switch (key) {
            case "time_s" -> OptionalDouble.of(MOMENT);
            case "factor" -> OptionalDouble.of(Nuisances.GAIN);
            case "delay_s" -> hypothesis.blamesSensor() ? OptionalDouble.of(Nuisances.DELAY / evidence.recording().clock().rate())
                    : OptionalDouble.empty();
            case "towards_x_rad", "towards_y_rad" -> OptionalDouble.of(Nuisances.TILT);
            default -> OptionalDouble.empty();
        };
    }

    /** A hidden mass by its frequency and damping ratio, a steady force by its amplitude: what a reader expects. */
    private static void inTheFieldsTerms(Hypothesis hypothesis, Map<String, Double> values, Map<String, Double> std) {
        if (hypothesis.mechanism().equals("mode.hidden")) {
            double m = values.get("mass_kg");
            double k = values.remove("stiffness_N_per_m");
            double c = values.remove("damping_Ns_per_m");
            double relativeMass = std.get("mass_kg") / m;
            double relativeStiffness = std.remove("stiffness_N_per_m") / k;
            double relativeDamping = std.remove("damping_Ns_per_m") / c;
            double frequency = Math.sqrt(k / m) / (2 * Math.PI);
            double damping = c / (2 * Math.sqrt(k * m));
            values.put("frequency_hz", frequency);
            values.put("damping_ratio", damping);
            std.put("mass_kg", m * Math.hypot(relativeMass, MASS_SCALE));
            std.put("frequency_hz", frequency * Math.hypot(relativeStiffness, relativeMass) / 2);
            std.put("damping_ratio", damping * Math.hypot(relativeDamping, Math.hypot(relativeStiffness, relativeMass) / 2));
        } else if (values.containsKey("cosine_N")) {
            double cosine = values.get("cosine_N");
            double sine = values.get("sine_N");
            values.put("amplitude_N", Math.hypot(cosine, sine));
            std.put("amplitude_N", Math.hypot(cosine * std.get("cosine_N"), sine * std.get("sine_N")) / Math.hypot(cosine, sine));
            for (String part : List.of("cosine_N", "sine_N")) {
                values.remove(part);
                std.remove(part);
            }
        } else if (hypothesis.mechanism().equals("sensor.delay") && Math.abs(values.getOrDefault("drift_s_per_s", 0.0)) < 1e-8) {
            values.remove("drift_s_per_s");
            std.remove("drift_s_per_s");
        }
    }

    private double[][] covariance(Fitter.State state) {
        Fitter.State full = state.slopes().length > 0 ? state
                : new Fitter(evidence).lookWithSlopes(state.candidate(), state.x(), state.frame());
        double[][] c = new Fitter.Normal(full).curvature();
        double[][] out = new double[c.length][];
        for (int i = 0; i < c.length; i++) {
            double[] unit = new double[c.length];
            unit[i] = 1;
            out[i] = Fitter.solve(c, unit, new boolean[c.length], 0);
        }
        return out;
    }
}
