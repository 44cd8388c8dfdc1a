package wbv.state;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.InputFile;
import wbv.state.markov.HiddenMarkov;
import wbv.state.mixture.CovarianceShape;
import wbv.state.mixture.Gaussian;
import wbv.state.mixture.Mixture;

/** A {@link StateModel} as a JSON file that people can read. Numbers are written so that they read back as the same doubles. */
public final class StateModelFile {

    private static final ObjectMapper MAPPER = new ObjectMapper();
    private static final int VERSION = 2;

    private StateModelFile() {}

    /**
     * The file's text.
     *
     * @param provenance what, and from what, it was made
     */
    public static String text(StateModel model, Map<String, String> provenance) {
        ObjectNode root = MAPPER.createObjectNode().put("wbv_states", VERSION);
        FeatureSpec features = model.features();
        root.putObject("channels").put("seat", features.seat().toString()).put("head", features.head().toString())
                .put("roll", features.roll().toString()).put("pitch", features.pitch().toString());
        root.put("rate_Hz", features.rate()).put("jerk_corner_Hz", features.corner());
        root.putObject("thresholds").put("jerk_m_per_s3", model.thresholds().jerk())
                .put("surge_m_per_s2", model.thresholds().surge())
                .put("rocking_rad_per_s", model.thresholds().rocking()).put("rest_m_per_s3", model.thresholds().rest());
        root.put("jerk_error_m_per_s3", model.error());
        FeatureSpec.NAMES.forEach(root.putArray("features")::add);
        root.put("mixture", model.mixture());
        ObjectNode rows = root.putObject("training_rows");
        model.rows().forEach((state, count) -> rows.put(state.toString(), count));
        model.trials().forEach(root.putArray("trials")::add);
        ArrayNode states = root.putArray("states");
        for (int k = 0; k < model.chain().states(); k++) {
            ObjectNode state = states.addObject().put("name", model.names().get(k).toString())
                    .put("activity", model.activities().get(k).toString()).put("share", model.shares()[k])
                    .put("initial", model.chain().initial()[k]);
            Mixture mixture = model.chain().emissions().get(k);
            if (k > 0 && mixture.equals(model.chain().emissions().get(k - 1))) {
                state.put("density", "as before");
            } else {
                ArrayNode density = state.putArray("density");
                for (int m = 0; m < mixture.size(); m++) {
                    component(density.addObject().put("weight", mixture.weights()[m]), mixture.components().get(m));
                }
            }
            numbers(state.putArray("to"), model.chain().transition()[k]);
        }
        ObjectNode made = root.putObject("provenance");
        provenance.forEach(made::put);
        return compact(root.toPrettyString()) + "\n";
    }

    private static void component(ObjectNode into, Gaussian gaussian) {
        numbers(into.putArray("mean"), gaussian.mean());
        ArrayNode covariance = into.putArray("covariance");
        int d = gaussian.dimensions();
        for (int i = 0; i < d; i++) {
            ArrayNode row = covariance.addArray();
            for (int j = 0; j < d; j++) {
                row.add(gaussian.covariance(i, j));
            }
        }
    }

    /** Arrays of numbers on one line. */
    private static String compact(String text) {
        StringBuilder out = new StringBuilder();
        int depth = 0;
        for (String line : text.split("\n")) {
            String bare = line.strip();
            boolean number = bare.matches("-?[0-9][0-9.eE+-]*,?");
            if (number) {
                out.append(out.charAt(out.length() - 1) == '[' ? "" : " ").append(bare);
                depth = 1;
            } else if (depth == 1 && bare.startsWith("]")) {
                out.append(bare);
                depth = 0;
            } else {
                out.append(out.length() == 0 ? "" : "\n").append(line);
                depth = 0;
            }
        }
        return out.toString();
    }

    private static void numbers(ArrayNode into, double[] values) {
        for (double value : values) {
            into.add(value);
        }
    }

    /**
     * Reads a file.
     *
     * @throws DataFault if it is missing, is no JSON, or says something else than {@link #text} writes
     */
    public static StateModel read(Path path) throws IOException {
        return parse(InputFile.text(path, "'wbv states train' makes a model.json"), path.toString());
    }

    /** The model that ships with the program: {@code wbv states train --simulated 12}, people simulated by the rig. */
    public static StateModel shipped() {
        try (InputStream in = StateModelFile.class.getResourceAsStream("seated.json")) {
            return parse(new String(in.readAllBytes(), StandardCharsets.UTF_8), "seated.json");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Reads a file's text.
     *
     * @param name of it, for messages
     * @throws DataFault as {@link #read}
     */
    public static StateModel parse(String text, String name) {
        JsonNode root;
        try {
            root = MAPPER.readTree(text);
        } catch (JsonProcessingException wrong) {
            throw InputFile.notJson(name, wrong);
        }
        if (root.path("wbv_states").asInt() != VERSION) {
            throw DataFault.in(name, "holds no state model of version " + VERSION
                    + " ('wbv_states'); 'wbv states train' makes them");
        }
        try {
            return new Reading(name).model(root);
        } catch (IllegalArgumentException wrong) {
            throw DataFault.in(name, wrong.getMessage(), wrong);
        }
    }

    /** One reading; every fault names the file and the field. */
    private record Reading(String file) {

        StateModel model(JsonNode root) {
            JsonNode channels = field(root, "channels");
            FeatureSpec features = new FeatureSpec(number(root, "rate_Hz"), channel(channels, "seat"), channel(channels, "head"),
                    channel(channels, "roll"), channel(channels, "pitch"));
            List<String> named = new ArrayList<>();
            field(root, "features").forEach(each -> named.add(each.asText()));
            if (!named.equals(FeatureSpec.NAMES)) {
                throw DataFault.in(file, "'features' must be " + FeatureSpec.NAMES + ": " + named);
            }
            JsonNode limits = field(root, "thresholds");
            Thresholds thresholds = new Thresholds(number(limits, "jerk_m_per_s3"), number(limits, "surge_m_per_s2"),
                    number(limits, "rocking_rad_per_s"), number(limits, "rest_m_per_s3"));
            JsonNode states = list(root, "states");
            List<Activity> activities = new ArrayList<>();
            List<MotionState> names = new ArrayList<>();
            double[] shares = new double[states.size()];
            List<Mixture> emissions = new ArrayList<>();
            double[] initial = new double[states.size()];
            double[][] transition = new double[states.size()][];
            for (int k = 0; k < states.size(); k++) {
                JsonNode state = states.get(k);
                names.add(state(field(state, "name").asText()));
                activities.add(activity(field(state, "activity").asText()));
                shares[k] = number(state, "share");
                initial[k] = number(state, "initial");
                transition[k] = numbers(state, "to");
                emissions.add(k > 0 && field(state, "density").isTextual() ? emissions.get(k - 1) : mixture(state));
            }
            Map<MotionState, Integer> rows = new EnumMap<>(MotionState.class);
            field(root, "training_rows").fields().forEachRemaining(entry -> rows.put(state(entry.getKey()), entry.getValue()
                    .asInt()));
            List<String> trials = new ArrayList<>();
            field(root, "trials").forEach(each -> trials.add(each.asText()));
            return new StateModel(features, thresholds, field(root, "mixture").asText(),
                    new HiddenMarkov(initial, transition, emissions), activities, names, shares,
                    number(root, "jerk_error_m_per_s3"), trials, rows);
        }

        private Mixture mixture(JsonNode state) {
            JsonNode density = list(state, "density");
            double[] weights = new double[density.size()];
            List<Gaussian> components = new ArrayList<>();
            for (int m = 0; m < weights.length; m++) {
                weights[m] = number(density.get(m), "weight");
                components.add(gaussian(density.get(m)));
            }
            return new Mixture(weights, components);
        }

        private Gaussian gaussian(JsonNode state) {
            double[] mean = numbers(state, "mean");
            int d = mean.length;
            double[] covariance = new double[d * d];
            JsonNode rows = list(state, "covariance");
            for (int i = 0; i < d; i++) {
                double[] row = numbers("covariance", rows.path(i));
                if (rows.size() != d || row.length != d) {
                    throw DataFault.in(file, "'covariance' must be " + d + " by " + d);
                }
                System.arraycopy(row, 0, covariance, i * d, d);
            }
            return Gaussian.exact(CovarianceShape.FULL, mean, covariance);
        }

        private MotionState state(String word) {
            return MotionState.named(word).orElseThrow(() -> DataFault.in(file, "'" + word + "' is no motion state"));
        }

        private Activity activity(String word) {
            return Arrays.stream(Activity.values()).filter(each -> each.toString().equals(word)).findFirst()
                    .orElseThrow(() -> DataFault.in(file, "'" + word + "' is no activity: idle, riding, rocking or jolt"));
        }

        private Channel channel(JsonNode node, String name) {
            return Channel.parse(field(node, name).asText());
        }

        private JsonNode field(JsonNode node, String name) {
            if (!node.has(name)) {
                throw DataFault.in(file, "'" + name + "' is missing; 'wbv states train' writes it");
            }
            return node.get(name);
        }

        private double number(JsonNode node, String name) {
            JsonNode value = field(node, name);
            if (!value.isNumber() || !Double.isFinite(value.asDouble())) {
                throw DataFault.in(file, "'" + name + "' must be a finite number, not " + what(value));
            }
            return value.asDouble();
        }

        private JsonNode list(JsonNode node, String name) {
            JsonNode value = field(node, name);
            if (!value.isArray()) {
                throw DataFault.in(file, "'" + name + "' must be a list, not " + what(value));
            }
            return value;
        }

        private double[] numbers(JsonNode node, String name) {
            return numbers(name, list(node, name));
        }

        private double[] numbers(String name, JsonNode list) {
            double[] values = new double[list.size()];
            for (int i = 0; i < values.length; i++) {
                if (!list.path(i).isNumber()) {
                    throw DataFault.in(file, "'" + name + "' must hold numbers, not " + what(list.path(i)));
                }
                values[i] = list.path(i).asDouble();
            }
            return values;
        }

        /** A value, as a message quotes it. */
        private static String what(JsonNode value) {
            String text = value.toString();
            return value.isMissingNode() ? "nothing" : "'" + (text.length() > 40 ? text.substring(0, 40) + "…" : text) + "'";
        }
    }
}
