package wbv.diagnosis;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import wbv.body.Model;
import wbv.body.law.Learned;

/**
 * What a diagnosis came to.
 *
 * @param verdict        in a word
 * @param sentence       in a sentence, for a person
 * @param located        where simulation and recording differ, most first
 * @param missing        what was left out; empty where nothing was, or nothing of the library carries it
 * @param alternatives   what else could be it, best first
 * @param nextExperiment what would settle it
 * @param fit            how well the models fit
 * @param latent         places that could carry the mismatch whatever it is, best first; empty where a name was found
 * @param model          the model with what was found, fitted
 * @param learned        the law that was learned where no mechanism of the library carries what is missing
 */
public record Diagnosis(Verdict verdict, String sentence, List<Located> located, List<Named> missing, List<Named> alternatives,
        String nextExperiment, Fit fit, List<Latent> latent, Model model, Optional<LearnedLaw> learned) {

    /** The verdict in a word; its JSON name is in lower case with hyphens. */
    public enum Verdict {
        MISSING_PHYSICS, PARAMETERS_ONLY, NOTHING_MISSING,
        /** Something is missing, in all of the recording, and no mechanism of the library carries it. */
        UNEXPLAINED,
        /** Something is missing that is not in the library; its law was learned, and holds on data that were not used. */
        LEARNED_LAW,
        /** A mechanism carries it, and another does about as well. */
        AMBIGUOUS,
        /**
         * The recording does not say whether something is missing: its parts contradict each other, or the input does not cause what was
         * measured.
         */
        CANNOT_TELL;

        /** Whether no physics is said to be missing. */
        public boolean isQuiet() {
            return this == PARAMETERS_ONLY || this == NOTHING_MISSING;
        }

        /** Whether nothing is claimed of any mechanism. */
        public boolean isRefusal() {
            return this == UNEXPLAINED || this == CANNOT_TELL;
        }

        /** {@code missing-physics} and so on. */
        public String word() {
            return name().toLowerCase(Locale.ROOT).replace('_', '-');
        }
    }

    /** What matters most, in a few lines of text: verdict and sentence, errors on data not used, what would settle it. */
    public String summary() {
        StringBuilder text = new StringBuilder(verdict.word()).append(": ").append(sentence).append('\n');
        fit.channels()
                .forEach(proof -> text.append(String.format(Locale.ROOT, "  %-18s held-out error %5.1f %% before, %5.1f %% after, %s%n",
                        proof.channel(), 100 * proof.before().value(), 100 * proof.after().value(), proof.noise())));
        return text.append(nextExperiment.isEmpty() ? "" : "  To settle it: " + nextExperiment + "\n").toString();
    }

    /**
     * A part of the mismatch.
     *
     * @param band  two numbers: lowest and highest frequency of its middle four fifths [Hz]
     * @param time  two numbers: first and last moment of its middle four fifths [s]
     * @param share part of the whole mismatch, 0 to 1
     * @param times mean square over all noise that reaches this channel [1]: 1 is noise alone
     */
    public record Located(String channel, double[] band, double[] time, double share, double times) {}

    /**
     * A mechanism at a place.
     *
     * @param probability that this is what was left out
     * @param parameters  its numbers, units in the names
     * @param intervals   where they lie with 95 %; for those that have an uncertainty
     * @param reduced     mean square of the whitened residual with it
     * @param numbers     logarithm of how likely the model's own numbers are where it has them, against as given [nat], 0 or less
     * @param form        what of it no number tells, by what it tells, in a word each; nothing for most
     */
    public record Named(String mechanism, String where, double probability, Map<String, Double> parameters, Map<String, Interval> intervals,
            double reduced, double numbers, Map<String, String> form) {

        /**
         * One of which numbers tell all.
         *
         * @param reduced [1]
         * @param numbers [nat]
         */
        public Named(String mechanism, String where, double probability, Map<String, Double> parameters, Map<String, Interval> intervals,
                double reduced, double numbers) {
            this(mechanism, where, probability, parameters, intervals, reduced, numbers, Map.of());
        }

        /**
         * One for which the model's own numbers stay as they are.
         *
         * @param reduced [1]
         */
        public Named(String mechanism, String where, double probability, Map<String, Double> parameters, Map<String, Interval> intervals,
                double reduced) {
            this(mechanism, where, probability, parameters, intervals, reduced, 0);
        }

        /** The same, held at another probability. */
        Named at(double other) {
            return new Named(mechanism, where, other, parameters, intervals, reduced, numbers, form);
        }

        /**
         * The same where data see other noise.
         *
         * @param left mean square of the whitened residual with it there [1]
         */
        Named leaving(double left) {
            return new Named(mechanism, where, probability, parameters, intervals, left, numbers, form);
        }

        /**
         * The same with other numbers of the model.
         *
         * @param own how likely they are [nat]
         */
        Named with(double own) {
            return new Named(mechanism, where, probability, parameters, intervals, reduced, own, form);
        }

        /** The same in a form. */
        Named in(Map<String, String> other) {
            return new Named(mechanism, where, probability, parameters, intervals, reduced, numbers, other);
        }

        /** Standard deviations of a normal distribution as wide as the intervals; infinite where an end is open. */
        public Map<String, Double> std() {
            Map<String, Double> out = new LinkedHashMap<>();
            intervals.forEach((key, interval) -> out.put(key, interval.std()));
            return out;
        }
    }

    /**
     * A law that was learned.
     *
     * @param where   link
     * @param formula of its force, which pulls the ends of the link together [N]
     * @param terms   that add up to it, as {@code model.json} has them
     * @param rivals  other laws that were fitted, likeliest first
     */
    public record LearnedLaw(String where, String formula, List<Learned> terms, List<Rival> rivals) {

        /**
         * Another law.
         *
         * @param probability against all that were fitted
         * @param reduced mean square of the whitened residual with it
         */
        public record Rival(String formula, double probability, double reduced) {}
    }

    /**
     * A place that carries the mismatch as an arbitrary signal.
     *
     * @param reduced mean square of the whitened residual that is left then: 1 if that place explains all
     */
    public record Latent(String kind, String where, double reduced) {}

    /**
     * How well the models fit, on data used (fit) and not used (held out) for it.
     *
     * @param given       mean square of the whitened residual with the user's own values, in the fit's window
     * @param before      with fitted values, likewise
     * @param after       with what was found, likewise
     * @param heldBefore  likewise, with fitted values, held out
     * @param heldAfter   likewise, with what was found, held out
     * @param heldOut     two numbers: first and last moment of the held-out window [s]
     * @param channels    errors held out, by channel
     * @param bands       the same in bands, by channel and then from the lowest
     * @param sensors     small errors that the sensors were found to have beside the last model, by channel (or {@code input}) and by
     *                    name with its unit. Errors by channel and band are those of models seen with the errors found beside each on the
     *                    data of the fit; for the mean squares of the whitened residual they are found anew where it is taken
     */
    public record Fit(double given, double before, double after, double heldBefore, double heldAfter, double[] heldOut,
            List<Proof> channels, List<Proof> bands, Map<String, Map<String, Double>> sensors) {

        /** Root mean square of the error held out over that of the channel's whole signal [1], by channel, without what was found. */
        public Map<String, Double> nrmseBefore() {
            return byChannel(proof -> proof.before().value());
        }

        /** The same with what was found. */
        public Map<String, Double> nrmseAfter() {
            return byChannel(proof -> proof.after().value());
        }

        /** The same of noise alone. */
        public Map<String, Double> nrmseFloor() {
            return byChannel(Proof::floor);
        }

        private Map<String, Double> byChannel(ToDoubleFunction<Proof> figure) {
            Map<String, Double> out = new LinkedHashMap<>();
            channels.forEach(proof -> out.put(proof.channel(), figure.applyAsDouble(proof)));
            return out;
        }
    }

    /**
     * Held-out error of a channel, in all or in a band: root mean square over that of the channel's whole signal, so that the squares of
     * the bands add up.
     *
     * @param band    two numbers: lowest and highest frequency [Hz]
     * @param signal  share of the channel's power that lies in the band
     * @param before  without what was found
     * @param after with it
     * @param floor ratio that noise alone would leave
     * @param removed part of what is above the noise that went; NaN where there was too little to remove
     */
    public record Proof(String channel, double[] band, double signal, Ranged before, Ranged after, double floor, Ranged removed) {

        /** How much of the channel noise is, in words: where less is left than it was taken for, it is no more than that. */
        public String noise() {
            boolean bound = floor > after.value();
            return String.format(Locale.ROOT, bound ? "at most %.1f %% is noise" : "%5.1f %% is noise",
                    100 * (bound ? after.value() : floor));
        }
    }

    /**
     * A figure with what 90 % of other draws of the same blocks of data give; ends are NaN where they cannot be said.
     *
     * @param value a ratio of {@link Proof}
     * @param low   end of that ratio
     * @param high  end of that ratio
     */
    public record Ranged(double value, double low, double high) {}
}
