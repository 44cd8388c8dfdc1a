package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.Model;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.Place;

/**
 * A mechanism and a force on a body that nobody measured, found together: by itself neither shows what it is beside the other. A law that
 * is not linear answers to the force too, of which its free run knows nothing as long as the force is but ignored. What enters at a body
 * and at another place, both ignored, tells the force before any law is known: models are simulated with it, mechanisms race at the other
 * place, and the best are fitted with the force in turn.
 */
public final class PushedLaws {

    private final Evidence evidence;
    private final Search search;
    private final Fitter.State base;
    private final Candidate baseline;

    /**
     * On this evidence.
     *
     * @param base the model without any mechanism, fitted
     */
    public PushedLaws(Evidence evidence, Search search, Fitter.State base) {
        this.evidence = evidence;
        this.search = search;
        this.base = base;
        this.baseline = base.candidate();
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
     * A pair of places.
     *
     * @param body where a force may act
     * @param others places that no output tells apart, where a mechanism may
     * @param x where the model fits beside both: coordinates [1], one a knob
     */
    private record Way(Place body, List<Place> others, double[] x) {}

    /** A mechanism so far, beside a force on a body [N], by sample of the recording. */
    private record Begun(Place body, double[] force, Fitter.State fit) {}

    /**
     * The mechanism and the body that leave least, where they leave far less than the best mechanism by itself and than whatever acts on
     * that body by itself; empty where none does, or outputs are too few to show it.
     *
     * @param leaders mechanisms by themselves, least first
     */
    public Optional<Found> best(List<Fitter.State> leaders) {
        // What stands for a simulation leaves more of its own, which would pass for a force.
        if (evidence.standsForSimulation() || evidence.outputs().size() < Locator.FEWEST_OUTPUTS) {
            return Optional.empty();
        }
        double single = Stream.concat(leaders.stream(), Stream.of(base)).mapToDouble(Fitter.State::reduced).min().orElseThrow();
        return ways().stream().map(way -> begun(way, leaders)).flatMap(Optional::stream)
                .sorted(Comparator.comparingDouble(begun -> begun.fit().reduced())).limit(Effort.LEADERS).map(this::fitted)
                .min(Comparator.comparingDouble(found -> found.fit().reduced()))
                .filter(found -> Effort.BEHIND * Refinement.excess(found.fit().reduced()) < Refinement.excess(single))
                .filter(this::isNeeded);
    }

    /** Near pairs of places of which one is a body: of twins the heaviest, on which a force shows no more than on the others. */
    private List<Way> ways() {
        TwoPlaces places = new TwoPlaces(evidence, search, base, (step, share) -> {});
        NearPairs near = NearPairs.of(evidence, base, places.pairs(places.looked(places.likeliest())));
        Map<List<Place>, Way> out = new LinkedHashMap<>();
        for (Known.Ignoring pair : near.pairs()) {
            for (int i = 0; i < pair.places().size(); i++) {
                List<Place> others = near.twins().of(pair.places().get(1 - i));
                heaviest(near.twins().of(pair.places().get(i))).filter(body -> !others.contains(body.plain(baseline.template())))
                        .ifPresent(body -> out.putIfAbsent(List.of(body, others.get(0)), new Way(body, others, pair.x())));
            }
        }
        return List.copyOf(out.values());
    }

    private Optional<Place> heaviest(List<Place> twins) {
        List<Model.Body> bodies = evidence.model().bodies();
        return IntStream.range(0, bodies.size()).mapToObj(body -> new Place(Place.Kind.BODY, body))
                .filter(place -> twins.contains(place.plain(baseline.template())))
                .max(Comparator.comparingDouble(place -> bodies.get(place.index()).mass()));
    }

    /**
     * The mechanism that fits best where models are simulated with the force that the two places tell: the one that races best along the
     * measured motion, or one that leads by itself, since along the little that a stiff link moves sensors that err tell no law.
     */
    private Optional<Begun> begun(Way way, List<Fitter.State> leaders) {
        List<Place> both = Stream.concat(Stream.of(way.body()), way.others().stream().limit(1)).toList();
        double[] force = new VariableProjection(evidence, both).at(baseline, way.x()).force(0);
        Search blind = new Search(evidence.pushed(way.body().index(), force).ignoring(way.body()), (step, share) -> {});
        Stream<Fitter.State> leading = leaders.stream().limit(Effort.LEADERS).filter(leader -> way.others().contains(Place.ofLast(leader)))
                .map(leader -> blind.refinement().begun(leader.candidate(), Candidate.standing(leader.x(), way.x())));
        return Stream.concat(blind.racedAsMeasured(baseline, way.x(), search.hypotheses(base, way.others()::contains)).stream(), leading)
                .min(Comparator.comparingDouble(Fitter.State::reduced)).map(fit -> new Begun(way.body(), force, fit));
    }

    /** Mechanism and force in turn, begun with the force that the places told and as the mechanism tells it, whichever leads further. */
    private Found fitted(Begun begun) {
        VariableProjection beside = new VariableProjection(evidence, List.of(begun.body()));
        Candidate with = begun.fit().candidate();
        double[] x = begun.fit().x();
        VariableProjection.Turn turn = Stream.of(beside.at(with, x, begun.force()), beside.at(with, x)).map(each -> each.on(Effort.STEPS))
                .min(Comparator.comparingDouble(each -> each.fit().reduced())).orElseThrow();
        return new Found(begun.body().index(), turn.force(0), turn.fit());
    }

    /** Whether whatever acts on the body by itself leaves more than noise, of which the mechanism takes most. */
    private boolean isNeeded(Found found) {
        Place body = new Place(Place.Kind.BODY, found.body());
        VariableProjection beside = new VariableProjection(evidence, List.of(body));
        List<double[]> starts = new ArrayList<>(List.of(Arrays.copyOf(found.fit().x(), base.x().length)));
        Locator.of(new Locator(evidence, baseline).singles(base.x()), body.plain(baseline.template())).map(Known.Ignoring::x)
                .ifPresent(starts::add);
        double alone = starts.stream().mapToDouble(x -> beside.base(baseline, x).fit().reduced()).min().orElseThrow();
        return alone > Priors.SILENT && Effort.BEHIND * (found.fit().reduced() - 1) < alone - 1;
    }
}
