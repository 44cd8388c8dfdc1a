package wbv.study;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import wbv.exposure.DailyExposure;
import wbv.exposure.SeatAxis;
import wbv.recording.AtomicFile;
import wbv.recording.TableText;

/** An exposure as {@code exposure.csv}: a row for each task and axis, then a row for each axis of the day. */
final class ExposureTable {

    private static final List<String> HEADER = List.of("task", "minutes", "axis", "weighting", "k", "band_to_hz", "measured_s",
            "a_w_m_s2", "k_a_w_m_s2", "crest_factor", "mtvv_m_s2", "vdv_measured_m_s1_75", "a8_m_s2", "points",
            "vdv_daily_m_s1_75", "seat_rms",
            "seat_vdv");
    private static final String DAY = "all";

    private ExposureTable() {}

    static void write(ExposureStudy exposure, Path file) throws IOException {
        StringBuilder text = new StringBuilder();
        exposure.request().provenance().forEach((name, value) -> text.append("# ").append(TableText.comment(name + ": " + value))
                .append('\n'));
        text.append(String.join(",", HEADER)).append('\n');
        ExposureResults results = exposure.results();
        for (ExposureResults.Task task : results.tasks()) {
            for (Map.Entry<String, ExposureResults.TaskAxis> entry : task.axes().entrySet()) {
                ExposureResults.TaskAxis axis = entry.getValue();
                row(text, List.of(TableText.cell(task.name()), task.minutes(), entry.getKey(), axis.weighting(), axis.k(),
                        axis.band_to_hz(),
                        axis.measured_s(), axis.a_w_m_s2(), axis.k_a_w_m_s2(), axis.crest_factor(), axis.mtvv_m_s2(),
                        axis.vdv_measured_m_s1_75(), axis.partial_a8_m_s2(), axis.partial_points(), axis.daily_vdv_m_s1_75(),
                        axis.seat_rms().orElse(Double.NaN), axis.seat_vdv().orElse(Double.NaN)));
            }
        }
        DailyExposure day = exposure.day();
        results.day().axes().forEach((letter, axis) -> {
            SeatAxis of = SeatAxis.valueOf(letter.toUpperCase(Locale.ROOT));
            List<Object> cells = new ArrayList<>(List.of(DAY, day.minutes(), letter, of.weighting().symbol(), of.factor()));
            for (int i = cells.size(); i < HEADER.size(); i++) {
                cells.add(Double.NaN);
            }
            cells.set(HEADER.indexOf("a8_m_s2"), axis.a8_m_s2());
            cells.set(HEADER.indexOf("points"), axis.points());
            cells.set(HEADER.indexOf("vdv_daily_m_s1_75"), axis.vdv_m_s1_75());
            row(text, cells);
        });
        AtomicFile.write(file, text.toString().getBytes(StandardCharsets.UTF_8));
    }

    private static void row(StringBuilder text, List<?> cells) {
        text.append(cells.stream().map(cell -> cell instanceof Double number && !Double.isFinite(number) ? "" : cell.toString())
                .collect(Collectors.joining(","))).append('\n');
    }
}
