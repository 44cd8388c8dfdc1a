package wbv.diagnosis.search;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Spectra;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.fit.Readings;

/**
 * Fits that are blind to whatever enters at some places. What enters there is a force that may be anything at every frequency, and is
 * eliminated as the likeliest beside the rest (Golub and Pereyra 1973). The direction along which it reaches the outputs turns with the
 * model's numbers. So models are simulated with the force as it was found last: then the derivatives are those of what was eliminated but
 * for a part as small as what is left (Kaufman 1975), and a law answers to the force too.
 */
final class VariableProjection {

    private final Evidence evidence;
    private final Evidence blind;
    /** No devices, but their channels. */
    private final List<Place> places;
    /** Those of forces. */
    private final List<Place> acting;

    /**
     * Beside some places.
     *
     * @param evidence that sees all of them
     */
    VariableProjection(Evidence evidence, List<Place> places) {
        this.evidence = evidence;
        this.places = places.stream().flatMap(place -> place.each(evidence).stream()).toList();
        this.acting = this.places.stream().filter(place -> !place.isSensor()).toList();
        Evidence seen = evidence;
        for (Place place : places) {
            seen = seen.ignoring(place);
        }
        this.blind = seen;
    }

    /**
     * A model at some numbers, and what enters beside it.
     *
     * @param x coordinates [1], one a knob. Not copied, not modified.
     */
    Turn at(Candidate candidate, double[] x) {
        return from(new double[acting.size()][2 * evidence.whole().omega().length], blind, candidate, x);
    }

    /**
     * The same where a force is known already at the first of the places, the only one at which forces enter.
     *
     * @param x coordinates [1], one a knob. Not copied, not modified.
     * @param force [N], by sample of the recording. Not modified.
     */
    Turn at(Candidate candidate, double[] x, double[] force) {
        double[][] forces = {evidence.whole().spectrum(force)};
        return from(forces, pushed(forces), candidate, x);
    }

    private Turn from(double[][] forces, Evidence knowing, Candidate candidate, double[] x) {
        Fitter fitter = new Fitter(knowing);
        return new Turn(forces, knowing, fitter, fitter.look(candidate, x, knowing.fit())).known();
    }

    /**
     * The user's model beside the places. Its numbers stay as given where nothing tells them.
     *
     * @param x where it starts: coordinates [1], one a knob. Not modified.
     */
    Turn base(Candidate baseline, double[] x) {
        return at(baseline, at(baseline.surer(Priors.NUMBER_DEVIATION), x).on(Effort.ROUNDS).fit().x());
    }

    /** A model, and what enters at the places beside it, so far. */
    final class Turn {

        private final double[][] forces;
        private final Evidence knowing;
        private final Fitter fitter;
        private final Fitter.State fit;

        private Turn(double[][] forces, Evidence knowing, Fitter fitter, Fitter.State fit) {
            this.forces = forces;
            this.knowing = knowing;
            this.fitter = fitter;
            this.fit = fit;
        }

        /** The model, simulated with what enters, in its own frame. */
        Fitter.State fit() {
            return fit;
        }

        /** The evidence that is blind to the places, where models are simulated with what enters there. */
        Evidence evidence() {
            return knowing;
        }

        /**
         * What enters at a place [N], by sample of the recording.
         *
         * @param place which of those where forces enter
         */
        double[] force(int place) {
            return evidence.whole().series(forces[place]);
        }

        /** Some turns further, as long as they lead anywhere. */
        Turn on(int turns) {
            Turn best = this;
            for (int i = 0; i < turns; i++) {
                Turn next = best.next();
                if (!(next.fit.cost() < (1 - Effort.ROUGH) * best.fit.cost())) {
                    break;
                }
                best = next;
            }
            return best;
        }

        private Turn next() {
            return new Turn(forces, knowing, fitter, stepped()).known();
        }

        /** The same model with what it leaves along the directions known. */
        private Turn known() {
            if (fit.failed() || acting.isEmpty()) {
                return this;
            }
            double[][] again = forces(fit, knowing, forces);
            Evidence pushed = pushed(again);
            Fitter own = new Fitter(pushed);
            return new Turn(again, pushed, own, own.look(fit.candidate(), fit.x(), pushed.fit()));
        }

        /** A few steps, shortened until less is left in the frame where they end: what is ignored lies along another direction there. */
        private Fitter.State stepped() {
            double[] to = fit.failed() ? fit.x() : fitter.fit(fit.candidate(), fit.x(), fit.frame(), Effort.FIRST_STEPS, Effort.EXACT).x();
            Fitter.State best = fit;
            double share = 1;
            for (int i = 0; i <= Effort.TRIES && best == fit; i++, share /= 2) {
                double part = share;
                double[] x = fit.x().clone();
                Arrays.setAll(x, k -> x[k] + part * (to[k] - x[k]));
                Fitter.State tried = fitter.look(fit.candidate(), x, knowing.fit());
                best = tried.cost() < fit.cost() ? tried : fit;
            }
            return best;
        }
    }

    /** The blind evidence, where models are simulated with forces at the places. */
    private Evidence pushed(double[][] forces) {
        double[][] bodies = new double[evidence.model().bodies().size()][2 * evidence.whole().omega().length];
        boolean[] any = new boolean[bodies.length];
        for (int p = 0; p < forces.length; p++) {
            double[] shares = acting.get(p).onBodies(evidence.model().assembly().structure());
            for (int body = 0; body < bodies.length; body++) {
                Spectra.add(bodies[body], forces[p], shares[body]);
                any[body] |= shares[body] != 0;
            }
        }
        Evidence out = blind;
        for (int body = 0; body < bodies.length; body++) {
            out = any[body] ? out.pushed(body, evidence.whole().series(bodies[body])) : out;
        }
        return out;
    }

    /**
     * What enters at the places with what a fit leaves along their directions.
     *
     * @param forces that it was simulated with, spectra by place. Not modified.
     */
    private double[][] forces(Fitter.State fit, Evidence knowing, double[][] forces) {
        Excitation whole = knowing.whole();
        Assembly assembly = new Simulator(whole).equivalent(fit.candidate().at(fit.x()));
        Readings readings = new Readings(knowing);
        double[][] left = readings.beyond(readings.of(fit));
        return IntStream.range(0, forces.length).mapToObj(p -> {
            List<Place> others = places.stream().filter(place -> !place.equals(acting.get(p))).toList();
            return force(forces[p], acting.get(p).direction(whole, assembly), left,
                    NoiseMetric.ignoring(evidence, whole, assembly, others));
        }).toArray(double[][]::new);
    }

    /**
     * A force with what is left along its direction, each line as far as it stands out of what is left across (Wiener 1949).
     *
     * @param force simulated with so far [N]. Not modified.
     * @param left spectra by output
     * @param metric that sees nothing of the other places
     */
    private double[] force(double[] force, double[][] direction, double[][] left, NoiseMetric metric) {
        double lowest = evidence.fit().frequency(0);
        double top = evidence.fit().frequency(evidence.fit().lines() - 1);
        double[] out = new double[force.length];
        double[] seen = new double[force.length / 2];
        double across = 0;
        int lines = 0;
        for (int k = 1; k < seen.length; k++) {
            double frequency = evidence.whole().omega()[k] / (2 * Math.PI);
            double size = metric.product(direction, direction, k)[0];
            if (size > 0 && frequency >= lowest && frequency <= top) {
                double[] along = metric.product(direction, left, k);
                out[2 * k] = force[2 * k] + along[0] / size;
                out[2 * k + 1] = force[2 * k + 1] + along[1] / size;
                seen[k] = size * (out[2 * k] * out[2 * k] + out[2 * k + 1] * out[2 * k + 1]);
                across += metric.product(left, left, k)[0] - (along[0] * along[0] + along[1] * along[1]) / size;
                lines++;
            }
        }
        double noise = across / Math.max(1, lines * (direction.length - places.size()));
        for (int k = 1; k < seen.length; k++) {
            double share = seen[k] > noise ? 1 - noise / seen[k] : 0;
            out[2 * k] *= share;
            out[2 * k + 1] *= share;
        }
        return out;
    }
}
