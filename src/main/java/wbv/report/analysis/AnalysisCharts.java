package wbv.report.analysis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.exposure.SeatAxis;
import wbv.identify.EquivalentBody;
import wbv.recording.Channel;
import wbv.report.page.Band;
import wbv.report.page.Beside;
import wbv.report.page.Block;
import wbv.report.page.ChartAxis;
import wbv.report.page.Heatmap;
import wbv.report.page.LineChart;
import wbv.report.page.LineChart.Marker;
import wbv.report.page.Series;
import wbv.report.page.Text;
import wbv.report.recording.Shades;
import wbv.result.Digits;
import wbv.signal.Backing;
import wbv.signal.Envelope;
import wbv.signal.FrequencyResponse;
import wbv.signal.Spectrogram;
import wbv.study.Analysis;
import wbv.study.FollowedBody;
import wbv.study.PublishedRange;
import wbv.study.ResponseCurve;
import wbv.study.Unbacked;

/** The pictures of an analysis. */
final class AnalysisCharts {

    private static final double LEAST_FREQUENCY = 0.3;

    private final Analysis analysis;
    private final double rate;
    private final double start;

    AnalysisCharts(Analysis analysis) {
        this.analysis = analysis;
        this.rate = analysis.inspection().clock().rate();
        this.start = analysis.inspection().clock().start();
    }

    /** Modulus of the response to an output, with the estimator's body and what is published about such paths. */
    Block modulus(int i) {
        FollowedBody followed = analysis.followed().get(i);
        Optional<FrequencyResponse> some = analysis.frequencyResponse(i);
        if (some.isEmpty()) {
            return noSegment();
        }
        FrequencyResponse h = some.get();
        int[] shown = shown(h);
        double[] f = pick(h.frequency(), shown);
        boolean[] usable = usable(h, shown);
        double[] h1 = pick(h.h1().magnitudes(), shown);
        double[] hv = pick(h.hv().magnitudes(), shown);
        double[] error = pick(h.error(), shown);
        double[] deviation = IntStream.range(0, h1.length).mapToDouble(k -> usable[k] ? h1[k] * error[k] : Double.NaN).toArray();
        List<Series> series = new ArrayList<>(List.of(Series.line("H1", f, h1).with(Band.deviations(h1, deviation, 2, "±2σ")),
                Series.line("Hv", f, hv)));
        double top = top(h1, hv, usable);
        if (BodyTile.of(analysis.bodies().get(i)).single()) {
            EquivalentBody.Mode mode = BodyTile.of(analysis.bodies().get(i)).modes().get(0);
            double[] body = Arrays.stream(f).map(each -> modulus(mode, each)).toArray();
            series.add(Series.dashed("body", f, body));
            top = Math.max(top, Arrays.stream(body).max().orElse(1));
        }
        Optional<PublishedRange> published = PublishedRange.of(analysis.input(), followed.channel(), analysis.segmentation());
        published.ifPresent(range -> series.add(Series.range("published models of seated people", f,
                new Band(Band.Kind.UNCERTAINTY, pick(range.low(), shown), pick(range.high(), shown), ""))));
        LineChart chart = new LineChart(analysis.input() + " to " + followed.channel(), ChartAxis.log("Frequency", "Hz"),
                ChartAxis.linear("Modulus", ratio(followed.channel())).within(0, 1.15 * top), series)
                .shaded(shades(h, shown, f)).grouped(group(followed));
        return chart
                .noted("H1 is right where only the output is noisy, Hv where both are equally so; both agree where the coherence is near"
                        + " 1. Hatched frequencies are not to be believed."
                        + (BodyTile.of(analysis.bodies().get(i)).single() ? " Broken: the body that simulates the"
                                + " output best." : "")
                        + published.map(range -> " Grey: " + range.words() + ".").orElse(""));
    }

    /** Transmissibility of a body of one mode on a shaken base. */
    private static double modulus(EquivalentBody.Mode mode, double frequency) {
        double r = frequency / mode.frequency();
        double damped = 2 * mode.damping() * r;
        return Math.sqrt((1 + damped * damped) / ((1 - r * r) * (1 - r * r) + damped * damped));
    }

    private static List<LineChart.Shade> shades(FrequencyResponse h, int[] shown, double[] f) {
        return Shades.of(Arrays.stream(shown).mapToObj(k -> h.backing()[k]).toArray(Backing[]::new), f, false);
    }

    Optional<LineChart> phase(int i) {
        FollowedBody followed = analysis.followed().get(i);
        return analysis.frequencyResponse(i).map(h -> {
            int[] shown = shown(h);
            double[] f = pick(h.frequency(), shown);
            double[] degrees = Arrays.stream(pick(h.h1().phases(), shown)).map(Math::toDegrees).toArray();
            return new LineChart("Phase", ChartAxis.log("Frequency", "Hz"), ChartAxis.linear("Phase", "°"),
                    List.of(Series.line("H1", f, degrees)))
                    .shaded(shades(h, shown, f)).grouped(group(followed));
        });
    }

    Optional<LineChart> coherence(int i) {
        FollowedBody followed = analysis.followed().get(i);
        return analysis.frequencyResponse(i).map(h -> {
            int[] shown = shown(h);
            double[] f = pick(h.frequency(), shown);
            return new LineChart("Coherence of " + Digits.significant(h.averages(), 3) + " independent averages",
                    ChartAxis.log("Frequency", "Hz"), ChartAxis.linear("Coherence γ²", "1").within(0, 1.02),
                    List.of(Series.line("γ²", f, pick(h.coherence(), shown)))).shaded(shades(h, shown, f))
                    .grouped(group(followed)).noted(believed(h, shown[0], i));
        });
    }

    /** From which coherence on a response is believed, and what makes the output where it is not. */
    private String believed(FrequencyResponse h, int from, int i) {
        String why = Unbacked.sentence(h.backing(), from, false, analysis.otherAxes(), i);
        return "Believed from a coherence of " + Digits.significant(FrequencyResponse.Excited.USUAL.leastCoherence(h.averages(), 1), 2)
                + " on." + (why.isEmpty() ? "" : " " + Character.toUpperCase(why.charAt(0)) + why.substring(1) + ".");
    }

    /** H1 of all outputs in the unit of the leading one, where it can be believed. */
    Optional<LineChart> everyPlace() {
        List<Series> series = new ArrayList<>();
        Channel leading = analysis.followed().get(analysis.leading()).channel();
        for (int i = 0; i < analysis.followed().size(); i++) {
            Channel output = analysis.followed().get(i).channel();
            analysis.frequencyResponse(i).filter(h -> ratio(output).equals(ratio(leading))).ifPresent(h -> {
                int[] shown = shown(h);
                boolean[] usable = usable(h, shown);
                double[] h1 = pick(h.h1().magnitudes(), shown);
                series.add(Series.line(output.toString(), pick(h.frequency(), shown),
                        IntStream.range(0, h1.length).mapToDouble(k -> usable[k] ? h1[k] : Double.NaN).toArray()));
            });
        }
        return series.size() < 2 ? Optional.empty() : Optional.of(new LineChart("Every output, H1 where it can be believed",
                ChartAxis.log("Frequency", "Hz"), ChartAxis.linear("Modulus", ratio(leading)).within(0, Double.NaN), series));
    }

    /** The channel whose weighted spectrum is drawn, if any is. */
    Optional<Channel> weighted() {
        return analysis.exposure().flatMap(measured -> Stream.concat(Stream.of(analysis.input()), analysis.outputs().stream())
                .filter(channel -> channel.location().equals(measured.place()) && axis(channel).isPresent()).findFirst());
    }

    private static Optional<SeatAxis> axis(Channel channel) {
        return Analysis.acceleration(channel) ? Arrays.stream(SeatAxis.values()).filter(axis -> axis.letter() == channel.axis()).findFirst()
                : Optional.empty();
    }

    /** Spectra of the input, the outputs that are shown, and what of them counts for exposure. */
    Block spectra() {
        List<Series> series = new ArrayList<>();
        for (int i : leadingFirst()) {
            Channel output = analysis.followed().get(i).channel();
            analysis.frequencyResponse(i).ifPresent(h -> {
                if (series.isEmpty()) {
                    add(series, analysis.input(), h, h.inputDensity());
                }
                if (analysis.shown(output) || analysis.followed().size() <= 3) {
                    add(series, output, h, h.outputDensity());
                }
            });
        }
        return series.isEmpty() ? noSegment() : new LineChart("Power spectral density", ChartAxis.log("Frequency", "Hz"),
                ChartAxis.log("Density", densityUnit()), series);
    }

    private void add(List<Series> series, Channel channel, FrequencyResponse h, double[] density) {
        int[] shown = shown(h);
        double[] f = pick(h.frequency(), shown);
        double[] picked = pick(density, shown);
        series.add(Series.line(channel.toString(), f, picked));
        if (weighted().equals(Optional.of(channel))) {
            SeatAxis axis = axis(channel).orElseThrow();
            series.add(Series.dashed(channel + ", weighted " + axis.weighting().symbol(), f, IntStream.range(0, f.length)
                    .mapToDouble(k -> picked[k] * Math.pow(axis.weighting().factor(f[k]), 2)).toArray()));
        }
    }

    /** Natural frequency and damping ratio of the body between the input and an output, over time. */
    List<Block> body(int i) {
        FollowedBody followed = analysis.followed().get(i);
        if (!BodyTile.of(analysis.bodies().get(i)).found()) {
            return List.of(new Text(analysis.input() + " to " + followed.channel() + ": no natural frequency is given; "
                    + BodyTile.of(analysis.bodies().get(i)).reason() + "."));
        }
        List<Marker> cuts = Arrays.stream(followed.cuts()).mapToObj(t -> new Marker(start + t, "cut")).toList();
        String group = "body " + followed.channel();
        return List.of(new Beside(
                tracked("Natural frequency, " + followed.channel(), "Natural frequency", "Hz", followed.outlines().get(0).frequency(),
                        followed.outlines().get(0).frequencyDeviation()).marked(cuts).grouped(group),
                tracked("Damping ratio, " + followed.channel(), "Damping ratio", "1", followed.outlines().get(0).damping(),
                        followed.outlines().get(0).dampingDeviation())
                        .marked(cuts).grouped(group)),
                new Text(BodyTile.of(analysis.bodies().get(i)).explains("") + " Mean NIS "
                        + Digits.significant(followed.meanNis(), 3) + " (1 if the filter knows how wrong it is), "
                        + followed.track().divergences() + " divergences, " + followed.track().missing()
                        + " samples missing."));
    }

    private LineChart tracked(String title, String label, String unit, Envelope value, Envelope deviation) {
        double[] y = values(value, value::mean);
        return new LineChart(title, ChartAxis.linear("Time", "s"), ChartAxis.linear(label, unit),
                List.of(Series.line(label.toLowerCase(Locale.ROOT),
                        IntStream.range(0, value.size()).mapToDouble(k -> start + value.centre(k) / rate).toArray(), y)
                        .with(Band.deviations(y, values(deviation, deviation::mean), 2, "±2σ"))));
    }

    /** A channel's samples. */
    LineChart history(Channel channel) {
        return new LineChart(channel.toString(), ChartAxis.linear("Time", "s"), ChartAxis.linear(label(channel), channel.quantity().unit()),
                List.of(WaveformSeries.of(channel.toString(), analysis.samples(channel), start, 1 / rate))).grouped("time");
    }

    List<Block> spectrograms() {
        return List.of(spectrogram(analysis.input(), analysis.inputSpectrogram()),
                spectrogram(analysis.followed().get(analysis.leading()).channel(), analysis.outputSpectrogram()));
    }

    private Block spectrogram(Channel channel, Spectrogram spectrogram) {
        int columns = spectrogram.columns();
        if (columns == 0 || spectrogram.segmentation().bins() < 3) { // bins: segments of milliseconds resolve nothing
            return noSegment();
        }
        double[] all = IntStream.range(0, spectrogram.segmentation().bins()).mapToDouble(spectrogram.segmentation()::frequency).toArray();
        int rows = all.length;
        double[] times = IntStream.range(0, columns).mapToDouble(c -> start + spectrogram.time(c)).toArray();
        double[][] values = new double[columns][];
        for (int c = 0; c < columns; c++) {
            double[] decibels = spectrogram.decibels(c);
            values[c] = IntStream.range(1, rows).mapToDouble(k -> Double.isFinite(decibels[k]) ? decibels[k] : Double.NaN).toArray();
        }
        return new Heatmap(channel.toString(), ChartAxis.linear("Time", "s"), ChartAxis.linear("Frequency", "Hz"),
                ChartAxis.linear("Density", "dB re 1 (" + channel.quantity().unit() + ")²/Hz"), times, Arrays.copyOfRange(all, 1, rows),
                values)
                .grouped("spectrogram");
    }

    private static String group(FollowedBody followed) {
        return "response " + followed.channel();
    }

    private static String label(Channel channel) {
        return switch (channel.quantity()) {
            case ACCELERATION, SPECIFIC_FORCE -> "Acceleration";
            case ANGULAR_RATE -> "Angular rate";
            default -> channel.quantity().symbol();
        };
    }

    /** Unit of a power spectral density; each channel's own where input and outputs differ. */
    private String densityUnit() {
        List<String> units = Stream.concat(Stream.of(analysis.input()), analysis.outputs().stream()).map(c -> c.quantity().unit())
                .distinct()
                .toList();
        return units.size() == 1 ? "(" + units.get(0) + ")²/Hz" : "unit²/Hz";
    }

    /** Unit of the modulus of a response to the input. */
    private String ratio(Channel output) {
        return ResponseCurve.ratio(output, analysis.input());
    }

    private Block noSegment() {
        return new Text("There is no stretch of " + Digits.significant(analysis.segmentation().duration(), 3)
                + " s without a missing sample, so there are no spectra.");
    }

    /** The leading output, then the others in order. */
    private int[] leadingFirst() {
        int leading = analysis.leading();
        return IntStream.concat(IntStream.of(leading), IntStream.range(0, analysis.followed().size()).filter(i -> i != leading)).toArray();
    }

    /** Largest modulus where it can be believed, at least 1. */
    private static double top(double[] h1, double[] hv, boolean[] usable) {
        double top = 1;
        for (int i = 0; i < h1.length; i++) {
            top = usable[i] ? Math.max(top, Math.max(h1[i], hv[i])) : top;
        }
        return top;
    }

    private static boolean[] usable(FrequencyResponse h, int[] shown) {
        boolean[] usable = new boolean[shown.length];
        for (int i = 0; i < shown.length; i++) {
            usable[i] = h.usable()[shown[i]];
        }
        return usable;
    }

    /** Bins worth drawing: from 0.3 Hz to half the rate. */
    private static int[] shown(FrequencyResponse h) {
        return IntStream.range(0, h.frequency().length).filter(k -> h.frequency()[k] >= LEAST_FREQUENCY).toArray();
    }

    private static double[] values(Envelope envelope, IntToDoubleFunction of) {
        return IntStream.range(0, envelope.size()).mapToDouble(of).toArray();
    }

    private static double[] pick(double[] values, int[] at) {
        return Arrays.stream(at).mapToDouble(i -> values[i]).toArray();
    }
}
