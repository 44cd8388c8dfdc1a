package wbv.study;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import wbv.filter.BodyEstimate;
import wbv.recording.Channel;

/**
 * The results of a tracking for machines, as {@code results.json} holds them. Units stand in the names.
 *
 * @param recording name of the recording
 * @param input     name of the exciting channel
 * @param crossed_by names of other motions of the base, whose part in the outputs was taken away
 * @param bodies    the equivalent body over the recording, by output
 * @param tracks    one for each output and estimator
 */
public record TrackingResults(String recording, double rate_hz, double duration_s, String input,
        List<String> crossed_by, Map<String, PathBody.Facts> bodies,
        List<TrackFacts> tracks,
        Map<String, String> provenance) {

    /**
     * What an estimator knew after the last sample, and how it fared.
     *
     * @param mse             mean square of output less prediction, from ten seconds on, in the channel's unit squared
     * @param mse_of_variance the same over the output's variance [1]
     * @param mean_nis mean of the normalised innovations squared [1]
     * @param unexplained_rms of a sample of the output, in its channel's unit
     * @param changes_s from the first sample, as many as there are, at most 500
     */
    public record TrackFacts(String output, String estimator, int degrees, List<ModeFacts> modes, double share, double mse,
            double mse_of_variance, double mean_nis, double unexplained_rms, double excited_share,
            double[] changes_s, List<String> changes_heard_by, long cuts, long divergences, long reseeds, long gaps, long missing,
            String caution) {}

    /** One mode. */
    public record ModeFacts(double natural_frequency_hz, double natural_frequency_sd_hz, double damping_ratio,
            double damping_ratio_sd) {}

    static TrackingResults of(Tracking tracking) {
        List<TrackFacts> facts = new ArrayList<>();
        for (FollowedBody one : tracking.followed()) {
            BodyEstimate track = one.track();
            List<ModeFacts> modes = new ArrayList<>();
            for (int m = 0; m < track.modes(); m++) {
                modes.add(new ModeFacts(track.frequency(m), track.frequencyDeviation(m), track.damping(m),
                        track.dampingDeviation(m)));
            }
            facts.add(new TrackFacts(one.channel().toString(), one.design().method().word(), one.design().degrees(), modes,
                    track.share(), one.meanSquareError(), one.relativeError(), one.meanNis(), track.outputNoise(), one.excited(),
                    one.changes(), one.heardBy(), track.cuts(), track.divergences(), track.reseeds(), track.gaps(), track.missing(),
                    one.caution()));
        }
        Map<String, PathBody.Facts> bodies = new LinkedHashMap<>();
        tracking.bodies().forEach(body -> bodies.put(body.output().toString(), body.facts()));
        return new TrackingResults(tracking.request().title(), tracking.inspection().clock().rate(),
                tracking.inspection().duration(), tracking.input().toString(),
                tracking.request().others().stream().map(Channel::toString).toList(), bodies, facts, tracking.request().provenance());
    }
}
