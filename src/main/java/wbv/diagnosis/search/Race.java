package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
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
        List<Trial> last = ahead(heat, Effort.CONTENDERS, promising);
        return last.stream().map(Trial::ground).distinct().count() == 1 ? last
                : Parallel.map(last, trial -> trial.ground() == whole ? trial
                        : new Trial(whole, List.of(trial.on(whole))).onward(1)).stream().sorted(LEAST).toList();
    }

    /**
     * Those that are not given up yet or promise much, and the first of another name in any case, which tells what the name of the first
     * is worth.
     */
    private List<Trial> ahead(List<Trial> trials, int most, Predicate<Trial> promising) {
        List<Trial> sorted = trials.stream().filter(trial -> !trial.first().failed()).sorted(LEAST).toList();
        List<Trial> out = new ArrayList<>(alike(sorted).flatMap(same -> near(same, most)).toList());
        sorted.stream().filter(trial -> promising.test(trial) && !out.contains(trial)).forEach(out::add);
        if (out.stream().map(trial -> claims(trial.first())).distinct().count() == 1) {
            sorted.stream().filter(trial -> !claims(trial.first()).equals(claims(out.get(0).first()))).findFirst().ifPresent(out::add);
        }
        out.sort(LEAST);
        return out;
    }

    /**
     * Those that race on the same data: how much of a part is left says nothing of what goes by the clock, which is not in it. Those of
     * which the first is hopeless on all data are left out.
     */
    private Stream<List<Trial>> alike(List<Trial> sorted) {
        List<List<Trial>> same = Stream.of(whole, brief).distinct()
                .map(ground -> sorted.stream().filter(trial -> trial.ground() == ground).toList()).filter(some -> !some.isEmpty()).toList();
        if (same.size() < 2) {
            return same.stream();
        }
        double[] left = same.stream().mapToDouble(some -> Refinement.excess(some.get(0).on(whole).reduced())).toArray();
        double reach = Effort.HOPELESS * Arrays.stream(left).min().orElseThrow();
        return IntStream.range(0, left.length).filter(i -> left[i] <= reach).mapToObj(same::get);
    }

    /** @param same least first */
    private static Stream<Trial> near(List<Trial> same, int most) {
        double reach = Effort.HOPELESS * same.get(0).excess();
        return same.stream().limit(most).takeWhile(trial -> trial.excess() <= reach);
    }

    /** Names of what comes to what a fit stands on. */
    Set<String> claims(Fitter.State fit) {
        return fit.candidate().added().stream().skip(whole.base().candidate().added().size()).map(Hypothesis::claim)
                .collect(Collectors.toSet());
    }
}
