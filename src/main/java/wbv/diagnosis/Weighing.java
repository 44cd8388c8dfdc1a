package wbv.diagnosis;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import wbv.body.Assembly;
import wbv.body.Simulator;

/**
 * The evidence of hypotheses: each is fitted again beside the processes that it leaves room for, a sitter's own force, what its formula may be
 * wrong by, a free force at one place if it has one, and then summed over all of them.
 */
final class Weighing {

    /** Fits with the processes as the fit before leaves them. */
    static final int ROUNDS = 4;
    /** Change of the evidence from round to round below which processes and values have settled beside each other. */
    private static final double SETTLED = 0.5;
    private static final int STEPS = 5;
    private static final double TOLERANCE = 1e-4;

    private final Evidence evidence;
    private final Candidate baseline;
    private final Priors priors;
    private final Fitter fitter;
    private final OwnForce own;
    private final ValuePrior values;

    /** @param evidence with no force of the sitter's taken as known @param baseline the model as given */
    Weighing(Evidence evidence, Candidate baseline, Priors priors) {
        this.evidence = evidence;
        this.baseline = baseline;
        this.priors = priors;
        this.fitter = new Fitter(evidence);
        this.own = new OwnForce(evidence, priors);
        this.values = new ValuePrior(priors);
    }

    /**
     * A hypothesis weighed.
     *
     * @param log   of its evidence @param fit in the frame of its likeliest processes @param form likeliest ρ
     * @param own   likeliest level of the sitter's own force that does not follow the ride [N] @param riding of what does [N]
     * @param scale likeliest step of the given numbers' error @param within probability that the free force leaves the name be; 1 where there is none
     * @param left  free force over the law's, NaN where there is no law or no free force
     */
    record Weight(double log, Fitter.State fit, double form, double own, double riding, int scale, double within, double left) {

        Weight plus(double more) {
            return new Weight(log + more, fit, form, own, riding, scale, within, left);
        }
    }

    /** The model exactly as given. */
    Weight nothing() {
        Candidate fixed = new Candidate(baseline.template(), List.of(), List.of());
        double[] x = {};
        Summed summed = summed(fixed, x, new double[0], Optional.empty());
        return new Weight(summed.value(), summed.state(), 0, summed.own().level(), summed.own().riding(), 0, 1, Double.NaN);
    }

    /** The model with values of its own, and whatever a candidate holds. @param x where it fits @param rounds fits at most; more never lower what is compared */
    Weight of(Candidate candidate, double[] x, int rounds) {
        return weighed(candidate, x, Optional.empty(), rounds);
    }

    /** The same with a free force at a place. */
    Weight withFree(Candidate candidate, double[] x, Place place, int rounds) {
        return weighed(candidate, x, Optional.of(place), rounds);
    }

    private Weight weighed(Candidate candidate, double[] start, Optional<Place> free, int rounds) {
        int scale = values.count() / 2;
        double[] x = start;
        double before = Double.NEGATIVE_INFINITY;
        double[] errors = {};
        Optional<Weight> best = Optional.empty();
        for (int round = 0; round <= rounds; round++) {
            Candidate known = values.at(candidate, scale);
            Summed summed = summed(known, x, errors, free);
            Fitter.State here = fitter.lookWithSlopes(known, x, summed.frame());
            Normal normal = new Normal(here);
            ValuePrior.Summed whole = values.evidence(summed.value(), normal, here);
            // More rounds are never worth less.
            if (best.filter(weight -> weight.log() >= whole.log()).isEmpty()) {
                best = Optional.of(new Weight(whole.log(), here, summed.form(), summed.own().level(), summed.own().riding(), whole.best(), summed.within(), summed.left()));
            }
            if (round == rounds || Math.abs(whole.log() - before) < SETTLED) {
                break;
            }
            before = whole.log();
            scale = whole.best();
            Fitter.State fit = fitter.fit(values.at(candidate, scale), x, summed.frame(), STEPS, TOLERANCE);
            x = fit.x();
            errors = fit.errors();
        }
        Weight found = best.orElseThrow();
        return rounds == 0 ? found : found.plus(new ProfileSum(fitter).correction(found.fit(), new Normal(found.fit())));
    }

    /**
     * The likelihood at a point, summed over processes.
     *
     * @param frame of the likeliest ones
     */
    private record Summed(double value, Fitter.State state, Fitter.Frame frame, double form, OwnForce.Summed own, double within, double left) { }

    /** @param errors of the sensors as they were found beside the processes, which sensors read late and too large too; none where nothing is known */
    private Summed summed(Candidate candidate, double[] x, double[] errors, Optional<Place> free) {
        Fitter.Frame plain = fitter.frame(candidate, x, evidence.fit());
        Fitter.State state = fitter.look(candidate, x, plain);
        Assembly linear = new Simulator(evidence.excitation()).equivalent(candidate.at(x));
        UnaryOperator<double[][]> seen = way -> plain.nuisances().seen(way, errors);
        List<FormDiscrepancy> forms = candidate.added().stream()
                .map(part -> FormDiscrepancy.of(evidence, baseline, state, part, linear, seen, priors)).toList();
        List<double[][]> ways = own.ways(evidence, linear).stream().map(seen).toList();
        LogLikelihood likelihood = LogLikelihood.of(state, ModelledErrors.columns(evidence, state, linear));
        List<double[]> whitened = ways.stream().map(way -> plain.whitening().whiten(way)).toList();
        return free.isPresent() ? free(state, way(linear, free.get(), seen), likelihood, forms, ways, whitened, free.get()) : formed(state, likelihood, forms, ways, whitened);
    }

    /** Over ρ, the same for all parts, and the sitter's own force. */
    private Summed formed(Fitter.State state, LogLikelihood likelihood, List<FormDiscrepancy> forms, List<double[][]> ways, List<double[]> whitened) {
        double[] shares = forms.stream().map(FormDiscrepancy::shares).max((a, b) -> a.length - b.length).orElse(new double[] {0});
        double[] terms = new double[shares.length];
        OwnForce.Summed[] all = new OwnForce.Summed[shares.length];
        for (int i = 0; i < shares.length; i++) {
            UnaryOperator<double[]> through = UnaryOperator.identity();
            LogLikelihood seen = likelihood;
            for (FormDiscrepancy form : forms) {
                RankOne process = new RankOne(through.apply(form.whitened()), form.power(shares[i]), likelihood.outputs());
                UnaryOperator<double[]> before = through;
                through = vector -> process.of(before.apply(vector));
                seen = seen.with(process);
            }
            all[i] = own.sum(seen, ways, whitened.stream().map(through).toList());
            terms[i] = all[i].value() - Math.log(shares.length);
        }
        int best = LogSum.greatest(terms);
        List<Whitening.Source> sources = new ArrayList<>(all[best].source());
        forms.forEach(form -> sources.add(new Whitening.Source(form.power(shares[best]), form.way())));
        return new Summed(LogSum.of(terms), state, frame(state, sources), shares[best], all[best], 1, Double.NaN);
    }

    /** What a unit at a place does to each output, as sensors read it; an error at one is read as it is. */
    private double[][] way(Assembly linear, Place place, UnaryOperator<double[][]> seen) {
        double[][] way = evidence.atLines(evidence.excitation(), place.direction(evidence.excitation(), linear), evidence.fit());
        return place.kind() == Place.Kind.SENSOR ? way : seen.apply(way);
    }

    /** Over a free force beside the likeliest of the sitter's own, and the own force beside the free one. */
    private Summed free(Fitter.State state, double[][] way, LogLikelihood likelihood, List<FormDiscrepancy> forms, List<double[][]> ways,
                        List<double[]> whitened, Place place) {
        double[] unit = state.frame().whitening().whiten(way);
        FreeForce force = new FreeForce(evidence.fit(), place.kind(), priors);
        // Where both may be the cause, each is tried first: neither leaves to the other what it has taken.
        Beside first = beside(likelihood, ways, whitened, force, unit, new double[evidence.fit().lines()]);
        Beside second = beside(likelihood, ways, whitened, force, unit, force.sum(likelihood, unit).power());
        Beside best = first.value() > second.value() ? first : second;
        OwnForce.Summed beside = best.own();
        FreeForce.Summed found = best.free();
        List<Whitening.Source> sources = new ArrayList<>(beside.source());
        sources.add(new Whitening.Source(found.power(), way));
        Optional<FormDiscrepancy> law = forms.stream().filter(form -> form.place().equals(place)).findFirst();
        return new Summed(best.value(), state, frame(state, sources), 0, beside, law.map(form -> found.within(priors.left(), form.force(), best.sizes())).orElse(0.0),
                law.map(form -> found.share(form.force(), best.sizes())).orElse(Double.NaN));
    }

    /** Both processes together. @param sizes how well the sensors see the free one beside the other */
    private record Beside(double value, OwnForce.Summed own, FreeForce.Summed free, double[] sizes) { }

    /** @param power of the free force beside which the sitter's own is found */
    private Beside beside(LogLikelihood likelihood, List<double[][]> ways, List<double[]> whitened, FreeForce force, double[] unit, double[] power) {
        int outputs = likelihood.outputs();
        RankOne taken = new RankOne(unit, power, outputs);
        OwnForce.Summed beside = own.sum(likelihood.with(taken), ways, whitened.stream().map(taken::of).toList());
        LogLikelihood seen = likelihood;
        double[] through = unit;
        for (int i = 0; i < beside.source().size(); i++) {
            RankOne process = new RankOne(whitened.get(beside.body()), beside.source().get(i).power(), outputs);
            seen = seen.with(process);
            through = process.of(unit);
        }
        FreeForce.Summed found = force.sum(seen, through);
        // What summing over the own force's levels adds to its likeliest one, beside the free force.
        double spread = beside.source().isEmpty() ? 0 : beside.value() - seen.with(new RankOne(through, power, outputs)).value();
        return new Beside(found.value() + spread, beside, found, RankOne.sizes(through, outputs));
    }

    /** The frame of a state with processes in the noise. */
    private Fitter.Frame frame(Fitter.State state, List<Whitening.Source> sources) {
        Whitening whitening = evidence.whitening(evidence.excitation(), state.candidate().at(state.x()), evidence.fit(), UnaryOperator.identity(), sources);
        return new Fitter.Frame(whitening, state.frame().nuisances().through(evidence, whitening));
    }
}
