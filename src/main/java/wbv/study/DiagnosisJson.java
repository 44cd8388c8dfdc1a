package wbv.study;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import wbv.diagnosis.Diagnosis;
import wbv.diagnosis.Interval;
import wbv.diagnosis.picture.Pictures;

/**
 * A diagnosis in the format of {@code diagnosis.json}.
 *
 * @param sentence      the verdict for a person
 * @param subject       what the model is of: person or rig
 * @param declared whether the model says so, or it was guessed from what it holds
 * @param latent        places that could carry what nothing explains, best first
 * @param learned       the law that was learned where no mechanism carries what is missing; its terms stand in {@code model.json}
 */
public record DiagnosisJson(String verdict, String sentence, String subject, @JsonProperty("subject_declared") boolean declared,
        List<Located> located, List<Named> missing, List<Named> alternatives,
        @JsonProperty("next_experiment") String nextExperiment, Fit fit, List<Latent> latent, List<Law> learned,
        @JsonProperty("model_values") List<Value> modelValues, Map<String, String> provenance) {

    /**
     * @param times mean square of the mismatch in units of the noise
     * @param pValue see {@link Pictures.View#pValue}
     */
    record Located(String channel, @JsonProperty("band_hz") double[] band, @JsonProperty("time_s") double[] time, double share,
            @JsonProperty("times_noise") double times, @JsonProperty("p_value") double pValue) {}

    /**
     * @param std null where the recording does not tell
     * @param intervals that hold 95 %
     * @param identifiable whether both ends are known
     * @param form what of it no number tells, by what it tells, in a word each
     * @param reduced χ² per number with it, on the data fitted
     */
    record Named(String mechanism, String where, double probability, Map<String, String> form, Map<String, Double> parameters,
            Map<String, Double> std,
            Map<String, Range> intervals, Map<String, Boolean> identifiable,
            @JsonProperty("chi2_reduced") double reduced) {}

    /**
     * @param low null where the recording sets no end
     * @param high likewise
     * @param from {@code curvature} or {@code profile}; {@code held} of a number that was not fitted
     */
    record Range(double low, double high, String from) {
        static Range of(Interval interval) {
            return new Range(interval.low(), interval.high(), interval.from().name().toLowerCase(Locale.ROOT));
        }
    }

    /**
     * Error held out, over the channel's signal, in a band or in all.
     *
     * @param signal  part of the channel's power that lies in the band
     * @param removed part of what is above the noise that went, null where there was too little
     * @param before90 where 90 % of other draws of the data's blocks lie, likewise the others
     */
    record HeldOut(String channel, @JsonProperty("band_hz") double[] band, @JsonProperty("signal_share") double signal,
            @JsonProperty("nrmse_before") double before, @JsonProperty("nrmse_before_90") double[] before90,
            @JsonProperty("nrmse_after") double after, @JsonProperty("nrmse_after_90") double[] after90,
            @JsonProperty("noise_floor_nrmse") double floor, double removed,
            @JsonProperty("removed_90") double[] removed90) {
        static HeldOut of(Diagnosis.Proof p) {
            return new HeldOut(p.channel(), p.band(), p.signal(), p.before().value(), ends(p.before()), p.after().value(),
                    ends(p.after()),
                    p.floor(), p.removed().value(), ends(p.removed()));
        }

        private static double[] ends(Diagnosis.Ranged ranged) {
            return new double[] {ranged.low(), ranged.high()};
        }
    }

    /** All χ² per number: 1 is noise alone. */
    record Fit(@JsonProperty("heldout_s") double[] heldOut, @JsonProperty("heldout_nrmse_given") Map<String, Double> given,
            @JsonProperty("heldout_nrmse_before") Map<String, Double> before,
            @JsonProperty("heldout_nrmse_after") Map<String, Double> after,
            @JsonProperty("noise_floor_nrmse") Map<String, Double> floor, @JsonProperty("chi2_given") double chi2Given,
            @JsonProperty("chi2_before") double chi2Before, @JsonProperty("chi2_after") double chi2After,
            @JsonProperty("heldout_chi2_before") double heldBefore, @JsonProperty("heldout_chi2_after") double heldAfter,
            @JsonProperty("heldout_by_channel") List<HeldOut> channels,
            @JsonProperty("heldout_by_band") List<HeldOut> bands,
            @JsonProperty("sensor_errors") Map<String, Map<String, Double>> sensors) {}

    /**
     * @param formula of the force that pulls the ends of the link together [N]
     * @param corrects mechanisms in the link whose form it corrects; none where it is all that is missing
     * @param rivals other laws that were fitted, likeliest first
     */
    record Law(String where, String formula, List<String> corrects, List<Rival> rivals) {}

    record Rival(String formula, double probability, @JsonProperty("chi2_reduced") double reduced) {}

    record Latent(String kind, String where, @JsonProperty("chi2_reduced") double reduced) {}

    /** @param interval that holds the last with 95 %; both ends null where the fit holds it */
    record Value(String where, String parameter, double given, double fitted, @JsonProperty("final") double last, Range interval) {
        static Value of(Pictures.Value v) {
            return new Value(v.where(), v.key(), v.given(), v.before(), v.after(),
                    v.within().map(Range::of).orElse(new Range(Double.NaN, Double.NaN, "held")));
        }
    }

    /**
     * A diagnosis in this format.
     *
     * @param provenance by what it came about: versions, options, SHA-256 of the files
     */
    public static DiagnosisJson of(Diagnosis d, Pictures pictures, Map<String, String> provenance) {
        Map<String, Pictures.View> views = new LinkedHashMap<>();
        pictures.views().forEach(view -> views.put(view.channel(), view));
        return new DiagnosisJson(d.verdict().word(), d.sentence(), d.model().subject().word(), d.model().declared().isPresent(),
                d.located().stream().map(located -> located(located, Optional.ofNullable(views.get(located.channel())))).toList(),
                d.missing().stream().map(DiagnosisJson::named).toList(),
                d.alternatives().stream().map(DiagnosisJson::named).toList(),
                d.nextExperiment(), fit(d.fit(), pictures),
                d.latent().stream().map(l -> new Latent(l.kind(), l.where(), l.reduced())).toList(),
                d.learned().stream()
                        .map(law -> new Law(law.where(), law.formula(),
                                d.missing().stream()
                                        .filter(named -> d.verdict() != Diagnosis.Verdict.LEARNED_LAW && named.where().equals(law.where()))
                                        .map(Diagnosis.Named::mechanism).toList(),
                                law.rivals().stream()
                                        .map(rival -> new Rival(rival.formula(), rival.probability(), rival.reduced())).toList()))
                        .toList(),
                pictures.values().stream().map(Value::of).toList(),
                provenance);
    }

    private static Located located(Diagnosis.Located l, Optional<Pictures.View> view) {
        double pValue = view.map(seen -> seen.pValue(l.times())).orElse(Double.NaN);
        return new Located(l.channel(), l.band(), l.time(), l.share(), l.times(), pValue);
    }

    private static Fit fit(Diagnosis.Fit f, Pictures pictures) {
        Map<String, Double> given = new LinkedHashMap<>();
        pictures.views().forEach(view -> given.put(view.channel(), view.nrmseGiven()));
        return new Fit(f.heldOut(), given, f.nrmseBefore(), f.nrmseAfter(), f.nrmseFloor(), f.given(), f.before(), f.after(),
                f.heldBefore(), f.heldAfter(), f.channels().stream().map(HeldOut::of).toList(),
                f.bands().stream().map(HeldOut::of).toList(), f.sensors());
    }

    private static Named named(Diagnosis.Named n) {
        Map<String, Range> ranges = new LinkedHashMap<>();
        Map<String, Boolean> identifiable = new LinkedHashMap<>();
        n.intervals().forEach((key, interval) -> {
            ranges.put(key, Range.of(interval));
            identifiable.put(key, interval.isClosed());
        });
        return new Named(n.mechanism(), n.where(), n.probability(), n.form(), n.parameters(), n.std(), ranges, identifiable, n.reduced());
    }
}
