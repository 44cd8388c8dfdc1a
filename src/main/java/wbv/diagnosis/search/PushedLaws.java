package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.Assembly;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.fit.Readings;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Start;

/**
 * A law and a force on a body that nobody measured, fitted together. A law that is not linear answers to the force too, of which its free
 * run knows nothing as long as the force is but ignored. So models are simulated with the force as what a fit leaves along its direction
 * shows it, and the two are found in turn.
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
     * A law, found beside a force.
     *
     * @param body on which that acts
     * @param force [N], by sample of the recording
     * @param fit of the law, blind to whatever acts on that body
     */
    public record Found(int body, double[] force, Fitter.State fit) {}

    /**
     * The law and the body that leave least, where they explain nearly all, and leave far less than the best law by itself and than
     * whatever acts on that body by itself; empty where none does, or outputs are too few to show it.
     *
     * @param leaders mechanisms by themselves, least first
     */
    public Optional<Found> best(List<Fitter.State> leaders) {
        Set<String> claims = leaders.stream().map(fit -> fit.candidate().last()).filter(Screening::isInLink).map(Hypothesis::claim)
                .distinct().limit(Effort.SECONDS).collect(Collectors.toSet());
        // What stands for a simulation leaves more of its own, which would pass for a force.
        boolean open = !evidence.standsForSimulation() && evidence.outputs().size() >= Locator.FEWEST_OUTPUTS;
        if (claims.isEmpty() || !open) {
            return Optional.empty();
        }
        List<Hypothesis> laws = new Search(evidence, (step, share) -> {}).hypotheses(base).stream()
                .filter(hypothesis -> claims.contains(hypothesis.claim())).toList();
        List<Turn> begun = IntStream.range(0, evidence.model().bodies().size()).boxed().flatMap(body -> begun(body, laws)).toList();
        List<Turn> first = sorted(Parallel.map(begun, turn -> turn.on(Effort.ROUNDS)));
        List<Turn> last = sorted(Parallel.map(first.stream().limit(Effort.LEADERS).toList(), turn -> turn.on(Effort.STEPS)));
        return last.stream().findFirst().filter(turn -> Refinement.explainsNearlyAll(base, turn.fit))
                .filter(turn -> Effort.BEHIND * Refinement.excess(turn.left()) < alone(turn.body(), leaders))
                .map(turn -> new Found(turn.body(), turn.known.series(turn.force), turn.fit));
    }

    /** What is left by the best law by itself, or where whatever acts on a body is ignored, beyond noise [1]. */
    private double alone(int body, List<Fitter.State> leaders) {
        return Refinement.excess(Math.min(leaders.get(0).reduced(), beside(body).reduced()));
    }

    private Known.Ignoring beside(int body) {
        Place plain = new Place(Place.Kind.BODY, body).plain(base.candidate().template());
        return new Locator(evidence, base.candidate()).singles(base.x()).stream().filter(found -> found.places().get(0).equals(plain))
                .findFirst().orElseThrow();
    }

    private Stream<Turn> begun(int body, List<Hypothesis> laws) {
        Candidate baseline = base.candidate();
        Place place = new Place(Place.Kind.BODY, body);
        double[] x = place.plain(baseline.template()).asGiven(baseline, beside(body).x());
        return laws.stream().flatMap(law -> law.starts().stream().map(start -> begun(place, x, law, start)));
    }

    private Turn begun(Place place, double[] x, Hypothesis hypothesis, Start start) {
        Candidate with = base.candidate().with(hypothesis);
        Fitter fitter = new Fitter(evidence.ignoring(place));
        Fitter.State there = fitter.look(with, base.candidate().extended(x, with, hypothesis, start.values()), evidence.fit());
        return new Turn(new Unmeasured(evidence, place), new double[2 * evidence.whole().omega().length], there);
    }

    private static List<Turn> sorted(List<Turn> turns) {
        List<Turn> out = new ArrayList<>(turns);
        out.sort(Comparator.comparingDouble(Turn::left));
        return out;
    }

    /**
     * A law so far.
     *
     * @param force as it is known so far [N], spectrum at the lines of the whole recording
     * @param fit simulated with it, in its own frame
     */
    private record Turn(Unmeasured known, double[] force, Fitter.State fit) {

        int body() {
            return known.place.index();
        }

        double left() {
            return fit.reduced();
        }

        /** Some turns further, as long as they lead anywhere. */
        Turn on(int turns) {
            Turn best = this;
            for (int i = 0; i < turns; i++) {
                Turn next = best.next();
                if (!(next.left() < (1 - Effort.ROUGH) * best.left())) {
                    break;
                }
                best = next;
            }
            return best;
        }

        private Turn next() {
            Fitter.State stepped = stepped();
            double[] again = stepped.failed() ? force : known.force(stepped, force);
            Evidence pushed = known.pushed(again);
            return new Turn(known, again, new Fitter(pushed).look(stepped.candidate(), stepped.x(), pushed.fit()));
        }

        /** A few steps, shortened until less is left in the frame where they end: what is ignored lies along another direction there. */
        private Fitter.State stepped() {
            Evidence pushed = known.pushed(force);
            Fitter fitter = new Fitter(pushed);
            double[] to = fit.failed() ? fit.x() : fitter.fit(fit.candidate(), fit.x(), fit.frame(), Effort.FIRST_STEPS, Effort.EXACT).x();
            Fitter.State best = fit;
            double share = 1;
            for (int i = 0; i <= Effort.TRIES && best == fit; i++, share /= 2) {
                double part = share;
                double[] x = fit.x().clone();
                Arrays.setAll(x, k -> x[k] + part * (to[k] - x[k]));
                Fitter.State tried = fitter.look(fit.candidate(), x, pushed.fit());
                best = tried.cost() < fit.cost() ? tried : fit;
            }
            return best;
        }
    }

    /**
     * A force on a body, as what a fit leaves along its direction shows it.
     *
     * @param evidence that knows nothing of it
     */
    private record Unmeasured(Evidence evidence, Place place) {

        double[] series(double[] force) {
            return evidence.whole().series(force);
        }

        /** The evidence that knows of it, and is blind to the rest of what acts there. */
        Evidence pushed(double[] force) {
            return evidence.ignoring(place).pushed(place.index(), series(force));
        }

        /**
         * The force with what a fit leaves along its direction, each line as far as it stands out of what is left across it (Wiener 1949).
         *
         * @param force simulated with so far. Not modified.
         */
        double[] force(Fitter.State fit, double[] force) {
            Evidence pushed = pushed(force);
            Excitation whole = pushed.whole();
            Assembly assembly = new Simulator(whole).equivalent(fit.candidate().at(fit.x()));
            double[][] direction = place.direction(whole, assembly);
            double[][] residual = new double[direction.length][];
            double[][] read = new Readings(pushed).of(fit);
            for (int o = 0; o < residual.length; o++) {
                residual[o] = whole.spectrum(left(o, read[o], whole.rate()));
            }
            NoiseMetric metric = new NoiseMetric(evidence, whole, assembly);
            double lowest = evidence.fit().frequency(0);
            double top = evidence.fit().frequency(evidence.fit().lines() - 1);
            double[] out = new double[force.length];
            double[] seen = new double[force.length / 2];
            double across = 0;
            int lines = 0;
            for (int k = 1; k < seen.length; k++) {
                double frequency = whole.omega()[k] / (2 * Math.PI);
                double size = metric.product(direction, direction, k)[0];
                if (size > 0 && frequency >= lowest && frequency <= top) {
                    double[] along = metric.product(direction, residual, k);
                    out[2 * k] = force[2 * k] + along[0] / size;
                    out[2 * k + 1] = force[2 * k + 1] + along[1] / size;
                    seen[k] = size * (out[2 * k] * out[2 * k] + out[2 * k + 1] * out[2 * k + 1]);
                    across += metric.product(residual, residual, k)[0] - (along[0] * along[0] + along[1] * along[1]) / size;
                    lines++;
                }
            }
            double noise = across / Math.max(1, lines * (direction.length - 1));
            for (int k = 1; k < seen.length; k++) {
                double share = seen[k] > noise ? 1 - noise / seen[k] : 0;
                out[2 * k] *= share;
                out[2 * k + 1] *= share;
            }
            return out;
        }

        /** What was measured less what sensors would read, faded in and out for a second so that its ends make no noise. */
        private double[] left(int output, double[] read, double rate) {
            double[] out = new double[read.length];
            for (int i = 0; i < out.length; i++) {
                double inside = Math.min(1, Math.min(i + 0.5, out.length - i - 0.5) / rate);
                double fading = Math.pow(Math.sin(Math.PI / 2 * inside), 2);
                out[i] = evidence.valid(output)[i] ? fading * (evidence.measured(output)[i] - read[i]) : 0;
            }
            return out;
        }
    }
}
