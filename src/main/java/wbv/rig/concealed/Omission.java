package wbv.rig.concealed;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import wbv.rig.concealed.law.Term;

/**
 * Something the model leaves out.
 *
 * @param mechanism  in the vocabulary's words, {@code unknown} where the vocabulary has none
 * @param where      link, body or channel
 * @param form       its law, in words
 * @param parameters true values, units in the names
 * @param law        its force in neutral mathematics, for those that are to be learned; none for all others
 * @param change     what it does to a chain and its sensors
 */
record Omission(String mechanism, String where, String form, Map<String, Double> parameters, List<Term> law, Consumer<Setup> change) {

    Omission {
        law = List.copyOf(law);
        // In one order always, so that keys are the same to the byte.
        parameters = Collections.unmodifiableMap(new TreeMap<>(parameters));
    }

    /** What is told of one that is no change of a chain. */
    static Omission told(String mechanism, String where, String form, Map<String, Double> parameters, List<Term> law) {
        return new Omission(mechanism, where, form, parameters, law, setup -> {});
    }

    /** One that has a name, or is not to be learned. */
    Omission(String mechanism, String where, String form, Map<String, Double> parameters, Consumer<Setup> change) {
        this(mechanism, where, form, parameters, List.of(), change);
    }
}
