package wbv.study;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import wbv.recording.Channel;
import wbv.signal.AbsorbedPower;
import wbv.signal.ComplexSeries;
import wbv.signal.Peak;
import wbv.signal.SubjectMean;

/**
 * Frequency responses for machines, as {@code frf.json} holds them. Units stand in the names, or beside the numbers.
 *
 * @param level      confidence of the margins
 * @param frequency_hz by bin, as are all curves
 * @param among      for each input the share of it that the others explain, by frequency; empty with one input
 * @param responses  by output, and by input within
 * @param provenance how the results came about
 */
public record ResponseResults(AnalysisResults.RecordingFacts recording, List<String> inputs, List<String> outputs,
        double segment_s, double resolution_hz, double level, double[] frequency_hz,
        List<double[]> input_density, List<double[]> among, List<ResponseFacts> responses,
        Map<String, String> provenance) {

    /**
     * One response.
     *
     * @param averages  number of independent averages
     * @param margin    half the band about |H1|, by bin, in {@code unit}
     * @param phase_margin_rad likewise, by bin
     * @param multiple_coherence by bin
     * @param partial_coherence by bin
     * @param ordinary_coherence by bin
     * @param output_density by bin, in the square of the output's unit over hertz
     * @param unusable_because by frequency, empty where it is usable
     * @param other_cause the other motion of highest partial coherence where the inputs do not make the output; empty elsewhere
     * @param other_motion the one that is named most often, null where none is
     * @param h2        null where there are fewer outputs than inputs
     * @param model     null where no model answers
     * @param people    mean of several people, null where there is one
     */
    public record ResponseFacts(String input, String output, String unit, double averages, PeakFacts peak, double usable_from_hz,
            double usable_to_hz, Polar h1, double[] margin, double[] phase_margin_rad, Optional<Polar> h2,
            Polar hv, double[] multiple_coherence, double[] partial_coherence,
            double[] ordinary_coherence, boolean[] usable, String[] unusable_because,
            String[] other_cause, Optional<OtherCauseFacts> other_motion, double[] output_density, Optional<Polar> model,
            Optional<MisfitFacts> misfit, Optional<DrivingPointFacts> driving_point,
            Optional<PeopleFacts> people) {}

    /**
     * A motion that is no input and may move the output.
     *
     * @param partial_coherence median over the frequencies where it is named
     * @param frequencies how many
     */
    public record OtherCauseFacts(String channel, double partial_coherence, int frequencies) {
        static OtherCauseFacts of(OtherAxes.Named named) {
            return new OtherCauseFacts(named.channel().toString(), named.partial(), named.bins());
        }
    }

    /**
     * A complex curve.
     *
     * @param modulus by bin, in the unit of the response
     * @param phase_rad by bin
     */
    public record Polar(double[] modulus, double[] phase_rad) {
        static Polar of(ComplexSeries h) {
            return new Polar(h.magnitudes(), h.phases());
        }
    }

    /**
     * The highest place of |H1| where it is usable.
     *
     * @param modulus in the unit of the response
     * @param margin likewise
     * @param at_end whether the highest value stands at the end of what is usable, so that the curve may rise further
     */
    public record PeakFacts(double frequency_hz, double modulus, double margin, boolean at_end) {}

    /**
     * How a model differs from H1.
     *
     * @param relative rms of model less H1 over that of H1
     * @param inside_band share of usable frequencies inside the band
     */
    public record MisfitFacts(double relative, double inside_band) {}

    /**
     * A force over an acceleration at one place.
     *
     * @param normalised ratio of the apparent mass to the sitting mass, by bin; empty where that is not known
     * @param impedance_ns_per_m modulus by bin
     * @param absorbed_power_w_per_hz by bin
     * @param sitting_mass_kg null where nothing near 0.5 Hz is excited; then nothing is normalised
     */
    public record DrivingPointFacts(OptionalDouble sitting_mass_kg, double plate_kg, double[] normalised,
            double[] impedance_ns_per_m, double[] absorbed_power_w_per_hz, double absorbed_power_w) {}

    /**
     * Mean of several people's curves, stretched so that their peaks meet.
     *
     * @param peak in the unit of the response
     * @param peak_sd likewise
     * @param mean by bin, in the unit of the response
     * @param sd likewise
     * @param plain_mean likewise, of the curves as they are
     */
    public record PeopleFacts(List<String> names, int averaged, double peak_hz, double peak_sd_hz, double peak, double peak_sd,
            double[] mean, double[] sd, double[] plain_mean) {}

    static ResponseResults of(ResponseAnalysis analysis) {
        MeasuredResponse measured = analysis.measured();
        List<ResponseFacts> facts = new ArrayList<>();
        for (int c = 0; c < analysis.curves().size(); c++) {
            facts.add(facts(analysis, c));
        }
        List<double[]> among = new ArrayList<>();
        List<double[]> densities = new ArrayList<>();
        for (int i = 0; i < measured.inputs().size(); i++) {
            densities.add(measured.response(0).inputDensity(i));
            if (measured.inputs().size() > 1) {
                among.add(measured.response(0).coherenceAmongInputs(i));
            }
        }
        return new ResponseResults(AnalysisResults.RecordingFacts.of(analysis.request().title(), measured.inspection(),
                measured.relay()), names(measured.inputs()), names(measured.outputs()), measured.segmentation().duration(),
                measured.segmentation().resolution(), analysis.request().level(), measured.segmentation().frequencies(),
                densities, among, facts, analysis.request().provenance());
    }

    private static List<String> names(List<Channel> channels) {
        return channels.stream().map(Channel::toString).toList();
    }

    private static ResponseFacts facts(ResponseAnalysis analysis, int c) {
        ResponseCurve curve = analysis.curves().get(c);
        MeasuredResponse measured = analysis.measured();
        int output = measured.outputs().indexOf(curve.output());
        Peak highest = curve.highest();
        double[] band = curve.usableBand();
        return new ResponseFacts(curve.input().toString(), curve.output().toString(), curve.unit(), curve.all().averages(),
                new PeakFacts(highest.frequency(), highest.height(), curve.highestMargin(), curve.peak().isEmpty()),
                band[0], band[1], Polar.of(curve.h1()), curve.margin(), curve.phaseMargin(), curve.bareH2().map(Polar::of),
                Polar.of(curve.hv()),
                curve.all().multipleCoherence(0), curve.all().partialCoherence(0, curve.index()),
                curve.all().ordinaryCoherence(0, curve.index()), curve.usable(),
                Unbacked.reasons(curve.backing(), measured.inputs().size() > 1), measured.others().names(output, curve.backing()),
                measured.others().likeliest(output, curve.backing()).map(OtherCauseFacts::of), curve.all().outputDensity(0),
                curve.model().map(Polar::of), curve.misfit().map(m -> new MisfitFacts(m.relative(), m.inside())),
                analysis.power(curve).map(power -> drivingPoint(curve, power)),
                analysis.mean(c).map(mean -> people(analysis.people(c).keySet(), mean)));
    }

    private static DrivingPointFacts drivingPoint(ResponseCurve curve, AbsorbedPower power) {
        OptionalDouble sitting = curve.apparentMass().sitting(curve.usable());
        double[] normalised = sitting.isPresent() ? curve.apparentMass().normalised(sitting.getAsDouble()) : new double[0];
        return new DrivingPointFacts(sitting, curve.plate(), normalised, curve.apparentMass().impedance().magnitudes(),
                power.density(), power.total());
    }

    private static PeopleFacts people(Set<String> titles, SubjectMean mean) {
        return new PeopleFacts(List.copyOf(titles), mean.people(), mean.peak().frequency(),
                mean.peakDeviation().frequency(), mean.peak().height(), mean.peakDeviation().height(), mean.mean(),
                mean.deviation(), mean.plain());
    }
}
