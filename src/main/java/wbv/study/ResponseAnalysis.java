package wbv.study;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import wbv.body.Model;
import wbv.body.simulate.ModelResponse;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.inspect.RowSource;
import wbv.result.OutputFolder;
import wbv.result.ResultsJson;
import wbv.signal.AbsorbedPower;
import wbv.signal.Backing;
import wbv.signal.ComplexSeries;
import wbv.signal.FrequencyResponse.Excited;
import wbv.signal.Peak;
import wbv.signal.SubjectMean;
import wbv.signal.WaveletResponse;

/** Frequency responses of one recording, or the mean of several people's, with a model drawn over them. */
public final class ResponseAnalysis {

    /** The bins below hold the mean. */
    private static final int FIRST_BIN = 2;

    private final ResponseRequest request;
    private final MeasuredResponse measured;
    private final List<ResponseCurve> curves;
    private final Map<String, List<ResponseCurve>> people = new LinkedHashMap<>();
    private final Map<Channel, WaveletResponse> wavelets = new LinkedHashMap<>();

    private ResponseAnalysis(ResponseRequest request, BiConsumer<String, Double> progress) throws IOException {
        this.request = request;
        this.measured = new MeasuredResponse(request.source(), request, progress);
        this.curves = curves(measured, request.model());
        if (request.model().isPresent() && curves.stream().allMatch(curve -> curve.model().isEmpty())) {
            Model model = request.model().get();
            throw new DataFault("the model '" + model.name() + "' answers none of the responses: it is excited by "
                    + model.excitations() + " and has the sensors " + model.outputs() + ", asked is " + measured.inputs() + " to "
                    + measured.outputs());
        }
        if (request.plate() > 0 && curves.stream().noneMatch(ResponseCurve::isApparentMass)) {
            throw new DataFault("a plate's mass can be taken off an apparent mass only: no output is a force along the axis of "
                    + "an acceleration, " + measured.inputs() + " to " + measured.outputs());
        }
        for (int o = 0; o < measured.outputs().size(); o++) {
            ResponseCurve curve = curves.get(o * measured.inputs().size());
            measured.wavelet(o).ifPresent(through -> wavelets.put(curve.output(), through.where(curve::excited)));
        }
        if (!request.people().isEmpty()) {
            people.put(request.title(), curves);
        }
        for (Map.Entry<String, RowSource> other : request.people().entrySet()) {
            List<ResponseCurve> theirs = curves(new MeasuredResponse(other.getValue(), request, progress), Optional.empty());
            if (curves.stream().noneMatch(curve -> of(theirs, curve).isPresent())) {
                throw DataFault.in(other.getKey(), "has none of the responses of " + request.title() + ", "
                        + measured.inputs() + " to " + measured.outputs() + ", so that no mean of people can be taken");
            }
            people.put(other.getKey(), theirs);
        }
    }

    /**
     * Measures and writes {@code frf.json} and {@code frf.csv}, and {@code wavelet.csv} where asked for.
     *
     * @param progress told the step and the share of it that is done, 0 to 1 or NaN
     * @throws DataFault if the recording gives no response
     */
    public static ResponseAnalysis run(ResponseRequest request, OutputFolder out, BiConsumer<String, Double> progress)
            throws IOException {
        ResponseAnalysis analysis = new ResponseAnalysis(request, progress);
        ResultsJson.write(ResponseResults.of(analysis), out.file("frf.json"));
        ResponseFile.write(analysis.curves, analysis.measured, request.provenance(), out.file("frf.csv"));
        if (request.wavelet()) {
            WaveletFile.write(analysis, request.provenance(), out.file("wavelet.csv"));
        }
        return analysis;
    }

    private List<ResponseCurve> curves(MeasuredResponse of, Optional<Model> model) {
        Optional<ModelResponse> answer = model.map(each -> new ModelResponse(each, of.segmentation()));
        List<ResponseCurve> all = new ArrayList<>();
        for (int o = 0; o < of.outputs().size(); o++) {
            for (int i = 0; i < of.inputs().size(); i++) {
                Channel input = of.inputs().get(i);
                Channel output = of.outputs().get(o);
                ResponseCurve bare = new ResponseCurve(input, output, i, of.response(o), of.h2(o, i), Optional.empty(),
                        request.plate(), request.level());
                Optional<ComplexSeries> said = answer.flatMap(each -> said(each, model.orElseThrow(), bare));
                all.add(new ResponseCurve(input, output, i, of.response(o), of.h2(o, i), said, request.plate(), request.level()));
            }
        }
        return all;
    }

    /** What the model answers: its sensor's motion, or the force under all of it. */
    private static Optional<ComplexSeries> said(ModelResponse answer, Model model, ResponseCurve curve) {
        if (answer.has(curve.input(), curve.output())) {
            return Optional.of(answer.of(curve.input(), curve.output()));
        }
        boolean under = curve.isApparentMass() && model.excitations().equals(List.of(curve.input()));
        return under ? Optional.of(answer.apparentMass()) : Optional.empty();
    }

    /**
     * The mean of the moduli of those who have this response; normalised apparent masses where it is one. Empty if fewer than
     * two peak.
     */
    public Optional<SubjectMean> mean(int curve) {
        List<ResponseCurve> all = people(curve).values().stream().toList();
        return all.size() < 2 ? Optional.empty() : SubjectMean.of(all.stream().map(ResponseAnalysis::comparable).toList());
    }

    /** One of the curves of everybody who has it, by title; empty if there is one person only. */
    public Map<String, ResponseCurve> people(int curve) {
        Map<String, ResponseCurve> all = new LinkedHashMap<>();
        people.forEach((title, theirs) -> of(theirs, curves.get(curve)).ifPresent(own -> all.put(title, own)));
        return all;
    }

    /** The curve of somebody between the same two channels. */
    private static Optional<ResponseCurve> of(List<ResponseCurve> theirs, ResponseCurve curve) {
        return theirs.stream().filter(own -> own.input().equals(curve.input()) && own.output().equals(curve.output())).findFirst();
    }

    private static SubjectMean.Curve comparable(ResponseCurve curve) {
        double[] modulus = curve.h1().magnitudes();
        if (curve.isApparentMass()) {
            OptionalDouble sitting = curve.apparentMass().sitting(curve.usable());
            modulus = curve.apparentMass().normalised(sitting.orElseThrow(() -> new DataFault(
                    "people's apparent masses can be compared only over their sitting mass, which is read near 0.5 Hz, where "
                            + curve.name() + " is not usable")));
        }
        return new SubjectMean.Curve(curve.frequency(), modulus, curve.usable());
    }

    /** The power that an output takes in at its driving point; empty if it is not a force over an acceleration along its axis. */
    public Optional<AbsorbedPower> power(ResponseCurve curve) {
        return curve.isApparentMass() ? Optional.of(AbsorbedPower.of(measured.spectra(measured.outputs().indexOf(curve.output())),
                measured.inputs().size(), curve.index())) : Optional.empty();
    }

    /** What matters most, in a few lines of text. */
    public String summary() {
        StringBuilder text = new StringBuilder(String.format(Locale.ROOT, "%s: %.1f s at %.4g Hz, segments of %.3g s, %.3g "
                + "independent averages%n", request.title(), measured.inspection().duration(), measured.segmentation().rate(),
                measured.segmentation().duration(), measured.response(0).averages()));
        Set<String> used = Stream.concat(measured.inputs().stream(), measured.outputs().stream()).map(Channel::location)
                .collect(Collectors.toSet());
        FoldedFindings.of(measured.inspection(), used).forEach(finding -> text.append("  ").append(finding.severity()).append(": ")
                .append(finding.message()).append('\n'));
        request.skin().forEach((place, skin) -> text.append(String.format(Locale.ROOT,
                "  skin under %s taken out: %.3g Hz, damping ratio %.2g%n", place, skin.frequency(), skin.damping())));
        for (int c = 0; c < curves.size(); c++) {
            ResponseCurve curve = curves.get(c);
            text.append(String.format(Locale.ROOT, "%-40s ", curve.name())).append(sentence(curve, measured)).append('\n');
            through(curve.output()).ifPresent(through -> text.append(String.format(Locale.ROOT, "%-40s %s%n", "", drift(through))));
            power(curve).ifPresent(power -> text.append(String.format(Locale.ROOT, "%-40s absorbed power %.4g W%n", "",
                    power.total())));
            mean(c).ifPresent(mean -> text.append(String.format(Locale.ROOT, "%-40s mean of %d people: %.3g ± %.2g at %.3g "
                    + "± %.2g Hz%n", "", mean.people(), mean.peak().height(), mean.peakDeviation().height(),
                    mean.peak().frequency(), mean.peakDeviation().frequency())));
        }
        return text.toString();
    }

    /** The response of an output through time, where that was asked for. */
    public Optional<WaveletResponse> through(Channel output) {
        return Optional.ofNullable(wavelets.get(output));
    }

    /** Within which frequencies the peak moved, by tenths of the time in which it was seen. */
    private static String drift(WaveletResponse through) {
        double[] ridge = Arrays.stream(through.ridge()).filter(Double::isFinite).sorted().toArray();
        if (ridge.length == 0) {
            return "through time: no peak that is not chance";
        }
        return String.format(Locale.ROOT, "through time: peak from %.3g to %.3g Hz in eight tenths of the time, seen in %.0f %% of it",
                ridge[(int) (0.1 * (ridge.length - 1))], ridge[(int) (0.9 * (ridge.length - 1))],
                100.0 * ridge.length / through.times().length);
    }

    private static String sentence(ResponseCurve curve, MeasuredResponse measured) {
        return height(curve) + missing(curve, measured);
    }

    private static String missing(ResponseCurve curve, MeasuredResponse measured) {
        String words = Unbacked.sentence(curve.backing(), FIRST_BIN, measured.inputs().size() > 1, measured.others(),
                measured.outputs().indexOf(curve.output()));
        return words.isEmpty() || curve.index() < measured.inputs().size() - 1 ? "" : String.format(Locale.ROOT, "%n%-40s %s", "", words);
    }

    private static String height(ResponseCurve curve) {
        Peak highest = curve.highest();
        if (Double.isNaN(highest.height())) {
            long still = Unbacked.count(curve.backing(), FIRST_BIN, Backing.NOT_EXCITED);
            return String.format(Locale.ROOT, "no usable frequency: not excited at %d of %d, elsewhere the coherence is below "
                    + "%.2g (largest %.2g)", still, curve.backing().length - FIRST_BIN,
                    Excited.USUAL.leastCoherence(curve.all().averages(), curve.all().inputs()),
                    Arrays.stream(curve.all().multipleCoherence(0)).skip(FIRST_BIN).max().orElse(0));
        }
        double[] band = curve.usableBand();
        String unit = curve.unit().equals("1") ? "" : " " + curve.unit();
        String what = curve.peak().isPresent() ? "peak" : "highest";
        return String.format(Locale.ROOT, "%s %.3g ± %.1g%s at %.3g Hz; usable %.3g to %.3g Hz", what, highest.height(),
                curve.highestMargin(), unit, highest.frequency(), band[0], band[1])
                + curve.misfit().map(m -> String.format(Locale.ROOT, "; model off by %.1f %%", 100 * m.relative())).orElse("");
    }

    /** The MOA task that gives the same response sample by sample, for the first output. */
    public String taskString() {
        String map = request.map().map(file -> " -m " + quoted(file.toString())).orElse("");
        String inputs = measured.inputs().stream().map(Channel::toString).collect(Collectors.joining(","));
        return String.format(Locale.ROOT, "wbv.task.RespondOverTime -g %s -s (wbv.stream.RecordingStream -f %s -i %s -o %s%s)",
                measured.segmentation().duration(), quoted(request.source().toString()), inputs, measured.outputs().get(0), map);
    }

    /** A value of a task string must be quoted where it holds a space. */
    private static String quoted(String value) {
        return value.contains(" ") ? "'" + value + "'" : value;
    }

    /** What was asked. */
    public ResponseRequest request() {
        return request;
    }

    /** What was measured. */
    public MeasuredResponse measured() {
        return measured;
    }

    /** By output, and by input within. */
    public List<ResponseCurve> curves() {
        return curves;
    }

    /** Whether there is more than one person. */
    public boolean several() {
        return !people.isEmpty();
    }
}
