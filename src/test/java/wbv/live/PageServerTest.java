package wbv.live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.URI;
import java.net.URLEncoder;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Datagrams in, the page and its events out, over the sockets of this computer. */
@Timeout(60)
class PageServerTest {

    private static final String EVIL = "<img src=x onerror=alert(1)>";
    private static final InetSocketAddress ANY = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);

    private final HttpClient client = HttpClient.newHttpClient();
    private final LiveStream live = new LiveStream(LiveSettings.usual(), text -> {}, Aside.NONE, System::nanoTime);

    private HttpResponse<String> get(PageServer server, String path) throws IOException, InterruptedException {
        return client.send(HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + server.port() + path)).build(),
                HttpResponse.BodyHandlers.ofString());
    }

    private void rows(String seat, int from, int to) {
        for (int i = from; i < to; i++) {
            send(row(seat, i));
        }
    }

    private static String row(String seat, int i) {
        double u = Math.sin(0.45 * i) + 0.7 * Math.sin(0.21 * i * (1 + 0.0001 * i));
        return String.format(Locale.ROOT, "{\"seat\":\"%s\",\"t\":%.6f,\"platform.acc.z\":%.6f,\"head.acc.z\":%.6f,\"seat.acc.z\":%.6f}",
                seat, i / 60.0, u, 1.3 * u + 0.2 * Math.sin(0.9 * i), 8 * u);
    }

    private void send(String line) {
        byte[] bytes = line.getBytes(StandardCharsets.UTF_8);
        live.line("test", "", bytes, 0, bytes.length);
    }

    @Test
    void thePageLoadsNothingFromElsewhereAndPutsWordsInAsText() throws IOException, InterruptedException {
        try (PageServer server = new PageServer(ANY, live::feed)) {
            HttpResponse<String> page = get(server, "/");
            assertEquals(200, page.statusCode());
            String policy = page.headers().firstValue("Content-Security-Policy").orElse("");
            assertTrue(policy.contains("default-src 'none'") && policy.contains("script-src 'self'") && !policy.contains("unsafe"), policy);
            assertEquals("nosniff", page.headers().firstValue("X-Content-Type-Options").orElse(""));
            assertFalse(page.body().contains("http://") || page.body().contains("https://") || page.body().contains("<script>"),
                    page.body());
            String script = get(server, "/live.js").body();
            for (String word : List.of("innerHTML", "outerHTML", "insertAdjacentHTML", "document.write", "eval(", "new Function",
                    "https://")) {
                assertFalse(script.contains(word), word);
            }
            assertTrue(get(server, "/live.css").body().contains("--paper"));
            assertEquals(404, get(server, "/../../etc/passwd").statusCode());
            assertEquals(405,
                    client.send(HttpRequest.newBuilder(URI.create(server.address())).POST(HttpRequest.BodyPublishers.ofString("x")).build(),
                            HttpResponse.BodyHandlers.ofString()).statusCode());
        }
    }

    /** A foreign page that makes its own name lead to this computer gets nothing. */
    @Test
    void anotherNameForThisComputerIsRefused() throws IOException {
        try (PageServer server = new PageServer(ANY, live::feed); Socket socket = new Socket("127.0.0.1", server.port())) {
            socket.getOutputStream().write(
                    "GET /events HTTP/1.1\r\nHost: evil.example:80\r\nConnection: close\r\n\r\n".getBytes(StandardCharsets.US_ASCII));
            assertTrue(new String(socket.getInputStream().readAllBytes(), StandardCharsets.US_ASCII).startsWith("HTTP/1.1 400"));
        }
    }

    private static JsonNode next(BufferedReader events) throws IOException {
        for (String line = events.readLine(); line != null; line = events.readLine()) {
            if (line.startsWith("data: ")) {
                return Told.parsed(line.substring(6));
            }
        }
        throw new IOException("the stream of events has ended");
    }

    private BufferedReader events(PageServer server, String query) throws IOException, InterruptedException {
        HttpResponse<InputStream> response = client.send(
                HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + server.port() + "/events" + query)).build(),
                HttpResponse.BodyHandlers.ofInputStream());
        assertEquals("text/event-stream", response.headers().firstValue("Content-Type").orElse(""));
        return new BufferedReader(new InputStreamReader(response.body(), StandardCharsets.UTF_8));
    }

    @Test
    void eventsTellWhatIsNew() throws IOException, InterruptedException {
        rows("truck 7", 0, 1200);
        rows(EVIL, 0, 200);
        try (PageServer server = new PageServer(ANY, live::feed);
                BufferedReader events = events(server, "?seat=" + URLEncoder.encode(EVIL, StandardCharsets.UTF_8))) {
            JsonNode first = next(events);
            assertEquals(EVIL, first.get("shown").asText());
            assertEquals(2, first.get("table").size());
            assertEquals("truck 7", first.get("table").get(0).get("seat").asText());
            assertEquals("head.acc.z", first.get("plan").get("output").asText());
            assertTrue(first.get("curve").get("t").size() > 190, first.toString());
            double a8 = first.get("result").get("exposure").get("a8_m_s2").asDouble();
            double last = first.get("curve").get("t").get(first.get("curve").get("t").size() - 1).asDouble();
            rows(EVIL, 200, 500);
            int samples = 0;
            double later = a8;
            while (samples < 290) {
                JsonNode news = next(events);
                assertFalse(news.has("plan"));
                samples += news.has("curve") ? news.get("curve").get("t").size() : 0;
                later = news.has("result") ? news.get("result").get("exposure").get("a8_m_s2").asDouble() : later;
                assertTrue(!news.has("curve") || news.get("curve").get("t").get(0).asDouble() > last);
            }
            assertTrue(later > a8, a8 + " and " + later);
            send("nonsense");
            JsonNode notices = null;
            while (notices == null) {
                notices = next(events).get("notices");
            }
            assertEquals("unreadable", notices.get(0).get("kind").asText());
        }
    }

    /** Another server at the same port: whoever asks again is shown it from its beginning. */
    @Test
    void aServerThatStartedAgainIsFollowed() throws IOException, InterruptedException {
        int port;
        String run;
        rows("a", 0, 300);
        try (PageServer server = new PageServer(ANY, live::feed)) {
            port = server.port();
            try (BufferedReader events = events(server, "")) {
                run = next(events).get("run").asText();
            }
        }
        LiveStream another = new LiveStream(LiveSettings.usual(), text -> {}, Aside.NONE, System::nanoTime);
        try (PageServer server = new PageServer(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), another::feed);
                BufferedReader events = events(server, "")) {
            JsonNode first = next(events);
            assertFalse(first.get("run").asText().equals(run));
            assertEquals(0, first.get("seats").asInt());
        }
    }

    @Test
    void datagramsAreRows() throws Exception {
        try (DatagramSource source = new DatagramSource(ANY); DatagramSocket sender = new DatagramSocket()) {
            LiveRun run = new LiveRun(live, List.of(source), Double.POSITIVE_INFINITY);
            Thread runs = Told.running(run);
            for (int i = 0; i < 600; i += 6) {
                byte[] bytes = String.join("\n", IntStream.range(i, i + 6).mapToObj(k -> row("7", k)).toList())
                        .getBytes(StandardCharsets.UTF_8);
                sender.send(new DatagramPacket(bytes, bytes.length, InetAddress.getLoopbackAddress(), source.port()));
                Thread.sleep(1);
            }
            byte[] bad = "nonsense".getBytes(StandardCharsets.UTF_8);
            sender.send(new DatagramPacket(bad, bad.length, InetAddress.getLoopbackAddress(), source.port()));
            long until = System.nanoTime() + Duration.ofSeconds(20).toNanos();
            while (live.unreadable() == 0 && System.nanoTime() < until) {
                Thread.sleep(10);
            }
            run.stop();
            runs.join();
            assertEquals(List.of(600L, 1L), List.of(live.rows(), live.unreadable()));
        }
    }
}
