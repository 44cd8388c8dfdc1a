package wbv.diagnosis;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.NormalDistribution;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Knob;
import wbv.diagnosis.fit.Slot;
import wbv.diagnosis.search.MassScale;

/**
 * Which numbers of a model are wrong where nothing else is: those that were found another than given by more than 95 % leave open, surest
 * first. A number that the recording hardly tells may be found anywhere, and is not among them.
 */
final class WrongNumbers {

    private static final int MOST = 3;
    private static final double SURE = 0.95;

    private final Evidence evidence;
    private final Fitter.State base;
    private final MassScale scale;

    /**
     * @param base with fitted values
     * @param scale of its masses
     */
    WrongNumbers(Evidence evidence, Fitter.State base, MassScale scale) {
        this.evidence = evidence;
        this.base = base;
        this.scale = scale;
    }

    /** @param sureness by how many standard deviations it is off */
    private record Off(Knob knob, double found, double sureness) {}

    /** A sentence with a blank before it; nothing where no number is surely wrong, or nobody gave one. */
    String words() {
        if (evidence.standsForSimulation()) {
            return "";
        }
        return NumberIntervals.of(evidence, base).map(this::surelyWrong).orElse("");
    }

    private String surelyWrong(NumberIntervals intervals) {
        // Where the scale of all masses is open, numbers may all be right and still not fit each other.
        for (MassScale held : List.of(scale, MassScale.NONE)) {
            List<Off> surest = surest(intervals, held);
            if (!surest.isEmpty()) {
                return " Surely wrong" + (held.deviation() == 0 ? asGiven() : "") + ": "
                        + surest.stream().map(this::told).collect(Collectors.joining("; ")) + ".";
            }
        }
        return "";
    }

    private List<Off> surest(NumberIntervals intervals, MassScale held) {
        int[] numbers = IntStream.range(0, base.candidate().given())
                .filter(i -> NumberIntervals.isOfModel(base.candidate().knobs().get(i))).toArray();
        // With one chance in twenty that any of so many right ones is among them (Bonferroni).
        double sure = new NormalDistribution().inverseCumulativeProbability(1 - (1 - SURE) / 2 / Math.max(1, numbers.length));
        return Arrays.stream(numbers).boxed().map(i -> off(i, intervals, held)).filter(off -> off.sureness() > sure)
                .sorted(Comparator.comparingDouble(Off::sureness).reversed()).limit(MOST).toList();
    }

    /** What motion alone does not show: the mass that sets the scale of the rest is taken as it was given. */
    private String asGiven() {
        Model model = evidence.model();
        return IntStream.range(0, model.bodies().size()).filter(body -> !model.driven() && isHeld(body)).mapToObj(model.bodies()::get)
                .findFirst()
                .map(body -> ", if " + body.name() + " weighs " + DisplayedNumber.of("mass_kg").text(body.mass()) + " as given").orElse("");
    }

    private boolean isHeld(int body) {
        return evidence.model().massKey(evidence.model().bodies().get(body)).isPresent() && base.candidate().knobs().stream()
                .noneMatch(knob -> knob.slot().kind() == Slot.Kind.MASS && knob.slot().at() == body);
    }

    private Off off(int i, NumberIntervals intervals, MassScale held) {
        Knob knob = base.candidate().knobs().get(i);
        return new Off(knob, held.factor() * knob.value(base.x()[i]), intervals.sureness(i, held));
    }

    private String told(Off off) {
        boolean about = evidence.model().links().stream()
                .anyMatch(link -> link.name().equals(off.knob().place()) && evidence.model().about(link));
        DisplayedNumber number = DisplayedNumber.of(about ? ModelFile.keyAbout(off.knob().key()) : off.knob().key());
        return number.label() + " of " + off.knob().place() + ", given " + number.text(off.knob().reference()) + ", found "
                + number.text(off.found());
    }
}
