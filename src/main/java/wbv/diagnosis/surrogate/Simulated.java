package wbv.diagnosis.surrogate;

import java.util.Optional;
import java.util.OptionalDouble;
import wbv.body.Model;
import wbv.recording.Channel;
import wbv.recording.Recording;

/**
 * What a simulation gave, and what its user says of it.
 *
 * @param outputs channels named as the recording's and on its clock; what the recording lacks only helps to identify
 * @param name    what messages call it
 * @param input   acceleration of the recording that drove it
 * @param subject what it simulates; where nobody says so, the places that it names tell
 * @param mass    of all that the input moves [kg], &gt; 0, where it is known: forces go by it
 */
public record Simulated(Recording outputs, String name, Channel input, Optional<Model.Subject> subject, OptionalDouble mass) {

    public Simulated {
        if (mass.isPresent() && !(mass.getAsDouble() > 0 && mass.getAsDouble() < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("what a simulation moves must have a mass > 0: " + mass.getAsDouble() + " kg");
        }
    }

    /** Of which nothing is said. */
    public static Simulated of(Recording outputs, String name, Channel input) {
        return new Simulated(outputs, name, input, Optional.empty(), OptionalDouble.empty());
    }

    /** Other outputs of the same simulation. */
    public Simulated with(Recording others) {
        return new Simulated(others, name, input, subject, mass);
    }

    /** What it is said to simulate, else a person if any of its places is one on a seat or on who sits there. */
    Model.Subject simulates() {
        return subject
                .orElse(outputs.channels().stream().anyMatch(channel -> Segment.at(channel.location()).isPresent()) ? Model.Subject.PERSON
                        : Model.Subject.RIG);
    }
}
