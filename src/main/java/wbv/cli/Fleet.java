package wbv.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import wbv.filter.Method;
import wbv.fleet.FleetEngine;
import wbv.fleet.FleetOrder;
import wbv.fleet.FleetRun;
import wbv.fleet.Replay;
import wbv.fleet.SeatOrder;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.recording.RowSource;
import wbv.seat.SeatPlan;
import wbv.seat.SeatResult;
import wbv.state.StateModel;
import wbv.state.StateModelFile;

/** {@code wbv fleet}: many seats at once. */
@Command(name = "fleet", mixinStandardHelpOptions = true,
        description = "Follows many seats at once: recordings are replayed as the packets of so many seats, each from a place of its own "
                + "in the ride. Writes results.csv and alarms.csv. A run that was killed goes on where it stood when the same "
                + "command is given again; its files come out as if nothing had happened.",
        footer = {"", "Examples:", "  wbv fleet data/arff/ride-subject1.arff --seats 10000 --out out",
            "  wbv fleet data/arff/ride-subject1.arff --seats 200 --disturb 1 --out out"})
final class Fleet implements Callable<Integer> {

    private static final int MOST_SEATS = 1_000_000;
    private static final int WORST = 10;

    @Mixin
    private RecordingOptions recording;

    @Option(names = "--seats", paramLabel = "N", defaultValue = "1000", description = "how many (${DEFAULT-VALUE})")
    private int seats;

    @Option(names = "--packet", paramLabel = "SAMPLES", description = "samples that are sent together (those of one second)")
    private Optional<Integer> packet = Optional.empty();

    @Option(names = "--every", paramLabel = "SECONDS", defaultValue = "10", description = "time between results of a seat (${DEFAULT-VALUE})")
    private double every;

    @Option(names = "--estimator", paramLabel = "NAME", defaultValue = "ekf-adwin",
            description = "ekf, ekf-adwin, ukf, particle, constrained or fused (${DEFAULT-VALUE})")
    private String estimator;

    @Option(names = "--boxcar", description = "samples are means over the sampling period (Xsens MTw, DOT): undo their droop")
    private boolean boxcar;

    @Option(names = "--model", paramLabel = "FILE", description = "model of states (the one that ships, where packets have its channels)")
    private Optional<Path> model = Optional.empty();

    @Option(names = "--disturb", paramLabel = "SEED",
            description = "simulate a bad network: packets shuffled within two seconds, 1%% twice, 1%% lost, drawn by this seed")
    private Optional<Long> disturb = Optional.empty();

    @Option(names = "--threads", paramLabel = "N", description = "threads (one for each core); results do not depend on it")
    private Optional<Integer> threads = Optional.empty();

    @Option(names = "--keep", paramLabel = "SECONDS", defaultValue = "10",
            description = "time between two times that the state of all seats is kept in DIR (${DEFAULT-VALUE}); 0: after every packet")
    private double keep;

    @Option(names = "--local", paramLabel = "N", description = "start a cluster of Apache Flink on this computer with so many workers, and "
            + "follow the seats on it; the results are the same")
    private Optional<Integer> local = Optional.empty();

    @Option(names = "--cluster", paramLabel = "HOST:PORT", description = "follow the seats on a cluster of Apache Flink that is there, by "
            + "its REST port; all of its machines must see DIR under the same name")
    private Optional<String> cluster = Optional.empty();

    @Option(names = "--out", paramLabel = "DIR", defaultValue = "out", description = "folder for the results (${DEFAULT-VALUE})")
    private Path out;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        List<Recording> recordings = new ArrayList<>();
        for (RowSource source : recording.each()) {
            recordings.add(source.load());
        }
        double rate = recordings.get(0).clock().rate();
        List<Channel> common = new ArrayList<>(recordings.get(0).channels());
        recordings.forEach(each -> common.retainAll(each.channels()));
        Method method = Method.named(estimator).orElseThrow(() -> wrong("--estimator must be one of " + String.join(", ",
                Method.words()) + ": " + estimator));
        Optional<StateModel> states = Optional.of(model.isPresent() ? StateModelFile.read(model.get()) : StateModelFile.shipped());
        int interval = (int) Math.max(1, Math.round(checked("--every", every, 1e-3, 86_400) * rate));
        List<Channel> needed = SeatPlan.usual(rate, common, method, boxcar, states, interval).needed();
        SeatPlan plan = SeatPlan.usual(rate, needed, method, boxcar, states, interval);
        if (model.isPresent() && plan.states().isEmpty()) {
            throw new DataFault(model.get() + ": its channels " + states.get().features().channels() + " at "
                    + states.get().features().rate() + " Hz are not those of the recordings");
        }
        int size = packet.orElse((int) Math.max(1, Math.round(rate)));
        FleetOrder order = new FleetOrder(recordings, new SeatOrder(rate, needed, method, boxcar, plan.states(), interval),
                (int) checked("--seats", seats, 1, MOST_SEATS), (int) checked("--packet", size, 1, 8192), disturb);
        Replay replay = order.replay();
        if (local.isPresent() || cluster.isPresent()) {
            return onMachines(order);
        }
        int cores = threads.orElse(Runtime.getRuntime().availableProcessors());
        FleetRun run = new FleetRun(replay, plan, out, (int) checked("--threads", cores, 1, 1024), checked("--keep", keep, 0, 86_400));
        try (ProgressBar bar = new ProgressBar()) {
            FleetRun.Outcome outcome = run.run(share -> bar.at("following seats", share));
            bar.close();
            spec.commandLine().getOut().print(summary(outcome, rate) + "Wrote " + out.resolve("results.csv") + ", alarms.csv\n");
            spec.commandLine().getOut().flush();
        }
        return 0;
    }

    private int onMachines(FleetOrder order) throws IOException {
        if (local.isPresent() && cluster.isPresent()) {
            throw wrong("--local starts machines, --cluster names some: choose one");
        }
        FleetEngine engine = FleetEngine.find().orElseThrow(() -> wrong("this wbv was built without Apache Flink: './wbv fleet' with"
                + " --local or --cluster builds it, or 'mvn -Pfleet package' and the class path of the launcher"));
        double between = checked("--keep", keep, 0.1, 86_400);
        PrintWriter err = spec.commandLine().getErr();
        if (local.isPresent()) {
            engine.local(order, (int) checked("--local", local.get(), 1, 64), between, out, err::println);
        } else {
            engine.cluster(order, cluster.get(), between, out, err::println);
        }
        spec.commandLine().getOut().println("Wrote " + out.resolve("results.csv") + ", alarms.csv");
        return 0;
    }

    private double checked(String option, double value, double low, double high) {
        if (!(value >= low && value <= high)) {
            throw wrong(option + " must be " + plain(low) + " to " + plain(high) + ": " + plain(value));
        }
        return value;
    }

    private static String plain(double value) {
        return value == Math.rint(value) ? Long.toString((long) value) : Double.toString(value);
    }

    private ParameterException wrong(String message) {
        return new ParameterException(spec.commandLine(), message);
    }

    private static String summary(FleetRun.Outcome outcome, double rate) {
        long packets = 0;
        long twice = 0;
        long late = 0;
        long lost = 0;
        long samples = 0;
        for (SeatResult seat : outcome.seats()) {
            packets += seat.losses().packets();
            twice += seat.losses().twice();
            late += seat.losses().late();
            lost += seat.losses().lost();
            samples += seat.losses().samples();
        }
        StringBuilder text = new StringBuilder();
        if (outcome.resumed() > 0) {
            text.append("Went on from packet ").append(outcome.resumed()).append(" of every seat.\n");
        }
        text.append(String.format(Locale.ROOT, "%d seats, %d samples", outcome.seats().size(), outcome.samples()));
        if (outcome.taken() > 0 && outcome.processor() > 0) {
            text.append(String.format(Locale.ROOT, "; %.2f µs of processor time a sample: %.0f samples/s a core, which carries %.0f seats",
                    1e6 / outcome.samplesPerCore(), outcome.samplesPerCore(), outcome.samplesPerCore() / rate));
        }
        text.append(String.format(Locale.ROOT, "%nPackets: %d taken, %d came twice, %d too late, %d lost (%d samples)%n", packets, twice,
                late, lost, samples));
        return text.append(worst(outcome.seats())).toString();
    }

    private static String worst(List<SeatResult> seats) {
        List<SeatResult> order = seats.stream().filter(each -> each.exposure().isPresent())
                .sorted(Comparator.comparingDouble(each -> -each.exposure().get().a8())).limit(WORST).toList();
        if (order.isEmpty()) {
            return "";
        }
        StringBuilder text = new StringBuilder(String.format(Locale.ROOT, "%-12s %10s %12s %14s %13s %12s%n", "worst seats", "A(8) m/s²",
                "VDV m/s^1.75", "min to action", "min to limit", "lost samples"));
        for (SeatResult seat : order) {
            SeatResult.Exposure exposure = seat.exposure().get();
            text.append(String.format(Locale.ROOT, "%-12s %9.3f %12.2f %14.0f %13.0f %12d%n", seat.seat(), exposure.a8(), exposure.vdv(),
                    exposure.minutesToAction(), exposure.minutesToLimit(), seat.losses().samples()));
        }
        return text.toString();
    }
}
