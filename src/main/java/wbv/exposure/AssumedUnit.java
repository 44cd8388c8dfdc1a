package wbv.exposure;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import wbv.recording.Channel;
import wbv.recording.Metadata;
import wbv.recording.Quantity;
import wbv.recording.Unit;
import wbv.recording.inspect.Finding;
import wbv.recording.inspect.Inspection;
import wbv.recording.inspect.Severity;

/**
 * Whether an acceleration that is taken for m/s² may as well be in g: where nobody states its unit and no gravity shows it, its level is
 * all that speaks. Levels of seats in use scatter about {@link #TYPICAL} by factors, up as far as down. What is nearer to it in g than in
 * m/s², less than a √9.81-th of it, is thus likelier to be in g, however widely they scatter. That is no proof, and no reason to refuse:
 * a seat on a good track is as quiet.
 */
final class AssumedUnit {

    /** What half of all seats in use show, about (assumed): the action value of 2002/44/EC [m/s²]. */
    private static final double TYPICAL = Directive.ACTION.a8();
    private static final double LITTLE = TYPICAL / Math.sqrt(Unit.STANDARD_GRAVITY);

    private AssumedUnit() {}

    /** @param seat channels of the seat that were measured */
    static Optional<Remark> of(Inspection inspection, Metadata metadata, List<Channel> seat, Map<SeatAxis, Vibration> axes) {
        double level = axes.entrySet().stream().mapToDouble(each -> each.getKey().factor() * each.getValue().rms()).max().orElse(0);
        double inG = Unit.STANDARD_GRAVITY * level;
        boolean told = seat.stream().allMatch(channel -> metadata.units().containsKey(channel.toString()));
        if (told || gravityShows(inspection, seat) || !(level < LITTLE && inG >= LITTLE)) {
            return Optional.empty();
        }
        String place = seat.get(0).location() + "." + seat.get(0).quantity().symbol();
        return Optional.of(new Remark(Severity.WARNING,
                "nothing states the unit of " + place + " and no gravity shows it: m/s² is assumed, and k a_w "
                        + RoundedNumber.text(level, 2)
                        + " m/s² is little for a seat in use; measured in g, eight hours a day of it would be "
                        + "A(8) " + RoundedNumber.text(inG, 2) + " m/s²; state the unit",
                "in the header, " + seat.get(0) + " [g], or in the sidecar, \"units\": {\"" + place
                        + "\": \"g\"}; \"m/s2\" if it is that"));
    }

    private static boolean gravityShows(Inspection inspection, List<Channel> seat) {
        String place = seat.get(0).location();
        boolean without = inspection.findings().stream()
                .anyMatch(finding -> finding instanceof Finding.GravityMissing missing && missing.location().equals(place));
        return seat.get(0).quantity() == Quantity.SPECIFIC_FORCE && !without || inspection.findings().stream()
                .anyMatch(finding -> finding instanceof Finding.GravityLeftIn left && left.location().equals(place));
    }
}
