package wbv.study;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import wbv.filter.model.Bounds.Attribute;
import wbv.pole.Chord;
import wbv.pole.RemovalCheck;
import wbv.pole.SensorRemoval;
import wbv.pole.TrainedPoles;
import wbv.recording.AtomicFile;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.result.OutputFolder;
import wbv.result.ResultsJson;

/**
 * A recording without some of its sensors: their motion as trained poles predict it, and their bodies as the constrained
 * estimator follows them within the polygons' bounds, with no sample of theirs.
 */
public final class WithoutSensors {

    private final TrainedPoles trained;
    private final String name;
    private final Recording recording;
    private final SensorRemoval.Prediction prediction;
    private final List<Channel> absent;

    /** Results for machines. */
    record Results(String recording, String finding, List<Place> absent, @JsonProperty("poles_seen") int seen,
            @JsonProperty("windows_lost") int lost,
            @JsonProperty("polygons_cut_inside") double inside, Map<String, String> provenance) {}

    /**
     * @param frequency of the body at the end, NaN-free; errors are null where the sensor was there all the time and nothing to
     * compare
     */
    record Place(String channel, @JsonProperty("frequency_Hz") double frequency, double damping,
            @JsonProperty("error_over_variance") Double error, @JsonProperty("peak_off_Hz") Double frequencyOff,
            @JsonProperty("peak_off") Double magnitudeOff) {}

    private WithoutSensors(TrainedPoles trained, String name, Recording recording, List<Channel> absent) {
        this.trained = trained;
        this.name = name;
        this.recording = recording;
        this.absent = absent;
        this.prediction = new SensorRemoval(trained).predict(name, recording);
    }

    /**
     * Runs.
     *
     * @param places whose sensors are not looked at
     * @throws DataFault if the polygons were not trained for a place, or the recording lacks what they rest on
     */
    public static WithoutSensors run(TrainedPoles trained, String name, Recording recording, List<String> places) {
        List<Channel> absent = new ArrayList<>();
        for (String place : places) {
            absent.add(trained.layout().absent().stream().filter(channel -> channel.location().equals(place)).findFirst()
                    .orElseThrow(
                            () -> new DataFault("the polygons say nothing of '" + place + "'; they were trained for " + trained.layout()
                                    .absent())));
        }
        return new WithoutSensors(trained, name, recording, absent);
    }

    /** Writes prediction.csv, tracks.csv and results.json. */
    public void write(Map<String, String> provenance, OutputFolder out) throws IOException {
        prediction.writeMotion(out.file("prediction.csv"), absent, recording);
        AtomicFile.write(out.file("tracks.csv"), tracksText().getBytes(StandardCharsets.UTF_8));
        ResultsJson.write(results(provenance), out.file("results.json"));
    }

    private String tracksText() {
        StringBuilder text = new StringBuilder("t");
        for (Channel channel : absent) {
            for (String column : List.of("frequency_Hz", "frequency_lower_Hz", "frequency_upper_Hz", "damping", "damping_lower",
                    "damping_upper",
                    "body_prediction_m_s2")) {
                text.append(',').append(channel.location()).append('.').append(column);
            }
        }
        text.append('\n');
        int current = -1;
        for (int k = 0; k < recording.length(); k++) {
            while (current + 1 < prediction.seen().size() && prediction.seen().get(current + 1).sample() <= k) {
                current++;
            }
            text.append(recording.clock().time(k));
            for (Channel channel : absent) {
                SensorRemoval.Body body = prediction.bodies().get(channel);
                text.append(',').append(body.frequency()[k]);
                bounds(text, channel, current, 0);
                text.append(',').append(body.damping()[k]);
                bounds(text, channel, current, 1);
                text.append(',').append(Double.isNaN(body.motion()[k]) ? "" : Double.toString(body.motion()[k]));
            }
            text.append('\n');
        }
        return text.toString();
    }

    private void bounds(StringBuilder text, Channel channel, int current, int attribute) {
        if (current < 0) {
            text.append(",,");
        } else {
            Chord chord = prediction.seen().get(current).bounds().get(channel).get(attribute);
            text.append(',').append(chord.lower()).append(',').append(chord.upper());
        }
    }

    /** Natural frequency [Hz] or damping ratio of an absent place's body at a sample. */
    public double at(Channel channel, Attribute attribute, int sample) {
        SensorRemoval.Body body = prediction.bodies().get(channel);
        return (attribute == Attribute.FREQUENCY ? body.frequency() : body.damping())[sample];
    }

    private List<RemovalCheck> checks() {
        return prediction.seen().isEmpty() ? List.of() : RemovalCheck.of(trained, name, recording, prediction).stream()
                .filter(check -> absent.contains(check.channel())).toList();
    }

    private Results results(Map<String, String> provenance) {
        List<RemovalCheck> checks = checks();
        List<Place> places = new ArrayList<>();
        for (Channel channel : absent) {
            SensorRemoval.Body body = prediction.bodies().get(channel);
            int last = recording.length() - 1;
            RemovalCheck check = checks.stream().filter(each -> each.channel().equals(channel)).findFirst().orElse(null);
            places.add(new Place(channel.toString(), body.frequency()[last], body.damping()[last], check == null ? null
                    : (Double) check.error(),
                    check == null ? null : check.frequencyOff().orElse(null), check == null ? null : check.magnitudeOff()
                            .orElse(null)));
        }
        return new Results(name, finding(), places, prediction.seen().size(), prediction.lost(), prediction.inside(), provenance);
    }

    /** What the sensors say of the prediction where they were there all the time, else that nobody can; or why there is none. */
    public String finding() {
        if (prediction.seen().isEmpty()) {
            return summary().strip();
        }
        List<RemovalCheck> checks = checks();
        List<String> said = new ArrayList<>();
        for (Channel channel : absent) {
            RemovalVerdict verdict = RemovalVerdict.of(channel, checks);
            said.add(!verdict.tried() ? "how well " + channel + " is predicted cannot be told, since nothing measured it"
                    : verdict.holds() ? String.format(Locale.ROOT, "%s is predicted but for %.1f %% of its variance", channel, 100
                            * verdict.most()) : channel + " is not predicted: " + verdict.reason());
        }
        String text = String.join("; ", said);
        return Character.toUpperCase(text.charAt(0)) + text.substring(1) + ".";
    }

    /** The result in a few lines. */
    public String summary() {
        if (prediction.seen().isEmpty()) {
            return "No pole of " + trained.layout().measured() + " like those trained was found in " + prediction.lost()
                    + " windows: the population's median stands in all the time.\n";
        }
        StringBuilder text = new StringBuilder(finding() + System.lineSeparator()).append(String.format(Locale.ROOT,
                "%d windows told the pole of %s, %d did not; %.0f %% of the bounds lie within the trained polygons%n",
                prediction.seen().size(),
                trained.layout().measured(), prediction.lost(), 100 * prediction.inside()));
        for (Channel channel : absent) {
            SensorRemoval.Body body = prediction.bodies().get(channel);
            text.append(String.format(Locale.ROOT, "%-18s natural frequency %.2f Hz, damping ratio %.3f at the end%n", channel,
                    body.frequency()[recording.length() - 1], body.damping()[recording.length() - 1]));
        }
        for (RemovalCheck check : checks()) {
            text.append(String.format(Locale.ROOT, "%-18s the sensor says: %.1f %% of its variance is not predicted%n",
                    check.channel(),
                    100 * check.error()));
        }
        return text.toString();
    }

    /** What it was predicted by. */
    public TrainedPoles trained() {
        return trained;
    }

    /** Of the recording. */
    public String name() {
        return name;
    }

    /** With all sensors that it has; the absent ones only to compare. */
    public Recording recording() {
        return recording;
    }

    /** The absent places' motion and the bounds of their bodies. */
    public SensorRemoval.Prediction prediction() {
        return prediction;
    }

    /** Whose sensors were not looked at. */
    public List<Channel> absent() {
        return absent;
    }
}
