package wbv.rig.concealed;

import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;

/**
 * Something the model leaves out.
 *
 * @param mechanism  in the vocabulary's words, {@code unknown} where the vocabulary has none
 * @param where      link, body or channel
 * @param form       its law, in words
 * @param parameters true values, units in the names
 * @param change     what it does to a chain and its sensors
 */
record Omission(String mechanism, String where, String form, Map<String, Double> parameters, Consumer<Setup> change) {

    Omission {
        // In one order always, so that keys are the same to the byte.
        parameters = Collections.unmodifiableMap(new TreeMap<>(parameters));
    }
}
