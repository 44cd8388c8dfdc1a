package wbv.report.states;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import wbv.recording.Channel;
import wbv.report.page.Beside;
import wbv.report.page.Block;
import wbv.report.page.ChartAxis;
import wbv.report.page.Figures;
import wbv.report.page.HtmlWriter;
import wbv.report.page.Lead;
import wbv.report.page.LineChart;
import wbv.report.page.Page;
import wbv.report.page.Section;
import wbv.report.page.Series;
import wbv.report.page.StateGraph;
import wbv.report.page.Table;
import wbv.report.page.Text;
import wbv.report.page.XyChart;
import wbv.report.page.XySeries;
import wbv.result.Digits;
import wbv.result.OutputFolder;
import wbv.state.Confusion;
import wbv.state.FeatureSpec;
import wbv.state.MotionState;
import wbv.state.Reliability;
import wbv.state.StateModel;
import wbv.state.StateTrack;
import wbv.state.mixture.Gaussian;
import wbv.study.StatesStudy;

/** The report of motion states: when which, how one follows another, what they look like, and how far to trust them. */
public final class StatesPage {

    /** Most samples of a chart. */
    private static final int DRAWN = 12_000;
    private static final int CLOUD = 1500;
    private static final ChartAxis TIME = ChartAxis.linear("Time", "s");

    private final StateModel model;
    private final List<MotionState> known;
    private final List<StatesStudy.Labelled> labelled;
    private final Confusion confusion;
    private final Confusion live;
    private final List<Reliability> forecasts;
    private final Map<String, String> provenance;

    private StatesPage(StatesStudy study, Map<String, String> provenance) {
        this.model = study.model();
        this.known = List.copyOf(model.known());
        this.labelled = study.labelled();
        this.confusion = study.confusion();
        this.live = study.live();
        this.forecasts = study.forecasts();
        this.provenance = provenance;
    }

    /** Writes {@code report.html}. */
    public static void write(StatesStudy study, Map<String, String> provenance, OutputFolder out) throws IOException {
        HtmlWriter.write(new StatesPage(study, provenance).page(), out.file("report.html"));
    }

    private Page page() {
        List<Section> sections = new ArrayList<>(List.of(finding(), strip(), transitions(), emissions()));
        if (confusion.all() > 0) {
            sections.add(truth());
            sections.add(reliability());
        }
        sections.add(way());
        sections.add(new Section("Provenance", "The same inputs, options and version give the same results.",
                new Table("", List.of(Table.Column.words("What"), Table.Column.words("Value")),
                        provenance.entrySet().stream().map(entry -> List.of(entry.getKey(), entry.getValue())).toList())));
        return new Page("Motion states of " + labelled.get(0).name(), model.chain().states() + " components of " + known.size()
                + " states (" + model.mixture() + "), trained on " + model.trials().size()
                + (model.trials().size() == 1 ? " recording" : " recordings"), sections);
    }

    private Section finding() {
        List<Block> blocks = new ArrayList<>();
        StateTrack first = labelled.get(0).track();
        MotionState most = known.stream().max((a, b) -> Double.compare(StatesStudy.seconds(first, a),
                StatesStudy.seconds(first, b)))
                .orElseThrow();
        double jerking = known.stream().filter(MotionState::jerk).mapToDouble(state -> StatesStudy.seconds(first, state)).sum();
        blocks.add(new Lead(String.format(Locale.ROOT, "%s for %.0f %% of the time; %.1f s of jerk in %.0f s.",
                capital(most.toString()),
                100 * StatesStudy.seconds(first, most) / first.recording().duration(), jerking, first.recording().duration())));
        if (confusion.all() > 0) {
            blocks.add(new Figures(new Figures.Figure("Accuracy", Digits.rounded(100 * confusion.accuracy(), 1), "%", "whole "
                    + "recording"),
                    new Figures.Figure("Accuracy live", Digits.rounded(100 * live.accuracy(), 1), "%", "from the past alone"),
                    new Figures.Figure("Macro-F1", Digits.rounded(confusion.macroF1(), 2), "", "all states alike"),
                    new Figures.Figure("Jerk in 100 ms", Digits.rounded(forecasts.get(0).area(), 3), "AUC", "of the forecast")));
        }
        List<List<String>> rows = new ArrayList<>();
        double[] shares = model.longRun();
        for (int k = 0; k < known.size(); k++) {
            MotionState state = known.get(k);
            rows.add(List.of(state.toString(), state.meaning(), Digits.rounded(StatesStudy.seconds(first, state), 1),
                    Digits.rounded(100 * StatesStudy.seconds(first, state) / first.recording().duration(), 1),
                    Digits.rounded(100 * shares[k], 1), Integer.toString(model.rows().getOrDefault(state, 0))));
        }
        blocks.add(new Table("States", List.of(Table.Column.words("State"), Table.Column.words("What it is"),
                Table.Column.numbers("Here [s]"), Table.Column.numbers("Here [%]"), Table.Column.numbers("Model, long run [%]"),
                Table.Column.numbers("Samples learned from")), rows));
        blocks.add(new Text(String.format(Locale.ROOT, "Jerk is the slope of vertical acceleration, low-passed at %.1f Hz; in a "
                + "jolt a place jerks beyond %.0f m/s³. A jolt is where the seat's mean acceleration changes by more than %.1f m/s² from "
                + "0.15 s to the next. It rocks where roll and pitch rate below about 1.5 Hz exceed %.2g rad/s, and rests where jerk "
                + "stays below %.2g m/s³. Where no truth lies beside a recording, these thresholds name the samples that the model "
                + "learns from.", model.features().corner(), model.thresholds().jerk(), model.thresholds().surge(),
                model.thresholds().rocking(), model.thresholds().rest())));
        return new Section("Finding", "", blocks);
    }

    private Section strip() {
        StateTrack track = labelled.get(0).track();
        int n = Math.min(DRAWN, track.length());
        double[] time = new double[n];
        Arrays.setAll(time, i -> track.recording().clock().time(i));
        List<Block> blocks = new ArrayList<>();
        List<Series> strips = new ArrayList<>();
        for (int k = 0; k < known.size(); k++) {
            double[] y = new double[n];
            for (int i = 0; i < n; i++) {
                y[i] = track.state(i) == known.get(k) ? known.size() - k : Double.NaN;
            }
            strips.add(Series.points(known.get(k).toString(), time, y));
        }
        List<String> names = new ArrayList<>(known.stream().map(MotionState::toString).toList());
        Collections.reverse(names);
        blocks.add(new LineChart("State", TIME, ChartAxis.named(names), strips).grouped("time"));
        FeatureSpec features = model.features();
        for (Channel channel : List.of(features.seat(), features.head())) {
            blocks.add(new LineChart(channel.toString(), TIME, ChartAxis.linear("Acceleration", "m/s²"),
                    List.of(Series.line(channel.toString(),
                            time, Arrays.copyOf(track.recording().values(channel), n))))
                    .grouped("time"));
        }
        blocks.add(new LineChart("Roll and pitch rate", TIME, ChartAxis.linear("Rate", "rad/s"), List.of(
                Series.line(features.roll().toString(), time, Arrays.copyOf(track.recording().values(features.roll()), n)),
                Series.line(features.pitch().toString(), time, Arrays.copyOf(track.recording().values(features.pitch()), n))))
                .grouped("time"));
        List<Series> ahead = new ArrayList<>();
        for (int h = 0; h < StateTrack.HORIZONS.length; h++) {
            double[] y = new double[n];
            int horizon = h;
            Arrays.setAll(y, i -> track.forecast(horizon, i));
            ahead.add(Series.line("within " + Math.round(1000 * StateTrack.HORIZONS[h]) + " ms", time, y));
        }
        blocks.add(new LineChart("Forecast: probability of a jerk", TIME, ChartAxis.linear("Probability", "").within(0, 1), ahead)
                .grouped("time"));
        return new Section("States over time", "The likeliest state of every sample given the whole recording, one line a state, "
                + "above the "
                + "signals" + (n < track.length() ? "; the first " + Math.round(time[n - 1]) + " s" : "") + ". Drag to zoom.",
                blocks);
    }

    private Section transitions() {
        double[][] chances = model.transitions();
        List<String> names = known.stream().map(MotionState::toString).toList();
        List<Table.Column> columns = new ArrayList<>(List.of(Table.Column.words("From")));
        names.forEach(name -> columns.add(Table.Column.numbers(name)));
        List<List<String>> rows = new ArrayList<>();
        for (int i = 0; i < names.size(); i++) {
            List<String> row = new ArrayList<>(List.of(names.get(i)));
            for (double chance : chances[i]) {
                row.add(Digits.rounded(100 * chance, chance < 0.001 ? 3 : chance < 0.01 ? 2 : 1));
            }
            rows.add(row);
        }
        return new Section("How one follows another", "From one sample to the next. Arrows: transitions of one in a hundred or "
                + "more, wider "
                + "where likelier, and in the circle the probability of staying.",
                new StateGraph("Transitions [%]", names, chances, model.longRun(), 0.01),
                new Table("Transition probabilities [%]", columns, rows));
    }

    private Section emissions() {
        List<XySeries> jerks = clouds(FeatureSpec.SEAT_JERK, FeatureSpec.HEAD_JERK);
        List<XySeries> levels = clouds(FeatureSpec.SURGE, FeatureSpec.SWAY);
        for (int k = 0; k < known.size(); k++) {
            double[][] outline = ellipses(known.get(k));
            levels.add(new XySeries(known.get(k) + ", 2σ", outline[0], outline[1], XySeries.Style.DASHED).coloured(k));
        }
        return new Section("What the states look like", "Left what a jolt's states are told by: jerk of the head over jerk of the "
                + "seat. Right what tells a jolt and rocking: how the seat sways over how it surges, both as logarithms that are "
                + "flat where they say nothing; dashed the ellipses of two standard deviations of every component.",
                new Beside(
                        new XyChart("Head over seat", ChartAxis.linear("Seat jerk", "m/s³"), ChartAxis.linear("Head jerk", "m/s³"), jerks),
                        new XyChart("Sway over surge", ChartAxis.linear("Surge, log10", "m/s²"), ChartAxis.linear("Sway, log10", "rad/s"),
                                levels)));
    }

    /** Samples of the first recording by state, at most so many of each. */
    private List<XySeries> clouds(int across, int up) {
        StateTrack track = labelled.get(0).track();
        List<XySeries> series = new ArrayList<>();
        for (int k = 0; k < known.size(); k++) {
            MotionState state = known.get(k);
            int[] members = java.util.stream.IntStream.range(0, track.length()).filter(i -> track.told(i)
                    && track.state(i) == state)
                    .toArray();
            int step = Math.max(1, members.length / CLOUD);
            int[] kept = java.util.stream.IntStream.range(0, members.length).filter(i -> i % step == 0).map(i -> members[i])
                    .toArray();
            if (kept.length > 0) {
                series.add(new XySeries(state.toString(), Arrays.stream(kept).mapToDouble(i -> track.features()[i][across]).toArray(),
                        Arrays.stream(kept).mapToDouble(i -> track.features()[i][up]).toArray(), XySeries.Style.CLOUD).coloured(k));
            }
        }
        return series;
    }

    /** Ellipses of the components of a state, sway over surge, one after another with gaps. */
    private double[][] ellipses(MotionState state) {
        List<double[]> points = new ArrayList<>();
        int across = FeatureSpec.SURGE - FeatureSpec.SHAKING;
        int up = FeatureSpec.SWAY - FeatureSpec.SHAKING;
        for (int k = 0; k < model.chain().states(); k++) {
            if (model.names().get(k) != state) {
                continue;
            }
            for (Gaussian gaussian : model.chain().emissions().get(k).components()) {
                double a = gaussian.covariance(across, across);
                double l21 = gaussian.covariance(across, up) / Math.sqrt(a);
                double l22 = Math.sqrt(Math.max(0, gaussian.covariance(up, up) - l21 * l21));
                for (int i = 0; i <= 40; i++) {
                    double angle = 2 * Math.PI * i / 40;
                    points.add(new double[] {gaussian.mean(across) + 2 * Math.sqrt(a) * Math.cos(angle),
                        gaussian.mean(up) + 2 * (l21 * Math.cos(angle) + l22 * Math.sin(angle))});
                }
                points.add(new double[] {Double.NaN, Double.NaN});
            }
        }
        return new double[][] {points.stream().mapToDouble(p -> p[0]).toArray(), points.stream().mapToDouble(p -> p[1])
                .toArray()};
    }

    private Section truth() {
        Set<MotionState> all = java.util.EnumSet.copyOf(known);
        for (MotionState state : MotionState.values()) {
            if (confusion.of(state) > 0) {
                all.add(state);
            }
        }
        List<Table.Column> columns = new ArrayList<>(List.of(Table.Column.words("True")));
        all.forEach(state -> columns.add(Table.Column.numbers(state.toString())));
        columns.add(Table.Column.numbers("F1"));
        List<List<String>> rows = new ArrayList<>();
        for (MotionState state : all) {
            List<String> row = new ArrayList<>(List.of(state.toString()));
            all.forEach(other -> row.add(Integer.toString(confusion.count(state, other))));
            row.add(Digits.rounded(confusion.f1(state), 2));
            rows.add(row);
        }
        return new Section("Against the truth", "What the rig injected at known times, and how seat and head truly jerked, row "
                + "by row; what was "
                + "said of the sample, column by column.", new Table("Samples", columns, rows));
    }

    private Section reliability() {
        List<XySeries> series = new ArrayList<>(List.of(new XySeries("said and came alike", new double[] {0, 1}, new double[] {0,
            1},
                XySeries.Style.DASHED).coloured(7)));
        List<List<String>> rows = new ArrayList<>();
        for (int h = 0; h < forecasts.size(); h++) {
            Reliability forecast = forecasts.get(h);
            String name = "within " + Math.round(1000 * StateTrack.HORIZONS[h]) + " ms";
            List<Reliability.Bin> bins = forecast.bins();
            series.add(new XySeries(name, bins.stream().mapToDouble(Reliability.Bin::said).toArray(),
                    bins.stream().mapToDouble(Reliability.Bin::came).toArray(),
                    bins.stream().mapToDouble(bin -> 2 * Math.sqrt(bin.came() * (1 - bin.came()) / bin.count())).toArray(),
                    XySeries.Style.POINTS, h));
            rows.add(List.of(name, Digits.rounded(forecast.area(), 3), Digits.rounded(100 * forecast.calibrationError(), 1),
                    Digits.rounded(100 * forecast.base(), 1)));
        }
        return new Section("Can the forecast be trusted?", "Of the samples where so much was said, so many jerks came (± 2σ as "
                + "if samples were "
                + "independent, which they are not). Jolts come at random times: what can be foreseen is how one goes on.",
                new Beside(new XyChart("Reliability", ChartAxis.linear("Said", "").within(0, 1), ChartAxis.linear("Came", "").within(0, 1),
                        series),
                        new Table("Forecast of a jerk", List.of(Table.Column.words("Horizon"), Table.Column.numbers("AUC"),
                                Table.Column.numbers("Mean error [%]"), Table.Column.numbers("Came [%]")), rows)));
    }

    private Section way() {
        List<List<String>> rows = new ArrayList<>();
        for (StatesStudy.Labelled each : labelled) {
            rows.add(List.of(each.name(), Integer.toString(each.way().samples()),
                    each.way().lag().map(lag -> Digits.rounded(1000 * lag.seconds(), 1)).orElse("–"),
                    each.way().lag().map(lag -> Digits.rounded(2000 * lag.deviation(), 1)).orElse("–"),
                    Digits.rounded(each.way().frequency(), 2), Digits.rounded(each.way().damping(), 2),
                    each.body().map(body -> Digits.rounded(body[0], 2)).orElse("–"),
                    each.body().map(body -> Digits.rounded(body[1], 2)).orElse("–")));
        }
        return new Section("From seat to head", "How much later the head jerks, and the body of one degree of freedom that would "
                + "do that, where the states jerk; beside it the streaming estimator's, from all of the signals. Only jolts that stand "
                + "out of the ride tell a lag, three at least.",
                new Table("", List.of(
                        Table.Column.words("Recording"), Table.Column.numbers("Jerking samples"), Table.Column.numbers("Lag "
                                + "[ms]"),
                        Table.Column.numbers("±2σ [ms]"),
                        Table.Column.numbers("Frequency [Hz]"), Table.Column.numbers("Damping ratio"),
                        Table.Column.numbers("Kalman [Hz]"), Table.Column.numbers("Kalman damping")), rows));
    }

    private static String capital(String word) {
        return Character.toUpperCase(word.charAt(0)) + word.substring(1);
    }
}
