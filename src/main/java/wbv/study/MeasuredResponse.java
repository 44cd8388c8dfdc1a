package wbv.study;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.stream.Stream;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.inspect.Inspection;
import wbv.recording.inspect.Relay;
import wbv.recording.inspect.RowSource;
import wbv.recording.inspect.UniformReader;
import wbv.sensing.SkinMount;
import wbv.signal.ComplexSeries;
import wbv.signal.Detrend;
import wbv.signal.FrequencyResponse.Excited;
import wbv.signal.GapBridges;
import wbv.signal.ResponseMatrix;
import wbv.signal.Segmentation;
import wbv.signal.SpectralMatrix;
import wbv.signal.WaveletResponse;

/** The frequency responses of one recording, measured in one pass with flat memory. */
public final class MeasuredResponse {

    /** Segments that a response needs for each input, overlapping by half. */
    private static final int LEAST_SEGMENTS = 4;
    /** A segment is not shortened below this [s], however short the record. */
    private static final double SHORTEST = 1;
    /** Missing samples that spectra bridge [s]. */
    private static final double LONGEST_BRIDGE = 0.05;
    /** Inputs that share more than this at the typical bin are one motion. */
    private static final double MOST_SHARED = 0.98;

    private final Inspection inspection;
    private final Relay relay;
    private final long bridged;
    private final List<Channel> inputs;
    private final List<Channel> outputs;
    private final Segmentation segmentation;
    private final List<SpectralMatrix> spectra = new ArrayList<>();
    private final List<ResponseMatrix> responses = new ArrayList<>();
    private final Optional<ResponseMatrix> together;
    private final Optional<Waves> waves;
    private OtherAxes others;
    private final double[] pair;

    MeasuredResponse(RowSource source, ResponseRequest request, BiConsumer<String, Double> progress) throws IOException {
        inspection = source.inspect(share -> progress.accept("reading", share));
        List<Channel> channels = List.copyOf(inspection.summaries().keySet());
        inputs = request.chooseInputs(channels, inspection.name());
        inputs.forEach(this::requireMotion);
        outputs = request.chooseOutputs(channels, inputs, inspection.name());
        outputs.forEach(inspection::require);
        for (String place : request.skin().keySet()) {
            if (Stream.concat(inputs.stream(), outputs.stream()).noneMatch(channel -> channel.location().equals(place))) {
                throw new DataFault("skin is told of " + place + ", where no input or output is: " + inputs + ", " + outputs);
            }
        }
        segmentation = segmentation(request);
        int m = inputs.size();
        pair = new double[m + 1];
        waves = request.wavelet() ? Optional.of(new Waves(m + outputs.size(), inspection.samples())) : Optional.empty();
        outputs.forEach(output -> spectra.add(new SpectralMatrix(segmentation, Detrend.MEAN, m + 1)));
        boolean jointly = m > 1 && outputs.size() >= m;
        SpectralMatrix all = new SpectralMatrix(segmentation, Detrend.MEAN, jointly ? m + outputs.size() : 1);
        GapBridges bridges = new GapBridges(m + outputs.size(), Math.max(1,
                (int) Math.round(LONGEST_BRIDGE * segmentation.rate())));
        relay = read(source, bridges, jointly ? List.of(all) : List.of(), progress);
        bridged = bridges.bridged();
        SpectralMatrix joint = all;
        for (int c = 0; c < m + outputs.size(); c++) {
            SkinMount skin = request.skin().get((c < m ? inputs.get(c) : outputs.get(c - m)).location());
            if (skin != null) {
                ComplexSeries correction = skin.correction(segmentation.frequencies());
                joint = jointly ? joint.filtered(c, correction) : joint;
                for (int o = 0; o < outputs.size(); o++) {
                    if (c < m || c == m + o) {
                        spectra.set(o, spectra.get(o).filtered(Math.min(c, m), correction));
                    }
                }
            }
        }
        for (SpectralMatrix each : spectra) {
            responses.add(ResponseMatrix.of(each, m, Excited.USUAL));
        }
        together = jointly && joint.independent() > m ? Optional.of(ResponseMatrix.of(joint, m, Excited.USUAL))
                : Optional.empty();
        requireApart();
    }

    private void requireMotion(Channel input) {
        inspection.require(input);
        if (inspection.summaries().get(input).rms() == 0) {
            throw DataFault.in(inspection.name(), "the input " + input + " does not move: nothing answers it; choose another");
        }
    }

    private Segmentation segmentation(ResponseRequest request) {
        double rate = inspection.clock().rate();
        long samples = inspection.samples();
        if (request.segment().isPresent()) {
            Segmentation wanted = Segmentation.lasting(rate, request.segment().getAsDouble());
            requireLength(wanted.length(), samples, rate, 1);
            return wanted;
        }
        int least = LEAST_SEGMENTS * inputs.size();
        Segmentation segmentation = Segmentation.ofSitter(rate, samples, least, Math.max(8, SHORTEST * rate));
        requireLength(segmentation.length(), samples, rate, least);
        return segmentation;
    }

    private void requireLength(int length, long samples, double rate, int segments) {
        long needed = (segments + 1) * (long) length / 2;
        if (needed > samples) {
            throw DataFault.in(inspection.name(), String.format(Locale.ROOT,
                    "%.3g s are too short for a frequency response from %d %s: "
                            + "%s of %.3g s %s %.3g s",
                    samples / rate, inputs.size(), inputs.size() == 1 ? "input" : "inputs",
                    segments == 1 ? "a segment" : segments + " segments", length / rate,
                    segments == 1 ? "needs" : "overlapping by half need", needed / rate));
        }
    }

    private Relay read(RowSource source, GapBridges bridges, List<SpectralMatrix> joint, BiConsumer<String, Double> progress)
            throws IOException {
        List<Channel> all = new ArrayList<>(inputs);
        all.addAll(outputs);
        double[] values = new double[all.size()];
        try (UniformReader reader = source.uniform(inspection)) {
            int[] columns = all.stream().mapToInt(channel -> 1 + reader.channels().indexOf(channel)).toArray();
            double[] row = new double[1 + reader.channels().size()];
            others = new OtherAxes(inspection, inputs, outputs, segmentation, reader.channels());
            for (long sample = 1; reader.read(row); sample++) {
                for (int c = 0; c < values.length; c++) {
                    values[c] = row[columns[c]];
                }
                average(bridges, values, joint);
                others.accept(row);
                if (sample % 2048 == 0) {
                    progress.accept("averaging", reader.fractionRead());
                }
            }
            for (int late = bridges.delay(); late > 0; late--) {
                Arrays.fill(values, Double.NaN);
                average(bridges, values, joint);
            }
            others.finish();
            return reader.relay();
        }
    }

    /** @param values one a channel. Modified. */
    private void average(GapBridges bridges, double[] values, List<SpectralMatrix> joint) {
        if (!bridges.accept(values)) {
            return;
        }
        waves.ifPresent(all -> all.accept(values));
        for (int i = 0; i < joint.size(); i++) {
            joint.get(i).accept(values);
        }
        int m = inputs.size();
        System.arraycopy(values, 0, pair, 0, m);
        for (int o = 0; o < outputs.size(); o++) {
            pair[m] = values[m + o];
            spectra.get(o).accept(pair);
        }
    }

    private void requireApart() {
        for (int i = 0; i < inputs.size() && inputs.size() > 1; i++) {
            double[] shared = responses.get(0).coherenceAmongInputs(i).clone();
            Arrays.sort(shared);
            if (shared[shared.length / 2] > MOST_SHARED) {
                throw DataFault.in(inspection.name(), String.format(Locale.ROOT,
                        "the input %s moves as the other inputs do (they explain "
                                + "%.1f %% of it): what answers which cannot be told; leave one of %s out",
                        inputs.get(i),
                        100 * shared[shared.length / 2], inputs));
            }
        }
    }

    /** What a first look at every sample found. */
    public Inspection inspection() {
        return inspection;
    }

    /** What laying the rows on the clock did to them. */
    public Relay relay() {
        return relay;
    }

    /** Samples bridged, in all channels. */
    public long bridged() {
        return bridged;
    }

    /** In the order of {@link ResponseMatrix}' columns. */
    public List<Channel> inputs() {
        return inputs;
    }

    /** In the order of its rows. */
    public List<Channel> outputs() {
        return outputs;
    }

    /** Of all its spectra. */
    public Segmentation segmentation() {
        return segmentation;
    }

    /** Spectra of the inputs and of an output, which is the last channel. */
    SpectralMatrix spectra(int output) {
        return spectra.get(output);
    }

    /** Responses of one output to all inputs, from the segments that both have. */
    public ResponseMatrix response(int output) {
        return responses.get(output);
    }

    /** The other motions where the inputs are. */
    public OtherAxes others() {
        return others;
    }

    /** An output's response to the one input through time; empty where that was not asked for. */
    public Optional<WaveletResponse> wavelet(int output) {
        return waves.map(all -> all.response(1 + output, inspection.clock()));
    }

    /** H2, which several inputs give only together with as many outputs. */
    Optional<ComplexSeries> h2(int output, int input) {
        return inputs.size() == 1 ? responses.get(output).h2(0, 0) : together.flatMap(all -> all.h2(output, input));
    }
}
