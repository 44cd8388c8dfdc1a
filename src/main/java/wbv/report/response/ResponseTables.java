package wbv.report.response;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import wbv.recording.Channel;
import wbv.report.page.Table;
import wbv.result.Digits;
import wbv.signal.Peak;
import wbv.signal.SubjectMean;
import wbv.study.ResponseAnalysis;
import wbv.study.ResponseCurve;

/** The tables of a report on frequency responses. */
final class ResponseTables {

    private final ResponseAnalysis analysis;
    private final List<ResponseCurve> curves;

    ResponseTables(ResponseAnalysis analysis) {
        this.analysis = analysis;
        this.curves = analysis.curves();
    }

    /** The cross-axis matrix: a row for each output, a column for each input. */
    Table matrix() {
        List<Table.Column> columns = new ArrayList<>(List.of(Table.Column.words("Highest usable |H1|")));
        analysis.measured().inputs().forEach(input -> columns.add(Table.Column.numbers("from " + input)));
        List<List<String>> rows = new ArrayList<>();
        for (Channel output : analysis.measured().outputs()) {
            List<String> row = new ArrayList<>(List.of(output.toString()));
            curves.stream().filter(curve -> curve.output().equals(output)).forEach(curve -> row.add(cell(curve)));
            rows.add(row);
        }
        return new Table("Cross-axis matrix: the answer to each input alone, the others held still", columns, rows);
    }

    private static String cell(ResponseCurve curve) {
        Peak highest = curve.highest();
        return Double.isNaN(highest.height()) ? "–" : height(curve, 2) + " at " + Digits.significant(highest.frequency(), 2)
                + " Hz";
    }

    private static String height(ResponseCurve curve, int digits) {
        return Digits.significant(curve.highest().height(), digits) + " ± " + Digits.significant(curve.highestMargin(),
                digits - 1);
    }

    /**
     * Every response with what it is worth.
     *
     * @param percent the level of the intervals, in words
     */
    Table responses(String percent) {
        List<List<String>> rows = new ArrayList<>();
        for (ResponseCurve curve : curves) {
            double[] band = curve.usableBand();
            boolean usable = Double.isFinite(band[0]);
            String at = Digits.significant(curve.highest().frequency(), 3) + (usable && curve.peak().isEmpty() ? " (end)" : "");
            rows.add(List.of(curve.name(), usable ? height(curve, 3) : "–", curve.unit(), at,
                    usable ? Digits.significant(band[0], 2) + " to " + Digits.significant(band[1], 3) : "–",
                    Digits.significant(curve.typical(curve.all().multipleCoherence(0)), 3),
                    Digits.significant(curve.typical(curve.all().partialCoherence(0, curve.index())), 3),
                    curve.misfit().map(ResponseTables::misfit).orElse("–")));
        }
        return new Table("Every response, with " + percent + " intervals. (end): the highest value stands at the end of what is "
                + "usable. Coherences are medians over the usable frequencies",
                List.of(Table.Column.words("Response"),
                        Table.Column.numbers("Highest |H1|"), Table.Column.words("Unit"), Table.Column.numbers("at [Hz]"),
                        Table.Column.numbers("Usable [Hz]"), Table.Column.numbers("Multiple γ²"), Table.Column.numbers("Partial γ²"),
                        Table.Column.numbers("Model off by")),
                rows);
    }

    private static String misfit(ResponseCurve.Misfit misfit) {
        return Digits.significant(100 * misfit.relative(), 3) + " %; " + Digits.significant(100 * misfit.inside(), 2)
                + " % in the band";
    }

    /** Peaks by person, and their mean. */
    Table people() {
        List<List<String>> rows = new ArrayList<>();
        for (int c = 0; c < curves.size(); c++) {
            String name = curves.get(c).name();
            for (Map.Entry<String, ResponseCurve> person : analysis.people(c).entrySet()) {
                ResponseCurve own = person.getValue();
                rows.add(List.of(name, person.getKey(), Digits.significant(own.highest().frequency(), 3),
                        Digits.significant(own.highest().height(), 3), own.peak().isPresent() ? "" : "no peak inside: left out"));
            }
            analysis.mean(c).ifPresent(mean -> rows.add(List.of(name, "mean of " + mean.people(),
                    withDeviation(mean, Peak::frequency), withDeviation(mean, Peak::height), "")));
        }
        return new Table("Peaks by person; the mean with the standard deviation over people",
                List.of(Table.Column.words("Response"),
                        Table.Column.words("Recording"), Table.Column.numbers("Peak [Hz]"), Table.Column.numbers("Height"),
                        Table.Column.words("Remark")),
                rows);
    }

    private static String withDeviation(SubjectMean mean, Function<Peak, Double> of) {
        return Digits.significant(of.apply(mean.peak()), 3) + " ± " + Digits.significant(of.apply(mean.peakDeviation()), 2);
    }
}
