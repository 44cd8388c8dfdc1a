package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Supplier;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * Which mechanisms show at a place while whatever enters at another is ignored. No mechanism at that other place can leave less than is
 * left so: what is far behind here is no rival beside any. What was sought is kept with the evidence.
 */
final class ShownBeside {

    private final Evidence evidence;
    private final BiConsumer<String, Double> progress;
    private final Fitter.State base;

    /** @param base the model without any mechanism, fitted */
    ShownBeside(Evidence evidence, Fitter.State base, BiConsumer<String, Double> progress) {
        this.evidence = evidence;
        this.base = base;
        this.progress = progress;
    }

    /** @param x told by being the same array */
    private record Asked(double[] x, Place ignored, Set<Place> places) {}

    /**
     * What was fitted while a place is ignored.
     *
     * @param without the model alone
     * @param fits with one mechanism each, least first; none where the model alone leaves noise
     */
    record Shown(Fitter.State without, List<Fitter.State> fits) {

        private Shown at(Place place) {
            return new Shown(without, fits.stream().filter(fit -> Place.ofLast(fit).equals(place)).toList());
        }
    }

    /**
     * At some places.
     *
     * @param places where it may act, likeliest first, with the base's numbers as they fit beside both
     */
    Shown among(Place ignored, Map<Place, double[]> places) {
        Shown shown = once(ignored, places.keySet(), () -> sought(ignored, places));
        places.keySet().forEach(place -> once(ignored, Set.of(place), () -> shown.at(place)));
        return shown;
    }

    private Shown once(Place ignored, Set<Place> places, Supplier<Shown> seek) {
        return evidence.known().once(new Asked(base.x(), ignored, Set.copyOf(places)), Shown.class, seek);
    }

    private Shown sought(Place ignored, Map<Place, double[]> places) {
        Candidate baseline = base.candidate();
        VariableProjection beside = new VariableProjection(evidence, List.of(ignored));
        Fitter.State alone = beside.base(baseline, places.values().iterator().next()).fit();
        if (alone.reduced() < Priors.SILENT) {
            return new Shown(alone, List.of());
        }
        Search blind = new Search(evidence.ignoring(ignored), progress);
        Fitter.State without = blind.sloped(baseline, alone.x());
        Map<Place, double[]> given = new LinkedHashMap<>();
        places.forEach((place, numbers) -> given.put(place, ignored.asGiven(baseline, numbers)));
        List<Fitter.State> found = blind.leaders(without, Effort.LEADERS, Whereabouts.among(evidence, baseline, given));
        return new Shown(without, Trial.sorted(answering(beside, blind.hypotheses(without), found)));
    }

    /**
     * The same where laws answer to what is ignored too, which shows once there is a law: the best few, and the best of these in all of its
     * forms.
     *
     * @param all hypotheses of the library
     */
    private List<Fitter.State> answering(VariableProjection beside, List<Hypothesis> all, List<Fitter.State> found) {
        List<Fitter.State> out = new ArrayList<>(found);
        Set<String> claims = new HashSet<>();
        List<Fitter.State> first = found.stream().filter(fit -> claims.add(fit.candidate().last().claim())).limit(Effort.LEADERS).toList();
        out.removeAll(first);
        List<Fitter.State> answering = Parallel.map(first, fit -> beside.at(fit.candidate(), fit.x()).on(Effort.STEPS).fit());
        out.addAll(answering);
        answering.stream().min(Comparator.comparingDouble(Fitter.State::reduced)).ifPresent(best -> {
            Hypothesis one = best.candidate().last();
            List<Hypothesis> forms = all.stream().filter(form -> form.claim().equals(one.claim()) && !form.name().equals(one.name()))
                    .toList();
            out.addAll(Parallel.map(forms, form -> from(best, form, beside)));
        });
        return out;
    }

    /** Another form of what a fit has, from the start that begins best. */
    private Fitter.State from(Fitter.State fit, Hypothesis form, VariableProjection beside) {
        double[] x = Arrays.copyOf(fit.x(), base.x().length);
        Candidate with = base.candidate().with(form);
        return form.starts().stream().map(start -> beside.at(with, base.candidate().extended(x, with, form, start.values())))
                .min(Comparator.comparingDouble(turn -> turn.fit().cost())).orElseThrow().on(Effort.STEPS).fit();
    }
}
