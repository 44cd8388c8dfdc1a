package wbv.report.diagnosis;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import wbv.diagnosis.Diagnosis;
import wbv.diagnosis.DisplayedNumber;
import wbv.diagnosis.Interval;
import wbv.diagnosis.picture.Pictures;
import wbv.report.page.BarChart;
import wbv.report.page.Beside;
import wbv.report.page.Block;
import wbv.report.page.Chart;
import wbv.report.page.Figures;
import wbv.report.page.Findings;
import wbv.report.page.Lead;
import wbv.report.page.Page;
import wbv.report.page.Section;
import wbv.report.page.Table;
import wbv.report.page.Text;
import wbv.result.Digits;

/** The report of a diagnosis, so that a person can believe it, or not, by looking. */
final class DiagnosisPage {

    /** Errors of sensors that a reader knows what to make of. */
    private static final List<String> SENSOR_ERRORS = List.of("gain", "delay", "tilt", "arm");
    private static final String GAIN = "gain";

    private final Diagnosis diagnosis;
    private final Pictures pictures;
    private final Map<String, String> provenance;
    private final DiagnosisCharts charts;
    private final HeldOutCharts heldOut;

    DiagnosisPage(Diagnosis diagnosis, Pictures pictures, Map<String, String> provenance) {
        this.diagnosis = diagnosis;
        this.pictures = pictures;
        this.provenance = provenance;
        this.charts = new DiagnosisCharts(pictures);
        this.heldOut = new HeldOutCharts(diagnosis.fit(), pictures.completed(), charts.before(), charts.after());
    }

    Page page() {
        List<Section> sections = new ArrayList<>();
        sections.add(finding());
        if (!pictures.portraits().isEmpty()) {
            sections.add(portraits());
        }
        sections.add(charts.residuals());
        sections.add(charts.responses());
        sections.add(heldOut.bands());
        sections.add(charts.histories());
        sections.add(values());
        if (!diagnosis.alternatives().isEmpty() || !diagnosis.latent().isEmpty()) {
            sections.add(rivals());
        }
        sections.add(new Section("Provenance", "The same inputs, options and version give the same results.",
                new Table("", List.of(Table.Column.words("What"), Table.Column.words("Value")),
                        provenance.entrySet().stream().map(entry -> List.of(entry.getKey(), entry.getValue())).toList())));
        String name = diagnosis.model().name();
        return new Page(name.isBlank() ? "Diagnosis" : "Diagnosis of " + name, pictures.views().size() + " outputs; held out "
                + Digits.rounded(diagnosis.fit().heldOut()[0], 0) + " to " + Digits.rounded(diagnosis.fit().heldOut()[1], 0)
                + " s", sections);
    }

    private Section finding() {
        Diagnosis.Fit fit = diagnosis.fit();
        List<Figures.Figure> figures = new ArrayList<>();
        figures.add(new Figures.Figure("verdict", words(diagnosis.verdict()), "", ""));
        figures.add(new Figures.Figure("held-out χ² " + (pictures.completed() ? "before" : "fitted"),
                Digits.significant(fit.heldBefore(), 3), "",
                "times the noise's power"));
        if (pictures.completed()) {
            figures.add(new Figures.Figure("held-out χ² after", Digits.significant(fit.heldAfter(), 3), "", "1 is noise alone"));
            figures.add(new Figures.Figure("mismatch explained", percent(share(fit.heldBefore(), fit.heldAfter())), "",
                    "held out"));
        } else {
            figures.add(new Figures.Figure("χ² as given", Digits.significant(fit.given(), 3), "",
                    "fitted part; 1 is noise alone"));
        }
        if (!diagnosis.missing().isEmpty()) {
            figures.add(new Figures.Figure("probability", Digits.significant(diagnosis.missing().get(0).probability(), 2), "",
                    diagnosis.verdict() == Diagnosis.Verdict.LEARNED_LAW ? "among the laws that were fitted"
                            : diagnosis.missing().get(0).mechanism()));
        }
        List<Block> blocks = new ArrayList<>(List.of(new Lead(diagnosis.sentence()), new Figures(figures), bars()));
        if (!diagnosis.missing().isEmpty()) {
            blocks.add(found());
        }
        diagnosis.learned().ifPresent(law -> blocks.add(laws(law)));
        PlaneDrawing.of(diagnosis.model(), diagnosis.missing().stream().map(Diagnosis.Named::where).toList()).ifPresent(blocks::add);
        if (!diagnosis.nextExperiment().isBlank()) {
            blocks.add(new Findings(List.of(new Findings.Finding(Findings.Severity.NOTE, "Next experiment",
                    diagnosis.nextExperiment())), ""));
        }
        return new Section("Finding", "", blocks);
    }

    private Table laws(Diagnosis.LearnedLaw law) {
        List<List<String>> rows = new ArrayList<>();
        rows.add(List.of(law.formula(), "learned", Digits.significant(diagnosis.fit().after(), 3)));
        law.rivals().forEach(rival -> rows.add(List.of(rival.formula(), "rival", Digits.significant(rival.reduced(), 3))));
        boolean corrects = diagnosis.verdict() != Diagnosis.Verdict.LEARNED_LAW;
        return new Table(
                (corrects ? "What was learned of the form of the law in " + law.where() + ", beside the library's, and what else was fitted"
                        : "The law that was learned for " + law.where() + ", and others that were fitted beside it")
                        + ". The force pulls the ends of the link together; "
                        + "r is its deflection, v its speed, both positive in extension",
                List.of(Table.Column.words("Force F"), Table.Column.words("As"),
                        Table.Column.numbers("χ² left")),
                rows);
    }

    private static String words(Diagnosis.Verdict verdict) {
        return verdict.word().replace('-', ' ');
    }

    /** Part of what is above the noise that went. */
    private static double share(double before, double after) {
        return before > 1 ? Math.max(0, Math.min(1, (before - after) / (before - 1))) : Double.NaN;
    }

    private static String percent(double share) {
        return Double.isNaN(share) ? "–" : Digits.significant(100 * share, share > 0.99 ? 4 : 3) + " %";
    }

    private BarChart bars() {
        Map<String, Double> given = new LinkedHashMap<>();
        pictures.views().forEach(view -> given.put(view.channel(), view.nrmseGiven()));
        return heldOut.channels(given);
    }

    private Table found() {
        List<List<String>> rows = new ArrayList<>();
        for (Diagnosis.Named named : diagnosis.missing()) {
            String place = named.mechanism() + " at " + named.where();
            for (Map.Entry<String, String> choice : named.form().entrySet()) {
                rows.add(List.of(place, choice.getKey(), choice.getValue(), "", "", ""));
                place = "";
            }
            for (Map.Entry<String, Double> entry : named.parameters().entrySet()) {
                DisplayedNumber amount = DisplayedNumber.of(entry.getKey());
                Optional<Interval> interval = Optional.ofNullable(named.intervals().get(entry.getKey()));
                double value = amount.factor() * entry.getValue();
                rows.add(List.of(place, amount.label(),
                        interval.map(i -> value(value, half(i, amount))).orElseGet(() -> Digits.significant(value, 4)),
                        interval.map(i -> range(i, amount)).orElse(""), amount.unit(),
                        interval.map(i -> i.from().name().toLowerCase(Locale.ROOT)).orElse("")));
                place = "";
            }
            if (named.parameters().isEmpty() && named.form().isEmpty()) {
                rows.add(List.of(place, "", "", "", "", ""));
            }
        }
        String what = diagnosis.verdict().isRefusal() ? "What comes nearest, and is in the completed model." : "What was found.";
        return new Table(what + " An interval is read off the curvature of the cost where that is a parabola, off the "
                + "profile of the cost where it is not",
                List.of(Table.Column.words("Mechanism"), Table.Column.words("Parameter"),
                        Table.Column.numbers("Value"), Table.Column.numbers("95 %"), Table.Column.words("Unit"),
                        Table.Column.words("From")),
                rows);
    }

    /** Half the width; infinite where an end is open. */
    private static double half(Interval interval, DisplayedNumber amount) {
        return interval.isClosed() ? amount.factor() * (interval.high() - interval.low()) / 2 : Double.POSITIVE_INFINITY;
    }

    /** As many digits as two of half the width reach, five at most. */
    private static String value(double value, double half) {
        boolean known = half > 0 && half < Double.MAX_VALUE;
        return known && Digits.decimals(half, 2) <= Digits.decimals(Math.max(Math.abs(value), half), 5)
                ? Digits.rounded(value, Digits.decimals(half, 2)) : Digits.significant(value, known ? 5 : 4);
    }

    private static String range(Interval interval, DisplayedNumber amount) {
        double low = amount.factor() * interval.low();
        double high = amount.factor() * interval.high();
        if (!interval.isClosed()) {
            boolean neither = Double.isInfinite(low) && Double.isInfinite(high);
            return "not identifiable" + (neither ? "" : Double.isInfinite(low) ? ", at most " + Digits.significant(high, 2)
                    : ", at least " + Digits.significant(low, 2));
        }
        if (!(high > low)) {
            return "";
        }
        int decimals = Digits.decimals((high - low) / 2, 2);
        return decimals > 5 ? Digits.significant(low, 5) + " to " + Digits.significant(high, 5)
                : Digits.rounded(low, decimals) + " to " + Digits.rounded(high, decimals);
    }

    private Section portraits() {
        List<Block> blocks = new ArrayList<>();
        List<Chart> drawn = pictures.portraits().stream().map(PortraitChart::of).toList();
        for (int i = 0; i < drawn.size(); i += 2) {
            blocks.add(i + 1 < drawn.size() ? new Beside(drawn.get(i), drawn.get(i + 1)) : drawn.get(i));
        }
        String where = diagnosis.missing().isEmpty() ? "" : " Where a law was found, it is drawn over what was measured.";
        return new Section(diagnosis.missing().isEmpty() ? "What is missing" : "The missing physics",
                "What the place must do for model and recording to "
                        + "agree, worked out from the recording with no mechanism assumed." + where,
                blocks);
    }

    private Section values() {
        List<List<String>> rows = new ArrayList<>();
        for (Pictures.Value value : pictures.values()) {
            DisplayedNumber amount = DisplayedNumber.of(value.key());
            String unit = amount.unit().isEmpty() ? "" : " [" + amount.unit() + "]";
            List<String> row = new ArrayList<>(List.of(value.where(), amount.label() + unit,
                    Digits.significant(amount.factor() * value.given(), 4),
                    Digits.significant(amount.factor() * value.before(), 4)));
            if (pictures.completed()) {
                row.add(Digits.significant(amount.factor() * value.after(), 4));
            }
            row.add(value.within().map(interval -> range(interval, amount)).orElse(""));
            double change = 100 * (value.after() / value.given() - 1);
            row.add(value.given() == 0 ? "" : (change > 0 ? "+" : "") + Digits.significant(change, 2) + " %");
            rows.add(row);
        }
        List<Table.Column> columns = new ArrayList<>(List.of(Table.Column.words("Where"), Table.Column.words("Value"),
                Table.Column.numbers("Given"), Table.Column.numbers(pictures.completed() ? "Fitted alone" : "Fitted")));
        if (pictures.completed()) {
            columns.add(Table.Column.numbers("Completed"));
        }
        columns.add(Table.Column.numbers("95 %"));
        columns.add(Table.Column.numbers("Change"));
        boolean onlyRatios = pictures.views().stream().allMatch(view -> view.unit().equals("m/s²"));
        List<Block> blocks = new ArrayList<>(List.of(new Table("", columns, rows)));
        if (!diagnosis.fit().sensors().isEmpty()) {
            blocks.add(sensors());
        }
        return new Section("Values", "The model's own numbers: as they were given, and as they come out of the fit"
                + (pictures.completed() ? " without and with what was missing." : ".")
                + " The last lie in their interval with 95 %; what the recording tells only together, such as two offsets, "
                + "has a wide one each."
                + (onlyRatios ? " Accelerations know masses, stiffness and damping only up to a common factor, which all given masses set."
                        : ""),
                blocks);
    }

    /** A row for each sensor, a column for each kind of small error. */
    private Table sensors() {
        Map<String, Map<String, Double>> sensors = diagnosis.fit().sensors();
        List<String> keys = sensors.values().stream().flatMap(errors -> errors.keySet().stream()).distinct()
                .filter(key -> SENSOR_ERRORS.stream().anyMatch(key::startsWith)).toList();
        List<Table.Column> columns = new ArrayList<>(List.of(Table.Column.words("Sensor")));
        keys.forEach(key -> columns.add(Table.Column.numbers(head(key))));
        List<List<String>> rows = new ArrayList<>();
        sensors.forEach((sensor, errors) -> {
            List<String> row = new ArrayList<>(List.of(sensor));
            keys.forEach(key -> row.add(errors.containsKey(key) ? Digits.significant(shown(key, errors.get(key)), 2) : ""));
            rows.add(row);
        });
        return new Table(
                "Small errors of the sensors, as every sensor has them, found with the " + (pictures.completed() ? "completed" : "fitted")
                        + " model: a part of what it reads, how late it is, and by how much it is tilted and out of place",
                columns, rows);
    }

    private static String head(String key) {
        DisplayedNumber amount = DisplayedNumber.of(key);
        return key.equals(GAIN) ? "gain error [%]" : amount.label().replace("arm on", "arm, turning about") + " [" + amount.unit() + "]";
    }

    private static double shown(String key, double value) {
        return key.equals(GAIN) ? 100 * value : DisplayedNumber.of(key).factor() * value;
    }

    private Section rivals() {
        List<Block> blocks = new ArrayList<>();
        double before = diagnosis.fit().before();
        if (!diagnosis.alternatives().isEmpty()) {
            List<List<String>> rows = new ArrayList<>();
            diagnosis.missing().forEach(named -> rows.add(rival(named, before, "found")));
            diagnosis.alternatives().forEach(named -> rows.add(rival(named, before, "rival")));
            blocks.add(new Table("What each explains of the mismatch, on the data fitted",
                    List.of(Table.Column.words("Mechanism"), Table.Column.words("Where"), Table.Column.words("As"),
                            Table.Column.numbers("Explains"), Table.Column.numbers("χ² left"),
                            Table.Column.numbers("Probability")),
                    rows));
        }
        if (!diagnosis.latent().isEmpty()) {
            blocks.add(new Table("Places that could carry an arbitrary signal, best first: χ² falls to 1 only where it enters",
                    List.of(Table.Column.words("Place"), Table.Column.words("Kind"), Table.Column.numbers("χ² left")),
                    diagnosis.latent().stream().map(DiagnosisPage::place).toList()));
        }
        if (!diagnosis.nextExperiment().isBlank() && !diagnosis.alternatives().isEmpty()) {
            blocks.add(new Text("What would settle it: " + diagnosis.nextExperiment()));
        }
        return new Section("Rivals", "What else was tried, each refitted in full.", blocks);
    }

    private static List<String> place(Diagnosis.Latent place) {
        return List.of(place.where(), place.kind(), Digits.significant(place.reduced(), 3));
    }

    private static List<String> rival(Diagnosis.Named named, double before, String role) {
        return List.of(named.mechanism(), named.where(), role, percent(share(before, named.reduced())),
                Digits.significant(named.reduced(), 3),
                Digits.significant(named.probability(), 2));
    }
}
