package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * Fewer and fewer fits, a few steps further each time: on a part of the data where that is enough to tell which are worth the whole, see
 * {@link Refinement#brief}.
 *
 * @param whole all data, with the base that all of them stand on
 * @param brief a part of them, or the same
 */
record Race(Trial.Ground whole, Trial.Ground brief) {

    private static final Comparator<Trial> LEAST = Comparator.comparingDouble(Trial::cost);

    /** @param base with its derivatives */
    static Race on(Fitter.State base, Refinement refinement, Fitter fitter) {
        Trial.Ground whole = Trial.Ground.of(fitter, base);
        return new Race(whole, refinement.brief(base).orElse(whole));
    }

    /** Where a candidate races. */
    Trial.Ground ground(Candidate candidate) {
        return candidate.added().stream().anyMatch(Hypothesis::byTheClock) ? whole : brief;
    }

    /**
     * The last few, two names among them, best first; none that failed.
     *
     * @param begun in any order
     * @param promising which stay in the race wherever they stand: what has farther to go stands behind after as many steps
     */
    List<Trial> last(List<Trial> begun, Predicate<Trial> promising) {
        List<Trial> heat = begun;
        for (int left = Effort.CONTENDERS; left >= Effort.PLACES; left /= 2) {
            heat = Parallel.map(ahead(heat, left, promising), trial -> trial.onward(Effort.SECONDS));
        }
        return ahead(heat, Effort.CONTENDERS, promising);
    }

    /**
     * Those that are not given up yet or promise much, and the first of another name in any case, which tells what the name of the first
     * is worth.
     */
    private List<Trial> ahead(List<Trial> trials, int most, Predicate<Trial> promising) {
        List<Trial> sorted = trials.stream().filter(trial -> !trial.first().failed()).sorted(LEAST).toList();
        double reach = sorted.isEmpty() ? 0 : Effort.HOPELESS * sorted.get(0).excess();
        List<Trial> out = new ArrayList<>(sorted.stream().limit(most).takeWhile(trial -> trial.excess() <= reach).toList());
        sorted.stream().filter(trial -> promising.test(trial) && !out.contains(trial)).forEach(out::add);
        if (out.stream().map(trial -> claims(trial.first())).distinct().count() == 1) {
            sorted.stream().filter(trial -> !claims(trial.first()).equals(claims(sorted.get(0).first()))).findFirst().ifPresent(out::add);
        }
        out.sort(LEAST);
        return out;
    }

    /** Names of what comes to what a fit stands on. */
    Set<String> claims(Fitter.State fit) {
        return fit.candidate().added().stream().skip(whole.base().candidate().added().size()).map(Hypothesis::claim)
                .collect(Collectors.toSet());
    }
}
