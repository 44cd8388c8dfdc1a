package wbv.diagnosis;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import wbv.body.Learned;
import wbv.body.Model;
import wbv.body.Modulator;

/** A law that was learned, as people write it: {@code F = 1240 N/(m/s)² |v|v − 0.31 N/(m·N) r × load of seat-pelvis}. */
final class LearnedWords {

    private static final MathContext DIGITS = new MathContext(4);

    private final Model model;
    private final List<Learned> terms;

    /** @param model that holds the law @param where its link */
    LearnedWords(Model model, String where) {
        this.model = model;
        this.terms = model.links().stream().filter(link -> link.name().equals(where)).flatMap(link -> link.laws().stream())
                .filter(Learned.class::isInstance).map(Learned.class::cast).toList();
    }

    /** The formula of a law that a fit holds. */
    static String of(Model model, Fitter.State fit) {
        return new LearnedWords(Augmented.of(model, fit.candidate().at(fit.x())), fit.candidate().last().where()).formula();
    }

    List<Learned> terms() {
        return terms;
    }

    String formula() {
        StringBuilder out = new StringBuilder("F =");
        for (Learned term : terms) {
            boolean negative = term.coefficient() < 0;
            out.append(out.length() > 3 ? negative ? " − " : " + " : negative ? " −" : " ")
                    .append(new BigDecimal(Math.abs(term.coefficient())).round(DIGITS).toPlainString()).append(' ').append(term.unit()).append(" · ")
                    .append(term.formula()).append(modulator(term.modulator()));
        }
        return out.toString();
    }

    private String modulator(Modulator modulator) {
        if (modulator instanceof Modulator.None) {
            return "";
        }
        return " × " + (modulator instanceof Modulator.Load load ? "load of " + model.links().get(load.link()).name() : modulator.toString());
    }
}
