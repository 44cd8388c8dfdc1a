package wbv.report;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.filter.Track;
import wbv.recording.Channel;
import wbv.recording.Inspection;
import wbv.report.LineChart.Marker;
import wbv.signal.Envelope;
import wbv.signal.FrequencyResponse;
import wbv.signal.Spectrogram;

/** The report of an analysis. */
final class AnalysisPage {

    private static final double LEAST_FREQUENCY = 0.3;

    private final Analysis analysis;
    private final double rate;
    private final double start;

    AnalysisPage(Analysis analysis) {
        this.analysis = analysis;
        this.rate = analysis.inspection().clock().rate();
        this.start = analysis.inspection().clock().start();
    }

    Page page() {
        Inspection seen = analysis.inspection();
        String subtitle = analysis.input() + " to " + String.join(", ", analysis.outputs().stream().map(Channel::toString).toList())
                + " — " + Digits.significant(seen.duration(), 4) + " s at " + Digits.significant(rate, 5) + " Hz";
        return new Page("Vibration of " + analysis.request().title(), subtitle, List.of(summary(),
                RecordingSection.of(analysis.inspection(), analysis.relay()), histories(), spectra(), responses(),
                bodies(), spectrograms(), provenance()));
    }

    private Section summary() {
        List<Block> blocks = new ArrayList<>();
        Response response = analysis.responses().get(analysis.leading());
        Track track = response.estimator().track();
        List<Figures.Figure> figures = new ArrayList<>();
        response.known().ifPresentOrElse(body -> {
            figures.add(Figures.Figure.measured("natural frequency", body.frequency(), body.frequencyDeviation(), "Hz"));
            figures.add(Figures.Figure.measured("damping ratio", body.damping(), body.dampingDeviation(), ""));
        }, () -> figures.add(new Figures.Figure("body", "not found", "", response.lost())));
        analysis.frequencyResponse(analysis.leading()).ifPresent(h -> {
            int peak = peak(h);
            if (peak >= 0) {
                figures.add(new Figures.Figure("peak transmissibility", Digits.significant(h.h1().magnitude(peak), 3),
                        "at " + Digits.significant(h.frequency()[peak], 3) + " Hz", ""));
            }
        });
        figures.add(Figures.Figure.of("ADWIN cuts", track.cuts(), ""));
        blocks.add(new Text("From " + analysis.input() + " to " + response.channel()
                + ": what the streaming estimator knows after the last sample, and what the averaged spectra show."
                + (response.known().isPresent() && !response.lost().isEmpty() ? " The estimate is " + response.lost() + "." : "")));
        blocks.add(new Figures(figures));
        if (analysis.responses().size() > 1) {
            blocks.add(bodyTable());
        }
        return new Section("Summary", "", blocks);
    }

    private Table bodyTable() {
        List<List<String>> rows = new ArrayList<>();
        for (int i = 0; i < analysis.responses().size(); i++) {
            Response response = analysis.responses().get(i);
            Track track = response.estimator().track();
            String peak = analysis.frequencyResponse(i).map(h -> peak(h) < 0 ? "" : Digits.significant(h.h1().magnitude(peak(h)), 3)
                    + " at " + Digits.significant(h.frequency()[peak(h)], 3) + " Hz").orElse("");
            rows.add(List.of(response.channel().toString(),
                    response.known().map(b -> withDeviation(b.frequency(), b.frequencyDeviation()) + late(response)).orElse("not found"),
                    response.known().map(b -> withDeviation(b.damping(), b.dampingDeviation())).orElse("–"), peak, Long.toString(track.cuts()),
                    Long.toString(track.divergences()), Digits.significant(track.outputNoise(), 3)));
        }
        return new Table("Single-degree-of-freedom body between input and each output, after the last sample (± 2σ)",
                List.of(Table.Column.words("Output"), Table.Column.numbers("Natural frequency [Hz]"), Table.Column.numbers("Damping ratio"),
                        Table.Column.numbers("Peak |H1|"), Table.Column.numbers("Cuts"), Table.Column.numbers("Divergences"),
                        Table.Column.numbers("Unexplained [m/s²]")), rows);
    }

    private static String late(Response response) {
        return response.lost().isEmpty() ? "" : String.format(java.util.Locale.ROOT, " at %.0f s", response.known().orElseThrow().time());
    }

    private static String withDeviation(double value, double deviation) {
        return Digits.significant(value, 3) + " ± " + Digits.significant(2 * deviation, 2);
    }

    private Section histories() {
        List<Block> charts = new ArrayList<>();
        charts.add(history(analysis.input(), analysis.inputSamples()));
        for (int i : leadingFirst()) {
            charts.add(history(analysis.responses().get(i).channel(), analysis.responses().get(i).samples()));
        }
        return new Section("Time histories", "Where many samples share a pixel, their range is drawn.", charts);
    }

    private LineChart history(Channel channel, Envelope samples) {
        double[] x = times(samples);
        Series series = Series.line(channel.toString(), x, values(samples, samples::mean));
        if (samples.width() > 1) {
            series = series.with(Band.extremes(values(samples, samples::smallest), values(samples, samples::largest)));
        }
        return new LineChart(channel.toString(), Axis.linear("Time", "s"), Axis.linear(label(channel), channel.quantity().unit()),
                List.of(series)).grouped("time");
    }

    private Section spectra() {
        List<Series> series = new ArrayList<>();
        for (int i : leadingFirst()) {
            analysis.frequencyResponse(i).ifPresent(h -> {
                int[] shown = shown(h);
                if (series.isEmpty()) {
                    series.add(Series.line(analysis.input().toString(), pick(h.frequency(), shown), pick(h.inputDensity(), shown)));
                }
                series.add(Series.line(analysis.responses().get(i).channel().toString(), pick(h.frequency(), shown),
                        pick(h.outputDensity(), shown)));
            });
        }
        Block block = series.isEmpty() ? noSegment() : new LineChart("Power spectral density", Axis.log("Frequency", "Hz"),
                Axis.log("Density", densityUnit()), series);
        return new Section("Spectra", "Welch averages: Hann window, segments of "
                + Digits.significant(analysis.segmentation().duration(), 3) + " s overlapping by half, resolution "
                + Digits.significant(analysis.segmentation().resolution(), 2) + " Hz.", block);
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
        List<String> units = Stream.concat(Stream.of(analysis.input()), analysis.outputs().stream()).map(c -> c.quantity().unit()).distinct().toList();
        return units.size() == 1 ? "(" + units.get(0) + ")²/Hz" : "unit²/Hz";
    }

    /** Unit of the modulus of a response to the input. */
    private String ratioUnit(Channel output) {
        String in = analysis.input().quantity().unit();
        String out = output.quantity().unit();
        return in.equals(out) ? "1" : "(" + out + ")/(" + in + ")";
    }

    private Block noSegment() {
        return new Text("There is no stretch of " + Digits.significant(analysis.segmentation().duration(), 3)
                + " s without a missing sample, so there are no spectra.");
    }

    private Section responses() {
        List<Block> blocks = new ArrayList<>();
        for (int i : leadingFirst()) {
            Response response = analysis.responses().get(i);
            analysis.frequencyResponse(i).ifPresentOrElse(h -> addResponse(response, h, blocks), () -> blocks.add(noSegment()));
        }
        return new Section("Transmissibility", "H1 is right where only the output is noisy, Hv where both are equally so; both agree where "
                + "the coherence is near 1. Shaded frequencies are not excited enough to be believed. The broken line is the estimator's "
                + "body with the parameters it ended with.", blocks);
    }

    private void addResponse(Response response, FrequencyResponse h, List<Block> blocks) {
        int[] shown = shown(h);
        double[] f = pick(h.frequency(), shown);
        boolean[] usable = new boolean[shown.length];
        for (int i = 0; i < shown.length; i++) {
            usable[i] = h.usable()[shown[i]];
        }
        double[] h1 = pick(h.h1().magnitudes(), shown);
        double[] error = pick(h.error(), shown);
        double[] deviation = IntStream.range(0, h1.length).mapToDouble(i -> usable[i] ? h1[i] * error[i] : Double.NaN).toArray();
        String group = "response " + response.channel();
        String reason = "not excited";
        blocks.add(new LineChart(analysis.input() + " to " + response.channel(), Axis.log("Frequency", "Hz"),
                Axis.linear("Modulus", ratioUnit(response.channel())).within(0, 1.15 * top(h1, pick(h.hv().magnitudes(), shown), usable)),
                List.of(Series.line("H1", f, h1).with(Band.deviations(h1, deviation, 2, "±2σ")),
                        Series.line("Hv", f, pick(h.hv().magnitudes(), shown)),
                        Series.dashed("estimator", f, Arrays.stream(f).map(response.estimator()::modulus).toArray())))
                .shadedUnless(usable, f, reason).grouped(group));
        double[] degrees = Arrays.stream(pick(h.h1().phases(), shown)).map(Math::toDegrees).toArray();
        blocks.add(new LineChart("Phase", Axis.log("Frequency", "Hz"), Axis.linear("Phase", "°"),
                List.of(Series.line("H1", f, degrees))).shadedUnless(usable, f, reason).grouped(group));
        blocks.add(new LineChart("Coherence", Axis.log("Frequency", "Hz"), Axis.linear("Coherence γ²", "1").within(0, 1.02),
                List.of(Series.line("γ²", f, pick(h.coherence(), shown)))).shadedUnless(usable, f, reason).grouped(group)
                .noted(Digits.significant(h.averages(), 3) + " independent averages"));
    }

    /** Largest modulus where it can be believed, at least 1. */
    private static double top(double[] h1, double[] hv, boolean[] usable) {
        double top = 1;
        for (int i = 0; i < h1.length; i++) {
            top = usable[i] ? Math.max(top, Math.max(h1[i], hv[i])) : top;
        }
        return top;
    }

    private Section bodies() {
        List<Block> blocks = new ArrayList<>();
        for (int i : leadingFirst()) {
            Response response = analysis.responses().get(i);
            List<Marker> cuts = Arrays.stream(response.cuts()).mapToObj(t -> new Marker(start + t, "cut")).toList();
            String group = "body " + response.channel();
            blocks.add(tracked("Natural frequency, " + response.channel(), "Natural frequency", "Hz", response.frequency(),
                    response.frequencyDeviation()).marked(cuts).grouped(group));
            blocks.add(tracked("Damping ratio, " + response.channel(), "Damping ratio", "1", response.damping(),
                    response.dampingDeviation()).marked(cuts).grouped(group)
                    .noted("Mean NIS " + Digits.significant(response.meanNis(), 3) + " (1 if the filter knows how wrong it is), "
                            + response.estimator().track().divergences() + " divergences, "
                            + response.estimator().track().missing() + " samples missing."));
        }
        return new Section("Body over time", "A body of one degree of freedom followed by an extended Kalman filter whose memory ADWIN sets; "
                + "a cut marks where the body, or what disturbs it, has changed. The band is ±2σ as the filter sees it.", blocks);
    }

    private LineChart tracked(String title, String label, String unit, Envelope value, Envelope deviation) {
        double[] y = values(value, value::mean);
        double[] sd = values(deviation, deviation::mean);
        return new LineChart(title, Axis.linear("Time", "s"), Axis.linear(label, unit),
                List.of(Series.line(label.toLowerCase(java.util.Locale.ROOT), times(value), y).with(Band.deviations(y, sd, 2, "±2σ"))));
    }

    private Section spectrograms() {
        List<Block> blocks = new ArrayList<>();
        addSpectrogram(analysis.input(), analysis.inputSpectrogram(), blocks);
        addSpectrogram(analysis.responses().get(analysis.leading()).channel(), analysis.outputSpectrogram(), blocks);
        return new Section("Spectrograms", "Power spectral density over time.", blocks);
    }

    private void addSpectrogram(Channel channel, Spectrogram spectrogram, List<Block> blocks) {
        int columns = spectrogram.columns();
        double[] all = spectrogram.segmentation().frequencies();
        int rows = (int) IntStream.range(0, all.length).filter(k -> all[k] <= Math.min(all[all.length - 1], 30)).count();
        if (columns == 0 || rows < 3) { // rows: segments of milliseconds resolve nothing below 30 Hz
            blocks.add(noSegment());
            return;
        }
        double[] times = IntStream.range(0, columns).mapToDouble(c -> start + spectrogram.time(c)).toArray();
        double[][] values = new double[columns][];
        for (int c = 0; c < columns; c++) {
            double[] decibels = spectrogram.decibels(c);
            values[c] = IntStream.range(1, rows).mapToDouble(k -> Double.isFinite(decibels[k]) ? decibels[k] : Double.NaN).toArray();
        }
        blocks.add(new Heatmap(channel.toString(), Axis.linear("Time", "s"), Axis.linear("Frequency", "Hz"),
                Axis.linear("Density", "dB re 1 (" + channel.quantity().unit() + ")²/Hz"), times, Arrays.copyOfRange(all, 1, rows), values).grouped("spectrogram"));
    }

    private Section provenance() {
        List<List<String>> rows = new ArrayList<>();
        analysis.request().provenance().forEach((name, value) -> rows.add(List.of(name, value)));
        return new Section("Provenance", "The same inputs, options and version give the same results.",
                new Table("", List.of(Table.Column.words("What"), Table.Column.words("Value")), rows),
                new Code("The same estimate as a MOA task, for the first output:", analysis.taskString()));
    }

    /** The leading output, then the others in order. */
    private int[] leadingFirst() {
        int leading = analysis.leading();
        return IntStream.concat(IntStream.of(leading), IntStream.range(0, analysis.responses().size()).filter(i -> i != leading)).toArray();
    }

    private double[] times(Envelope envelope) {
        return IntStream.range(0, envelope.size()).mapToDouble(i -> start + envelope.centre(i) / rate).toArray();
    }

    private static double[] values(Envelope envelope, java.util.function.IntToDoubleFunction of) {
        return IntStream.range(0, envelope.size()).mapToDouble(of).toArray();
    }

    /** Bins worth drawing: from 0.3 Hz to half the rate. */
    private static int[] shown(FrequencyResponse h) {
        return IntStream.range(0, h.frequency().length).filter(k -> h.frequency()[k] >= LEAST_FREQUENCY).toArray();
    }

    private static double[] pick(double[] values, int[] at) {
        return Arrays.stream(at).mapToDouble(i -> values[i]).toArray();
    }

    private static int peak(FrequencyResponse h) {
        int peak = -1;
        for (int k = 0; k < h.frequency().length; k++) {
            if (h.usable()[k] && (peak < 0 || h.h1().magnitude(k) > h.h1().magnitude(peak))) {
                peak = k;
            }
        }
        return peak;
    }
}
