package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.stream.Stream;
import wbv.body.Assembly;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Mechanism;

/**
 * The search for two mechanisms at once. Each hides the other: with one of them missing, the fit bends the model to make up for it. So
 * two places are looked for that explain together what is left, and each mechanism is found while whatever acts at the other place is
 * ignored. Where sensors are too few for that, a second is added to the best first ones. What is found is compared as all else is: a second
 * part pays for having been chosen among all that could stand there, see {@link Chosen}.
 */
public final class PairSearch {

    /** The least that counts as an excess. */
    public static final double QUIET = Refinement.excess(1);

    private final Evidence evidence;
    private final Search search;
    private final Refinement refinement;
    private final Fitter.State base;
    private final List<Hypothesis> all;
    private final TwoPlaces places;
    private final FirstMechanisms firsts;

    /**
     * Lists the hypotheses; nothing is simulated but the base.
     *
     * @param base the model without any mechanism, fitted
     */
    public PairSearch(Evidence evidence, Search search, Fitter.State base, BiConsumer<String, Double> progress) {
        this.evidence = evidence;
        this.search = search;
        this.refinement = search.refinement();
        this.base = base;
        this.places = new TwoPlaces(evidence, search, base, progress);
        this.firsts = new FirstMechanisms(evidence, refinement, base, places);
        this.all = search.hypotheses(base);
    }

    /**
     * The likelier of the best single mechanism and the best pair.
     *
     * @param leaders single hypotheses on top of base, best first
     */
    public Chosen best(Fitter.State single, List<Fitter.State> leaders) {
        return evidence.outputs().size() == 1 || Place.ofLast(single).isAllThatMeasures(evidence) ? atOneOutput(single, leaders)
                : atTwo(single).orElseGet(() -> byPlaces(single, leaders));
    }

    /**
     * To one output every place explains everything, so that whatever is added anywhere makes up for what the formula of a law lacks:
     * beside a law that leaves no more than its form may, nothing is sought. Nor does ignoring a device that reads all outputs leave any
     * that tells of places.
     */
    private Chosen atOneOutput(Fitter.State single, List<Fitter.State> leaders) {
        return single.candidate().last().isLaw() && single.reduced() < Refinement.form(base) ? Chosen.single(single)
                : likeliest(single, oneByOne(single, leaders, hypothesis -> true));
    }

    /** The pair that leaves far less than whatever enters at any one place, where that outweighs the single one. */
    private Optional<Chosen> atTwo(Fitter.State single) {
        return firsts.atTwo().map(fit -> new Chosen(fit, price(hypothesis -> true)))
                .filter(pair -> refinement.outweighs(pair, Chosen.single(single))).map(pair -> likeliest(single, List.of(pair)));
    }

    private Chosen byPlaces(Fitter.State single, List<Fitter.State> leaders) {
        Place own = Place.ofLast(single);
        TwoPlaces.Looked looked = places.looked(own);
        boolean blind = looked.locator().isBlindToTwo();
        double alone = Refinement.excess(Locator.left(looked.singles(), own));
        // Where nothing more than noise is left beside a place no pair of places leaves less; nor need one be asked for where all enters at
        // one, whatever mechanism that is.
        boolean one = alone <= QUIET || !blind && Refinement.explained(base, single) < Priors.MAJORITY
                && places.atOne(looked.singles().get(0)) && firsts.atTwo().isEmpty();
        if (!one && !blind && firsts.leavesScatter(single)) {
            return likeliest(single, oneByOne(single, List.of(single), hypothesis -> true));
        }
        List<Known.Ignoring> pairs = one ? List.of() : places.pairs(looked);
        // No form that a law may have there makes up for what shows elsewhere: that there is a second needs no evidence of its own.
        return one || !blind && TwoPlaces.needless(own, alone, pairs) ? beside(single)
                : amongPairs(single, leaders, pairs, blind, !blind && alone > places.scatter());
    }

    /**
     * The likelier of a single mechanism and of those at pairs of places.
     *
     * @param blind whether sensors are too few to tell pairs of places
     * @param two   whether there is a second in any case
     */
    private Chosen amongPairs(Fitter.State single, List<Fitter.State> leaders, List<Known.Ignoring> pairs, boolean blind, boolean two) {
        List<Chosen> apart = places.pair(pairs).map(fit -> new Chosen(fit, two ? 0 : price(hypothesis -> true))).stream().toList();
        return !blind || apart.stream().anyMatch(pair -> refinement.outweighs(pair, Chosen.single(single))) ? likeliest(single, apart)
                : likeliest(single, Stream.concat(oneByOne(single, leaders, hypothesis -> true).stream(), apart.stream()).toList());
    }

    /**
     * The likelier of a single mechanism and one with a second at its own place, or hidden behind it: what a law leaves to another law is
     * its form.
     */
    private Chosen beside(Fitter.State single) {
        Place own = Place.ofLast(single);
        boolean law = single.candidate().last().isLaw();
        Assembly assembly = base.candidate().template();
        return likeliest(single, oneByOne(single, List.of(single), hypothesis -> own.hides(place(hypothesis), assembly)
                || place(hypothesis).equals(own) && !(law && hypothesis.isLaw())));
    }

    /**
     * The first mechanisms by themselves, least first, see {@link FirstMechanisms}.
     *
     * @param sought those that are sought by themselves
     * @param isOneLaw whether one law at one place does what the best of them does not
     */
    public List<Fitter.State> leaders(Supplier<List<Fitter.State>> sought, Predicate<Fitter.State> isOneLaw) {
        return firsts.leaders(sought, isOneLaw);
    }

    /**
     * Whether two mechanisms at two places explain nearly all where no one place will do, or take what a force that nobody measured might
     * make beside a single one: nothing hides what else is missing then.
     */
    public boolean isEnough(Fitter.State single) {
        return firsts.isPair(single);
    }

    /** The pair along what was measured that leaves less than a single mechanism; empty where none does. */
    public Optional<Chosen> leavingLess(Fitter.State single) {
        return firsts.measured(single).map(fit -> new Chosen(fit, price(hypothesis -> true)));
    }

    /** Whether two mechanisms at two places leave far less than whatever enters at any one of them. */
    public boolean isAtTwo() {
        return firsts.atTwo().isPresent();
    }

    /** Whether more than noise is left elsewhere than where a mechanism acts, whatever that does there. */
    public boolean showsElsewhere(Fitter.State single) {
        return new Locator(evidence, base.candidate()).among(List.of(Place.ofLast(single)), base.x()).stream()
                .anyMatch(found -> Refinement.excess(found.reduced()) > QUIET);
    }

    /** The likelier of a single mechanism and one with a second that was sought at some places alone. */
    Chosen beside(Fitter.State single, Fitter.State pair, Set<Place> places) {
        return likeliest(single, List.of(new Chosen(pair, price(hypothesis -> places.contains(place(hypothesis))))));
    }

    private Place place(Hypothesis hypothesis) {
        return Place.plain(hypothesis, base.candidate());
    }

    private double price(Predicate<Hypothesis> open) {
        return Chosen.price(all.stream().filter(open));
    }

    /** The likeliest of a single mechanism, of pairs, and of what each part of the best pair does by itself. */
    private Chosen likeliest(Fitter.State single, List<Chosen> pairs) {
        Chosen best = Chosen.single(single);
        for (Chosen pair : pairs) {
            best = refinement.outweighs(pair, best) ? pair : best;
        }
        List<Hypothesis> parts = best.fit() == single ? List.of() : best.fit().candidate().added();
        Chosen pair = best;
        return parts.stream().map(part -> Chosen.single(firsts.alone(part, pair.fit()))).filter(part -> !refinement.outweighs(pair, part))
                .min(Comparator.comparingDouble(part -> part.fit().cost())).orElse(best);
    }

    /**
     * A second mechanism on top of each of the best firsts.
     *
     * @param partners what may stand beside a first
     */
    private List<Chosen> oneByOne(Fitter.State single, List<Fitter.State> leaders, Predicate<Hypothesis> partners) {
        List<Chosen> out = new ArrayList<>();
        for (Fitter.State first : leaders.subList(0, Math.min(Effort.SECONDS, leaders.size()))) {
            if ((out.isEmpty() || Refinement.excess(least(out).fit().reduced()) > QUIET)
                    && (first == single || first.cost() < base.cost())) {
                beside(first, partners).ifPresent(out::add);
            }
        }
        if (!out.isEmpty() && Refinement.excess(least(out).fit().reduced()) > QUIET) {
            // The first was chosen while the second was still missing: once more, the other way round.
            Fitter.State second = firsts.alone(least(out).fit().candidate().last(), least(out).fit());
            beside(second, partners).ifPresent(out::add);
        }
        return out;
    }

    private static Chosen least(List<Chosen> pairs) {
        return pairs.stream().min(Comparator.comparingDouble(pair -> pair.fit().reduced())).orElseThrow();
    }

    /** The best second mechanism, sought where something still enters that the first does not explain. */
    private Optional<Chosen> beside(Fitter.State first, Predicate<Hypothesis> partners) {
        if (!Double.isFinite(first.cost())) {
            return Optional.empty();   // a run that left all bounds has nothing to be found beside it
        }
        return search.best(first, Whereabouts.found(evidence, first).only(partners.and(second -> !isForm(second, first))))
                .map(fit -> new Chosen(fit, price(partners)));
    }

    /** Whether what a hypothesis adds is a form of what a fit has at that place. */
    private boolean isForm(Hypothesis second, Fitter.State first) {
        Mechanism.Together one = second.kind().together();
        return one != Mechanism.Together.TWO && one == first.candidate().last().kind().together()
                && place(second).equals(Place.ofLast(first));
    }
}
