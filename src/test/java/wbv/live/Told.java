package wbv.live;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** A live stream in this Java, and the lines that it told. */
final class Told {

    private static final ObjectMapper MAPPER = new ObjectMapper();

    private final List<String> lines = new ArrayList<>();
    private long now;
    final LiveStream live;

    Told(LiveSettings settings) {
        live = new LiveStream(settings, lines::add, Aside.NONE, () -> now);
    }

    static Told usual() {
        return new Told(LiveSettings.usual());
    }

    /** Sends lines. */
    Told send(String text) {
        return sendFrom("test", text);
    }

    Told sendFrom(String sender, String text) {
        for (String line : text.split("\n")) {
            byte[] bytes = line.getBytes(StandardCharsets.UTF_8);
            live.line(sender, "", bytes, 0, bytes.length);
        }
        return this;
    }

    /** Sends bytes as standard input brings them. */
    Told stream(byte[] bytes) {
        try {
            new StreamSource("test", new ByteArrayInputStream(bytes)).run(live);
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
        return this;
    }

    /** Lets time pass. @param seconds on the wall */
    Told pass(double seconds) {
        now += (long) (seconds * 1e9);
        live.tick();
        return this;
    }

    Told finish() {
        live.finish();
        return this;
    }

    /** A run in a thread of its own, which ends when the run is stopped. */
    static Thread running(LiveRun run) {
        Thread thread = new Thread(() -> {
            try {
                run.run();
            } catch (InterruptedException ended) {
                Thread.currentThread().interrupt();
            }
        });
        thread.start();
        return thread;
    }

    /** All lines of a type. */
    List<JsonNode> of(String type) {
        return lines.stream().map(Told::parsed).filter(node -> node.get("type").asText().equals(type)).toList();
    }

    /** Kinds of all alarms, in order; those that are over with a minus before them. */
    List<String> alarms() {
        return of("alarm").stream().map(node -> (node.has("over") ? "-" : "") + node.get("kind").asText()).toList();
    }

    static JsonNode parsed(String line) {
        try {
            return MAPPER.readTree(line);
        } catch (IOException wrong) {
            throw new UncheckedIOException(line, wrong);
        }
    }
}
