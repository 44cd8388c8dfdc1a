package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import wbv.diagnosis.fit.BlindFit;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.fit.Place;

/** Places that are ignored race for what leaves least, in heats: all are fitted a little, those near the best to their end. */
final class PlaceHeats {

    /** How many times as far from the noise as the best a place may be that is fitted to the end: what it leaves is held against noise. */
    private static final double NEAR = 3;
    private static final Comparator<Known.Ignoring> BEST = Comparator.comparingDouble(Known.Ignoring::reduced);
    private static final Comparator<Begun> WARMEST = Comparator.comparing(Begun::found, BEST);
    private static final Comparator<Looked> LEAST = Comparator.comparing(Looked::found, BEST);
    private static final Comparator<VariableProjection.Turn> COST = Comparator.comparingDouble(turn -> turn.fit().cost());

    private final Evidence evidence;
    private final Candidate baseline;
    /** The same, held where a place that is ignored leaves nothing to tell its numbers. */
    private final Candidate believed;

    /** @param baseline the model that is refitted */
    PlaceHeats(Evidence evidence, Candidate baseline) {
        this.evidence = evidence;
        this.baseline = baseline;
        this.believed = baseline.surer(Priors.NUMBER_DEVIATION);
    }

    /**
     * Fits all a little, and the whole way those that are not hopeless then.
     *
     * @param all places that are ignored together
     * @param starts of each of them
     */
    List<Known.Ignoring> found(List<List<Place>> all, List<double[]> starts) {
        Fitter fitter = new Fitter(evidence);
        List<BlindFit> blind = Parallel.map(starts, x -> fitter.lookWithSlopes(believed, x, fitter.frame(believed, x, evidence.fit())))
                .stream().filter(state -> !state.failed()).map(state -> new BlindFit(evidence, fitter.about(state), state)).toList();
        if (blind.isEmpty()) {
            return all.stream().map(places -> new Known.Ignoring(places, baseline.start(), Double.POSITIVE_INFINITY)).toList();
        }
        List<List<Begun>> heat = Parallel.map(all, places -> blind.stream()
                .map(fit -> new Begun(fit.start(), fit.ignoring(places, Effort.FINAL_STEPS))).sorted(WARMEST).limit(Effort.SECONDS)
                .toList());
        List<Looked> looked = new ArrayList<>(
                heat.stream().map(begun -> new Looked(begun, false, begun.get(0).found())).sorted(LEAST).toList());
        for (int round = 0; round < Effort.SECONDS; round++) {
            // What was begun is seen in the frame where it began: what is near so is fitted in its own.
            double reach = Locator.reach(looked.stream().map(Looked::found).toList(), Effort.BEHIND);
            List<Looked> first = looked.subList(0, Math.min(Effort.CONTENDERS, looked.size()));
            List<Looked> near = Parallel.map(first, each -> each.isNear() || each.found().reduced() > reach ? each : near(each.begun()));
            for (int i = 0; i < near.size(); i++) {
                looked.set(i, near.get(i));
            }
            looked.sort(LEAST);
        }
        return again(looked.stream().map(Looked::found).toList());
    }

    /**
     * Where the numbers as they were given lead, of which those that nothing tells stay; if less was promised, the best of where the
     * warmest leads and of what begins anew: steps with another fit's derivatives may go astray.
     */
    private Looked near(List<Begun> begun) {
        Known.Ignoring warmest = begun.get(0).found();
        VariableProjection beside = new VariableProjection(evidence, warmest.places());
        VariableProjection.Turn turn = beside.at(believed, believed.start()).on(Effort.ROUNDS);
        if (turn.fit().reduced() > (1 + Effort.ROUGH) * warmest.reduced()) {
            turn = Stream.concat(Stream.of(turn), Stream.concat(Stream.of(warmest.x()), begun.stream().map(Begun::start))
                    .map(x -> beside.at(believed, x).on(1))).min(COST).orElseThrow().on(Effort.ROUNDS);
        }
        return new Looked(begun, true, seen(warmest.places(), turn));
    }

    static Known.Ignoring seen(List<Place> places, VariableProjection.Turn turn) {
        return new Known.Ignoring(places, turn.fit().x(), turn.fit().reduced());
    }

    /**
     * A fit a little on.
     *
     * @param start where it began
     */
    private record Begun(double[] start, Known.Ignoring found) {}

    /**
     * What some places leave.
     *
     * @param isNear whether that is seen in its own frame
     */
    private record Looked(List<Begun> begun, boolean isNear, Known.Ignoring found) {}

    /**
     * More steps for those that leave little more than the best.
     *
     * @param found best first
     */
    private List<Known.Ignoring> again(List<Known.Ignoring> found) {
        double reach = Locator.reach(found, NEAR);
        return sorted(Parallel.map(found, each -> each.reduced() > reach ? each
                : seen(each.places(), new VariableProjection(evidence, each.places()).at(believed, each.x()).on(Effort.STEPS))));
    }

    /** Best first. A new list. */
    static List<Known.Ignoring> sorted(List<Known.Ignoring> found) {
        List<Known.Ignoring> out = new ArrayList<>(found);
        out.sort(BEST);
        return out;
    }
}
