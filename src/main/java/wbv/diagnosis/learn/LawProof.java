package wbv.diagnosis.learn;

import java.util.List;
import java.util.Optional;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.LearnedForce;
import wbv.diagnosis.search.Chosen;
import wbv.diagnosis.search.Effort;
import wbv.diagnosis.search.Fits;
import wbv.diagnosis.search.Priors;
import wbv.diagnosis.search.Refinement;
import wbv.diagnosis.search.Search;

/** Whether a law is asked for, and whether one that was fitted holds: on data that were not used, and against what is known without it. */
public final class LawProof {

    private final Evidence evidence;
    private final Search search;
    private final boolean correction;

    /** @param correction whether laws stand beside a name whose form they correct */
    LawProof(Evidence evidence, Search search, boolean correction) {
        this.evidence = evidence;
        this.search = search;
        this.correction = correction;
    }

    /**
     * Whether named physics, laws among it, leave more than noise, of data used or not, or are two at one place: then it may be another
     * law, which only looks like it, or like both together. What stands for a simulation carries no law quite as that would, so that there
     * a right one may leave more.
     *
     * @param heldOut what they leave of data not used, as a mean square of the whitened residual
     */
    public static boolean doubts(Fits named, double heldOut) {
        List<Hypothesis> added = named.best().candidate().added();
        boolean physics = !added.isEmpty() && added.stream().allMatch(term -> !Place.of(term).isSensor())
                && added.stream().anyMatch(Hypothesis::isLaw);
        return physics && (isTwofold(named) || (named.evidence().standsForSimulation() ? leavesMuch(named)
                : Math.max(named.best().reduced(), heldOut) > Priors.SILENT));
    }

    /** Whether two are named at one place. */
    public static boolean isTwofold(Fits named) {
        List<Hypothesis> added = named.best().candidate().added();
        return added.stream().map(Place::of).distinct().count() < added.size();
    }

    /**
     * What terms beside a name may leave, to first order, where what holds has to take most of what the name leaves [1]: half of that gain
     * has to show. Of what may be noise as much has to go as of the least that is not.
     */
    static double within(Evidence evidence, Fitter.State named) {
        double floor = evidence.floor();
        double excess = Math.max(named.reduced() - floor, (Priors.SILENT - 1) * floor);
        return named.reduced() - Priors.MAJORITY / Effort.ALIKE * excess;
    }

    /**
     * Whether a named law in a link leaves more than a right one may: then its form may be not quite the library's. Where noise is only
     * bounded, all that is left may be that.
     */
    public static boolean lacks(Fits named) {
        List<Hypothesis> added = named.best().candidate().added();
        return (named.evidence().floor() < 1 || leavesMuch(named)) && added.stream().anyMatch(Hypothesis::isLaw)
                && added.stream().noneMatch(part -> part.kind() instanceof LearnedForce);
    }

    /** Whether more than noise is left, and more than a formula that is right may leave. */
    private static boolean leavesMuch(Fits named) {
        return named.best().reduced() > Math.max(Priors.SILENT, Refinement.form(named.base()));
    }

    /**
     * The best law, if it holds on data that were not used: by itself it leaves no more of what is missing there than a right name may, or
     * less than half of what a name leaves. Beside a name of more parts than it has terms it need not leave less. Beside any name its
     * evidence has to be greater.
     *
     * @param sentences most evident first
     * @param name what is known without it: the model alone, or with what was named
     */
    Optional<Sentence> law(List<Sentence> sentences, Chosen name) {
        Fitter.State than = name.fit();
        int parts = than.candidate().added().size();
        // What leaves more than the name by far does not come to leave less by polishing.
        double reach = parts == 0 ? Double.POSITIVE_INFINITY : evidence.floor() + Effort.ALIKE * (than.reduced() - evidence.floor());
        List<Sentence> near = sentences.stream().filter(Sentence::shows).limit(Effort.LEADERS)
                .filter(sentence -> sentence.fit().reduced() < reach).toList();
        return Parallel.map(near, sentence -> sentence.fitted(search.refinement().polish(sentence.fit()))).stream()
                .filter(sentence -> {
                    boolean evident = parts == 0 || correction || outweighs(sentence, name);
                    return evident && (sentence.fit().candidate().added().size() < parts
                            || (correction && evidence.floor() < 1 ? foretells(sentence.fit(), than) : holds(sentence.fit(), than)));
                }).findFirst();
    }

    /**
     * Whether a sentence is likelier than a name, as pairs of names are compared: beyond the first name, the choice of every term and of
     * every name costs.
     */
    private boolean outweighs(Sentence sentence, Chosen name) {
        double price = sentence.words().price(sentence.terms()) - Math.log(evidence.library().mechanisms().size());
        return search.refinement().outweighs(new Chosen(sentence.fit(), Math.max(0, price)), name);
    }

    /** Whether a fit leaves as little of what is missing without it as a law may, on data used and not used. */
    private boolean holds(Fitter.State fit, Fitter.State than) {
        double floor = evidence.floor();
        double share = than.candidate().added().isEmpty() ? Priors.UNLISTED : Priors.MAJORITY;
        return fit.reduced() - floor < share * (than.reduced() - floor)
                && search.refinement().heldOut(fit) - floor < share * (search.refinement().heldOut(than) - floor);
    }

    /** Whether a fit leaves less on data not used by more than chance. */
    private boolean foretells(Fitter.State fit, Fitter.State than) {
        Fitter later = new Fitter(evidence, evidence.whole());
        return Forecasts.of(later.look(fit.candidate(), fit.x(), evidence.heldOut()),
                later.look(than.candidate(), than.x(), later.frame(fit.candidate(), fit.x(), evidence.heldOut()))).isBetter();
    }
}
