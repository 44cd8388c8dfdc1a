package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * Fewer and fewer fits, a few steps further each time.
 *
 * @param fitter for what lies near the base
 * @param base what all of them stand on
 */
record Race(Fitter fitter, Fitter.State base) {

    /**
     * The last few, two names among them, best first; none that failed.
     *
     * @param begun in any order
     */
    List<Fitter.State> last(List<Fitter.State> begun) {
        List<Fitter.State> heat = begun;
        for (int left = Effort.CONTENDERS; left >= Effort.PLACES; left /= 2) {
            heat = Parallel.map(ahead(heat, left),
                    fit -> fitter.fit(fit.candidate(), fit.x(), fit.frame(), Effort.SECONDS, Effort.ROUGH));
        }
        return ahead(heat, Effort.CONTENDERS);
    }

    /** Those that are not given up yet, and the first of another name in any case, which tells what the name of the first is worth. */
    private List<Fitter.State> ahead(List<Fitter.State> fits, int most) {
        List<Fitter.State> sorted = Trial.sorted(fits).stream().filter(fit -> !fit.failed()).toList();
        double reach = sorted.isEmpty() ? 0 : Effort.HOPELESS * Refinement.excess(sorted.get(0).reduced());
        List<Fitter.State> out = new ArrayList<>(
                sorted.stream().limit(most).takeWhile(fit -> Refinement.excess(fit.reduced()) <= reach).toList());
        if (out.stream().map(this::claims).distinct().count() == 1) {
            sorted.stream().filter(fit -> !claims(fit).equals(claims(sorted.get(0)))).findFirst().ifPresent(out::add);
        }
        return out;
    }

    /** Names of what comes to what a fit stands on. */
    Set<String> claims(Fitter.State fit) {
        return fit.candidate().added().stream().skip(base.candidate().added().size()).map(Hypothesis::claim).collect(Collectors.toSet());
    }
}
