package wbv.diagnosis;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import wbv.diagnosis.mechanism.Library;

/** What a mechanism is, in the words of someone who sits in the seat. */
final class Phrases {

    private Phrases() {}

    /** A share in percent, from 99 on with its tenths; what rounds to all is all. */
    static String percent(double share) {
        return String.format(Locale.ROOT, share > 0.99 && share < 0.9995 ? "%.1f %%" : "%.0f %%", 100 * share);
    }

    /** One clause with the values found, without a full stop. */
    static String of(Library library, Diagnosis.Named named) {
        String clause = library.of(named.mechanism()).map(mechanism -> mechanism.sentence(named.parameters().keySet(), named.form()))
                .orElse(named.mechanism() + " at %s");
        StringBuilder text = new StringBuilder(String.format(clause, named.where()));
        String separator = " (";
        for (Map.Entry<String, Double> entry : named.parameters().entrySet()) {
            DisplayedNumber amount = DisplayedNumber.of(entry.getKey());
            text.append(separator).append(amount.label()).append(' ').append(Optional.ofNullable(named.intervals().get(entry.getKey()))
                    .map(interval -> amount.text(entry.getValue(), interval)).orElseGet(() -> amount.text(entry.getValue())));
            separator = "; ";
        }
        return text.append(named.parameters().isEmpty() ? "" : ")").toString();
    }
}
