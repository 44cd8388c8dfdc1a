package wbv.report;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import wbv.filter.Track;
import wbv.recording.Inspection;
import wbv.recording.Summary;
import wbv.signal.FrequencyResponse;

/**
 * The results of an analysis for machines, as {@code results.json} holds them. Units stand in the names.
 *
 * @param recording what was read and what is wrong with it
 * @param input     name of the exciting channel
 * @param outputs   by output, in the order of the recording
 * @param provenance how the results came about
 */
public record AnalysisResults(RecordingFacts recording, String input, List<OutputFacts> outputs, Map<String, String> provenance) {

    /** What was read. */
    public record RecordingFacts(String name, long rows, long samples, double rate_hz, double start_s, double duration_s, String laid,
                                 Map<String, Summary> channels, List<FindingFacts> findings) { }

    /** What is wrong with it. */
    public record FindingFacts(String kind, String severity, String message, String advice) { }

    /** One output. */
    public record OutputFacts(String channel, BodyFacts body, Optional<ResponseFacts> transmissibility) { }

    /** The estimate after the last sample, and how the estimator fared. @param found false if the estimate is what was assumed at the start */
    public record BodyFacts(boolean found, double natural_frequency_hz, double natural_frequency_sd_hz, double damping_ratio, double damping_ratio_sd,
                            double mean_nis, double unexplained_rms_m_per_s2, double[] adwin_cuts_s, long changes, long divergences,
                            long gaps, long missing) { }

    /** A frequency response at the bins of its segmentation. */
    public record ResponseFacts(double resolution_hz, double averages, long segments, long segments_skipped, double peak_hz, double peak,
                                double[] frequency_hz, double[] h1, double[] hv, double[] phase_rad, double[] coherence,
                                double[] relative_error, boolean[] usable, double[] input_m2_per_s4_per_hz,
                                double[] output_m2_per_s4_per_hz, double[] estimator) { }

    static AnalysisResults of(Analysis analysis) {
        Inspection seen = analysis.inspection();
        Map<String, Summary> channels = new LinkedHashMap<>();
        seen.summaries().forEach((channel, summary) -> channels.put(channel.toString(), summary));
        List<FindingFacts> findings = seen.findings().stream().map(f -> new FindingFacts(f.getClass().getSimpleName(),
                f.severity().name(), f.message(), f.advice())).toList();
        List<OutputFacts> outputs = new ArrayList<>();
        for (int i = 0; i < analysis.responses().size(); i++) {
            outputs.add(output(analysis, i));
        }
        return new AnalysisResults(new RecordingFacts(seen.name(), seen.rows(), seen.samples(), seen.clock().rate(), seen.clock().start(),
                seen.duration(), analysis.relay().sentence(), channels, findings), analysis.input().toString(), outputs,
                analysis.request().provenance());
    }

    private static OutputFacts output(Analysis analysis, int i) {
        Response response = analysis.responses().get(i);
        Track track = response.estimator().track();
        BodyFacts body = new BodyFacts(track.found(), track.frequency(), track.frequencyDeviation(), track.damping(), track.dampingDeviation(),
                response.meanNis(), track.outputNoise(), response.cuts(), track.changes(), track.divergences(), track.gaps(),
                track.missing());
        Optional<ResponseFacts> facts = analysis.frequencyResponse(i).map(h -> response(analysis, i, h, response));
        return new OutputFacts(response.channel().toString(), body, facts);
    }

    private static ResponseFacts response(Analysis analysis, int i, FrequencyResponse h, Response response) {
        double[] modulus = h.h1().magnitudes();
        int peak = -1;
        for (int k = 0; k < modulus.length; k++) {
            peak = h.usable()[k] && (peak < 0 || modulus[k] > modulus[peak]) ? k : peak;
        }
        double[] model = java.util.Arrays.stream(h.frequency()).map(response.estimator()::modulus).toArray();
        return new ResponseFacts(analysis.segmentation().resolution(), h.averages(), analysis.segments(i), analysis.segmentsSkipped(i),
                peak < 0 ? Double.NaN : h.frequency()[peak], peak < 0 ? Double.NaN : modulus[peak], h.frequency(), modulus,
                h.hv().magnitudes(), h.h1().phases(), h.coherence(), h.error(), h.usable(), h.inputDensity(), h.outputDensity(), model);
    }
}
