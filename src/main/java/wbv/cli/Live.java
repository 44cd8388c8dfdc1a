package wbv.cli;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import wbv.live.Aside;
import wbv.live.DatagramSource;
import wbv.live.Keep;
import wbv.live.LineSource;
import wbv.live.LiveRun;
import wbv.live.LiveSettings;
import wbv.live.LiveStream;
import wbv.live.MqttSource;
import wbv.live.PageServer;
import wbv.live.StreamSource;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.format.ColumnMap;
import wbv.recording.format.ReadOptions;
import wbv.state.StateModelFile;

/** {@code wbv live}: streams without an end. */
@Command(name = "live", mixinStandardHelpOptions = true,
        description = "Follows streams without an end: exposure so far and time left, natural frequency and damping, motion states, "
                + "faults and alarms, of one seat or many. Prints a line of JSON for every result and alarm; shows them on a page.",
        footer = {"", "Lines are CSV with a header t,seat.acc.z,… (perhaps a column seat), rows",
            "of a Movella DOT, or JSON: {\"seat\": \"7\", \"t\": 0.1, \"seat.acc.z\": 0.3}", "", "Examples:",
            "  wbv live data/arff/ride-subject1.arff --pace 1 --page 8080", "  zcat ride.csv.gz | wbv live -",
            "  wbv live --udp 5555 --page 8080 --aside unreadable.txt > results.jsonl"})
final class Live implements Callable<Integer> {

    /** Ports of UDP and TCP are 16 bits. */
    private static final int LAST_PORT = 65_535;

    @Parameters(paramLabel = "SOURCE", arity = "0..1",
            description = "file, named pipe or device with lines of samples; '-' is standard input")
    private Optional<String> name = Optional.empty();

    @Option(names = "--udp", paramLabel = "PORT", description = "take datagrams of one or more lines")
    private Optional<Integer> udp = Optional.empty();

    @Option(names = "--mqtt", paramLabel = "URL",
            description = "take messages of a broker, tcp://host:1883; user and password from WBV_MQTT_USER and WBV_MQTT_PASSWORD")
    private Optional<String> mqtt = Optional.empty();

    @Option(names = "--topic", paramLabel = "FILTER", defaultValue = "wbv/+",
            description = "of the messages; + says the seat (${DEFAULT-VALUE})")
    private String topic;

    @Option(names = "--page", paramLabel = "PORT", description = "show all of it on a page, http://localhost:PORT/")
    private Optional<Integer> page = Optional.empty();

    @Option(names = "--bind", paramLabel = "ADDRESS", defaultValue = "localhost",
            description = "where ports are opened (${DEFAULT-VALUE}: this computer alone); there is no password")
    private String bind;

    @Option(names = "--quiet", description = "print nothing on standard output")
    private boolean quiet;

    @Option(names = "--every", paramLabel = "SECONDS", defaultValue = "1", description = "time between results (${DEFAULT-VALUE})")
    private double every;

    @Option(names = "--pace", paramLabel = "FACTOR", description = "replay at so many times real time (as fast as it comes)")
    private Optional<Double> pace = Optional.empty();

    @Option(names = "--aside", paramLabel = "FILE", description = "append lines that cannot be read, up to 1 GB of them")
    private Optional<Path> aside = Optional.empty();

    @Option(names = "--state", paramLabel = "DIR",
            description = "keep what is known of all seats there, and go on with it after any end of the program")
    private Optional<Path> state = Optional.empty();

    @Option(names = "--columns", paramLabel = "HEADER", description = "header of senders that send none: t,seat.acc.z,head.acc.z")
    private Optional<String> columns = Optional.empty();

    @Option(names = "--map", paramLabel = "FILE", description = "JSON that says which column of a foreign CSV is which channel")
    private Optional<Path> map = Optional.empty();

    @Option(names = "--rate", paramLabel = "HZ", description = "sampling rate (learned from the first second)")
    private Optional<Double> rate = Optional.empty();

    @Option(names = "--location", paramLabel = "SENSOR=PLACE", description = "where a DOT sat, by its tag")
    private Map<String, String> locations = new LinkedHashMap<>();

    @Option(names = "--input", paramLabel = "CHANNEL", description = "exciting channel (platform, floor or seat.acc.z)")
    private Optional<String> input = Optional.empty();

    @Option(names = "--output", paramLabel = "CHANNEL", split = ",",
            description = "answering channels (head.acc.z, else sternum, pelvis or seat)")
    private List<String> outputs = new ArrayList<>();

    @Mixin
    private CommonOptions.Follower follower;

    @Mixin
    private CommonOptions.Contact contact;

    @Mixin
    private CommonOptions.Sampling sampling;

    @Option(names = "--states", paramLabel = "FILE", description = "model.json of 'wbv states train' (the one that ships, where it fits)")
    private Optional<Path> states = Optional.empty();

    @Option(names = "--seats", paramLabel = "N", defaultValue = "" + LiveSettings.USUAL_SEATS,
            description = "seats that are followed at most (${DEFAULT-VALUE})")
    private int seats;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        LiveSettings settings = settings();
        double speed = pace.orElse(Double.POSITIVE_INFINITY);
        if (!(speed > 0)) {
            throw wrong("--pace must be > 0: " + speed);
        }
        InetAddress at = address();
        List<LineSource> sources = new ArrayList<>();
        Optional<Keep> keep = state.isPresent() ? Optional.of(new Keep(state.get())) : Optional.empty();
        try (Aside unreadable = aside.isPresent() ? Aside.in(aside.get()) : Aside.NONE) {
            LiveStream live = new LiveStream(settings, printed(), unreadable, keep, System::nanoTime);
            if (udp.isPresent()) {
                sources.add(new DatagramSource(new InetSocketAddress(at, port("--udp", udp.get()))));
            }
            if (mqtt.isPresent()) {
                sources.add(new MqttSource(mqtt.get(), topic, MqttSource.clientName(topic), environment("WBV_MQTT_USER"),
                        environment("WBV_MQTT_PASSWORD")));
            }
            if (name.isPresent()) {
                sources.add(stream(name.get()));
            }
            if (sources.isEmpty()) {
                throw wrong("say where samples come from: a SOURCE, '-' for standard input, --udp PORT or --mqtt URL");
            }
            live.begin(sources.stream().map(LineSource::name).collect(Collectors.joining(" and ")), Version.text());
            live.resume();
            if (page.isPresent()) {
                try (PageServer server = new PageServer(new InetSocketAddress(at, port("--page", page.get())), live::feed)) {
                    say("The page is at " + server.address());
                    follow(new LiveRun(live, sources, speed), live, true);
                }
            } else {
                follow(new LiveRun(live, sources, speed), live, false);
            }
        } finally {
            for (LineSource source : sources) {
                source.close();
            }
            if (keep.isPresent()) {
                keep.get().close();
            }
        }
        return 0;
    }

    /** @param stays whether someone may still look when all sources have ended */
    private void follow(LiveRun run, LiveStream live, boolean stays) {
        Thread main = Thread.currentThread();
        Thread atEnd = new Thread(() -> {
            run.stop();
            main.interrupt();
            try {
                run.await(3000);
            } catch (InterruptedException ended) {
                Thread.currentThread().interrupt();
            }
            live.finish();
        });
        Runtime.getRuntime().addShutdownHook(atEnd);
        try {
            run.run();
            live.finish();
            if (live.rows() == 0) {
                throw DataFault.in(live.source(), live.lines() == 0 ? "is empty: no line came" : "no row of samples is among its "
                        + live.lines() + (live.lines() == 1 ? " line" : " lines"));
            }
            if (stays) {
                say("The stream has ended; the page stays until wbv is ended (Ctrl-C).");
                Thread.sleep(Long.MAX_VALUE);
            }
        } catch (InterruptedException asked) {
            live.finish();
        } finally {
            try {
                Runtime.getRuntime().removeShutdownHook(atEnd);
            } catch (IllegalStateException ending) {
                // the hook is what ended it
            }
        }
    }

    private LiveSettings settings() throws IOException {
        if (rate.isPresent() && !Clock.isRate(rate.get())) {
            throw wrong("--rate must be " + Clock.SLOWEST + " to " + Clock.FASTEST + " Hz: " + rate.get());
        }
        if (!(every >= 0.01 && every <= 3600)) {
            throw wrong("--every must be 0.01 to 3600 s: " + every);
        }
        if (seats < 1) {
            throw wrong("--seats must be at least 1: " + seats);
        }
        List<Channel> inputs = Usage.channels(spec, input.stream().toList());
        ReadOptions reading = new ReadOptions(map.isPresent() ? Optional.of(ColumnMap.read(map.get())) : Optional.empty(),
                rate.map(OptionalDouble::of).orElseGet(OptionalDouble::empty), locations);
        return new LiveSettings(reading, columns, follower.method(), inputs.stream().findFirst(), Usage.channels(spec, outputs),
                contact.seat(), sampling.boxcar(),
                Optional.of(states.isPresent() ? StateModelFile.read(states.get()) : StateModelFile.shipped()), every, seats);
    }

    private StreamSource stream(String source) throws IOException {
        if (source.equals("-")) {
            if (RecordingOptions.standardInputIsClosed()) {
                throw new DataFault("standard input: is closed; pipe samples into it");
            }
            return new StreamSource("standard input", System.in);
        }
        try {
            if (Files.isDirectory(Path.of(source))) {
                throw DataFault.in(source, "is a folder; name a file or a pipe");
            }
            InputStream in = Files.newInputStream(Path.of(source));
            return new StreamSource(source, in);
        } catch (NoSuchFileException missing) {
            throw DataFault.in(source, "there is no such file, pipe or device", missing);
        }
    }

    private InetAddress address() {
        try {
            return InetAddress.getByName(bind.equals("localhost") ? "127.0.0.1" : bind);
        } catch (UnknownHostException unknown) {
            throw wrong("--bind names no address of this computer: " + bind);
        }
    }

    private static String environment(String variable) {
        return Optional.ofNullable(System.getenv(variable)).orElse("");
    }

    private int port(String option, int port) {
        if (port < 0 || port > LAST_PORT) {
            throw wrong(option + " must be 0 to " + LAST_PORT + ": " + port);
        }
        return port;
    }

    /** Lines on standard output; where nobody takes them any more, the stream ends. */
    private LiveStream.Lines printed() {
        if (quiet) {
            return text -> {};
        }
        PrintStream out = System.out;
        StringBuilder waiting = new StringBuilder();
        return new LiveStream.Lines() {
            @Override
            public void line(String text) {
                waiting.append(text).append('\n');
                if (waiting.length() > 1 << 16) {
                    flush();
                }
            }

            @Override
            public void flush() {
                if (waiting.length() > 0) {
                    out.print(waiting);
                    out.flush();
                    waiting.setLength(0);
                    if (out.checkError()) {
                        throw DataFault.in("standard output", "cannot be written; is its disk full, or its reader gone?");
                    }
                }
            }
        };
    }

    private void say(String words) {
        spec.commandLine().getErr().println(words);
        spec.commandLine().getErr().flush();
    }

    private ParameterException wrong(String message) {
        return new ParameterException(spec.commandLine(), message);
    }
}
