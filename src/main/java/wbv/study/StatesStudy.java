package wbv.study;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import wbv.recording.AtomicFile;
import wbv.result.OutputFolder;
import wbv.state.Confusion;
import wbv.state.HeadLag;
import wbv.state.MotionState;
import wbv.state.Reliability;
import wbv.state.SeatToHead;
import wbv.state.StateFiles;
import wbv.state.StateModel;
import wbv.state.StateTrack;
import wbv.state.TrueStates;

/** Motion states of recordings: JSON, CSV, ARFF. */
public final class StatesStudy {

    private final StateModel model;
    private final List<Labelled> labelled = new ArrayList<>();
    private final Confusion confusion = new Confusion();
    private final Confusion live = new Confusion();
    private final List<Reliability> forecasts = List.of(new Reliability(), new Reliability(), new Reliability());

    /**
     * A recording with what was said of it.
     *
     * @param body natural frequency [Hz] and damping ratio by the Kalman estimator
     */
    public record Labelled(String name, StateTrack track, SeatToHead way, Optional<double[]> body) {}

    /** Of no recording yet. */
    public StatesStudy(StateModel model) {
        this.model = model;
    }

    /**
     * Takes a recording's labels.
     *
     * @param body  natural frequency [Hz] and damping ratio from seat to head by the streaming estimator, where it found them
     * @param truth what truly happened, where it is known
     */
    public void add(String name, StateTrack track, Optional<double[]> body, Optional<TrueStates> truth) {
        labelled.add(new Labelled(name, track, SeatToHead.of(track), body));
        if (truth.isPresent()) {
            TrueStates states = truth.get();
            count(confusion, states, track, false);
            count(live, states, track, true);
            for (int h = 0; h < forecasts.size(); h++) {
                states.addTo(forecasts.get(h), track, h);
            }
        }
    }

    private static void count(Confusion into, TrueStates truth, StateTrack track, boolean live) {
        truth.against(track, live);
        for (int i = 0; i < track.length(); i++) {
            into.add(truth.states().get(i), live ? track.live(i) : track.state(i));
        }
    }

    /**
     * Writes {@code results.json}, and of the first recording {@code labels.csv}, {@code labels.arff}, {@code
     * bags.arff}.
     */
    public void write(Map<String, String> provenance, OutputFolder out) throws IOException {
        StateTrack first = labelled.get(0).track();
        StateFiles.writeCsv(first, out.file("labels.csv"));
        StateFiles.writeArff(first, out.file("labels.arff"));
        StateFiles.writeBags(first, out.file("bags.arff"));
        AtomicFile.write(out.file("results.json"), json(provenance));
    }

    private String json(Map<String, String> provenance) {
        ObjectNode root = new ObjectMapper().createObjectNode();
        for (Labelled each : labelled) {
            ObjectNode node = root.withArray("recordings").addObject().put("name", each.name())
                    .put("log_likelihood", each.track().logLikelihood());
            ObjectNode seconds = node.putObject("seconds");
            for (MotionState state : model.known()) {
                seconds.put(state.toString(), seconds(each.track(), state));
            }
            ObjectNode way = node.putObject("seat_to_head").put("jerk_samples", each.way().samples());
            put(way, "lag_s", each.way().lag().map(HeadLag.Lag::seconds).orElse(Double.NaN));
            put(way, "lag_standard_deviation_s", each.way().lag().map(HeadLag.Lag::deviation).orElse(Double.NaN));
            put(way, "jolts", each.way().lag().map(HeadLag.Lag::jolts).orElse(0.0));
            put(way, "frequency_Hz", each.way().frequency());
            put(way, "damping_ratio", each.way().damping());
            each.body().ifPresent(body -> {
                put(way, "kalman_frequency_Hz", body[0]);
                put(way, "kalman_damping_ratio", body[1]);
            });
        }
        if (confusion.all() > 0) {
            ObjectNode against = root.putObject("against_truth").put("samples", confusion.all())
                    .put("accuracy", confusion.accuracy()).put("macro_f1", confusion.macroF1()).put("accuracy_live",
                            live.accuracy());
            for (int h = 0; h < forecasts.size(); h++) {
                ObjectNode forecast = against.withArray("forecasts").addObject().put("within_s", StateTrack.HORIZONS[h]);
                put(forecast, "area_under_curve", forecasts.get(h).area());
                put(forecast, "calibration_error", forecasts.get(h).calibrationError());
            }
        }
        ObjectNode made = root.putObject("provenance");
        provenance.forEach(made::put);
        return root.toPrettyString() + "\n";
    }

    private static void put(ObjectNode node, String name, double value) {
        if (Double.isFinite(value)) {
            node.put(name, value);
        } else {
            node.putNull(name);
        }
    }

    /** Time for which a state was told [s]. */
    public static double seconds(StateTrack track, MotionState state) {
        int samples = 0;
        for (int i = 0; i < track.length(); i++) {
            samples += track.state(i) == state ? 1 : 0;
        }
        return samples / track.model().features().rate();
    }

    /** The result in a few lines. */
    public String summary() {
        StringBuilder text = new StringBuilder();
        for (Labelled each : labelled) {
            text.append(each.name()).append(':');
            for (MotionState state : model.known()) {
                double seconds = seconds(each.track(), state);
                text.append(seconds > 0 ? String.format(Locale.ROOT, " %s %.1f s,", state, seconds) : "");
            }
            text.setCharAt(text.length() - 1, '\n');
            text.append(each.way().lag().map(lag -> String.format(Locale.ROOT, "  the head jerks %.1f ± %.1f ms (2σ) after the seat",
                    1000 * lag.seconds(), 2000 * lag.deviation())).orElse("  no lag of the head: fewer than three jolts stand out"));
            if (Double.isFinite(each.way().frequency())) {
                text.append(String.format(Locale.ROOT, ", like a body of %.2f Hz, damping ratio %.2f", each.way().frequency(),
                        each.way().damping()));
            }
            each.body().ifPresent(body -> text.append(String.format(Locale.ROOT, " (Kalman: %.2f Hz, %.2f)", body[0], body[1])));
            text.append('\n');
        }
        if (confusion.all() > 0) {
            text.append(String.format(Locale.ROOT,
                    "Against the rig's truth: accuracy %.1f %% (live %.1f %%), macro-F1 %.2f; a jerk within 100 ms: AUC %.3f%n",
                    100 * confusion.accuracy(), 100 * live.accuracy(), confusion.macroF1(), forecasts.get(0).area()));
        }
        return text.toString();
    }

    /** What tells the states. */
    public StateModel model() {
        return model;
    }

    /** The recordings, in the order in which they came. */
    public List<Labelled> labelled() {
        return List.copyOf(labelled);
    }

    /** Of the states told afterwards, against the truth; empty where that is not known. */
    public Confusion confusion() {
        return confusion;
    }

    /** The same of the states told as the samples came. */
    public Confusion live() {
        return live;
    }

    /** Of forecasts, by horizon. */
    public List<Reliability> forecasts() {
        return forecasts;
    }
}
