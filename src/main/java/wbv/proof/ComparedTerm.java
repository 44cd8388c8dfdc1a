package wbv.proof;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * A summand of a law in the words in which keys and answers are compared: a product, what it depends on without any number.
 *
 * @param factors in any order
 * @param lagged whether the product answers late
 */
record ComparedTerm(Set<Factor> factors, boolean lagged) {

    /**
     * @param of what
     * @param at link or channel, empty for the law's own link
     * @param as how it enters: itself, sign, magnitude, square, ...
     */
    record Factor(String of, String at, String as) {}

    ComparedTerm {
        factors = Set.copyOf(factors);
    }

    /** Whether an answer's terms are those of the truth; empty where one of the two does not say any. */
    static Optional<Boolean> same(List<ComparedTerm> truth, List<ComparedTerm> answer) {
        return truth.isEmpty() || answer.isEmpty() ? Optional.empty() : Optional.of(new HashSet<>(truth).equals(new HashSet<>(answer)));
    }

    /** @param array as in a key's {@code law}; may be missing */
    static List<ComparedTerm> parse(JsonNode array) {
        List<ComparedTerm> out = new ArrayList<>();
        for (JsonNode one : array) {
            Set<Factor> factors = new HashSet<>();
            boolean memory = one.has("memory_s");
            for (JsonNode factor : one.get("factors")) {
                factors.add(new Factor(factor.get("of").asText(), factor.path("at").asText(""), factor.get("as").asText()));
                memory |= factor.has("memory_s");
            }
            out.add(new ComparedTerm(factors, memory));
        }
        return out;
    }

    void write(ArrayNode into) {
        ObjectNode one = into.addObject();
        ArrayNode list = one.putArray("factors");
        factors.stream().sorted(java.util.Comparator.comparing(Factor::toString))
                .forEach(f -> list.addObject().put("of", f.of()).put("at", f.at()).put("as", f.as()));
        if (lagged) {
            one.putNull("memory_s");
        }
    }
}
