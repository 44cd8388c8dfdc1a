package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.random.RandomGeneratorFactory;
import wbv.body.Assembly;
import wbv.recording.Channel;

/** Turns fits into a diagnosis: a verdict with its probability, values with their deviations, where, how well, and what would settle it. */
final class Verdicts {

    static final String PUSH = "input.unmeasured";
    private static final double SILENT = 1.2;
    private static final double STRANGE = 3;
    /** What data not used may show, of a mismatch that is not strange where it was fitted, and still pass for nothing. */
    private static final double LOUD = 2;
    private static final double LEAST_GAIN = 80;
    private static final double LEAST_SHARE = 0.5;
    /** What a mechanism must take off the mean square of the residual, in units of the noise; less is in the reach of second-order effects. */
    private static final double LEAST_DROP = 0.1;
    private static final double UNEXPLAINED = 4;
    private static final double WELL_EXPLAINED = 0.72;
    private static final double CARRIED_OVER = 0.72;
    /** On a rig what is left is chatter and the form of the law as often as missing physics: what went says more, if it went on unseen data too. */
    private static final double RIG_SHARE = 0.4;
    private static final double RIG_HELD = 0.75;
    private static final double NEAR = 0.5;
    /** How sure what nearly imitates a spring and a damper can be: the number may have been given wrong after all. */
    private static final double IMITATED = 0.75;
    /** How much more data not used may keep where a small error of a sensor is called a fault. */
    private static final double CARRIED_ALONG = 0.02;
    /** Seed of the blocks that are drawn for the proof's intervals: the same data give the same intervals. */
    private static final long DRAWS = 20200131;

    private final Evidence evidence;
    private final Fitter.State given;
    private final Fitter.State base;
    private final double heldBefore;
    private final Fitter.State best;
    private final List<Fitter.State> leaders;
    private final Refinement refinement;
    private final double heldAfter;
    private double carried = Double.NaN;

    /** @param best the fit with what was found, or {@code base} itself @param leaders single hypotheses, most credible first */
    Verdicts(Evidence evidence, Fitter.State given, Fitter.State base, double heldBefore, Fitter.State best, List<Fitter.State> leaders,
             Refinement refinement) {
        this.evidence = evidence;
        this.given = given;
        this.base = base;
        this.heldBefore = heldBefore;
        this.best = best;
        this.leaders = leaders;
        this.refinement = refinement;
        this.heldAfter = best == base ? heldBefore : refinement.heldOut(best);
    }

    /** @param locate finds the places that could carry the mismatch; asked only where no name is good enough */
    Diagnosed diagnosed(Function<Fitter.State, List<Diagnosis.Latent>> locate) {
        List<Diagnosis.Named> sensors = new PlainFaults(evidence).in(base, best);
        boolean named = best != base && explained() > (evidence.onRig() ? RIG_SHARE : LEAST_SHARE)
                && base.reduced() - best.reduced() > LEAST_DROP && (base.reduced() - best.reduced()) * degrees() > LEAST_GAIN
                && (evidence.onRig() || heldBefore - heldAfter > LEAST_DROP / 2)
                // So near to the noise only a name without a rival is a finding.
                && (heldBefore > SILENT || rivalry() > NEAR);
        // What is shown and written has the scale that all masses tell; what is simulated is the same.
        MassScale scale = MassScale.of(evidence, base);
        Fitter.State chosen = named ? best : base;
        Optional<OddLink> odd = named || evidence.onRig() || base.reduced() > STRANGE ? Optional.empty() : OddLink.in(base);
        Optional<Fitter.State> imitated = odd.flatMap(link -> link.explained(evidence, base))
                .filter(fit -> refinement.heldOut(fit) < heldBefore);
        Optional<Fitter.State> late = named || imitated.isPresent() || base.reduced() > SILENT ? Optional.empty()
                : new OddSensor(evidence, refinement).in(base).filter(fit -> refinement.heldOut(fit) < heldBefore + CARRIED_ALONG);
        List<Diagnosis.Named> missing = new ArrayList<>(sensors);
        List<Diagnosis.Named> alternatives = List.of();
        List<Diagnosis.Latent> latent = List.of();
        Diagnosis.Verdict verdict;
        Optional<BodyForce> force = named && best.reduced() < UNEXPLAINED || base.reduced() < STRANGE ? Optional.empty()
                : BodyForce.in(evidence, base, !named).filter(BodyForce::independent);
        if (force.isPresent()) {
            BodyForce found = force.get();
            double p = named ? Math.max(0.5, 1 - explained()) : found.following().isTold() ? 0.9 : 0.6;
            verdict = Diagnosis.Verdict.MISSING_PHYSICS;
            missing.add(pushed(found, p, scale));
            chosen = base;
            carried = found.carried();
            alternatives = rivals(1 - p);
        } else if (imitated.isPresent()) {
            Values values = new Values(evidence, imitated.get());
            chosen = values.state();
            verdict = Diagnosis.Verdict.MISSING_PHYSICS;
            missing.add(values.named(imitated.get().candidate().added().get(0), IMITATED));
            alternatives = List.of(odd.get().asNumber(base, 1 - IMITATED));
        } else if (late.isPresent()) {
            Values values = new Values(evidence, late.get());
            chosen = values.state();
            verdict = Diagnosis.Verdict.MISSING_PHYSICS;
            missing.add(values.named(late.get().candidate().last(), IMITATED));
        } else if (!named) {
            boolean quiet = heldBefore < SILENT || base.reduced() < STRANGE && heldBefore < LOUD;
            boolean right = given.reduced() < 1.12 * base.reduced() + 0.05;
            verdict = !sensors.isEmpty() && quiet ? Diagnosis.Verdict.MISSING_PHYSICS : !quiet ? Diagnosis.Verdict.UNEXPLAINED
                    : right ? Diagnosis.Verdict.NOTHING_MISSING : Diagnosis.Verdict.PARAMETERS_ONLY;
            if (!quiet) {
                latent = locate.apply(base);
                alternatives = rivals(0.1);
            }
        } else {
            double rivalry = rivalry();
            double p = probability(rivalry);
            boolean poor = evidence.onRig() ? heldAfter > RIG_HELD * heldBefore : explained() < WELL_EXPLAINED || !carriesOver();
            verdict = poor ? Diagnosis.Verdict.UNEXPLAINED : rivalry < NEAR ? Diagnosis.Verdict.AMBIGUOUS : Diagnosis.Verdict.MISSING_PHYSICS;
            if (poor) {
                latent = locate.apply(base);
            }
            Values values = new Values(evidence, best);
            chosen = values.state();
            for (Hypothesis hypothesis : best.candidate().added()) {
                missing.add(values.named(hypothesis, poor ? Math.min(p, 0.4) : p));
            }
            evidence.bodyForce().filter(push -> !poor && !push.ordinary(evidence)).ifPresent(push -> missing.add(pushed(push, p, scale)));
            alternatives = rivals(1 - p);
        }
        Fitter.State shown = scale.applied(base);
        Evidence seen = evidence.bodyForce().map(f -> evidence.with(f.scaled(scale.factor()))).orElse(evidence);
        Assembly completed = chosen == base ? shown.candidate().at(shown.x()) : chosen.candidate().at(chosen.x());
        String sentence = imitated.isPresent() ? Phrases.of(missing.get(missing.size() - 1)) + odd.get().words()
                : sentence(verdict, missing, alternatives);
        Diagnosis diagnosis = new Diagnosis(verdict, sentence, located(), missing, alternatives,
                Experiments.between(missing, alternatives, atBase(), scale.deviation() > 0), fit(chosen), latent,
                Augmented.of(evidence.model(), completed));
        return new Diagnosed(diagnosis, seen, given, shown, chosen == base ? shown : chosen);
    }

    /** A force that nobody measured, as a finding. */
    private Diagnosis.Named pushed(BodyForce force, double probability, MassScale scale) {
        double rms = scale.factor() * force.rms();
        return new Diagnosis.Named(PUSH, evidence.model().bodies().get(force.body()).name(), probability, Map.of("rms_N", rms),
                Map.of("rms_N", Interval.normal(rms, scale.deviation() * force.rms())), base.reduced());
    }

    /** Whether a diagnosis names a push and a mechanism beside it. */
    static boolean namesBesidePush(Diagnosis diagnosis) {
        Set<String> apart = Set.of(PUSH, "sensor.dropouts", "sensor.bias");
        List<String> names = diagnosis.missing().stream().map(Diagnosis.Named::mechanism).toList();
        return names.contains(PUSH) && names.stream().anyMatch(name -> !apart.contains(name));
    }

    /** The link on the base and the body on it. */
    private Set<String> atBase() {
        Set<String> out = new HashSet<>();
        evidence.model().links().stream().filter(link -> link.from().equals(evidence.model().base().name())).forEach(link -> {
            out.add(link.name());
            out.add(link.to());
        });
        return out;
    }

    private int degrees() {
        return base.frame().whitening().degrees();
    }

    /** Part of the mismatch that the found mechanisms explain. */
    private double explained() {
        return explained(base, best);
    }

    static double explained(Fitter.State base, Fitter.State best) {
        return Math.min(1, (base.reduced() - best.reduced()) / Math.max(base.reduced() - 1, 1e-9));
    }

    /** Whether data not used for the fit are explained about as well: a wrong law with enough freedom follows only what it has seen. */
    private boolean carriesOver() {
        return heldBefore < STRANGE || (heldBefore - heldAfter) / (heldBefore - 1) > CARRIED_OVER * explained();
    }

    /** How much worse the best other mechanism is, in units of what the best one leaves. */
    private double rivalry() {
        Set<String> own = new HashSet<>();
        best.candidate().added().forEach(h -> own.add(h.mechanism() + h.where()));
        double rival = leaders.stream().filter(fit -> !own.contains(fit.candidate().last().mechanism() + fit.candidate().last().where()))
                .mapToDouble(Fitter.State::reduced).findFirst().orElse(base.reduced());
        return (Math.min(rival, base.reduced()) - best.reduced()) / Math.max(best.reduced() - 1, 0.1);
    }

    private double probability(double rivalry) {
        double r = Math.max(0, rivalry);
        double p = 0.62 + 0.36 * r / (r + 1.5);
        double share = Math.min(1, explained() / 0.95);
        return Math.min(0.98, p * Math.pow(share, 2));
    }

    /** The other mechanisms, each once, sharing what probability is left. */
    private List<Diagnosis.Named> rivals(double left) {
        List<Diagnosis.Named> out = new ArrayList<>();
        Set<String> seen = new HashSet<>();
        best.candidate().added().forEach(h -> seen.add(h.mechanism() + h.where()));
        double share = left / 2;
        for (Fitter.State rival : leaders) {
            Hypothesis h = rival.candidate().added().get(0);
            if (out.size() < 5 && seen.add(h.mechanism() + h.where())) {
                out.add(new Diagnosis.Named(h.mechanism(), h.where(), share, Map.of(), Map.of(), rival.reduced()));
                share /= 2;
            }
        }
        return out;
    }

    private List<Diagnosis.Located> located() {
        Window window = evidence.fit();
        double[] r = base.residual();
        int outputs = evidence.outputs().size();
        double[] power = new double[outputs];
        double[][] byLine = new double[outputs][window.lines()];
        for (int line = 0; line < window.lines(); line++) {
            for (int o = 0; o < outputs; o++) {
                int at = base.frame().whitening().index(line, o);
                byLine[o][line] = Math.max(0, r[at] * r[at] + r[at + 1] * r[at + 1] - 2);
                power[o] += r[at] * r[at] + r[at + 1] * r[at + 1];
            }
        }
        double total = Arrays.stream(power).sum();
        List<Diagnosis.Located> out = new ArrayList<>();
        double rate = evidence.recording().clock().rate();
        double[] time = {window.start() / rate, (window.start() + window.length()) / rate};
        for (int o = 0; o < outputs; o++) {
            out.add(new Diagnosis.Located(evidence.outputs().get(o).toString(), new double[] {window.frequency(at(byLine[o], 0.1)),
                window.frequency(at(byLine[o], 0.9))}, time, power[o] / total, power[o] / (2 * window.lines())));
        }
        out.sort(Comparator.comparingDouble(Diagnosis.Located::share).reversed());
        return out;
    }

    /** Index at which a share of the sum is reached. */
    private static int at(double[] x, double share) {
        double total = Arrays.stream(x).sum();
        double sum = 0;
        for (int i = 0; i < x.length; i++) {
            sum += x[i];
            if (sum >= share * total) {
                return i;
            }
        }
        return x.length - 1;
    }

    private Diagnosis.Fit fit(Fitter.State chosen) {
        double rate = evidence.recording().clock().rate();
        Window held = evidence.heldOut();
        List<Diagnosis.Proof> proofs = new HeldOut(evidence, RandomGeneratorFactory.of("L64X128MixRandom").create(DRAWS)).of(base, chosen);
        int outputs = evidence.outputs().size();
        return new Diagnosis.Fit(given.reduced(), base.reduced(), chosen.reduced(), heldBefore,
                chosen == base ? heldBefore : refinement.heldOut(chosen),
                new double[] {held.start() / rate, (held.start() + held.length()) / rate},
                proofs.subList(0, outputs), proofs.subList(outputs, proofs.size()), Readings.errors(evidence, chosen));
    }

    private String sentence(Diagnosis.Verdict verdict, List<Diagnosis.Named> missing, List<Diagnosis.Named> alternatives) {
        String found = missing.stream().map(Phrases::of).reduce((first, next) -> first + " and " + next.substring(0, 1).toLowerCase(Locale.ROOT)
                + next.substring(1)).orElse("");
        String next = alternatives.isEmpty() ? "." : String.format("; next best %s at %s, %s.", alternatives.get(0).mechanism(),
                alternatives.get(0).where(),
                Phrases.percent(Math.max(0, (base.reduced() - alternatives.get(0).reduced()) / Math.max(base.reduced() - 1, 1e-9))));
        String tail = "; explains " + Phrases.percent(Double.isNaN(carried) ? explained() : carried) + " of the mismatch" + next;
        return switch (verdict) {
            case NOTHING_MISSING -> String.format(Locale.ROOT,
                    "Nothing is missing: the model as given leaves %.2f times the noise.", given.reduced());
            case PARAMETERS_ONLY -> String.format(Locale.ROOT,
                    "No physics is missing; with fitted values the model leaves %.2f times the noise instead of %.3g times.",
                    base.reduced(), given.reduced());
            case UNEXPLAINED -> String.format(Locale.ROOT,
                    "Something is missing (%.3g times the noise), and nothing in the library explains it.", base.reduced());
            case AMBIGUOUS -> found + (best == base ? "." : tail) + " The recording does not tell the two apart.";
            case MISSING_PHYSICS -> found + (best == base ? "." : tail);
        };
    }
}
