package wbv.proof;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import wbv.diagnosis.Diagnosis;

/**
 * What a diagnosis answered, as far as it is marked.
 *
 * @param verdict in a word; {@code failed} where there is no answer, and the sentence says why
 * @param latent  places that would carry the mismatch, best first
 * @param force   what the answer's laws do in the link that it names first; empty where they do nothing in any
 */
record ProofAnswer(String verdict, String sentence, List<Name> missing, List<Name> alternatives, List<String> latent, double before,
        double after,
        double heldBefore, double heldAfter, double seconds, Optional<LawForce> force) {

    static final String FAILED = "failed";
    /** The data were refused, in the words of the sentence, before anything was diagnosed. */
    static final String REFUSED = "refused";
    /** Nothing of the library carries it, and a law was learned that does. */
    static final String LEARNED_LAW = "learned-law";
    /** The mechanism of a law that was learned. */
    static final String LEARNED = "learned";
    private static final ObjectMapper JSON = new ObjectMapper();

    /**
     * A mechanism at a place.
     *
     * @param low ends of the intervals of its parameters; infinite where open
     * @param high likewise
     * @param left mean square of the whitened residual with it; NaN where the answer does not say
     * @param numbers logarithm of how likely the model's own numbers are with it [nat]; 0 where the answer does not say
     */
    record Name(String mechanism, String where, double probability, Map<String, Double> parameters, Map<String, Double> low,
            Map<String, Double> high, double left, double numbers) {}

    /** One that adds no force to a link. */
    ProofAnswer(String verdict, String sentence, List<Name> missing, List<Name> alternatives, List<String> latent, double before,
            double after,
            double heldBefore, double heldAfter, double seconds) {
        this(verdict, sentence, missing, alternatives, latent, before, after, heldBefore, heldAfter, seconds, Optional.empty());
    }

    static ProofAnswer of(Diagnosis d, double seconds, Optional<LawForce> force) {
        return new ProofAnswer(d.verdict().word(), d.sentence(), d.missing().stream().map(ProofAnswer::name).toList(),
                d.alternatives().stream().map(ProofAnswer::name).toList(), d.latent().stream().map(Diagnosis.Latent::where).toList(),
                d.fit().before(), d.fit().after(), d.fit().heldBefore(), d.fit().heldAfter(), seconds, force);
    }

    static ProofAnswer failed(String why, double seconds) {
        return new ProofAnswer(FAILED, why, List.of(), List.of(), List.of(), Double.NaN, Double.NaN, Double.NaN, Double.NaN, seconds);
    }

    static ProofAnswer refused(String why, double seconds) {
        return new ProofAnswer(REFUSED, why, List.of(), List.of(), List.of(), Double.NaN, Double.NaN, Double.NaN, Double.NaN, seconds);
    }

    private static Name name(Diagnosis.Named named) {
        Map<String, Double> low = new LinkedHashMap<>();
        Map<String, Double> high = new LinkedHashMap<>();
        named.intervals().forEach((key, interval) -> {
            low.put(key, interval.low());
            high.put(key, interval.high());
        });
        return new Name(named.mechanism(), named.where(), named.probability(), named.parameters(), low, high, named.reduced(),
                named.numbers());
    }

    String json() {
        ObjectNode root = JSON.createObjectNode();
        root.put("verdict", verdict).put("sentence", sentence).put("seconds", seconds).put("before", before).put("after", after)
                .put("held_before", heldBefore).put("held_after", heldAfter);
        names(root.putArray("missing"), missing);
        names(root.putArray("alternatives"), alternatives);
        latent.forEach(root.putArray("latent")::add);
        force.ifPresent(f -> {
            ObjectNode one = root.putObject("force").put("where", f.where()).put("rate_hz", f.rate()).put("held_from_s", f.from())
                    .put("held_to_s", f.to());
            ArrayNode law = one.putArray("law");
            f.terms().forEach(term -> term.write(law));
            f.newtons().forEach(one.putArray("force_N")::add);
        });
        return root.toPrettyString() + "\n";
    }

    static ProofAnswer parse(String json) throws IOException {
        JsonNode root = JSON.readTree(json);
        List<String> latent = new ArrayList<>();
        root.get("latent").forEach(place -> latent.add(place.asText()));
        return new ProofAnswer(root.get("verdict").asText(), root.get("sentence").asText(), names(root.get("missing")),
                names(root.get("alternatives")), latent, number(root.get("before")), number(root.get("after")),
                number(root.get("held_before")), number(root.get("held_after")), number(root.get("seconds")), force(root.path("force")));
    }

    private static Optional<LawForce> force(JsonNode node) {
        if (node.isMissingNode()) {
            return Optional.empty();
        }
        List<Double> newtons = new ArrayList<>();
        node.get("force_N").forEach(value -> newtons.add(number(value)));
        return Optional.of(new LawForce(node.get("where").asText(), number(node.get("rate_hz")), number(node.get("held_from_s")),
                number(node.get("held_to_s")), newtons, ComparedTerm.parse(node.get("law"))));
    }

    private static void names(ArrayNode into, List<Name> names) {
        for (Name name : names) {
            ObjectNode one = into.addObject().put("mechanism", name.mechanism()).put("where", name.where())
                    .put("probability", name.probability()).put("left", name.left()).put("numbers", name.numbers());
            ObjectNode parameters = one.putObject("parameters");
            name.parameters().forEach(parameters::put);
            ObjectNode low = one.putObject("low");
            name.low().forEach(low::put);
            ObjectNode high = one.putObject("high");
            name.high().forEach(high::put);
        }
    }

    private static List<Name> names(JsonNode array) {
        List<Name> out = new ArrayList<>();
        for (JsonNode one : array) {
            out.add(new Name(one.get("mechanism").asText(), one.get("where").asText(), number(one.get("probability")),
                    numbers(one.get("parameters")), numbers(one.get("low")), numbers(one.get("high")),
                    one.has("left") ? number(one.get("left")) : Double.NaN, one.has("numbers") ? number(one.get("numbers")) : 0));
        }
        return out;
    }

    static Map<String, Double> numbers(JsonNode object) {
        Map<String, Double> out = new LinkedHashMap<>();
        object.fieldNames().forEachRemaining(key -> out.put(key, number(object.get(key))));
        return out;
    }

    /** JSON has no word for what is not finite; it is written as text. */
    private static double number(JsonNode node) {
        return node.isTextual() ? Double.parseDouble(node.asText()) : node.asDouble();
    }
}
