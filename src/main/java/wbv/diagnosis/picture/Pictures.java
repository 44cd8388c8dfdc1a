package wbv.diagnosis.picture;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.apache.commons.math3.special.Gamma;
import wbv.diagnosis.Diagnosed;
import wbv.diagnosis.Diagnosis;
import wbv.diagnosis.Interval;
import wbv.diagnosis.NumberIntervals;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Knob;
import wbv.diagnosis.mechanism.Family;

/**
 * What a report of a diagnosis shows beside the diagnosis itself. Arrays are not copied: treat them as read-only.
 *
 * @param completed whether the later of the two models drawn is the user's with what was missing, and the earlier one the user's
 *                  fitted without; if not, the later is the user's fitted, and the earlier the same as given
 * @param views     by output of the model
 * @param portraits of what is missing, at the place that carries it; empty where nothing is
 * @param values    the numbers of the user's model
 */
public record Pictures(boolean completed, List<View> views, List<Portrait> portraits, List<Value> values) {

    /**
     * One output.
     *
     * @param unit    of its samples
     * @param heldOut samples that took no part in the fit
     * @param map     where in frequency and time the models fail
     * @param transfer from the base to this output; empty where too little was recorded
     * @param nrmseGiven ratio of the root mean square error to that of the signal, held out, with the user's own values
     * @param degrees  independent numbers behind {@link Diagnosis.Located#times}
     */
    public record View(String channel, String unit, Traces heldOut, ResidualMap map, List<Transfer> transfer, double nrmseGiven,
            int degrees) {

        /** How much stronger in power than estimated the sensors' noise may be before a mismatch counts as one. */
        private static final double NOISE_MARGIN = 1.1;

        /**
         * The chance of so strong a residual if it were noise alone, that noise a tenth stronger than estimated: the upper tail
         * of χ² with as many degrees of freedom as there are independent numbers.
         *
         * @param times mean square of the residual in units of the noise
         */
        public double pValue(double times) {
            double half = degrees / 2.0;
            double at = half * times / NOISE_MARGIN;
            // Far in the tail the continued fraction does not settle, and could only say 0.
            return at > 3 * half + 400 ? 0 : Gamma.regularizedGammaQ(half, at);
        }
    }

    /**
     * Samples of a stretch, those of models as the sensors would read them.
     *
     * @param from time of the first [s]
     * @param step between two [s]
     * @param measured by sample, in the output's unit; NaN where it does not count
     * @param before likewise, the earlier of the models
     * @param after likewise, the later
     */
    public record Traces(double from, double step, double[] measured, double[] before, double[] after) {}

    /**
     * Power of measured minus simulated, as the sensors would read it, over that which the noise of the sensors explains, by time and
     * frequency [dB]; NaN where nothing was measured.
     *
     * @param time by column [s]
     * @param frequency by row [Hz]
     * @param before by time and frequency [dB], of the earlier model
     * @param after likewise, of the later
     */
    public record ResidualMap(double[] time, double[] frequency, double[][] before, double[][] after) {}

    /**
     * Moduli of frequency responses, all estimated in the same way from samples.
     *
     * @param input  channel of the excitation
     * @param unit   of the moduli
     * @param frequency by line [Hz]
     * @param measured by line, in the unit of the moduli
     * @param error  relative standard error of what was measured, by line
     * @param usable where coherence and excitation back what was measured
     * @param before by line, in the unit of the moduli, of the earlier model
     * @param after  likewise, of the later
     */
    public record Transfer(String input, String unit, double[] frequency, double[] measured, double[] error, boolean[] usable,
            double[] before,
            double[] after) {}

    /**
     * A number of the user's model.
     *
     * @param where  link or body
     * @param key    with its unit, such as {@code stiffness_N_per_m}
     * @param given  by the user, in the unit of its key
     * @param before likewise, fitted without what is missing
     * @param after  likewise, in the final model
     * @param within where that lies with 95 %; empty where the fit holds it
     */
    public record Value(String where, String key, double given, double before, double after, Optional<Interval> within) {}

    public Pictures {
        views = List.copyOf(views);
        portraits = List.copyOf(portraits);
        values = List.copyOf(values);
    }

    /**
     * Draws from where the fits of a diagnosis ended, which takes a few simulations more. Besides what the chosen fit added, the place of
     * an unmeasured force is drawn, or the best place for what nothing explains.
     */
    public static Pictures of(Diagnosed diagnosed) {
        Diagnosis diagnosis = diagnosed.diagnosis();
        Evidence evidence = diagnosed.evidence;
        Stream<Diagnosis.Latent> forces = diagnosis.missing().stream()
                .filter(named -> evidence.library().of(named.mechanism()).filter(mechanism -> mechanism.family() == Family.FORCE)
                        .isPresent())
                .map(named -> new Diagnosis.Latent("body", named.where(), named.reduced()));
        return of(evidence, diagnosed.fits.given(), diagnosed.base, diagnosed.chosen,
                Stream.concat(forces, diagnosis.latent().stream()).toList());
    }

    /** @param latent places to be drawn where the chosen fit added nothing, best first */
    static Pictures of(Evidence evidence, Fitter.State given, Fitter.State base, Fitter.State chosen, List<Diagnosis.Latent> latent) {
        boolean completed = chosen.candidate().added().size() > base.candidate().added().size();
        Fitter.State before = completed ? base : given;
        return new Pictures(completed, new OutputCharts(evidence, given, before, chosen).all(),
                new Portraits(evidence, base, chosen).all(latent), values(evidence, given, base, chosen));
    }

    private static List<Value> values(Evidence evidence, Fitter.State given, Fitter.State base, Fitter.State chosen) {
        List<Value> out = new ArrayList<>();
        Optional<NumberIntervals> intervals = NumberIntervals.of(evidence, chosen);
        for (int i = 0; i < base.x().length; i++) {
            Knob knob = base.candidate().knobs().get(i);
            int number = i;
            out.add(new Value(knob.place(), knob.key(), value(given, i), value(base, i), value(chosen, i),
                    intervals.flatMap(found -> found.of(number))));
        }
        // The mass that the fits hold has the scale of all.
        for (int b = 0; b < evidence.model().bodies().size(); b++) {
            String where = evidence.model().bodies().get(b).name();
            int body = b;
            evidence.model().massKey(evidence.model().bodies().get(b))
                    .filter(key -> out.stream().noneMatch(v -> v.where().equals(where) && v.key().equals(key)))
                    .ifPresent(key -> out.add(new Value(where, key, mass(given, body), mass(base, body), mass(chosen, body),
                            intervals.flatMap(found -> found.ofHeld(mass(chosen, body))))));
        }
        return out;
    }

    private static double value(Fitter.State state, int i) {
        return state.candidate().knobs().get(i).value(state.x()[i]);
    }

    private static double mass(Fitter.State state, int body) {
        return state.candidate().template().structure().mass()[body];
    }
}
