package wbv.diagnosis;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** What a mechanism is, in the words of someone who sits in the seat. */
final class Phrases {

    private static final Map<String, String> WORDS = Map.ofEntries(
            Map.entry("parameters", "Only the numbers of %s are wrong"),
            Map.entry("stiffness.softening", "The link %s softens with deflection"),
            Map.entry("stiffness.hardening", "The link %s stiffens with deflection"),
            Map.entry("stiffness.asymmetric", "The link %s is not as stiff in compression as in extension"),
            Map.entry("damping.quadratic", "The damping of %s grows with speed"),
            Map.entry("friction.coulomb", "The link %s sticks: dry friction"),
            Map.entry("hysteresis", "The spring of %s yields and loses energy in every loop"),
            Map.entry("memory.viscoelastic", "The link %s relaxes: it remembers its past deflection"),
            Map.entry("contact.loss", "Contact is lost at %s"),
            Map.entry("contact.bumpstop", "The link %s hits a stop"),
            Map.entry("contact.backlash", "There is play in %s"),
            Map.entry("mode.hidden", "A mass that no sensor sees swings on %s"),
            Map.entry("coupling.axis", "Motion across couples into %s"),
            Map.entry("coupling.rotation", "Rotation lifts %s"),
            Map.entry("drift.step", "The link %s changed at one moment"),
            Map.entry("drift.slow", "The link %s changed over time"),
            Map.entry("muscle.reflex", "Something at %s answers late, as a muscle does"),
            Map.entry("input.unmeasured", "A force that was not measured acts on %s"),
            Map.entry("sensor.mount", "The sensor %s rides on a soft mount"),
            Map.entry("sensor.misalignment", "The sensor %s is tilted"),
            Map.entry("sensor.delay", "The sensor %s is late"),
            Map.entry("sensor.bias", "The sensor %s has a bias"),
            Map.entry("sensor.gain", "The sensor %s has a wrong gain"),
            Map.entry("sensor.rectifying", "The sensor %s loses the sign"),
            Map.entry("sensor.clipping", "The sensor %s clips"),
            Map.entry("sensor.dropouts", "The sensor %s drops samples"));

    private Phrases() { }

    /** A share in percent, from 99 on with its tenths; what rounds to all is all. */
    static String percent(double share) {
        return String.format(Locale.ROOT, share > 0.99 && share < 0.9995 ? "%.1f %%" : "%.0f %%", 100 * share);
    }

    /** One clause with the values found, without a full stop. */
    static String of(Diagnosis.Named named) {
        String clause = WORDS.getOrDefault(named.mechanism(), named.mechanism() + " at %s");
        StringBuilder text = new StringBuilder(String.format(clause, named.where()));
        String separator = " (";
        for (Map.Entry<String, Double> entry : named.parameters().entrySet()) {
            Amount amount = Amount.of(entry.getKey());
            text.append(separator).append(amount.label()).append(' ').append(Optional.ofNullable(named.intervals().get(entry.getKey()))
                    .map(interval -> amount.text(entry.getValue(), interval)).orElseGet(() -> amount.text(entry.getValue())));
            separator = "; ";
        }
        return text.append(named.parameters().isEmpty() ? "" : ")").toString();
    }
}
