package wbv.study;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import wbv.filter.BodyEstimate;
import wbv.recording.Channel;
import wbv.recording.inspect.Inspection;
import wbv.recording.inspect.Relay;
import wbv.recording.inspect.Summary;
import wbv.signal.FrequencyResponse;

/**
 * The results of an analysis for machines, as {@code results.json} holds them. Units stand in the names.
 *
 * @param recording what was read and what is wrong with it
 * @param input     name of the exciting channel
 * @param outputs   by output, in the order of the recording
 * @param exposure  null where the recording does not tell it
 * @param states    null where the shipped model of motion states does not fit
 * @param provenance how the results came about
 */
public record AnalysisResults(RecordingFacts recording, String input, List<OutputFacts> outputs,
        Optional<ExposureFacts> exposure, Optional<StateFacts> states, Map<String, String> provenance) {

    /** What was read. */
    public record RecordingFacts(String name, long rows, long samples, double rate_hz, double start_s, double duration_s, String laid,
            Map<String, Summary> channels, List<FindingFacts> findings) {

        static RecordingFacts of(String name, Inspection seen, Relay relay) {
            Map<String, Summary> channels = new LinkedHashMap<>();
            seen.summaries().forEach((channel, summary) -> channels.put(channel.toString(), summary));
            List<FindingFacts> findings = seen.findings().stream().map(f -> new FindingFacts(f.getClass().getSimpleName(),
                    f.severity().name(), f.message(), f.advice())).toList();
            return new RecordingFacts(name, seen.rows(), seen.samples(), seen.clock().rate(), seen.clock().start(),
                    seen.duration(), relay.sentence(), channels, findings);
        }
    }

    /** What is wrong with it. */
    public record FindingFacts(String kind, String severity, String message, String advice) {}

    /** One output: the body over the recording, the stream's last estimate, the transmissibility. */
    public record OutputFacts(String channel, PathBody.Facts body, StreamFacts stream, Optional<ResponseFacts> transmissibility) {}

    /**
     * The streaming estimate after the last sample, and how the estimator fared. Numbers are null where there never was one.
     *
     * @param known_at_s when the estimate was known, from the first sample: after the last sample unless it was lost before
     * @param lost       why nothing is known after the last sample; empty if something is
     * @param mean_nis mean of the normalised innovations squared [1]
     * @param unexplained_rms of a sample of the output, in its channel's unit
     * @param adwin_cuts_s from the first sample, as many as there are, at most 500
     */
    public record StreamFacts(double known_at_s, String lost, double natural_frequency_hz, double natural_frequency_sd_hz,
            double damping_ratio, double damping_ratio_sd,
            double mean_nis, double unexplained_rms, double[] adwin_cuts_s, long changes, long divergences,
            long gaps, long missing) {}

    /**
     * A frequency response at the bins of its segmentation.
     *
     * @param averages number of independent averages
     * @param peak of |H1| where it is usable, in the output's unit over the input's
     * @param h1 |H1| by bin, likewise
     * @param hv |Hv| by bin, likewise
     * @param relative_error relative standard error of |H| by bin
     * @param input_density by bin, in the unit beside it
     * @param output_density by bin, in the unit beside it
     * @param estimator |H| of the body that is followed, by bin [1]
     */
    public record ResponseFacts(double resolution_hz, double averages, long segments, long segments_skipped, double peak_hz, double peak,
            double[] frequency_hz, double[] h1, double[] hv, double[] phase_rad, double[] coherence,
            double[] relative_error, boolean[] usable, String[] unusable_because, String[] other_cause,
            Optional<ResponseResults.OtherCauseFacts> other_motion, String input_unit, double[] input_density,
            String output_unit, double[] output_density, double[] estimator) {}

    /**
     * The exposure of this recording.
     *
     * @param minutes_a_day  what A(8) and verdict are for
     * @param assumed        whether these minutes are assumed, not stated
     * @param verdict        the graver of that by A(8) and that by dose
     * @param minutes_to_action_value a day, by A(8); null if never
     * @param minutes_to_action_value_by_dose likewise
     * @param lower_bound    whether the sampling rate hides what true values have above {@code band_to_hz}
     */
    public record ExposureFacts(String place, Map<String, Double> a_w_m_s2, Map<String, Double> vdv_m_s175, double seconds,
            String worst_axis, double minutes_a_day, boolean assumed, double a8_m_s2, String verdict, double minutes_to_action_value,
            double minutes_to_action_value_by_dose,
            boolean lower_bound, double band_from_hz, double band_to_hz) {}

    /**
     * Motion states as the shipped model tells them.
     *
     * @param seconds   by state
     * @param untold_s time that is unlike what the model learned from
     * @param agreement share of the told samples whose state is what the thresholds say of the sample alone
     */
    public record StateFacts(Map<String, Double> seconds, double untold_s, double agreement) {}

    private static final FollowedBody.Estimate NEVER = new FollowedBody.Estimate(Double.NaN, Double.NaN, Double.NaN, Double.NaN,
            Double.NaN);

    static AnalysisResults of(Analysis analysis) {
        List<OutputFacts> outputs = new ArrayList<>();
        for (int i = 0; i < analysis.followed().size(); i++) {
            outputs.add(output(analysis, i));
        }
        return new AnalysisResults(RecordingFacts.of(analysis.request().title(), analysis.inspection(), analysis.relay()),
                analysis.input().toString(), outputs,
                analysis.exposure().map(measured -> new JudgedExposure(measured).facts()), analysis.states().map(ToldStates::facts),
                analysis.request().provenance());
    }

    private static OutputFacts output(Analysis analysis, int i) {
        FollowedBody body = analysis.followed().get(i);
        BodyEstimate track = body.estimator().track();
        FollowedBody.Estimate known = body.known().orElse(NEVER);
        StreamFacts stream = new StreamFacts(known.time(), body.lost(), known.frequency(), known.frequencyDeviation(), known.damping(),
                known.dampingDeviation(),
                body.meanNis(), track.outputNoise(), body.cuts(), track.changes(), track.divergences(), track.gaps(),
                track.missing());
        Optional<ResponseFacts> facts = analysis.frequencyResponse(i).map(h -> response(analysis, i, h, body));
        return new OutputFacts(body.channel().toString(), analysis.bodies().get(i).facts(), stream, facts);
    }

    private static ResponseFacts response(Analysis analysis, int i, FrequencyResponse h, FollowedBody body) {
        double[] modulus = h.h1().magnitudes();
        int peak = -1;
        for (int k = 0; k < modulus.length; k++) {
            peak = h.usable()[k] && (peak < 0 || modulus[k] > modulus[peak]) ? k : peak;
        }
        double[] model = java.util.Arrays.stream(h.frequency()).map(body.estimator()::modulus).toArray();
        return new ResponseFacts(analysis.segmentation().resolution(), h.averages(), analysis.segments(i), analysis.segmentsSkipped(i),
                peak < 0 ? Double.NaN : h.frequency()[peak], peak < 0 ? Double.NaN : modulus[peak], h.frequency(), modulus,
                h.hv().magnitudes(), h.h1().phases(), h.coherence(), h.error(), h.usable(),
                Unbacked.reasons(h.backing(), false), analysis.otherAxes().names(i, h.backing()),
                analysis.otherAxes().likeliest(i, h.backing()).map(ResponseResults.OtherCauseFacts::of),
                density(analysis.input()), h.inputDensity(), density(body.channel()), h.outputDensity(), model);
    }

    /** Unit of a density: that of the channel squared, over hertz. */
    private static String density(Channel channel) {
        return "(" + channel.quantity().unit() + ")²/Hz";
    }
}
