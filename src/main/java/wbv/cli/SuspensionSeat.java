package wbv.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import wbv.control.SeatHardware;
import wbv.control.trial.Comparison;
import wbv.control.trial.ControllerFamily;
import wbv.control.trial.EarthMover;
import wbv.control.trial.Endurance;
import wbv.control.trial.Floor;
import wbv.control.trial.Recovery;
import wbv.control.trial.RoadFloor;
import wbv.control.trial.Sitters;
import wbv.recording.format.ReadOptions;
import wbv.recording.format.RecordingFile;
import wbv.report.seat.DampingPage;
import wbv.report.seat.SeatPage;
import wbv.result.OutputFolder;
import wbv.result.ResultsJson;
import wbv.rig.Subject;
import wbv.study.DampingTest;
import wbv.study.seat.SeatStudy;

/** {@code wbv seat}: controllers of a suspension seat compared at equal stroke. */
@Command(name = "seat", mixinStandardHelpOptions = true,
        description = "Simulates a suspension seat under a person of the virtual rig, with passive, skyhook and model-based controllers "
                + "that know the sitter not at all, by streaming estimators, or exactly, and compares them at equal stroke. Writes "
                + "report.html and seat.json. The SEAT value of a recorded ride: wbv exposure.",
        footer = {"", "Examples:", "  wbv seat --floor EM1 --mass 55 --out out",
            "  wbv seat --floor EM1,EM5,road:C:30 --sitters 4 --jolt 5 --out out",
            "  wbv seat --floor all --sitters 20 --out out", "  wbv seat --faults 100", "  wbv seat --recording shaker.csv --out out"})
final class SuspensionSeat implements Callable<Integer> {

    @Option(names = "--floor", paramLabel = "FLOOR", split = ",", defaultValue = "EM1",
            description = "what shakes the floor: EM1 to EM9 (earth-moving machines of ISO 7096), all of them, or road:CLASS:KM_PER_H "
                    + "with a class A to E of ISO 8608; several by commas (${DEFAULT-VALUE})")
    private List<String> floors = new ArrayList<>();

    @Option(names = "--sitters", paramLabel = "N",
            description = "let so many ride: drivers of 55 to 110 kg, soft and stiff, first, then the rig's population (1)")
    private Optional<Integer> sitters = Optional.empty();

    @Option(names = "--mass", paramLabel = "KG", description = "let one person of this mass ride, average in all else")
    private Optional<Double> mass = Optional.empty();

    @Option(names = "--controller", paramLabel = "NAME", split = ",",
            description = "passive, skyhook, skyhook-on-off, clipped-lqg, active-lqg or active-h-infinity; several by commas (all)")
    private List<String> controllers = new ArrayList<>();

    @Option(names = "--jolt", paramLabel = "M_PER_S2", defaultValue = "0", description = "height of a jolt every 10 s (${DEFAULT-VALUE})")
    private double jolt;

    @Option(names = "--seconds", paramLabel = "S", defaultValue = "24", description = "judged length of each ride (${DEFAULT-VALUE})")
    private double seconds;

    @Mixin
    private CommonOptions.Seed seed;

    @Option(names = "--faults", paramLabel = "N",
            description = "instead: N rides with lost readings, silent sensors, delays, wrong estimates and changes of "
                    + "sitter; prints what became of them, writes nothing")
    private Optional<Integer> faults = Optional.empty();

    @Option(names = "--recording", paramLabel = "FILE",
            description = "instead: resonance, transmissibility there, damping ratio and SEAT of a passive seat on a "
                    + "shaker, from a recording of floor (platform.acc.z) and seat (seat.acc.z)")
    private Optional<Path> recording = Optional.empty();

    @Mixin
    private ResultFolder out;

    @Mixin
    private Answer answer;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        if (faults.isPresent()) {
            return endure(faults.get());
        }
        if (recording.isPresent()) {
            return test(recording.get());
        }
        Comparison.Request request = request();
        Map<String, String> provenance = new ResultProvenance(spec).entries();
        try (OutputFolder folder = out.open(); ProgressBar bar = answer.progress()) {
            SeatStudy study = SeatStudy.run(request, provenance, folder, share -> bar.at("riding", share));
            SeatPage.write(study, provenance, folder);
            folder.publish();
            bar.close();
            answer.print(study.summary(), "Wrote " + out.file("report.html") + ", seat.json\n", () -> ResultsJson.render(study.results()));
        }
        return 0;
    }

    private int test(Path file) throws IOException {
        Map<String, String> provenance = new ResultProvenance(spec).entries();
        String title = file.getFileName().toString();
        try (OutputFolder folder = out.open()) {
            DampingTest test = DampingTest.run(new RecordingFile(file, ReadOptions.DEFAULT), title, provenance, folder);
            DampingPage.write(test, title, provenance, folder);
            folder.publish();
            answer.print(test.summary(), "Wrote " + out.file("report.html") + ", seat.json\n", () -> ResultsJson.render(test));
        }
        return 0;
    }

    private int endure(int rides) throws IOException {
        if (rides < 1 || rides > 100_000) {
            throw wrong("--faults must be 1 to 100000 rides: " + rides);
        }
        StringBuilder text = new StringBuilder();
        Endured endured;
        try (ProgressBar bar = answer.progress()) {
            Endurance endurance = Endurance.run(SeatHardware.ASSUMED, rides, seed.number(), share -> bar.at("riding", 0.9 * share));
            text.append(String.format(Locale.ROOT, "%-64s %6s %9s %28s %7s%n", "fault, controller (simulated)", "rides", "unstable",
                    "over 1.25 times a passive",
                    "worst"));
            endurance.cases().forEach(
                    (fault, one) -> text.append(String.format(Locale.ROOT, "%-64s %6d %9d %28d %7.2f%n", fault, one.rides(), one.unstable(),
                            one.worse(), one.worst())));
            text.append(String.format(
                    "A sitter of 75 kg becomes one of 55 kg: back to within 5 %% of a ride with the latter alone after, and from 10 s "
                            + "on%n"));
            endured = new Endured(endurance,
                    Endurance.recover(SeatHardware.ASSUMED, seed.number(), share -> bar.at("riding", 0.9 + 0.1 * share)));
            for (Recovery each : endured.recoveries()) {
                text.append(String.format(Locale.ROOT, "  %-4s %-18s %5.1f s %7.3f%n", each.floor().word(), each.family().word(),
                        each.seconds(),
                        each.later()));
            }
        }
        answer.print(text.toString().replace(System.lineSeparator(), "\n"), "", () -> ResultsJson.render(endured));
        return 0;
    }

    /** What became of rides under faults, and after changes of the sitter. */
    record Endured(Endurance faults, List<Recovery> recoveries) {}

    private Comparison.Request request() {
        if (sitters.isPresent() && mass.isPresent()) {
            throw wrong("--sitters and --mass each say who rides: give one of them");
        }
        if (!(seconds >= 5 && seconds <= 600)) {
            throw wrong("--seconds must be 5 to 600: " + seconds);
        }
        if (!(jolt >= 0 && jolt <= 50)) {
            throw wrong("--jolt must be 0 to 50 m/s²: " + jolt);
        }
        return new Comparison.Request(SeatHardware.ASSUMED, floors.stream().flatMap(word -> floors(word).stream()).toList(), people(),
                families(), jolt, 6, seconds, seed.number());
    }

    private List<Subject> people() {
        if (mass.isPresent()) {
            try {
                return List.of(Sitters.ofMass(mass.get()));
            } catch (IllegalArgumentException e) {
                throw wrong("--mass: " + e.getMessage());
            }
        }
        int count = sitters.orElse(1);
        if (count < 1 || count > 1000) {
            throw wrong("--sitters must be 1 to 1000: " + count);
        }
        return Sitters.first(count);
    }

    private List<ControllerFamily> families() {
        return controllers.isEmpty() ? List.of(ControllerFamily.values()) : controllers.stream().map(word -> ControllerFamily.named(word)
                .orElseThrow(() -> wrong("--controller is one of " + String.join(", ", ControllerFamily.words()) + ": " + word))).toList();
    }

    private List<Floor> floors(String word) {
        if (word.equals("all")) {
            return List.of(EarthMover.values());
        }
        Optional<EarthMover> mover = Arrays.stream(EarthMover.values()).filter(each -> each.word().equalsIgnoreCase(word)).findFirst();
        if (mover.isPresent()) {
            return List.of(mover.get());
        }
        try {
            if (word.matches("road:[A-E]:[0-9]+(\\.[0-9]+)?")) {
                return List.of(new RoadFloor(word.charAt(5), Double.parseDouble(word.substring(7))));
            }
        } catch (IllegalArgumentException e) {
            throw wrong("--floor " + word + ": " + e.getMessage());
        }
        throw wrong("--floor is EM1 to EM9, all, or road:CLASS:KM_PER_H with a class A to E: " + word);
    }

    private ParameterException wrong(String message) {
        return new ParameterException(spec.commandLine(), message);
    }
}
