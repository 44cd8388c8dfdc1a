package wbv.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BiConsumer;
import wbv.filter.Track;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Inspection;
import wbv.recording.Quantity;
import wbv.recording.Relay;
import wbv.recording.UniformReader;
import wbv.signal.CrossSpectrum;
import wbv.signal.Detrend;
import wbv.signal.Envelope;
import wbv.signal.FrequencyResponse;
import wbv.signal.GapBridge;
import wbv.signal.Segmentation;
import wbv.signal.Spectrogram;
import wbv.task.TrackFile;

/**
 * One recording analysed in two passes with flat memory: an inspection, then spectra and streaming estimates side by side, sample
 * by sample on the uniform clock.
 */
public final class Analysis {

    private static final int SPECTROGRAM_COLUMNS = 400;
    private static final int ENVELOPE_POINTS = 2000;
    private static final int LEAST_SEGMENTS = 4;
    /** Missing samples that spectra bridge [s]. */
    private static final double LONGEST_BRIDGE = 0.05;

    private final AnalysisRequest request;
    private final Inspection inspection;
    private final Channel input;
    private final Envelope inputSamples = new Envelope(ENVELOPE_POINTS);
    private final List<Response> responses = new ArrayList<>();
    private final CrossSpectrum spectra;
    private final Spectrogram inputSpectrogram;
    private final Spectrogram outputSpectrogram;
    private final int leading;
    private final GapBridge[] bridges;
    private final PathBodies paths;
    private List<PathBody> bodies = List.of();
    private int warmUp;
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
            responses.add(new Response(output, rate, request.frequency(), request.damping(),
                    acceleration(input) && acceleration(output)));
        }
        paths = new PathBodies(rate, input, PathBodies.motionsOf(channels, input, outputs), outputs);
        Segmentation segmentation = segmentation(rate, inspection.samples());
        spectra = new CrossSpectrum(segmentation, Detrend.MEAN, outputs.size());
        inputSpectrogram = new Spectrogram(segmentation, Detrend.MEAN, SPECTROGRAM_COLUMNS);
        outputSpectrogram = new Spectrogram(segmentation, Detrend.MEAN, SPECTROGRAM_COLUMNS);
        leading = leading(outputs);
        bridges = new GapBridge[1 + outputs.size()];
        Arrays.setAll(bridges, i -> new GapBridge(Math.max(1, (int) Math.round(LONGEST_BRIDGE * rate))));
        warmUp = bridges[0].delay();
    }

    /**
     * Analyses and writes {@code tracks.csv} and {@code tracks.arff} on the way; {@link #finish} writes the rest.
     *
     * @param progress told the step and the share of it that is done, 0 to 1 or NaN
     * @throws DataFault if the recording cannot be analysed
     */
    public static Analysis run(AnalysisRequest request, OutputFolder out, BiConsumer<String, Double> progress) throws IOException {
        Inspection inspection = request.source().inspect(share -> progress.accept("reading", share));
        Analysis analysis = new Analysis(request, inspection);
        analysis.follow(out, progress);
        return analysis;
    }

    /** Writes {@code report.html} and {@code results.json}. */
    public AnalysisResults finish(OutputFolder out) throws IOException {
        AnalysisResults results = AnalysisResults.of(this);
        ResultsJson.write(results, out.file("results.json"));
        HtmlWriter.write(new AnalysisPage(this).page(), out.file("report.html"));
        return results;
    }

    /** A resolution that a sitter's resonance needs (4 Hz, damping ratio 0.3, peak lowered by 2 %), or what a short record allows. */
    private static Segmentation segmentation(double rate, long samples) {
        Segmentation wanted = Segmentation.resolving(rate, 4, 0.3, 0.02);
        int length = wanted.length();
        while (length > 16 && (LEAST_SEGMENTS + 1) * (long) length / 2 > samples) {
            length /= 2;
        }
        return new Segmentation(rate, length, wanted.overlap());
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

    private void follow(OutputFolder out, BiConsumer<String, Double> progress) throws IOException {
        List<Channel> outputs = outputs();
        try (UniformReader reader = request.source().uniform(inspection);
             TrackFile csv = tracks(out.file("tracks.csv"), outputs);
             TrackFile arff = tracks(out.file("tracks.arff"), outputs)) {
            int inputColumn = 1 + reader.channels().indexOf(input);
            int[] columns = outputs.stream().mapToInt(output -> 1 + reader.channels().indexOf(output)).toArray();
            int[] crossing = paths.motions().stream().mapToInt(motion -> 1 + reader.channels().indexOf(motion)).toArray();
            double[] others = new double[crossing.length];
            double[] row = new double[1 + reader.channels().size()];
            double[] y = new double[columns.length];
            otherAxes = new OtherAxes(inspection, List.of(input), outputs, spectra.segmentation(), reader.channels());
            for (long sample = 1; reader.read(row); sample++) {
                double u = row[inputColumn];
                inputSamples.accept(u);
                csv.begin(row[0]);
                arff.begin(row[0]);
                for (int i = 0; i < y.length; i++) {
                    y[i] = row[columns[i]];
                    Track track = responses.get(i).accept(u, y[i]);
                    csv.add(track);
                    arff.add(track);
                }
                csv.end();
                arff.end();
                for (int i = 0; i < others.length; i++) {
                    others[i] = row[crossing[i]];
                }
                paths.accept(u, others, y);
                average(u, y);
                otherAxes.accept(row);
                if (sample % 2048 == 0) {
                    progress.accept("analysing", reader.fractionRead());
                }
            }
            for (int late = bridges[0].delay(); late > 0; late--) {
                Arrays.fill(y, Double.NaN);
                average(Double.NaN, y);
            }
            otherAxes.finish();
            relay = reader.relay();
            csv.finish();
            arff.finish();
        }
        progress.accept("fitting", Double.NaN);
        bodies = paths.bodies(0);
    }

    private TrackFile tracks(Path file, List<Channel> outputs) throws IOException {
        return TrackFile.create(file, outputs.stream().map(Channel::toString).toList(), request.provenance());
    }

    /** Takes a sample into the spectra, where short gaps are bridged. @param y Modified. */
    private void average(double u, double[] y) {
        double x = bridges[0].accept(u);
        for (int i = 0; i < y.length; i++) {
            y[i] = bridges[1 + i].accept(y[i]);
        }
        if (warmUp > 0) {
            warmUp--;
            return;
        }
        spectra.accept(x, y);
        inputSpectrogram.accept(x);
        outputSpectrogram.accept(y[leading]);
    }

    /** Samples that the spectra bridged, in all channels. */
    long bridged() {
        return Arrays.stream(bridges).mapToLong(GapBridge::bridged).sum();
    }

    /** The MOA task that runs the same estimator on the output that is shown first. */
    String taskString() {
        Channel output = responses.get(leading).channel();
        String map = request.map().map(file -> " -m " + quoted(file.toString())).orElse("");
        return String.format(Locale.ROOT, "wbv.task.TrackBody -l (wbv.learn.AdwinKalman -f %s -d %s -r %s) -s (wbv.stream.RecordingStream -f %s -i %s -o %s%s)",
                request.frequency(), request.damping(), inspection.clock().rate(), quoted(request.title().equals("standard input") ? "FILE" : request.source().toString()), input, output, map);
    }

    /** A value of a task string must be quoted where it holds a space. */
    private static String quoted(String value) {
        return value.contains(" ") ? "'" + value + "'" : value;
    }

    /** What matters most, in a few lines of text. */
    public String summary() {
        StringBuilder text = new StringBuilder(String.format(Locale.ROOT, "%s: %.1f s at %.4g Hz, %d channels. %s%n", request.title(),
                inspection.duration(), inspection.clock().rate(), inspection.summaries().size(), relay.sentence()));
        inspection.findings().forEach(finding -> text.append("  ").append(finding.severity()).append(": ").append(finding.message()).append('\n'));
        for (PathBody body : bodies) {
            text.append(String.format(Locale.ROOT, "%s to %-20s %s%n", input, body.output(), body.line()));
        }
        return text.toString();
    }

    private static boolean acceleration(Channel channel) {
        return PathBodies.kind(channel) == Quantity.ACCELERATION;
    }

    /** The body between the input and each output, as known after the last sample. */
    List<PathBody> bodies() {
        return bodies;
    }

    AnalysisRequest request() {
        return request;
    }

    Inspection inspection() {
        return inspection;
    }

    Relay relay() {
        return relay;
    }

    Channel input() {
        return input;
    }

    List<Channel> outputs() {
        return responses.stream().map(Response::channel).toList();
    }

    List<Response> responses() {
        return responses;
    }

    /** Index of the output that is shown first. */
    int leading() {
        return leading;
    }

    Envelope inputSamples() {
        return inputSamples;
    }

    Segmentation segmentation() {
        return spectra.segmentation();
    }

    /** The frequency response to an output; empty if no segment was free of gaps. */
    Optional<FrequencyResponse> frequencyResponse(int output) {
        return spectra.averaged(output) == 0 ? Optional.empty()
                : Optional.of(spectra.response(output, FrequencyResponse.Excited.USUAL));
    }

    /** The other motions where the input is. */
    OtherAxes otherAxes() {
        return otherAxes;
    }

    long segments(int output) {
        return spectra.averaged(output);
    }

    long segmentsSkipped(int output) {
        return spectra.skipped(output);
    }

    Spectrogram inputSpectrogram() {
        return inputSpectrogram;
    }

    Spectrogram outputSpectrogram() {
        return outputSpectrogram;
    }
}
