package wbv.diagnosis.learn;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.search.Effort;
import wbv.diagnosis.search.Search;
import wbv.diagnosis.search.Trial;

/** Fits of laws by free run: a few steps for what is proposed, more for what leads then. */
final class LawFits {

    private final Evidence evidence;
    private final Search search;
    private final Fitter.State base;

    /** @param base on which all laws stand */
    LawFits(Evidence evidence, Search search, Fitter.State base) {
        this.evidence = evidence;
        this.search = search;
        this.base = base;
    }

    /**
     * Many terms begun on a part of the data that is shaken hard, where such a part tells, and the best of them fitted on there; as they
     * stand on all of the data.
     *
     * @param scored on all of them
     */
    List<Fitter.State> begunInPart(Fitter.State scored, Sentences sentences, List<Sentences.Proposal> terms) {
        if (terms.isEmpty()) {
            return List.of();
        }
        Optional<Trial.Ground> part = search.refinement().brief(base);
        Fitter fitter = part.map(Trial.Ground::fitter).orElse(search.fitter());
        Fitter.State there = part.map(ground -> fitter.lookWithSlopes(scored.candidate(), scored.x(), ground.base().frame()))
                .orElse(scored);
        List<Fitter.State> left = Parallel.map(terms, term -> begun(fitter, there, sentences, term)).stream()
                .filter(state -> !state.failed()).sorted(Comparator.comparingDouble(Fitter.State::reduced))
                .limit(terms.size() / Effort.ONE_IN).toList();
        List<Fitter.State> further = Parallel.map(left,
                state -> fitter.fit(state.candidate(), state.x(), there.frame(), Effort.STEPS, Effort.ENOUGH));
        return part.isEmpty() ? further
                : Parallel.map(further, state -> search.fitter().look(state.candidate(), state.x(), scored.frame()));
    }

    /**
     * The first steps from what is proposed; from less of it where that much is not stable.
     *
     * @param scored what the law is to stand on, as the fitter sees it, with derivatives
     */
    static Fitter.State begun(Fitter fitter, Fitter.State scored, Sentences sentences, Sentences.Proposal proposal) {
        Candidate with = scored.candidate();
        for (Hypothesis term : proposal.terms()) {
            with = with.with(term);
        }
        double[] x = sentences.start(proposal, with);
        Fitter.State state = fitter.look(with, x, scored.frame());
        for (int half = 0; half < Effort.TRIES && state.failed(); half++) {
            for (Hypothesis term : proposal.terms()) {
                int[] at = with.positions(term);
                for (int i = 0; i < at.length; i++) {
                    x[at[i]] *= with.knobs().get(at[i]).unit() == 0 ? 1 : 0.5;
                }
            }
            state = fitter.look(with, x, scored.frame());
        }
        return state.failed() ? state : fitter.fit(with, x, scored, runsFree(with) ? Effort.FIRST_STEPS : Effort.LAST_STEPS, Effort.ENOUGH);
    }

    /** Fitted on, in the whitening of its own model. */
    Fitter.State settled(Fitter.State state) {
        Fitter fitter = search.fitter();
        return state.failed() ? state : fitter.fit(state.candidate(), state.x(), fitter.frame(state.candidate(), state.x(), evidence.fit()),
                runsFree(state.candidate()) ? Effort.STEPS : Effort.LAST_STEPS, Effort.ENOUGH);
    }

    private static boolean runsFree(Candidate candidate) {
        return candidate.added().stream().anyMatch(Hypothesis::runsFree);
    }

    /**
     * A fit with other terms on the base, settled.
     *
     * @param from terms of the fit
     * @param to others, as many: each begins with the numbers of the one in its place, those that this has not at its own start
     */
    Fitter.State changed(Fitter.State fit, List<Hypothesis> from, List<Hypothesis> to) {
        Candidate with = base.candidate();
        for (Hypothesis each : to) {
            with = with.with(each);
        }
        double[] x = Arrays.copyOf(fit.x(), with.knobs().size());
        for (int t = 0; t < to.size(); t++) {
            int[] target = with.positions(to.get(t));
            int[] source = fit.candidate().positions(from.get(t));
            double[] start = to.get(t).starts().get(0).values();
            for (int i = 0; i < target.length; i++) {
                x[target[i]] = i < source.length ? fit.x()[source[i]] : with.knobs().get(target[i]).coordinate(start[i]);
            }
        }
        return settled(search.fitter().look(with, x, base.frame()));
    }
}
