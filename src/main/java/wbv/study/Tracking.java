package wbv.study;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import wbv.learn.Detectors;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;
import wbv.recording.inspect.Inspection;
import wbv.recording.inspect.RowBlock;
import wbv.recording.inspect.UniformReader;
import wbv.result.OutputFolder;
import wbv.result.ResultsJson;
import wbv.signal.Envelope;
import wbv.task.TrackFile;

/** A recording followed by one or more estimators in one pass, with flat memory. */
public final class Tracking {

    private static final int ENVELOPE_POINTS = 2000;
    private static final List<String> FILES = List.of("tracks.csv", "tracks.arff", "tracks.json");

    private final TrackingRequest request;
    private final Inspection inspection;
    private final Channel input;
    private final Envelope inputSamples = new Envelope(ENVELOPE_POINTS);
    private final List<Channel> outputs;
    private final List<FollowedBody> followed = new ArrayList<>();
    private final PathBodies paths;
    private List<PathBody> bodies = List.of();

    private Tracking(TrackingRequest request, Inspection inspection) {
        this.request = request;
        this.inspection = inspection;
        List<Channel> channels = List.copyOf(inspection.summaries().keySet());
        input = request.channels().chooseInput(channels, inspection.name());
        inspection.require(input);
        double rate = inspection.clock().rate();
        if (rate <= 2 * request.frequency()) {
            throw DataFault.in(inspection.name(), String.format(Locale.ROOT, "is sampled at %.4g Hz; to follow a body from %.4g Hz on takes"
                    + " more than %.4g Hz", rate, request.frequency(), 2 * request.frequency()));
        }
        outputs = request.channels().chooseOutputs(channels, input, inspection.name());
        for (Channel output : outputs) {
            inspection.require(output);
            if (output.equals(input)) {
                throw new DataFault("input and output are both " + input + "; choose two channels");
            }
            if (PathBodies.kind(output) != PathBodies.kind(input) || PathBodies.kind(output) == Quantity.FORCE) {
                throw new DataFault(output + " cannot answer " + input
                        + ": input and output must be two accelerations or two angular rates");
            }
            request.designs().forEach(design -> followed.add(new FollowedBody(output, design,
                    request.spec(PathBodies.kind(input), inspection.clock().rate()), Detectors.named(request.detector()),
                    request.others().size())));
        }
        for (Channel other : request.others()) {
            inspection.require(other);
            if (other.equals(input) || outputs.contains(other)) {
                throw new DataFault(other + " is " + (other.equals(input) ? "the input" : "an output")
                        + " already; a crossing motion is another of the base");
            }
        }
        List<Channel> motions = request.others().isEmpty() ? PathBodies.motionsOf(channels, input, outputs) : request.others();
        paths = new PathBodies(inspection.clock().rate(), input, motions, outputs);
    }

    /**
     * Tracks and writes {@code tracks.csv}, {@code tracks.arff} and {@code tracks.json} on the way, then
     * {@code results.json}.
     *
     * @param progress told the step and the share of it that is done, 0 to 1 or NaN
     * @throws DataFault if the recording cannot be tracked
     */
    public static Tracking run(TrackingRequest request, OutputFolder out, BiConsumer<String, Double> progress)
            throws IOException {
        Inspection inspection = request.source().inspect(share -> progress.accept("reading", share));
        Tracking tracking = new Tracking(request, inspection);
        tracking.follow(out, progress);
        ResultsJson.write(TrackingResults.of(tracking), out.file("results.json"));
        return tracking;
    }

    private void follow(OutputFolder out, BiConsumer<String, Double> progress) throws IOException {
        try (UniformReader reader = request.source().uniform(inspection); BodyTracks tracks = new BodyTracks()) {
            for (String name : FILES) {
                tracks.into(file(out.file(name)));
            }
            followed.forEach(one -> tracks.follow(one, reader, input, request.others()));
            List<Consumer<RowBlock>> takers = new ArrayList<>(tracks.takers());
            takers.add(RowBlock.each(reader, List.of(input), motion -> inputSamples.accept(motion[0])));
            takers.add(RowBlock.each(reader, paths.channels(), paths::accept));
            RowBlock block = new RowBlock(1 + reader.channels().size());
            while (block.read(reader)) {
                block.show(takers);
                tracks.write(block);
                progress.accept("tracking", reader.fractionRead());
            }
            tracks.finish();
            progress.accept("fitting", Double.NaN);
            bodies = paths.bodies(request.degrees());
        }
    }

    private TrackFile file(Path path) throws IOException {
        return TrackFile.of(path, followed.stream().map(one -> new TrackFile.Body(one.name(), one.design().degrees(),
                PathBodies.kind(input) == Quantity.ANGULAR_RATE ? "rad_s" : "m_s2")).toList(), request.provenance());
    }

    private String crossing() {
        return request.others().isEmpty() ? "" : ", crossed by " + names(", ");
    }

    private String names(String separator) {
        return request.others().stream().map(Channel::toString).collect(Collectors.joining(separator));
    }

    /** What matters most, in a few lines of text. */
    public String summary() {
        StringBuilder text = new StringBuilder(String.format(Locale.ROOT, "%s: %.1f s at %.4g Hz, from %s%n", request.title(),
                inspection.duration(), inspection.clock().rate(), input + crossing()));
        for (int i = 0; i < outputs.size(); i++) {
            text.append(String.format(Locale.ROOT, "%-20s %s%n", outputs.get(i), bodies.get(i).line()));
            for (FollowedBody one : followed.subList(i * request.designs().size(), (i + 1) * request.designs().size())) {
                text.append(String.format(Locale.ROOT, "  at the end, %-12s %s%n", one.design().method().word(), one.line()));
            }
        }
        return text.toString();
    }

    /** The MOA task that follows the first output by the last estimator. */
    public String taskString() {
        FollowedBody one = followed.get(request.designs().size() - 1);
        double density = one.estimator().spec().outputNoise() / Math.sqrt(inspection.clock().rate() / 2);
        String source = request.source().toString();
        return String.format(Locale.ROOT,
                "wbv.task.TrackBody -l (wbv.learn.BodyTracker -m %s -g %d -f %s -d %s -n %s -p %d -r %d%s%s)"
                        + " -s (wbv.stream.RecordingStream -f %s -i %s -o %s)",
                one.design().method().word(), one.design().degrees(),
                request.frequency(), request.damping(), density, one.design().particles(), one.design().seed(),
                request.others().isEmpty() ? "" : " -x " + names(","), detector(),
                source.contains(" ") ? "'" + source + "'" : source,
                request.others().isEmpty() ? input : input + "," + names(","), one.channel());
    }

    private String detector() {
        return request.detector().equals(Detectors.USUAL) ? ""
                : " -a " + (request.detector().contains(" ") ? "(" + request.detector() + ")" : request.detector());
    }

    /** What was asked. */
    public TrackingRequest request() {
        return request;
    }

    /** What a first look at every sample found. */
    public Inspection inspection() {
        return inspection;
    }

    /** What moves all bodies. */
    public Channel input() {
        return input;
    }

    /** What answers. */
    public List<Channel> outputs() {
        return outputs;
    }

    /** The input's samples, for drawing. */
    public Envelope inputSamples() {
        return inputSamples;
    }

    /** The body between the input and each output over the recording. */
    public List<PathBody> bodies() {
        return bodies;
    }

    /** By output, and by estimator within. */
    public List<FollowedBody> followed() {
        return followed;
    }
}
