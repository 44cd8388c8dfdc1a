package wbv.diagnosis.learn;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import wbv.body.Model;
import wbv.body.law.Learned;
import wbv.body.law.LearnedInertance;
import wbv.body.law.LearnedLimited;
import wbv.body.law.LearnedWave;
import wbv.body.number.Modulator;
import wbv.body.number.Units;
import wbv.diagnosis.fit.Augmented;
import wbv.diagnosis.fit.Fitter;

/** A law that was learned, as people write it: {@code F = 1240 N/(m/s)² |v|v − 0.31 N/(m·N) r × load of seat-pelvis}. */
public final class LearnedWords {

    private static final MathContext DIGITS = new MathContext(4);
    /** A shape that the motion of the link has no part in. */
    private static final String NOTHING_ELSE = "1 × ";

    private final Model model;
    private final List<Learned> terms;
    private final boolean about;

    /**
     * Looks up the terms; none where the link has no learned law.
     *
     * @param model that holds the law
     * @param where its link
     */
    public LearnedWords(Model model, String where) {
        this.model = model;
        this.about = model.links().stream().filter(link -> link.name().equals(where)).anyMatch(model::about);
        this.terms = model.links().stream().filter(link -> link.name().equals(where)).flatMap(link -> link.laws().stream())
                .filter(Learned.class::isInstance).map(Learned.class::cast).toList();
    }

    /** The formula of a law that a fit holds. */
    public static String of(Model model, Fitter.State fit) {
        return new LearnedWords(Augmented.of(model, fit.candidate().at(fit.x())), fit.candidate().last().where()).formula();
    }

    /** The terms of the law, in the order in which they were learned. */
    public List<Learned> terms() {
        return terms;
    }

    /** The law as an equation with units; "F =" and no more where there is none. */
    public String formula() {
        StringBuilder out = new StringBuilder("F =");
        for (Learned term : terms) {
            boolean negative = term.coefficient() < 0;
            out.append(out.length() > 3 ? negative ? " − " : " + " : negative ? " −" : " ")
                    .append(number(Math.abs(term.coefficient()))).append(' ').append(unit(term)).append(" · ")
                    .append(shape(term));
        }
        return out.toString();
    }

    private String unit(Learned term) {
        return about ? Units.about(term.unit(), !(term.modulator() instanceof Modulator.None)) : term.unit();
    }

    /** What the coefficient multiplies; of a link about an axis thousandths of metres are those of radians. */
    private String shape(Learned term) {
        String text = (about ? term.formula().replace(" mm", " mrad") : term.formula())
                + modulator(term.modulator(), term instanceof LearnedLimited);
        return text.startsWith(NOTHING_ELSE) ? text.substring(NOTHING_ELSE.length()) : text;
    }

    /** What would show whether the law is right: what its first term goes by, changed by itself. */
    public String experiment() {
        Learned first = terms.get(0);
        String what = modulator(first.modulator() instanceof Modulator.PartOf part ? part.whole() : first.modulator(), true).strip();
        if (first.modulator() instanceof Modulator.Ride) {
            return "Hold each of two levels for a minute, one after the other: the law must follow the level, and as late as it says.";
        }
        if (first.modulator().otherLink().isPresent()) {
            return "Ride again with a weight of ten kilograms more above that link: the law goes by the " + what + ".";
        }
        if (!(first.modulator() instanceof Modulator.None)) {
            return "Ride the same again and change the " + what + " by itself, or hold it still: the law must follow it.";
        }
        if (first instanceof LearnedWave) {
            return "Ride the same again with the breath held, or to a beat of another frequency: the wave must go, or follow.";
        }
        if (first.byTheClock()) {
            return "Repeat the beginning at the end (A-B-A): what changed with time stays changed, what goes by the level comes back.";
        }
        if (first instanceof LearnedInertance) {
            return "Ride with more of what is fast: the force must grow with the square of the frequency, which nothing that is only "
                    + "late does.";
        }
        if (first.hasMemory()) {
            return "Load the link by a step and hold it: the force must fade as the memory says.";
        }
        return "Ride at three levels of at least 4 to 1 in all: the force must grow as the formula says, and not in proportion.";
    }

    /** Four digits; with a power of ten where zeros would have to be counted. */
    private static String number(double value) {
        int power = value > 0 ? (int) Math.floor(Math.log10(value)) : 0;
        if (power >= -3 && power < 5) {
            return new BigDecimal(value).round(DIGITS).toPlainString();
        }
        return new BigDecimal(value * Math.pow(10, -power)).round(DIGITS).toPlainString() + Units.timesTen(power);
    }

    private String modulator(Modulator modulator, boolean limited) {
        if (modulator instanceof Modulator.None) {
            return "";
        }
        return (limited ? " " : " × ") + (modulator.otherLink()
                .map(other -> modulator.toString().replace("link " + (other.link() + 1), model.links().get(other.link()).name()))
                .orElse(modulator.toString()));
    }
}
