package wbv.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import wbv.fleet.FleetEngine;
import wbv.fleet.FleetOrder;
import wbv.fleet.FleetRun;
import wbv.fleet.FleetSource;
import wbv.fleet.FleetSummary;
import wbv.fleet.PacketFiles;
import wbv.fleet.SeatOrder;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.recording.inspect.RowSource;
import wbv.result.ResultsJson;
import wbv.seat.Packet;
import wbv.seat.SeatPlan;
import wbv.state.StateModel;
import wbv.state.StateModelFile;

/** {@code wbv fleet}: many seats at once. */
@Command(name = "fleet", mixinStandardHelpOptions = true,
        description = "Follows many seats at once: recordings are replayed as the packets of so many seats, each from a place of its own "
                + "in the ride; or packets are read from files, or from a topic kafka://HOST:PORT/TOPIC. Writes results.csv, alarms.csv, "
                + "and by the sensors' time machines.csv and worst.csv. A run that was killed goes on where it stood when the same "
                + "command is given again; its files come out as if nothing had happened.",
        footer = {"", "Examples:", "  wbv fleet data/arff/ride-subject1.arff --seats 10000 --out out",
            "  wbv fleet data/arff/ride-subject1.arff --seats 200 --disturb 1 --out out",
            "  wbv fleet data/arff/one-dof-linear.arff --seats 200 --send fleet.packets",
            "  wbv fleet fleet.packets --channels platform.acc.z,head.acc.z --out out"})
final class Fleet implements Callable<Integer> {

    private static final int MOST_SEATS = 1_000_000;
    private static final String KAFKA = "kafka://";
    private static final Pattern TOPIC = Pattern.compile("kafka://([^/]+:\\d+)/([A-Za-z0-9._-]+)");

    @Mixin
    private RecordingOptions recording;

    @Option(names = "--seats", paramLabel = "N", defaultValue = "1000", description = "how many (${DEFAULT-VALUE})")
    private int seats;

    @Option(names = "--packet", paramLabel = "SAMPLES", description = "samples that are sent together (those of one second)")
    private Optional<Integer> packet = Optional.empty();

    @Option(names = "--every", paramLabel = "SECONDS", defaultValue = "10",
            description = "time between results of a seat (${DEFAULT-VALUE})")
    private double every;

    @Mixin
    private CommonOptions.Follower follower;

    @Mixin
    private CommonOptions.Sampling sampling;

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

    @Option(names = "--channels", split = ",", paramLabel = "CHANNEL",
            description = "what the values of a packet are, in their order: packets do not say")
    private List<String> channels = new ArrayList<>();

    @Option(names = "--send", paramLabel = "FILE", description = "write the packets of the recordings to FILE, and follow nothing")
    private Optional<Path> send = Optional.empty();

    @Option(names = "--table", paramLabel = "MINUTES", defaultValue = "60",
            description = "period of the tables of machines and of the seats worst off, by the sensors' time (${DEFAULT-VALUE})")
    private double table;

    @Option(names = "--results", paramLabel = "PREFIX",
            description = "what the names of the topics of results begin with (that of the packets)")
    private Optional<String> results = Optional.empty();

    @Option(names = "--ends", description = "end where the topic ends now, instead of following it for ever")
    private boolean ends;

    @Option(names = "--local", paramLabel = "N", description = "start a cluster of Apache Flink on this computer with so many workers, and "
            + "follow the seats on it; the results are the same")
    private Optional<Integer> local = Optional.empty();

    @Option(names = "--cluster", paramLabel = "HOST:PORT", description = "follow the seats on a cluster of Apache Flink that is there, by "
            + "its REST port; all of its machines must see DIR under the same name")
    private Optional<String> cluster = Optional.empty();

    @Mixin
    private ResultFolder out;

    @Mixin
    private Answer answer;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        FleetOrder order = order();
        if (send.isPresent()) {
            return send(order);
        }
        if (local.isPresent() || cluster.isPresent()) {
            return onMachines(order);
        }
        if (order.source() instanceof FleetSource.Topic) {
            throw wrong("packets of Kafka are followed on machines of Apache Flink: add --local N or --cluster HOST:PORT");
        }
        double rate = order.follow().rate();
        int cores = threads.orElse(Runtime.getRuntime().availableProcessors());
        FleetRun run = new FleetRun(order, order.follow().plan(), out.path(),
                (int) Usage.within(spec, "--threads", cores, 1, 1024), Usage.within(spec, "--keep", keep, 0, 86_400, " s"));
        try (ProgressBar bar = answer.progress()) {
            FleetRun.Outcome outcome = run.run(share -> bar.at("following seats", share));
            bar.close();
            FleetSummary summary = FleetSummary.of(outcome);
            answer.print(summary.text(rate), wrote(outcome.unread()), () -> ResultsJson.render(summary));
        }
        return 0;
    }

    private int onMachines(FleetOrder order) throws IOException {
        if (local.isPresent() && cluster.isPresent()) {
            throw wrong("--local starts machines, --cluster names some: choose one");
        }
        FleetEngine engine = FleetEngine.find().orElseThrow(() -> wrong("this wbv was built without Apache Flink: './wbv fleet' with"
                + " --local or --cluster builds it, or 'mvn -Pfleet package' and the class path of the launcher"));
        double between = Usage.within(spec, "--keep", keep, 0.1, 86_400, " s");
        PrintWriter err = spec.commandLine().getErr();
        if (local.isPresent()) {
            engine.local(order, (int) Usage.within(spec, "--local", local.get(), 1, 64), between, out.path(), err::println);
        } else {
            engine.cluster(order, cluster.get(), between, out.path(), err::println);
        }
        boolean unread = Files.exists(out.file("unread.csv"));
        List<String> kinds = List.of("results", "alarms", "machines", "worst", "unread");
        if (order.source() instanceof FleetSource.Topic topic) {
            answer.print("Wrote the topics " + topic.results() + ".results, .alarms, .machines, .worst and .unread\n",
                    new Answer.Written(kinds.stream().map(kind -> topic.results() + "." + kind).toList()));
        } else {
            answer.print(wrote(unread), new Answer.Written(kinds.stream().filter(kind -> unread || !kind.equals("unread"))
                    .map(kind -> out.file(kind + ".csv").toString()).toList()));
        }
        return 0;
    }

    private String wrote(boolean unread) {
        return "Wrote " + out.file("results.csv") + ", alarms.csv, machines.csv, worst.csv"
                + (unread ? "; packets that cannot be read are in unread.csv" : "") + "\n";
    }

    private FleetOrder order() throws IOException {
        List<String> names = recording.names();
        Optional<String> topic = names.stream().filter(name -> name.startsWith(KAFKA)).findFirst();
        if (topic.isPresent()) {
            if (names.size() > 1) {
                throw wrong("one topic at a time, and nothing beside it: " + String.join(" ", names));
            }
            Matcher parts = TOPIC.matcher(topic.get());
            if (!parts.matches()) {
                throw wrong("a topic is named kafka://HOST:PORT/TOPIC: " + topic.get());
            }
            double rate = recording.rate().orElseThrow(() -> wrong("--rate must say how many samples a second the packets have"));
            return of(rate, told(), new FleetSource.Topic(parts.group(1), parts.group(2), results.orElse(parts.group(2)), ends));
        }
        List<Path> files = new ArrayList<>();
        for (String name : names) {
            if (!name.equals("-") && PacketFiles.holdsPackets(Path.of(name))) {
                files.add(Path.of(name));
            }
        }
        if (!files.isEmpty()) {
            if (files.size() < names.size()) {
                throw wrong("files of packets and recordings are not followed together: " + String.join(" ", names));
            }
            Packet first = PacketFiles.first(files);
            List<Channel> told = told();
            if (first.channels() != told.size()) {
                throw DataFault.in(files.get(0).toString(), "its packets have " + first.channels() + " channels, --channels names "
                        + told.size());
            }
            return of(recording.rate().orElse(first.rate()), told, new FleetSource.Packets(files));
        }
        return replayed();
    }

    /** The channels of packets, which have no names of them. */
    private List<Channel> told() {
        if (channels.isEmpty()) {
            throw wrong("--channels must name the channels of the packets, in their order: --channels platform.acc.z,head.acc.z");
        }
        try {
            return channels.stream().map(Channel::parse).toList();
        } catch (IllegalArgumentException unknown) {
            throw wrong("--channels: " + unknown.getMessage());
        }
    }

    /** @param given channels of the packets, all of them */
    private FleetOrder of(double rate, List<Channel> given, FleetSource source) throws IOException {
        SeatPlan plan = plan(rate, given);
        return new FleetOrder(new SeatOrder(rate, given, follower.method(), sampling.boxcar(), plan.states(), plan.interval()), source,
                period());
    }

    private double period() {
        return 60 * Usage.within(spec, "--table", table, 1e-3, 1e6, " min");
    }

    private SeatPlan plan(double rate, List<Channel> given) throws IOException {
        Optional<StateModel> states = Optional.of(model.isPresent() ? StateModelFile.read(model.get()) : StateModelFile.shipped());
        int interval = (int) Math.max(1, Math.round(Usage.within(spec, "--every", every, 1e-3, 86_400, " s") * rate));
        SeatPlan plan = SeatPlan.usual(rate, given, follower.method(), sampling.boxcar(), states, interval);
        if (model.isPresent() && plan.states().isEmpty()) {
            throw new DataFault(model.get() + ": its channels " + states.get().features().channels() + " at "
                    + states.get().features().rate() + " Hz are not those of the " + (channels.isEmpty() ? "recordings" : "packets"));
        }
        return plan;
    }

    private FleetOrder replayed() throws IOException {
        List<Recording> recordings = new ArrayList<>();
        for (RowSource source : recording.each()) {
            recordings.add(source.load());
        }
        double rate = recordings.get(0).clock().rate();
        List<Channel> common = new ArrayList<>(recordings.get(0).channels());
        recordings.forEach(each -> common.retainAll(each.channels()));
        int size = packet.orElse((int) Math.max(1, Math.round(rate)));
        FleetOrder order = of(rate, plan(rate, common).needed(), new FleetSource.Recordings(recordings,
                (int) Usage.within(spec, "--seats", seats, 1, MOST_SEATS), (int) Usage.within(spec, "--packet", size, 1, 8192), disturb));
        order.replay(); // refuses recordings that do not go together
        return order;
    }

    /** Writes the packets of a replay to a file, and follows nothing. */
    private int send(FleetOrder order) throws IOException {
        if (!(order.source() instanceof FleetSource.Recordings)) {
            throw wrong("--send writes the packets of recordings; these are packets");
        }
        long count = order.replay().write(send.get());
        answer.print("Wrote " + count + " packets to " + send.get() + "; follow them with --channels "
                + order.follow().channels().stream().map(Channel::toString).collect(Collectors.joining(",")) + "\n",
                new Answer.Written(send.get().toString()));
        return 0;
    }

    private ParameterException wrong(String message) {
        return new ParameterException(spec.commandLine(), message);
    }
}
