package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.FittedScene;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Knob;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.mechanism.Family;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.ParameterError;
import wbv.diagnosis.search.Calibration;
import wbv.diagnosis.search.Chosen;
import wbv.diagnosis.search.Effort;
import wbv.diagnosis.search.OddSensor;
import wbv.diagnosis.search.OwnNumbers;
import wbv.diagnosis.search.Priors;
import wbv.diagnosis.search.Refinement;
import wbv.diagnosis.search.Screening;
import wbv.diagnosis.search.Search;
import wbv.diagnosis.search.Trial;
import wbv.diagnosis.search.Whereabouts;
import wbv.signal.ScalarProduct;

/**
 * What a model's own numbers imitate so well that the fit leaves no more than noise. That is no proof that nothing is missing: by how much
 * noise scatters is the same with and without a law, and what tells the two apart is only how much likelier one makes data that neither was
 * fitted to. A memory is imitated by a spring four times too stiff; of nulls the likeliest law makes one nat of that in the mean, three at
 * most, of a memory that relaxes in 0.06 s nineteen, see {@link Calibration}.
 *
 * <p>Those are asked first, and where one of them is likelier than the numbers alone, all that acts at its place, and all that swings or
 * answers late, is asked beside it. So near to the noise a score is χ² with one degree of freedom: who does not pay for the choice of one
 * name by that is not asked.
 */
final class Imitations {

    private final Evidence evidence;
    private final Search search;
    private final Refinement refinement;
    private final Map<Fitter.State, Double> known = new IdentityHashMap<>();

    Imitations(Evidence evidence, Search search) {
        this.evidence = evidence;
        this.search = search;
        this.refinement = search.refinement();
    }

    /** Fits, likeliest first, and how likely each claim is. */
    record Weighed(List<Fitter.State> fits, Posterior posterior) {

        /** That only the numbers of a model are wrong, told by the link that had to move farthest. */
        Diagnosis.Named asNumbers(Fitter.State base) {
            int at = springs(base).boxed().max(Comparator.comparingDouble(i -> Math.abs(base.x()[i]))).orElseThrow();
            Knob knob = base.candidate().knobs().get(at);
            return new Diagnosis.Named(new ParameterError().word(), knob.place(), posterior.of(Claim.VALUES),
                    Map.of(knob.key(), knob.value(base.x()[at])), Map.of(), base.reduced());
        }
    }

    /**
     * What is likelier than the model's numbers alone; empty where nothing is.
     *
     * @param base that leaves no more than noise, with its derivatives
     */
    public Optional<Weighed> in(Fitter.State base) {
        Motion motion = Motion.measured(evidence, base.candidate().at(base.x()));
        List<Hypothesis> all = evidence.library().hypotheses(FittedScene.of(evidence, base.candidate().at(base.x()), motion));
        double price = Chosen.price(all.stream());
        // Where no spring may have another stiffness, none imitates anything.
        List<Hypothesis> asked = springs(base).findAny().isEmpty() ? List.of()
                : all.stream().filter(hypothesis -> hypothesis.kind().isImitatedByNumbers()).toList();
        List<Hypothesis> heard = asked.isEmpty() ? asked : new Screening(evidence, base, motion).scores(asked).stream()
                .filter(score -> score.gain() > 2 * price).map(Screening.Score::hypothesis).toList();
        List<Fitter.State> fits = likelier(Parallel.map(heard, hypothesis -> fitted(base, hypothesis)), base, price);
        Fitter.State alone = fits.isEmpty() ? base : alone(base, fits);
        List<Fitter.State> likelier = likelier(fits, alone, price);
        return likelier.isEmpty() ? Optional.empty() : Optional.of(weighed(alone, likelier, price)).filter(Imitations::isImitated);
    }

    /** Which numbers of a fit are stiffnesses of links. */
    private static IntStream springs(Fitter.State base) {
        return IntStream.range(0, base.candidate().template().structure().links())
                .flatMap(link -> base.candidate().stiffness(link).stream());
    }

    private List<Fitter.State> likelier(List<Fitter.State> fits, Fitter.State than, double price) {
        return fits.stream().filter(fit -> evidence(fit, than) > price).toList();
    }

    /**
     * The numbers alone as well as they can do: near the noise a fit ends some nats before its best, and beside a law numbers go where the
     * same numbers without it are likelier too.
     */
    private Fitter.State alone(Fitter.State base, List<Fitter.State> fits) {
        int own = base.x().length;
        Stream<Fitter.State> again = Parallel.map(fits, fit -> refinement.polish(base.candidate(), Arrays.copyOf(fit.x(), own))).stream();
        Fitter.State best = Stream.concat(Stream.of(base), again).min(Comparator.comparingDouble(this::misfit)).orElseThrow();
        return search.fitter().lookWithSlopes(best.candidate(), best.x(), best.frame());
    }

    /** Whether what is likeliest is what numbers imitate: of anything else as weak as that another law at its place may be the truth. */
    private static boolean isImitated(Weighed found) {
        Fitter.State first = found.fits().get(0);
        return first.candidate().last().kind().isImitatedByNumbers() && found.posterior().ranked().get(0).equals(Standing.claim(first));
    }

    /** With one hypothesis, from the numbers that imitate it and from those that were given. */
    private Fitter.State fitted(Fitter.State base, Hypothesis hypothesis) {
        Candidate with = base.candidate().with(hypothesis);
        List<Fitter.State> looks = Trial.sorted(Stream.of(base.x(), base.candidate().start()).flatMap(from -> hypothesis.starts().stream()
                .map(start -> search.fitter().look(with, base.candidate().extended(from, with, hypothesis, start.values()), base.frame())))
                .toList());
        return refinement.polish(Trial
                .sorted(looks.stream().limit(Effort.SECONDS)
                        .map(look -> search.fitter().fit(with, look.x(), base.frame(), Effort.LAST_STEPS, Effort.EXACT)).toList())
                .get(0));
    }

    /**
     * Beside the best of what may be taken for it.
     *
     * @param imitated fits that are likelier than the base
     */
    private Weighed weighed(Fitter.State base, List<Fitter.State> imitated, double price) {
        Set<String> places = imitated.stream().map(fit -> fit.candidate().last().where()).collect(Collectors.toSet());
        Whereabouts where = Whereabouts.anywhere(evidence, base.candidate())
                .only(rival -> places.contains(rival.where()) || rival.kind().family() == Family.DYNAMIC);
        // A sensor that is later than sensors scatter looks like a memory, and a fit takes it for small errors of several.
        List<Fitter.State> fits = Stream.of(imitated.stream(), new OddSensor(evidence, search).in(base).stream(),
                search.leaders(base, Effort.LEADERS, where, 2 * price).stream().filter(fit -> !Refinement.extreme(fit)))
                .flatMap(Function.identity()).toList();
        Map<Fitter.State, Double> likelier = new LinkedHashMap<>();
        fits.forEach(fit -> likelier.put(fit, evidence(fit, base)));
        // No formula is quite right: what a simpler law at its place says nearly as well is not told from that, nor by how much it says
        // more.
        Map<Fitter.State, Double> alone = Map.copyOf(likelier);
        for (Fitter.State fit : fits) {
            double simpler = fits.stream().filter(other -> fit.candidate().last().yieldsTo(other.candidate().last()))
                    .mapToDouble(alone::get).max().orElse(0);
            if (simpler > Priors.MAJORITY * alone.get(fit)) {
                likelier.remove(fit);
            } else if (simpler > price) {
                likelier.put(fit, simpler);
            }
        }
        Map<Claim, Double> best = new LinkedHashMap<>();
        likelier.forEach((fit, nats) -> best.merge(Standing.claim(fit), nats, Math::max));
        List<Posterior.Weighed> claims = new ArrayList<>(List.of(new Posterior.Weighed(Claim.VALUES, Priors.MAJORITY, 0)));
        best.forEach((claim, nats) -> claims.add(new Posterior.Weighed(claim, Priors.MAJORITY * Math.exp(-price), nats)));
        List<Fitter.State> ranked = new ArrayList<>(likelier.keySet());
        ranked.sort(Comparator.comparingDouble(fit -> -likelier.get(fit)));
        return new Weighed(ranked, Posterior.of(claims).but(Calibration.standard().lapse(), Claim.UNKNOWN));
    }

    /**
     * Logarithm of the odds of a fit against another, by data that were not used, each seen through its own model's noise (Dawid 1984), and
     * by the model's own numbers [nat]. No model is quite right, so that of nulls too some law makes such data likelier: by what those make
     * in the mean, as chance is distributed that has no scale but its mean, data are weighed.
     */
    private double evidence(Fitter.State fit, Fitter.State than) {
        return evidence(fit) - evidence(than);
    }

    /** Each is looked at once, however many it is held against. */
    private double evidence(Fitter.State fit) {
        return known.computeIfAbsent(fit, each -> numbers(each) - misfit(each) / 2 / Calibration.standard().nulls());
    }

    /** What stands for a simulation has numbers that nobody gave. */
    private double numbers(Fitter.State fit) {
        return evidence.standsForSimulation() ? 0 : OwnNumbers.logPrior(search.fitter(), fit, 1 / Calibration.standard().nulls());
    }

    /** What data that were not used say against a fit: sum of squares of what is left of them and of the sensors' errors. */
    private double misfit(Fitter.State fit) {
        Fitter.State later = new Fitter(evidence, evidence.whole()).look(fit.candidate(), fit.x(), evidence.heldOut());
        return later.square() + ScalarProduct.of(later.errors(), later.errors());
    }
}
