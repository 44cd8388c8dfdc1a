package wbv.report;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.apache.commons.math3.special.Gamma;
import wbv.diagnosis.Diagnosis;
import wbv.diagnosis.Pictures;

/**
 * A diagnosis in the format of {@code diagnosis.json}.
 *
 * @param sentence      the verdict for a person
 * @param latent        places that could carry what nothing explains, best first
 */
record DiagnosisJson(String verdict, String sentence, List<Located> located, List<Named> missing, List<Named> alternatives,
                     @JsonProperty("next_experiment") String nextExperiment, Fit fit, List<Latent> latent,
                     @JsonProperty("model_values") List<Value> modelValues, Map<String, String> provenance) {

    /** How much stronger than estimated the sensors' noise may be before a mismatch counts as one. */
    private static final double NOISE_MARGIN = 1.1;

    /** @param times mean square of the mismatch in units of the noise @param pValue see {@link #pValue} */
    record Located(String channel, @JsonProperty("band_hz") double[] band, @JsonProperty("time_s") double[] time, double share,
                   @JsonProperty("times_noise") double times, @JsonProperty("p_value") double pValue) { }

    /** @param std null where the recording does not tell @param reduced χ² per number with it, on the data fitted */
    record Named(String mechanism, String where, double probability, Map<String, Double> parameters, Map<String, Double> std,
                 @JsonProperty("chi2_reduced") double reduced) { }

    /** All χ² per number: 1 is noise alone. */
    record Fit(@JsonProperty("heldout_s") double[] heldOut, @JsonProperty("heldout_nrmse_given") Map<String, Double> given,
               @JsonProperty("heldout_nrmse_before") Map<String, Double> before, @JsonProperty("heldout_nrmse_after") Map<String, Double> after,
               @JsonProperty("noise_floor_nrmse") Map<String, Double> floor, @JsonProperty("chi2_given") double chi2Given,
               @JsonProperty("chi2_before") double chi2Before, @JsonProperty("chi2_after") double chi2After,
               @JsonProperty("heldout_chi2_before") double heldBefore, @JsonProperty("heldout_chi2_after") double heldAfter) { }

    record Latent(String kind, String where, @JsonProperty("chi2_reduced") double reduced) { }

    record Value(String where, String parameter, double given, double fitted, @JsonProperty("final") double last) { }

    static DiagnosisJson of(Diagnosis d, Pictures pictures, Map<String, String> provenance) {
        Map<String, Double> given = new LinkedHashMap<>();
        Map<String, Integer> degrees = new LinkedHashMap<>();
        for (Pictures.View view : pictures.views()) {
            given.put(view.channel(), view.nrmseGiven());
            degrees.put(view.channel(), view.degrees());
        }
        Diagnosis.Fit f = d.fit();
        return new DiagnosisJson(d.verdict().word(), d.sentence(), d.located().stream().map(l -> new Located(l.channel(), l.band(), l.time(),
                l.share(), l.times(), degrees.containsKey(l.channel()) ? pValue(l.times(), degrees.get(l.channel())) : Double.NaN)).toList(),
                d.missing().stream().map(DiagnosisJson::named).toList(), d.alternatives().stream().map(DiagnosisJson::named).toList(),
                d.nextExperiment(), new Fit(f.heldOut(), given, f.nrmseBefore(), f.nrmseAfter(), f.nrmseFloor(), f.given(), f.before(), f.after(),
                f.heldBefore(), f.heldAfter()), d.latent().stream().map(l -> new Latent(l.kind(), l.where(), l.reduced())).toList(),
                pictures.values().stream().map(v -> new Value(v.where(), v.key(), v.given(), v.before(), v.after())).toList(), provenance);
    }

    private static Named named(Diagnosis.Named n) {
        return new Named(n.mechanism(), n.where(), n.probability(), n.parameters(), n.std(), n.reduced());
    }

    /**
     * The chance of so strong a residual if it were noise alone, that noise a tenth stronger in power than estimated: the upper tail of χ²
     * with as many degrees of freedom as independent numbers.
     *
     * @param times mean square in units of the noise
     */
    static double pValue(double times, int degrees) {
        double half = degrees / 2.0;
        double at = half * times / NOISE_MARGIN;
        // Far in the tail the continued fraction does not settle, and says no more than 0.
        return at > 3 * half + 400 ? 0 : Gamma.regularizedGammaQ(half, at);
    }
}
