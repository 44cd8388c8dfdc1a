package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import wbv.body.law.Learned;
import wbv.diagnosis.fit.BodyForce;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.search.Calibration;
import wbv.diagnosis.search.Chosen;
import wbv.diagnosis.search.Effort;
import wbv.diagnosis.search.Fits;
import wbv.diagnosis.search.Locator;
import wbv.diagnosis.search.PairRivals;
import wbv.diagnosis.search.Priors;
import wbv.diagnosis.search.Refinement;
import wbv.diagnosis.search.Search;
import wbv.diagnosis.search.SecondMechanism;

/** What is concluded of hypotheses that were fitted: the best of them, with a second only if it must be, and the verdict on it. */
final class Conclusion {

    private final Inquiry inquiry;
    private final Evidence evidence;
    private final Search search;
    private final Refinement refinement;
    private final Fitter.State base;

    private Conclusion(Inquiry inquiry) {
        this.inquiry = inquiry;
        this.evidence = inquiry.evidence();
        this.search = inquiry.search();
        this.refinement = inquiry.refinement();
        this.base = inquiry.base();
    }

    /** @param leaders fits with one hypothesis each, least first; none where nothing is to be named */
    static Diagnosed of(Inquiry inquiry, List<Fitter.State> leaders) {
        return new Conclusion(inquiry).of(leaders);
    }

    private Diagnosed of(List<Fitter.State> leaders) {
        List<Fitter.State> fits = carried(leaders);
        Chosen first = fits.isEmpty() ? Chosen.single(base) : chosen(simplest(fits), fits);
        return withOwnForce(first, fits).orElseGet(() -> of(first, fits));
    }

    /**
     * The conclusion that knows of a person's own force beside two mechanisms, which shows in what both leave and hides the second while
     * nobody knows it, or while more is taken for it than it is; empty where there is none, or it lets no pair outweigh a single mechanism
     * that did.
     */
    private Optional<Diagnosed> withOwnForce(Chosen chosen, List<Fitter.State> fits) {
        int parts = chosen.fit().candidate().added().size();
        Optional<Chosen> pair = parts > 1 ? Optional.of(chosen)
                : parts == 1 && chosen.fit().reduced() > Priors.STRANGE && BodyForce.mayAct(evidence) && !inquiry.isOneLaw(chosen.fit())
                        ? inquiry.pairs().leavingLess(chosen.fit()) : Optional.empty();
        Optional<Conclusion> known = Optional.of(this).filter(itself -> parts == 1 && evidence.acting().own().isPresent());
        return pair.flatMap(two -> inquiry.own(two.fit()).map(force -> new Conclusion(inquiry.knowing(force))).or(() -> known)
                .flatMap(knowing -> knowing.again(two, fits, parts > 1)));
    }

    /**
     * The conclusion where more counts as noise than where a pair was found.
     *
     * @param asked whether it is asked for where the pair does not outweigh single mechanisms
     */
    private Optional<Diagnosed> again(Chosen pair, List<Fitter.State> leaders, boolean asked) {
        List<Fitter.State> fits = inquiry.again(leaders);
        Chosen single = Chosen.single(simplest(fits));
        Chosen two = new Chosen(refinement.polish(pair.fit()), pair.price());
        boolean outweighs = refinement.outweighs(two, single);
        return outweighs || asked ? Optional.of(of(outweighs ? two : single, fits)) : Optional.empty();
    }

    /** @param fits single mechanisms, of which the first may be one */
    private Diagnosed of(Chosen first, List<Fitter.State> fits) {
        PairRivals rivals = new PairRivals(evidence, search, base);
        List<Fitter.State> pairs = rivals.with(first.fit());
        Chosen chosen = rivals.likeliest(first, pairs);
        List<Fitter.State> all = Stream.concat(fits.stream(), pairs.stream()).toList();
        inquiry.progress().accept("proving", 0.9);
        Standing standing = Standing.of(new Fits(evidence, inquiry.given(), base, chosen, all));
        double heldBefore = refinement.heldOut(base);
        Diagnosed found = new Verdicts(standing, heldBefore, search).diagnosed(this::places);
        List<Diagnosis.Named> missing = found.diagnosis().missing();
        boolean unlisted = found.diagnosis().verdict() == Diagnosis.Verdict.MISSING_PHYSICS
                && missing.stream().allMatch(named -> named.mechanism().equals(Learned.MECHANISM));
        return unlisted
                ? new LearnedVerdict(standing.fits(), heldBefore, refinement).learned(found.diagnosis(), List.of(),
                        missing.get(0).probability())
                : found;
    }

    /**
     * The best with what it takes beside it.
     *
     * @param best     single mechanism
     * @param all of them
     */
    private Chosen chosen(Fitter.State best, List<Fitter.State> all) {
        // Two at two places are weighed by data not used themselves: these may be of a quieter part, in which one of the two hardly acts.
        boolean loud = best.reduced() > Priors.LOUD && (refinement.heldOut(best) > Priors.LOUD || inquiry.pairs().isAtTwo());
        boolean more = Refinement.explained(base, best) < Priors.NEARLY_ALL || best.reduced() > Priors.GLARING;
        boolean much = loud && (more || inquiry.pairs().showsElsewhere(best)) && !inquiry.isOneLaw(best);
        Chosen chosen = much ? inquiry.pairs().best(best, all) : Chosen.single(best);
        return !much && base.reduced() > Priors.SILENT
                ? new SecondMechanism(evidence, search, inquiry::pairs).of(best).orElse(chosen) : chosen;
    }

    private List<Diagnosis.Latent> places() {
        return new Locator(evidence, inquiry.baseline()).singles(base.x()).stream().map(found -> {
            Place place = found.places().get(0);
            return new Diagnosis.Latent(place.kind().word(), place.name(evidence), found.reduced());
        }).toList();
    }

    /**
     * Fits on a model that stands for a simulation, the best few of them with forces that may go another way than the model's. The others
     * stay as they are: which law it is shows in what it does where it acts, and a way that may differ makes many alike.
     */
    private List<Fitter.State> carried(List<Fitter.State> fits) {
        if (!evidence.standsForSimulation() || fits.isEmpty()) {
            return fits;
        }
        double near = 1 + Effort.ALIKE * Refinement.excess(fits.get(0).reduced());
        int count = (int) fits.stream().limit(Effort.SECONDS).filter(fit -> fit.reduced() < near).count();
        List<Fitter.State> out = new ArrayList<>(
                Parallel.map(fits.subList(0, count), fit -> refinement.polish(fit.candidate().withFreeWays(), fit.x())));
        out.addAll(fits.subList(count, fits.size()));
        out.sort(Comparator.comparingDouble(Fitter.State::reduced));
        return out;
    }

    /** The best, or a simpler law or form at the same place that is as likely but for what a number more costs. */
    private Fitter.State simplest(List<Fitter.State> leaders) {
        Fitter.State best = leaders.get(0);
        return leaders.subList(1, Math.min(Effort.LEADERS, leaders.size())).stream().filter(other -> isSimpler(other, best)).findFirst()
                .orElse(best);
    }

    private boolean isSimpler(Fitter.State other, Fitter.State best) {
        Hypothesis found = best.candidate().last();
        Hypothesis simpler = other.candidate().last();
        int more = found.free() - simpler.free();
        if (found.claim().equals(simpler.claim()) && more > 0) {
            return !refinement.pays(best, other, more);
        }
        return found.yieldsTo(simpler) && Calibration.standard().isAsLikely(other.reduced(), best.reduced());
    }
}
