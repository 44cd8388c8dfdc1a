package wbv.diagnosis;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
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

    /**
     * @param given what its user gave, in the unit of its key
     * @param sureness by how many standard deviations it is off
     */
    private record Off(String place, String key, double given, double found, double sureness) {}

    /** @param condition that sets the scale of all masses, with a comma before it; nothing where that is known */
    private record Wrong(String condition, List<Off> numbers) {}

    /** A sentence with a blank before it; nothing where no number is surely wrong, or nobody gave one. */
    String words() {
        if (evidence.standsForSimulation()) {
            return "";
        }
        return NumberIntervals.of(evidence, base).flatMap(this::surelyWrong)
                .map(wrong -> " Surely wrong" + wrong.condition() + ": "
                        + wrong.numbers().stream().limit(MOST).map(this::told).collect(Collectors.joining("; ")) + ".")
                .orElse("");
    }

    /**
     * Those that are wrong at the scale that all masses together tell. Where that is open numbers may all be right and still not fit each
     * other: then the fewest that are wrong if one mass is as it was given.
     */
    private Optional<Wrong> surelyWrong(NumberIntervals intervals) {
        Wrong told = new Wrong("", surest(numbers().mapToObj(i -> off(i, scale.factor(), intervals.sureness(i, scale)))));
        if (!told.numbers().isEmpty() || scale.deviation() == 0) {
            return Optional.of(told).filter(wrong -> !wrong.numbers().isEmpty());
        }
        List<Integer> masses = numbers().filter(i -> knob(i).slot().kind() == Slot.Kind.MASS).boxed().toList();
        Optional<Model.Body> heaviest = heaviest();
        Stream<Wrong> others = masses.stream().map(held -> new Wrong(asGiven(body(held)), surest(Stream.concat(
                numbers().mapToObj(i -> off(i, Math.exp(-base.x()[held]), intervals.surenessBeside(i, held))),
                heaviest.stream().map(body -> new Off(body.name(), knob(held).key(), body.mass(), body.mass() * Math.exp(-base.x()[held]),
                        intervals.surenessOfHeaviest(held)))))));
        Wrong first = new Wrong(heaviest.map(WrongNumbers::asGiven).orElse(""),
                surest(numbers().mapToObj(i -> off(i, 1, intervals.sureness(i, MassScale.NONE)))));
        return Stream.concat(Stream.of(first), others).filter(wrong -> !wrong.numbers().isEmpty())
                .min(Comparator.comparingInt(wrong -> wrong.numbers().size()));
    }

    private IntStream numbers() {
        return IntStream.range(0, base.candidate().given()).filter(i -> NumberIntervals.isOfModel(knob(i)));
    }

    private Knob knob(int i) {
        return base.candidate().knobs().get(i);
    }

    private Model.Body body(int mass) {
        return evidence.model().bodies().get(knob(mass).slot().at());
    }

    /** With one chance in twenty that any of so many right ones is among them (Bonferroni), surest first. */
    private List<Off> surest(Stream<Off> asked) {
        double sure = new NormalDistribution().inverseCumulativeProbability(1 - (1 - SURE) / 2 / Math.max(1, numbers().count()));
        return asked.filter(off -> off.sureness() > sure).sorted(Comparator.comparingDouble(Off::sureness).reversed()).toList();
    }

    private static String asGiven(Model.Body body) {
        return ", if " + body.name() + " weighs " + DisplayedNumber.of("mass_kg").text(body.mass()) + " as given";
    }

    /** The mass that a fit holds, which sets the scale of the rest: motion alone does not show it. */
    private Optional<Model.Body> heaviest() {
        Model model = evidence.model();
        return IntStream.range(0, model.bodies().size()).filter(body -> !model.driven() && isHeld(body)).mapToObj(model.bodies()::get)
                .findFirst();
    }

    private boolean isHeld(int body) {
        return evidence.model().massKey(evidence.model().bodies().get(body)).isPresent() && base.candidate().knobs().stream()
                .noneMatch(knob -> knob.slot().kind() == Slot.Kind.MASS && knob.slot().at() == body);
    }

    private Off off(int i, double factor, double sureness) {
        Knob knob = knob(i);
        return new Off(knob.place(), knob.key(), knob.reference(), factor * knob.value(base.x()[i]), sureness);
    }

    private String told(Off off) {
        boolean about = evidence.model().links().stream()
                .anyMatch(link -> link.name().equals(off.place()) && evidence.model().about(link));
        DisplayedNumber number = DisplayedNumber.of(about ? ModelFile.keyAbout(off.key()) : off.key());
        return number.label() + " of " + off.place() + ", given " + number.text(off.given()) + ", found "
                + number.text(off.found());
    }
}
