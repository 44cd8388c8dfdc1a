package wbv.rig.concealed;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Optional;
import wbv.rig.concealed.law.Term;

/** What was concealed, as JSON. */
final class ConcealedKey {

    private ConcealedKey() {}

    /**
     * @param noise variance by output that no model predicts [(m/s²)²]
     * @param force of a law that is to be learned, which is sealed beside the key
     */
    static ObjectNode json(ConcealedSpec spec, RideScene scene, List<OmissionSize> hidden, double stirring, double[] noise,
            Optional<String> force) {
        ObjectNode root = new ObjectMapper().createObjectNode();
        root.put("case", spec.name());
        ArrayNode mechanisms = root.putArray("mechanisms");
        double excess = 0;
        for (OmissionSize each : hidden) {
            ObjectNode one = mechanisms.addObject();
            write(each.omission(), one);
            one.put("share", Chain.rounded(each.share()));
            double mean = 0;
            for (int o = 0; o < noise.length; o++) {
                mean += each.left()[o] / noise[o] / noise.length;
            }
            one.put("linear_chi2", Chain.rounded(1 + mean));
            excess += mean;
        }
        root.put("strength", spec.strength()).put("setting", spec.setting().word()).put("exact_model", spec.exact());
        // What the best linear chain leaves over the noise, 1 for nothing but noise.
        root.put("linear_chi2", Chain.rounded(1 + excess));
        root.put("stirring_N", Chain.rounded(stirring));
        root.set("true_linear_model", scene.chain().json("true linear part", scene.blind()));
        root.put("first_resonance_hz", Chain.rounded(scene.chain().frequencies()[0]));
        root.put("seed", spec.seed());
        force.ifPresent(text -> root.put("force_sha256", ConcealedForce.digest(text)));
        return root;
    }

    /** What an omission says of itself. */
    static void write(Omission omission, ObjectNode into) {
        into.put("mechanism", omission.mechanism()).put("where", omission.where()).put("form", omission.form());
        ObjectNode parameters = into.putObject("parameters");
        omission.parameters().forEach((name, value) -> parameters.put(name, Chain.rounded(value)));
        if (!omission.law().isEmpty()) {
            omission.law().forEach(term -> write(term, into.withArray("law").addObject()));
        }
    }

    private static void write(Term term, ObjectNode into) {
        ArrayNode factors = into.putArray("factors");
        for (Term.Factor factor : term.factors()) {
            ObjectNode one = factors.addObject().put("of", factor.of());
            if (!factor.at().isEmpty()) {
                one.put("at", factor.at());
            }
            one.put("as", factor.as());
            factor.memory().ifPresent(memory -> one.put("memory_s", Chain.rounded(memory)));
        }
        term.memory().ifPresent(memory -> into.put("memory_s", Chain.rounded(memory)));
    }
}
