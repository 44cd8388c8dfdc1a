package wbv.proof;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * An opened key, as far as it is marked.
 *
 * @param linear what the best linear chain leaves over the noise, mean square; 1 for nothing but noise
 * @param first  body on the platform
 * @param seed of the case
 * @param band in which forces are compared: lowest and highest frequency [Hz]
 */
record Truth(List<Concealed> concealed, String setting, double strength, double linear, String first, long seed, List<Double> band) {

    /** Of a plane's person, whose places have several names. */
    private static final String PLANAR = "planar";

    /** One of sitters, whose forces are compared in the band of sitters. */
    Truth(List<Concealed> concealed, String setting, double strength, double linear, String first, long seed) {
        this(concealed, setting, strength, linear, first, seed, List.of(ForceMatch.LOW, ForceMatch.HIGH));
    }

    /**
     * What was concealed.
     *
     * @param linear what the best linear chain leaves of it alone over the noise, mean square; NaN in keys from before this was told
     * @param law of those that are to be learned
     */
    record Concealed(String mechanism, String where, String form, Map<String, Double> parameters, double linear, List<ComparedTerm> law) {
        Concealed(String mechanism, String where, String form, Map<String, Double> parameters, double linear) {
            this(mechanism, where, form, parameters, linear, List.of());
        }
    }

    static Truth parse(String json) throws IOException {
        JsonNode root = new ObjectMapper().readTree(json);
        List<Concealed> concealed = new ArrayList<>();
        for (JsonNode one : root.get("mechanisms")) {
            concealed.add(new Concealed(one.get("mechanism").asText(), one.get("where").asText(), one.get("form").asText(),
                    ProofAnswer.numbers(one.get("parameters")), one.path("linear_chi2").asDouble(Double.NaN),
                    ComparedTerm.parse(one.path("law"))));
        }
        return new Truth(concealed, root.get("setting").asText(), root.get("strength").asDouble(),
                root.get("linear_chi2").asDouble(),
                root.get("true_linear_model").get("bodies").get(0).get("name").asText(),
                root.get("seed").asLong(), root.has("force_band_hz")
                        ? List.of(root.get("force_band_hz").get(0).asDouble(), root.get("force_band_hz").get(1).asDouble())
                        : List.of(ForceMatch.LOW, ForceMatch.HIGH));
    }

    /**
     * Whether two places are one. A force on the first body, one in the link below it and a fault of the platform's sensor move
     * all
     * bodies alike: no recording tells them apart.
     */
    boolean samePlace(String a, String b) {
        return sameWords(a, b) || atBase(a) && atBase(b);
    }

    /**
     * Whether two places are said to be one: in the same words; in a plane a sensor's channels are one, a joint has no direction, and who
     * wears the sternum is the torso.
     */
    boolean sameWords(String a, String b) {
        return a.equals(b) || setting.equals(PLANAR) && plain(a).equals(plain(b));
    }

    private static Set<String> plain(String where) {
        return Arrays.stream(where.split("-")).map(end -> end.replaceAll("\\..*", ""))
                .map(place -> place.equals("torso") ? "sternum" : place).collect(Collectors.toSet());
    }

    private boolean atBase(String where) {
        return where.equals(first) || where.equals("platform-" + first) || where.startsWith("platform.acc");
    }
}
