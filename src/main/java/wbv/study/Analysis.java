package wbv.study;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.exposure.SeatMeasurement;
import wbv.exposure.SeatMeter;
import wbv.filter.model.Spec;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.Quantity;
import wbv.recording.inspect.Inspection;
import wbv.recording.inspect.Relay;
import wbv.recording.inspect.RowBlock;
import wbv.recording.inspect.UniformReader;
import wbv.result.OutputFolder;
import wbv.result.ResultsJson;
import wbv.signal.CrossSpectrum;
import wbv.signal.Detrend;
import wbv.signal.FrequencyResponse;
import wbv.signal.GapBridge;
import wbv.signal.Segmentation;
import wbv.signal.Spectrogram;
import wbv.state.StateModel;
import wbv.state.StateModelFile;
import wbv.state.StateRuns;
import wbv.task.TrackFile;

/**
 * One recording analysed in two passes with flat memory: an inspection, then spectra and streaming estimates side by side, sample
 * by sample on the uniform clock.
 */
public final class Analysis {

    private static final int SPECTROGRAM_COLUMNS = 400;
    /** Samples that the page holds of a channel that is shown at once: an hour and three quarters at 60 Hz. */
    private static final int SHOWN = 400_000;
    /** Samples that it holds of all others together. */
    private static final int OTHERS = 600_000;
    private static final int LEAST_SEGMENTS = 4;
    /** Missing samples that spectra bridge [s]. */
    private static final double LONGEST_BRIDGE = 0.05;
    /** Share of a segment that spectrograms bridge in a row: what is lost of the density is less than half a decibel. */
    private static final double PICTURED_BRIDGE = 0.1;

    private final AnalysisRequest request;
    private final Inspection inspection;
    private final Channel input;
    private final Map<Channel, Waveform> waveforms = new LinkedHashMap<>();
    private final Optional<StateRuns> states;
    private final List<FollowedBody> followed = new ArrayList<>();
    private final CrossSpectrum spectra;
    private final Spectrogram inputSpectrogram;
    private final Spectrogram outputSpectrogram;
    private final int leading;
    private final GapBridge[] bridges;
    private final double[] answers;
    private final PathBodies paths;
    private List<PathBody> bodies = List.of();
    private final GapBridge inputPicture;
    private final GapBridge outputPicture;
    private Optional<SeatMeasurement> exposure = Optional.empty();
    private String noExposure = "";
    private Metadata metadata = Metadata.NONE;
    private int warmUp;
    private int pictureWarmUp;
    private OtherAxes otherAxes;
    private Relay relay = new Relay(0, 0, 0, 0, 0, 0);

    private Analysis(AnalysisRequest request, Inspection inspection) {
        this.request = request;
        this.inspection = inspection;
        List<Channel> channels = List.copyOf(inspection.summaries().keySet());
        input = request.chooseInput(channels, inspection.name());
        inspection.require(input);
        List<Channel> outputs = request.chooseOutputs(channels, input, inspection.name());
        double rate = inspection.clock().rate();
        for (Channel output : outputs) {
            inspection.require(output);
            if (output.equals(input)) {
                throw new DataFault("input and output are both " + input + "; choose two channels");
            }
            followed.add(FollowedBody.usual(output, Spec.at(rate).startingAt(request.frequency(), request.damping()),
                    acceleration(input) && acceleration(output)));
        }
        paths = new PathBodies(rate, input, PathBodies.motionsOf(channels, input, outputs), outputs);
        Segmentation segmentation = segmentation(rate, inspection.samples());
        spectra = new CrossSpectrum(segmentation, Detrend.MEAN, outputs.size());
        inputSpectrogram = new Spectrogram(segmentation, Detrend.MEAN, SPECTROGRAM_COLUMNS);
        outputSpectrogram = new Spectrogram(segmentation, Detrend.MEAN, SPECTROGRAM_COLUMNS);
        leading = leading(outputs);
        bridges = new GapBridge[1 + outputs.size()];
        answers = new double[outputs.size()];
        int curved = Math.max(1, (int) Math.round(LONGEST_BRIDGE * rate));
        Arrays.setAll(bridges, i -> new GapBridge(curved));
        int straight = Math.max(curved, (int) (PICTURED_BRIDGE * segmentation.length()));
        inputPicture = new GapBridge(curved, straight);
        outputPicture = new GapBridge(curved, straight);
        pictureWarmUp = inputPicture.delay();
        warmUp = bridges[0].delay();
        waveforms.put(input, new Waveform(SHOWN));
        outputs.forEach(
                output -> waveforms.put(output, new Waveform(shown(output) ? SHOWN : Math.max(2000, OTHERS / outputs.size() / 2 * 2))));
        StateModel shipped = StateModelFile.shipped();
        states = StateRuns.canTell(shipped, channels, rate) ? Optional.of(new StateRuns(shipped)) : Optional.empty();
    }

    /** Whether an output's time history stands on the page unasked. */
    public boolean shown(Channel output) {
        return output.equals(followed.get(leading).channel()) || output.location().equals("seat");
    }

    /** What measures exposure; none where the recording does not tell it, and why. */
    private Optional<SeatMeter> meter(List<Channel> channels) {
        return unless(() -> SeatMeter.of(inspection, new SeatMeter.Setup(Optional.empty(), Optional.empty(), false), channels));
    }

    /** What belongs to exposure; none where the recording does not tell it, and why. */
    private <T> Optional<T> unless(Supplier<T> told) {
        try {
            return Optional.of(told.get());
        } catch (DataFault fault) {
            String where = inspection.name() + ": ";
            noExposure = fault.getMessage().startsWith(where) ? fault.getMessage().substring(where.length()) : fault.getMessage();
            return Optional.empty();
        }
    }

    /**
     * Analyses and writes {@code tracks.csv} and {@code tracks.arff} on the way; {@link #finish} writes the rest.
     *
     * @param ending   behind the names of the tracks: {@code .gz} to compress them, or nothing
     * @param progress told the step and the share of it that is done, 0 to 1 or NaN
     * @throws DataFault if the recording cannot be analysed
     */
    public static Analysis run(AnalysisRequest request, OutputFolder out, String ending, BiConsumer<String, Double> progress)
            throws IOException {
        Inspection inspection = request.source().inspect(share -> progress.accept("reading", share));
        Analysis analysis = new Analysis(request, inspection);
        analysis.follow(out, ending, progress);
        return analysis;
    }

    /** Writes {@code results.json}. */
    public AnalysisResults finish(OutputFolder out) throws IOException {
        AnalysisResults results = AnalysisResults.of(this);
        ResultsJson.write(results, out.file("results.json"));
        return results;
    }

    private static Segmentation segmentation(double rate, long samples) {
        return Segmentation.ofSitter(rate, samples, LEAST_SEGMENTS, 16);
    }

    /** The output that is shown first: the head if it is there, else the last. */
    private static int leading(List<Channel> outputs) {
        for (int i = 0; i < outputs.size(); i++) {
            if (outputs.get(i).location().equals("head")) {
                return i;
            }
        }
        return outputs.size() - 1;
    }

    private void follow(OutputFolder out, String ending, BiConsumer<String, Double> progress) throws IOException {
        List<Channel> outputs = outputs();
        try (UniformReader reader = request.source().uniform(inspection); BodyTracks tracks = new BodyTracks()) {
            tracks.into(tracks(out.file("tracks.csv" + ending), outputs));
            tracks.into(tracks(out.file("tracks.arff" + ending), outputs));
            followed.forEach(one -> tracks.follow(one, reader, input, List.of()));
            List<Consumer<RowBlock>> takers = new ArrayList<>(tracks.takers());
            Optional<SeatMeter> meter = meter(reader.channels());
            meter.ifPresent(each -> takers.add(RowBlock.each(each::accept)));
            states.ifPresent(each -> takers.add(RowBlock.each(reader, each.model().features().channels(), each::accept)));
            takers.add(RowBlock.each(reader, paths.channels(), paths::accept));
            takers.add(RowBlock.each(reader, List.of(input, outputs.get(leading)), motion -> picture(motion[0], motion[1])));
            takers.add(RowBlock.each(reader, Stream.concat(Stream.of(input), outputs.stream()).toList(), this::average));
            otherAxes = new OtherAxes(inspection, List.of(input), outputs, spectra.segmentation(), reader.channels());
            takers.add(RowBlock.each(otherAxes::accept));
            waveforms.forEach(
                    (channel, waveform) -> takers.add(RowBlock.each(reader, List.of(channel), motion -> waveform.accept(motion[0]))));
            RowBlock block = new RowBlock(1 + reader.channels().size());
            while (block.read(reader)) {
                block.show(takers);
                tracks.write(block);
                progress.accept("analysing", reader.fractionRead());
            }
            for (int late = inputPicture.delay(); late > 0; late--) {
                picture(Double.NaN, Double.NaN);
            }
            double[] nothing = new double[bridges.length];
            Arrays.fill(nothing, Double.NaN);
            for (int late = bridges[0].delay(); late > 0; late--) {
                average(nothing);
            }
            otherAxes.finish();
            relay = reader.relay();
            metadata = reader.metadata();
            states.ifPresent(StateRuns::finish);
            exposure = meter.flatMap(each -> unless(() -> each.finish(metadata)));
            tracks.finish();
        }
        progress.accept("fitting", Double.NaN);
        bodies = paths.bodies(0);
    }

    private TrackFile tracks(Path file, List<Channel> outputs) throws IOException {
        return TrackFile.create(file, outputs.stream().map(Channel::toString).toList(), request.provenance());
    }

    /**
     * Takes a sample into the spectra, where short gaps are bridged.
     *
     * @param motion of the input, then of the outputs. Not modified.
     */
    private void average(double[] motion) {
        double x = bridges[0].accept(motion[0]);
        for (int i = 0; i < answers.length; i++) {
            answers[i] = bridges[1 + i].accept(motion[1 + i]);
        }
        if (warmUp > 0) {
            warmUp--;
            return;
        }
        spectra.accept(x, answers);
    }

    /** Takes a sample into the spectrograms, where a gap costs no segment unless it is a good part of it. */
    private void picture(double u, double y) {
        double x = inputPicture.accept(u);
        double z = outputPicture.accept(y);
        if (pictureWarmUp > 0) {
            pictureWarmUp--;
            return;
        }
        inputSpectrogram.accept(x);
        outputSpectrogram.accept(z);
    }

    /** The longest gap that the spectrograms bridge [s]. */
    public double pictured() {
        return (inputPicture.delay() - 2) / inspection.clock().rate();
    }

    /** Samples that the spectra bridged, in all channels. */
    long bridged() {
        return Arrays.stream(bridges).mapToLong(GapBridge::bridged).sum();
    }

    /** The MOA task that runs the same estimator on the output that is shown first. */
    public String taskString() {
        Channel output = followed.get(leading).channel();
        String map = request.map().map(file -> " -m " + quoted(file.toString())).orElse("");
        return String.format(Locale.ROOT,
                "wbv.task.TrackBody -l (wbv.learn.AdwinKalman -f %s -d %s -r %s) -s (wbv.stream.RecordingStream -f %s -i %s -o %s%s)",
                request.frequency(), request.damping(), inspection.clock().rate(),
                quoted(request.title().equals("standard input") ? "FILE" : request.source().toString()), input, output, map);
    }

    /** A value of a task string must be quoted where it holds a space. */
    private static String quoted(String value) {
        return value.contains(" ") ? "'" + value + "'" : value;
    }

    /** What matters most, in a few lines of text: what was read, the finding, what is doubtful, and the body by output. */
    public String summary() {
        StringBuilder text = new StringBuilder(String.format(Locale.ROOT, "%s: %.1f s at %.4g Hz, %d channels. %s%n%s%n", request.title(),
                inspection.duration(), inspection.clock().rate(), inspection.summaries().size(), relay.sentence(),
                new Headline(this).sentence().replace('\u00a0', ' ')));
        findings().forEach(finding -> text.append("  ").append(finding.severity()).append(": ").append(finding.message()).append('\n'));
        text.append("The linear body that would move most like each place (of this path and ride, not the sitter's own mode), ± 2σ:\n");
        for (PathBody body : bodies) {
            text.append(String.format(Locale.ROOT, "%s to %-20s %s%n", input, body.output(), body.line()));
        }
        return text.toString();
    }

    /** What is wrong with the channels used, by kind, gravest first; last units that may be others. */
    public List<FoldedFindings.Line> findings() {
        Set<String> used = new HashSet<>();
        used.add(input.location());
        outputs().forEach(output -> used.add(output.location()));
        exposure.ifPresent(each -> used.add(each.place()));
        Stream<FoldedFindings.Line> unit = exposure.flatMap(SeatMeasurement::unit).stream()
                .map(remark -> new FoldedFindings.Line(remark.severity(), remark.message(), remark.advice()));
        Stream<FoldedFindings.Line> other = IntStream.range(0, followed.size()).boxed().flatMap(i -> frequencyResponse(i)
                .flatMap(response -> FoldedFindings.units(input, followed.get(i).channel(), response)).stream());
        return Stream.of(FoldedFindings.of(inspection, used).stream(), other, unit).flatMap(each -> each).toList();
    }

    /** Whether a channel is an acceleration, with gravity or without. */
    public static boolean acceleration(Channel channel) {
        return PathBodies.kind(channel) == Quantity.ACCELERATION;
    }

    /** The body between the input and each output, as known after the last sample. */
    public List<PathBody> bodies() {
        return bodies;
    }

    /** What was asked. */
    public AnalysisRequest request() {
        return request;
    }

    /** What a first look at every sample found. */
    public Inspection inspection() {
        return inspection;
    }

    /** What laying the rows on the clock did to them. */
    public Relay relay() {
        return relay;
    }

    /** What moves all outputs. */
    public Channel input() {
        return input;
    }

    /** What was followed, in the order of {@link #followed}. */
    public List<Channel> outputs() {
        return followed.stream().map(FollowedBody::channel).toList();
    }

    /** The body between the input and each output, followed by the usual estimator. */
    public List<FollowedBody> followed() {
        return followed;
    }

    /** Index of the output that is shown first. */
    public int leading() {
        return leading;
    }

    /** What the recording says of itself. */
    public Metadata metadata() {
        return metadata;
    }

    /** The exposure of this recording; empty where it does not tell one. */
    public Optional<SeatMeasurement> exposure() {
        return exposure;
    }

    /** Why there is no exposure; empty where there is one. */
    public String noExposure() {
        return noExposure;
    }

    /** The motion states, where the shipped model fits the recording. */
    public Optional<ToldStates> states() {
        return states.filter(ToldStates::fits).map(ToldStates::new);
    }

    /** The samples of the input or an output. */
    public Waveform samples(Channel channel) {
        return waveforms.get(channel);
    }

    /** How many samples a point of a drawn signal stands for, at most. */
    public int samplesAPoint() {
        return waveforms.values().stream().mapToInt(Waveform::width).max().orElse(1);
    }

    /** Of all its spectra. */
    public Segmentation segmentation() {
        return spectra.segmentation();
    }

    /** The frequency response to an output; empty if no segment was free of gaps. */
    public Optional<FrequencyResponse> frequencyResponse(int output) {
        return spectra.averaged(output) == 0 ? Optional.empty()
                : Optional.of(spectra.response(output, FrequencyResponse.Excited.USUAL));
    }

    /** The other motions where the input is. */
    public OtherAxes otherAxes() {
        return otherAxes;
    }

    long segments(int output) {
        return spectra.averaged(output);
    }

    long segmentsSkipped(int output) {
        return spectra.skipped(output);
    }

    /** Power of the input over time. */
    public Spectrogram inputSpectrogram() {
        return inputSpectrogram;
    }

    /** Power of the leading output over time. */
    public Spectrogram outputSpectrogram() {
        return outputSpectrogram;
    }
}
