package wbv.study;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.stream.Collectors;
import wbv.exposure.CautionZone;
import wbv.exposure.DailyExposure;
import wbv.exposure.DailyTask;
import wbv.exposure.Directive;
import wbv.exposure.Remark;
import wbv.exposure.SeatAxis;
import wbv.exposure.SeatMeasurement;
import wbv.exposure.SeatMeter;
import wbv.exposure.SpinalDose;
import wbv.exposure.SpinalRisk;
import wbv.recording.DataFault;
import wbv.recording.inspect.Severity;
import wbv.result.Digits;
import wbv.result.OutputFolder;
import wbv.result.ResultsJson;

/** The exposure of a day: every task's recording measured, added up, judged, and written for machines. */
public final class ExposureStudy {

    private static final double EIGHT_HOURS = 480;

    private final ExposureRequest request;
    private final List<SeatMeasurement> measured;
    private final DailyExposure day;
    private final boolean assumed;

    private ExposureStudy(ExposureRequest request, List<SeatMeasurement> measured) {
        this.request = request;
        this.measured = List.copyOf(measured);
        List<DailyTask> tasks = new ArrayList<>();
        boolean unsaid = false;
        for (int i = 0; i < measured.size(); i++) {
            ExposureRequest.Recorded recorded = request.recordings().get(i);
            SeatMeasurement one = measured.get(i);
            double minutes = recorded.minutes().orElse(one.metadata().dailyMinutes().orElse(Double.NaN));
            if (Double.isNaN(minutes)) {
                if (measured.size() > 1) {
                    throw DataFault.in(recorded.title(),
                            "how many minutes a day it stands for is not known; say --task NAME=MINUTES for every"
                                    + " recording in turn, or daily_minutes in its sidecar");
                }
                minutes = EIGHT_HOURS;
                unsaid = true;
            }
            tasks.add(one.task(recorded.task().or(() -> one.metadata().task()).orElse(recorded.title()), minutes));
        }
        assumed = unsaid;
        day = new DailyExposure(tasks);
    }

    /**
     * Evaluates and writes {@code exposure.json} and {@code exposure.csv}.
     *
     * @param progress told the step and the share of it that is done, 0 to 1 or NaN
     * @throws DataFault if a recording cannot be evaluated, or the tasks do not fit into a day
     */
    public static ExposureStudy run(ExposureRequest request, OutputFolder out, BiConsumer<String, Double> progress)
            throws IOException {
        List<SeatMeasurement> measured = new ArrayList<>();
        for (ExposureRequest.Recorded recorded : request.recordings()) {
            measured.add(SeatMeter.measure(recorded.source(), request.setup(),
                    share -> progress.accept("measuring " + recorded.title(), share)));
        }
        ExposureStudy exposure = new ExposureStudy(request, measured);
        ResultsJson.write(exposure.results(), out.file("exposure.json"));
        ExposureTable.write(exposure, out.file("exposure.csv"));
        return exposure;
    }

    /** What is written for machines. */
    public ExposureResults results() {
        return ExposureResults.of(this);
    }

    /** What matters most, in a few lines of text. */
    public String summary() {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < measured.size(); i++) {
            SeatMeasurement one = measured.get(i);
            DailyTask task = day.tasks().get(i);
            text.append(String.format(Locale.ROOT, "%s: %s, %.1f s at %.4g Hz, %.4g min a day%s%n", task.name(), one.place(),
                    one.inspection().duration(), one.inspection().clock().rate(), task.minutes(), assumed ? " (assumed)" : ""));
            one.axes().forEach((axis, vibration) -> text.append(String.format(Locale.ROOT,
                    "  %s %s  a_w %.3f m/s², k a_w %.3f, crest %.1f, MTVV %.3f, VDV %.2f m/s^1.75%s%n", axis.letter(),
                    axis.weighting().symbol(), vibration.rms(), axis.factor() * vibration.rms(), vibration.crestFactor(),
                    vibration.mtvv(),
                    vibration.vdv(), one.seatFactor(axis).isPresent()
                            ? String.format(Locale.ROOT, ", SEAT %.2f", one.seatFactor(axis).getAsDouble()) : "")));
        }
        for (Remark remark : remarks()) {
            if (remark.severity() != Severity.NOTE) {
                text.append("  ").append(remark.severity()).append(": ").append(remark.message()).append('\n');
            }
        }
        return text.append(sentence(" m/s^1.75")).append('\n').toString();
    }

    /**
     * The verdict in a sentence or two.
     *
     * @param doseUnit what follows the number of a dose
     */
    public String sentence(String doseUnit) {
        return String.format(Locale.ROOT,
                "A(8) is %.2f m/s² along %s: %s (%.0f points). The daily dose is %s%s along %s: %s.%s",
                day.a8(), day.worstA8().letter(), day.verdict().words(), day.points(), Digits.significant(day.vdv(), 3), doseUnit,
                day.worstVdv().letter(), day.verdictByDose().words(), unmeasured());
    }

    /** What the verdict leaves open because an axis was not measured in every task. */
    private String unmeasured() {
        String absent = Arrays.stream(SeatAxis.values())
                .filter(axis -> measured.stream().anyMatch(one -> !one.axes().containsKey(axis)))
                .map(axis -> String.valueOf(axis.letter())).collect(Collectors.joining(" and "));
        return absent.isEmpty() || day.verdict() == Directive.Verdict.ABOVE_LIMIT ? ""
                : " Not measured along " + absent + ": the whole may be higher.";
    }

    /** What was asked. */
    public ExposureRequest request() {
        return request;
    }

    /** By task. */
    public List<SeatMeasurement> measured() {
        return measured;
    }

    /** The tasks added up. */
    public DailyExposure day() {
        return day;
    }

    /** Where the day lies by Eq. B.1. */
    public CautionZone zone() {
        return CautionZone.ofA8(day.a8());
    }

    /** Where the day lies by Eq. B.2, with the dose measured. */
    public CautionZone zoneByDose() {
        return CautionZone.ofDose(day.vdv());
    }

    /** Daily dose of the spine, over the tasks measured vertically; empty where none was. */
    public Optional<Double> spinalDose() {
        double[] doses = new double[measured.size()];
        boolean any = false;
        for (int i = 0; i < doses.length; i++) {
            Optional<SeatMeasurement.Spine> spine = measured.get(i).spine();
            if (spine.isPresent()) {
                any = true;
                doses[i] = SpinalDose.daily(spine.get().dose(), 60 * day.tasks().get(i).minutes(), spine.get().seconds());
            }
        }
        return any ? Optional.of(SpinalDose.together(doses)) : Optional.empty();
    }

    /** Risks for the sitter's sex, or for both where it is not known. */
    public Map<SpinalRisk.Sex, SpinalRisk> risks() {
        Optional<String> known = measured.get(0).metadata().subject().flatMap(subject -> subject.sex());
        Map<SpinalRisk.Sex, SpinalRisk> risks = new EnumMap<>(SpinalRisk.Sex.class);
        for (SpinalRisk.Sex sex : SpinalRisk.Sex.values()) {
            if (known.isEmpty() || known.get().equalsIgnoreCase(sex.name())) {
                risks.put(sex, new SpinalRisk(sex, request.career().from(), request.career().years(), request.career().days()));
            }
        }
        return risks;
    }

    /** What the reader has to know, of all tasks, gravest first. */
    public List<Remark> remarks() {
        List<Remark> all = new ArrayList<>();
        if (assumed) {
            all.add(new Remark(Severity.WARNING, "no daily duration was given: 8 h are assumed",
                    "say it by --task NAME=MINUTES or as daily_minutes in the sidecar"));
        }
        Map<Remark, List<String>> whose = new LinkedHashMap<>();
        for (int i = 0; i < measured.size(); i++) {
            for (Remark remark : measured.get(i).remarks()) {
                whose.computeIfAbsent(remark, each -> new ArrayList<>()).add(day.tasks().get(i).name());
            }
        }
        whose.forEach((remark, tasks) -> all.add(tasks.size() == measured.size() ? remark
                : new Remark(remark.severity(), String.join("; ", tasks) + ": " + remark.message(), remark.advice())));
        all.sort(Comparator.comparing(Remark::severity).reversed());
        return all;
    }

    /** The task that adds most to A(8) along the worst axis. */
    public int heaviest() {
        int heaviest = 0;
        for (int i = 1; i < measured.size(); i++) {
            SeatAxis axis = day.worstA8();
            heaviest = day.tasks().get(i).a8(axis) > day.tasks().get(heaviest).a8(axis) ? i : heaviest;
        }
        return heaviest;
    }

    /** Minutes [min] in words: up to a day. */
    public static String minutes(double minutes) {
        return Double.isNaN(minutes) ? "–" : minutes > DailyTask.DAY ? "over 24 h" : minutes > 0 && minutes < 1 ? "< 1 min"
                : String.format(Locale.ROOT, "%d:%02d", Math.round(minutes) / 60, Math.round(minutes) % 60);
    }
}
