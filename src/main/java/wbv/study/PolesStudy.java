package wbv.study;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import wbv.identify.Pole;
import wbv.pole.PlaceClusters;
import wbv.pole.PoleTraining;
import wbv.pole.PolygonFile;
import wbv.pole.RemovalCheck;
import wbv.pole.SensorRemoval;
import wbv.recording.AtomicFile;
import wbv.recording.Recording;
import wbv.result.OutputFolder;
import wbv.result.ResultsJson;

/**
 * Trained poles, tried on recordings that took no part: {@code polygons.json}, {@code poles.csv} and {@code results.json}.
 */
public final class PolesStudy {

    /** A recording that took no part. */
    public record HeldBack(String name, Recording recording, SensorRemoval.Prediction prediction, List<RemovalCheck> checks) {}

    private final PoleTraining.Result result;
    private final List<HeldBack> heldBack = new ArrayList<>();

    /** Tried on nothing yet. */
    public PolesStudy(PoleTraining.Result result) {
        this.result = result;
    }

    /**
     * Tries what was learned on a recording that took no part.
     *
     * @param name of the recording
     */
    public void check(String name, Recording recording) {
        SensorRemoval.Prediction prediction = new SensorRemoval(result.trained()).predict(name, recording);
        heldBack.add(new HeldBack(name, recording, prediction, RemovalCheck.of(result.trained(), name, recording,
                prediction)));
    }

    /**
     * What {@code results.json} holds.
     *
     * @param recordings that were held back
     * @param pole_hz of the place that stays measured
     */
    record Results(String measured, double pole_hz, int trained_on, int recordings, List<RemovalVerdict> predicted,
            Map<String, String> provenance) {}

    /**
     * Writes all three.
     *
     * @param provenance what, and from what, this was made, in the order in which it is shown
     */
    public void write(Map<String, String> provenance, OutputFolder out) throws IOException {
        AtomicFile.write(out.file("polygons.json"), PolygonFile.text(result.trained(), provenance));
        StringBuilder csv = new StringBuilder("place,window,re_rad_per_s,im_rad_per_s,frequency_Hz,damping,dbscan,optics,em\n");
        for (PlaceClusters place : result.places()) {
            int[] optics = place.optics();
            int[] mixture = place.mixture();
            for (int i = 0; i < place.poles().size(); i++) {
                Pole pole = place.poles().get(i);
                csv.append(place.place()).append(',').append(place.window()[i]).append(',').append(pole.re()).append(',')
                        .append(pole.im()).append(',').append(pole.frequency()).append(',').append(pole.damping()).append(',')
                        .append(place.dbscan()[i]).append(',').append(optics[i]).append(',').append(mixture[i])
                        .append('\n');
            }
        }
        AtomicFile.write(out.file("poles.csv"), csv);
        ResultsJson.write(new Results(result.trained().layout().measured().toString(), result.trained().typical().frequency(),
                result.trained().trials().size(), heldBack.size(), verdicts(), provenance),
                out.file("results.json"));
    }

    /** The result in a few lines. */
    public String summary() {
        StringBuilder text = new StringBuilder(RemovalVerdict.sentence(verdicts(),
                heldBack.size())).append(System.lineSeparator());
        for (PlaceClusters place : result.places()) {
            text.append(String.format(Locale.ROOT, "%-18s %4d poles, %d clusters, %d noise (epsilon %.3f)%n", place.place(),
                    place.poles().size(),
                    place.count(), place.members(-1).size(), place.curve().epsilon()));
        }
        for (HeldBack held : heldBack) {
            for (RemovalCheck check : held.checks()) {
                text.append(String.format(Locale.ROOT,
                        "held back %s: %s predicted, %.1f %% of its variance left (mean body %.1f %%), peak %+.2f Hz, %+.2f%n",
                        held.name(), check.channel(), 100 * check.error(), 100 * check.meanError(), check.frequencyOff()
                                .orElse(Double.NaN),
                        check.magnitudeOff().orElse(Double.NaN)));
            }
        }
        return text.toString();
    }

    /** What the recordings that took no part say, by absent channel. */
    public List<RemovalVerdict> verdicts() {
        List<RemovalCheck> checks = heldBack.stream().flatMap(held -> held.checks().stream()).toList();
        return result.trained().layout().absent().stream().map(channel -> RemovalVerdict.of(channel, checks)).toList();
    }

    /** What was trained. */
    public PoleTraining.Result result() {
        return result;
    }

    /** The recordings that took no part. */
    public List<HeldBack> heldBack() {
        return List.copyOf(heldBack);
    }
}
