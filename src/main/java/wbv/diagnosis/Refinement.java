package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Refits the hypotheses that the screening ranked first, every law by free run, and orders them by what they really explain. */
final class Refinement {

    private static final int LINEAR = 12;
    private static final int LAWS = 10;
    private static final double LEAST_GAIN = 8;
    private static final double DISTORTED = 0.35;
    private static final double[] SHIFTS = {-1.5, -0.8, -0.4, -0.2, -0.1, -0.05, -0.02, 0.02, 0.05, 0.1, 0.2, 0.4, 0.8, 1.5};
    private static final Set<String> ALWAYS = Set.of("mode.hidden", "memory.viscoelastic");

    private final Evidence evidence;
    private final Fitter fitter;

    Refinement(Evidence evidence) {
        this.evidence = evidence;
        this.fitter = new Fitter(evidence);
    }

    /**
     * Refits.
     *
     * @param base   the fit on top of which the hypotheses stand
     * @param scores greatest first
     * @return fits, least cost first, all in the same whitening
     */
    List<Fitter.State> refit(Fitter.State base, List<Screening.Score> scores) {
        Fitter.Frame frame = base.frame();
        List<Screening.Score> chosen = choose(scores);
        // A refit that went far to absorb the effect is a bad place to start from: try the user's own values too.
        boolean distorted = false;
        for (int i = 0; i < base.x().length; i++) {
            distorted |= base.candidate().knobs().get(i).deviation() > 1 && Math.abs(base.x()[i]) > DISTORTED;
        }
        boolean both = distorted;
        List<Fitter.State> fits = new ArrayList<>(chosen.parallelStream().map(score -> best(base, score, frame, both)).toList());
        fits.sort(Comparator.comparingDouble(Fitter.State::cost));
        return fits;
    }

    /** The best linear hypotheses and the best laws. */
    private static List<Screening.Score> choose(List<Screening.Score> scores) {
        List<Screening.Score> chosen = new ArrayList<>();
        int linear = 0;
        int laws = 0;
        for (Screening.Score score : scores) {
            // A sensor's fault may be too large for a first-order look, and a memory too unlike its start: these always get their chance.
            boolean always = score.hypothesis().blamesSensor() || ALWAYS.contains(score.hypothesis().mechanism());
            boolean law = score.hypothesis().runsFree();
            if (always || score.gain() > LEAST_GAIN && (law ? laws++ < LAWS : linear++ < LINEAR)) {
                chosen.add(score);
            }
        }
        return chosen;
    }

    private Fitter.State best(Fitter.State base, Screening.Score score, Fitter.Frame frame, boolean both) {
        Candidate with = score.candidate();
        List<double[]> starts = new ArrayList<>();
        starts.add(score.x());
        for (Hypothesis.Start start : score.hypothesis().starts()) {
            if (score.hypothesis().starts().size() <= 6) {
                starts.add(base.candidate().extended(base.x(), with, score.hypothesis(), start.values()));
            }
        }
        int plain = starts.size();
        for (int i = 0; both && i < plain; i++) {
            double[] own = starts.get(i).clone();
            System.arraycopy(base.candidate().start(), 0, own, 0, base.x().length);
            starts.add(own);
        }
        List<Fitter.State> looks = new ArrayList<>();
        Set<Double> seen = new HashSet<>();
        for (double[] x : starts) {
            Fitter.State look = fitter.look(with, x, frame);
            if (seen.add(look.cost())) {
                looks.add(look);
            }
        }
        looks.sort(Comparator.comparingDouble(Fitter.State::cost));
        Fitter.State best = fitter.fit(with, looks.get(0).x(), frame, 7, 2e-3);
        if (both && looks.size() > 1 && best.cost() > 0.5 * base.cost()) {
            Fitter.State other = fitter.fit(with, looks.get(1).x(), frame, 7, 2e-3);
            best = other.cost() < best.cost() ? other : best;
        }
        return timed(best, 1);
    }

    /** A moment is not found by slopes: steps of it are tried, and the rest refitted, until none helps. */
    private Fitter.State timed(Fitter.State fit, int rounds) {
        Fitter.State best = fit;
        for (int i = 0; i < best.candidate().knobs().size(); i++) {
            if (!best.candidate().knobs().get(i).name().endsWith("time_s") || best.failed()) {
                continue;
            }
            for (int round = 0; round < rounds; round++) {
                Fitter.State start = best;
                for (double shift : SHIFTS) {
                    double[] x = start.x().clone();
                    x[i] = start.candidate().knobs().get(i).coordinate(start.candidate().knobs().get(i).value(x[i]) + shift);
                    Fitter.State look = fitter.look(start.candidate(), x, start.frame());
                    best = look.cost() < best.cost() ? look : best;
                }
                if (best == start) {
                    break;
                }
                Fitter.State again = fitter.fit(best.candidate(), best.x(), best.frame(), 5, 1e-3);
                best = again.cost() < best.cost() ? again : best;
            }
        }
        return best;
    }

    /** A leader fitted to the end, in the whitening of its own model. */
    Fitter.State polish(Fitter.State fit) {
        Fitter.State state = fit;
        for (int round = 0; round < 2; round++) {
            Fitter.Frame own = fitter.frame(state.candidate(), state.x(), evidence.fit());
            state = timed(fitter.fit(state.candidate(), state.x(), own, 15, 3e-4), 4);
        }
        return state;
    }

    /** χ² per number on the held-out window. */
    double heldOut(Fitter.State fit) {
        Fitter whole = new Fitter(evidence, evidence.whole());
        return whole.look(fit.candidate(), fit.x(), whole.frame(fit.candidate(), fit.x(), evidence.heldOut())).reduced();
    }
}
