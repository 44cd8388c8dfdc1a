package wbv.cli;

import java.io.IOException;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import wbv.exposure.SeatAxis;
import wbv.exposure.SeatMeter;
import wbv.exposure.SpinalRisk;
import wbv.recording.inspect.RowSource;
import wbv.report.exposure.ExposurePage;
import wbv.result.OutputFolder;
import wbv.result.ResultsJson;
import wbv.study.ExposureRequest;
import wbv.study.ExposureStudy;
import wbv.study.TypedExposure;

/** {@code wbv exposure}: a day's vibration against the values of the Directive. */
@Command(name = "exposure", mixinStandardHelpOptions = true, modelTransformer = Exposure.WithoutRecording.class,
        description = "Evaluates a day's exposure to whole-body vibration: weighted r.m.s., dose, A(8), action and limit value, "
                + "comfort, shocks. Every RECORDING is one task. Writes report.html (one page when printed), exposure.json and "
                + "exposure.csv. Without a RECORDING, of magnitudes and hours that are typed in: prints A(8), points and the time to "
                + "action and limit value.",
        footer = {"", "Examples:", "  wbv exposure data/arff/ride-subject1.arff --task 'haul road=380' --boxcar",
            "  wbv exposure loaded.csv empty.csv --task loaded=240 --task empty=200",
            "  wbv exposure car.csv --map data/maps/wobble.json --seat axle_pass",
            "  wbv exposure --magnitude x=0.3,z=0.7 --hours 4 --magnitude z=1.2 --hours 0.5"})
final class Exposure implements Callable<Integer> {

    /** More than anybody sits on [m/s²]; a larger number is in another unit. */
    private static final double MOST = 100;

    @Mixin
    private RecordingOptions recording;

    @Option(names = "--task", paramLabel = "NAME=MINUTES",
            description = "name and daily minutes of the task; one for each recording, in their order (sidecar's task and daily_minutes)")
    private List<String> tasks = new ArrayList<>();

    @Option(names = "--magnitude", paramLabel = "AXIS=M_PER_S2",
            description = "without a recording: weighted r.m.s. acceleration along x, y or z without the factor k (a declared value that "
                    + "has its factor is z); several axes by commas, once for each spell")
    private List<String> magnitudes = new ArrayList<>();

    @Option(names = "--hours", paramLabel = "H", description = "hours a day of the spell; once for each --magnitude")
    private List<Double> hours = new ArrayList<>();

    @Mixin
    private CommonOptions.Contact contact;

    @Option(names = "--base", paramLabel = "PLACE", description = "below the seat, for its SEAT value (platform or floor)")
    private Optional<String> base = Optional.empty();

    @Mixin
    private CommonOptions.Sampling sampling;

    @Option(names = "--from-age", paramLabel = "YEARS", defaultValue = "20",
            description = "age at which daily exposure began, for the spine (${DEFAULT-VALUE}, assumed)")
    private int fromAge;

    @Option(names = "--years", paramLabel = "N", defaultValue = "20", description = "years of it (${DEFAULT-VALUE}, assumed)")
    private int years;

    @Option(names = "--days-a-year", paramLabel = "N", defaultValue = "240",
            description = "days a year (${DEFAULT-VALUE}, assumed)")
    private double days;

    @Mixin
    private ResultFolder out;

    @Mixin
    private Answer answer;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        if (!magnitudes.isEmpty() || !hours.isEmpty()) {
            return typed();
        }
        if (recording.names().isEmpty()) {
            throw wrong("name a RECORDING, or say what the vibration is: --magnitude z=0.7 --hours 4");
        }
        ExposureRequest request = new ExposureRequest(recordings(), new SeatMeter.Setup(contact.seat(),
                base.map(name -> Usage.place(spec, "--base", name)), sampling.boxcar()), career(),
                new ResultProvenance(spec).of(recording.inputs()).entries());
        try (OutputFolder folder = out.open(); ProgressBar bar = answer.progress()) {
            ExposureStudy exposure = ExposureStudy.run(request, folder, bar::at);
            ExposurePage.write(exposure, folder);
            folder.publish();
            bar.close();
            answer.print(exposure.summary(), "Wrote " + out.file("report.html") + ", exposure.json, exposure.csv\n",
                    () -> ResultsJson.render(exposure.results()));
        }
        return 0;
    }

    /** A RECORDING is not needed where magnitudes are typed in. */
    static final class WithoutRecording implements CommandLine.IModelTransformer {
        @Override
        public CommandSpec transform(CommandSpec spec) {
            PositionalParamSpec needed = spec.positionalParameters().get(0);
            spec.remove(needed);
            return spec.add(PositionalParamSpec.builder().paramLabel(needed.paramLabel()).index("0..*").arity("0..*")
                    .description(needed.description())
                    .type(needed.type()).auxiliaryTypes(needed.auxiliaryTypes()).getter(needed.getter()).setter(needed.setter())
                    .hasInitialValue(false).build());
        }
    }

    private int typed() throws IOException {
        List<String> foreign = spec.commandLine().getParseResult().matchedArgs().stream().filter(each -> !(each instanceof OptionSpec option
                && List.of("--magnitude", "--hours", "--json", "--quiet").contains(option.longestName())))
                .map(each -> each instanceof OptionSpec option
                        ? option.longestName() : each.paramLabel())
                .toList();
        if (!foreign.isEmpty()) {
            throw wrong("--magnitude and --hours stand for a recording, and nothing is written: leave out " + String.join(", ", foreign));
        }
        TypedExposure exposure = TypedExposure.of(spells());
        answer.print(exposure.summary(), "", () -> ResultsJson.render(exposure.results()));
        return 0;
    }

    /** One spell where there is one number of hours, else a spell for each magnitude. */
    private List<TypedExposure.Spell> spells() {
        if (magnitudes.isEmpty() || hours.size() != 1 && hours.size() != magnitudes.size()) {
            throw wrong("--hours must be given once for each --magnitude: " + hours.size() + " for " + magnitudes.size());
        }
        hours.stream().filter(h -> !(h > 0 && h <= 24)).findFirst().ifPresent(h -> {
            throw wrong("--hours must be more than 0 and at most 24: " + h);
        });
        List<TypedExposure.Spell> spells = new ArrayList<>();
        for (int i = 0; i < hours.size(); i++) {
            Map<SeatAxis, Double> levels = new EnumMap<>(SeatAxis.class);
            for (String each : String.join(",", hours.size() == 1 ? magnitudes : List.of(magnitudes.get(i))).split(",")) {
                level(each.strip(), levels);
            }
            spells.add(new TypedExposure.Spell(levels, hours.get(i)));
        }
        return spells;
    }

    private void level(String words, Map<SeatAxis, Double> levels) {
        if (words.matches("[xyz]=([0-9]+\\.?[0-9]*|\\.[0-9]+)")) {
            double value = Double.parseDouble(words.substring(2));
            SeatAxis axis = SeatAxis.valueOf(words.substring(0, 1).toUpperCase(Locale.ROOT));
            if (value <= MOST && levels.putIfAbsent(axis, value) == null) {
                return;
            }
        }
        throw wrong(
                "--magnitude must be AXIS=M_PER_S2, each of x, y and z once and at most " + MOST + " m/s², as in x=0.3,z=0.7: " + words);
    }

    private List<ExposureRequest.Recorded> recordings() throws IOException {
        List<RowSource> sources = recording.each();
        if (!tasks.isEmpty() && tasks.size() != sources.size()) {
            throw wrong("--task must be given once for each recording, or not at all: " + tasks.size() + " for " + sources.size()
                    + " recordings");
        }
        List<ExposureRequest.Recorded> recorded = new ArrayList<>();
        for (int i = 0; i < sources.size(); i++) {
            String title = recording.title(i);
            recorded.add(tasks.isEmpty() ? new ExposureRequest.Recorded(sources.get(i), title, Optional.empty(),
                    OptionalDouble.empty())
                    : task(sources.get(i), title, tasks.get(i)));
        }
        return recorded;
    }

    private ExposureRequest.Recorded task(RowSource source, String title, String words) {
        int equals = words.lastIndexOf('=');
        try {
            double minutes = Double.parseDouble(words.substring(equals + 1));
            if (equals > 0 && minutes >= 0 && minutes <= 1440) {
                return new ExposureRequest.Recorded(source, title, Optional.of(words.substring(0, equals).strip()),
                        OptionalDouble.of(minutes));
            }
        } catch (NumberFormatException notNumber) {
            // told below
        }
        throw wrong("--task must be NAME=MINUTES with 0 to 1440 minutes a day: " + words);
    }

    private ExposureRequest.Career career() {
        try {
            SpinalRisk checked = new SpinalRisk(SpinalRisk.Sex.MALE, fromAge, years, days);
            return new ExposureRequest.Career(checked.startAge(), checked.years(), checked.days());
        } catch (IllegalArgumentException e) {
            throw wrong("--from-age, --years, --days-a-year: " + e.getMessage());
        }
    }

    private ParameterException wrong(String message) {
        return new ParameterException(spec.commandLine(), message);
    }
}
