package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * A mechanism and a force on a body that nobody measured, fitted together: by itself neither shows what it is beside the other. A law that
 * is not linear answers to the force too, of which its free run knows nothing as long as the force is but ignored. So models are simulated
 * with the force as what a fit leaves along its direction shows it, and the two are found in turn.
 */
public final class PushedLaws {

    private final Evidence evidence;
    private final Fitter.State base;

    /**
     * On this evidence.
     *
     * @param base the model without any mechanism, fitted
     */
    public PushedLaws(Evidence evidence, Fitter.State base) {
        this.evidence = evidence;
        this.base = base;
    }

    /**
     * A mechanism, found beside a force.
     *
     * @param body on which that acts
     * @param force [N], by sample of the recording
     * @param fit of the mechanism, blind to whatever acts on that body
     */
    public record Found(int body, double[] force, Fitter.State fit) {}

    /**
     * The mechanism and the body that leave least, where they explain nearly all, and leave far less than the best mechanism by itself and
     * than whatever acts on that body by itself; empty where none does, or outputs are too few to show it.
     *
     * @param leaders mechanisms by themselves, least first
     */
    public Optional<Found> best(List<Fitter.State> leaders) {
        // What stands for a simulation leaves more of its own, which would pass for a force.
        if (evidence.standsForSimulation() || evidence.outputs().size() < Locator.FEWEST_OUTPUTS) {
            return Optional.empty();
        }
        double single = Stream.concat(leaders.stream().limit(1), Stream.of(base)).mapToDouble(Fitter.State::reduced).min().orElseThrow();
        List<Begun> first = sorted(Parallel.map(laws(leaders), start -> start.get().on(Effort.ROUNDS)));
        List<Begun> last = sorted(Parallel.map(first.stream().limit(Effort.LEADERS).toList(), begun -> begun.on(Effort.STEPS)));
        return last.stream().findFirst().filter(begun -> Refinement.explainsNearlyAll(base, begun.turn().fit()))
                .filter(begun -> Effort.BEHIND * Refinement.excess(begun.left()) < Refinement
                        .excess(Math.min(single, beside(begun.body()).reduced())))
                .map(begun -> new Found(begun.body(), begun.turn().force(0), begun.turn().fit()));
    }

    /** The laws that lead by themselves, beside each body. */
    private List<Supplier<Begun>> laws(List<Fitter.State> leaders) {
        Set<String> claims = leaders.stream().map(fit -> fit.candidate().last()).filter(Directions::isInLink)
                .filter(Hypothesis::runsFree).map(Hypothesis::claim).distinct().limit(Effort.SECONDS).collect(Collectors.toSet());
        List<Hypothesis> laws = new Search(evidence, (step, share) -> {}).hypotheses(base).stream()
                .filter(hypothesis -> claims.contains(hypothesis.claim())).toList();
        return IntStream.range(0, evidence.model().bodies().size()).boxed().flatMap(body -> starts(body, laws)).toList();
    }

    private Known.Ignoring beside(int body) {
        Place plain = new Place(Place.Kind.BODY, body).plain(base.candidate().template());
        return Locator.of(new Locator(evidence, base.candidate()).singles(base.x()), plain).orElseThrow();
    }

    private Stream<Supplier<Begun>> starts(int body, List<Hypothesis> laws) {
        Candidate baseline = base.candidate();
        Place place = new Place(Place.Kind.BODY, body);
        double[] x = place.plain(baseline.template()).asGiven(baseline, beside(body).x());
        return laws.stream().flatMap(law -> {
            Candidate with = baseline.with(law);
            return law.starts().stream().map(start -> () -> begun(place, with, baseline.extended(x, with, law, start.values())));
        });
    }

    private Begun begun(Place body, Candidate candidate, double[] x) {
        return new Begun(body.index(), new VariableProjection(evidence, List.of(body)).at(candidate, x));
    }

    private static List<Begun> sorted(List<Begun> all) {
        List<Begun> out = new ArrayList<>(all);
        out.sort(Comparator.comparingDouble(Begun::left));
        return out;
    }

    /** A law so far, beside a force on a body. */
    private record Begun(int body, VariableProjection.Turn turn) {

        double left() {
            return turn.fit().reduced();
        }

        Begun on(int turns) {
            return new Begun(body, turn.on(turns));
        }
    }
}
