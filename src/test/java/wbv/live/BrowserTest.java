package wbv.live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.WebSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;

/** The page in a real browser: a Chromium without a window, asked through its own protocol. Skipped where there is none. */
@Timeout(120)
class BrowserTest {

    private static final String EVIL = "<img src=x onerror=alert(1)>";

    @TempDir(cleanup = CleanupMode.NEVER) // the browser may still write as it ends
    private Path folder;

    /** A page of a browser. */
    private static final class Browser implements AutoCloseable, WebSocket.Listener {

        private final Process process;
        private final WebSocket socket;
        private final BlockingQueue<JsonNode> answers = new LinkedBlockingQueue<>();
        private final StringBuilder part = new StringBuilder();
        private int asked;
        private volatile String fault = "";

        Browser(String program, Path folder) throws Exception {
            process = new ProcessBuilder(program, "--headless=new", "--no-sandbox", "--disable-gpu", "--remote-debugging-port=0",
                    "--user-data-dir=" + folder, "about:blank").redirectErrorStream(true).redirectOutput(folder.resolve("log").toFile())
                    .start();
            Path port = folder.resolve("DevToolsActivePort");
            for (int i = 0; i < 600 && !(Files.exists(port) && Files.readAllLines(port).size() > 1); i++) {
                Thread.sleep(50);
            }
            String base = "http://127.0.0.1:" + Files.readAllLines(port).get(0);
            HttpClient client = HttpClient.newHttpClient();
            JsonNode targets = new ObjectMapper().readTree(client.send(HttpRequest.newBuilder(URI.create(base + "/json")).build(),
                    HttpResponse.BodyHandlers.ofString()).body());
            String url = "";
            for (JsonNode target : targets) {
                url = target.get("type").asText().equals("page") ? target.get("webSocketDebuggerUrl").asText() : url;
            }
            socket = client.newWebSocketBuilder().buildAsync(URI.create(url), this).get(30, TimeUnit.SECONDS);
            ask("Runtime.enable", "{}");
        }

        @Override
        public CompletionStage<?> onText(WebSocket from, CharSequence data, boolean last) {
            part.append(data);
            if (last) {
                JsonNode message = Told.parsed(part.toString());
                part.setLength(0);
                if (message.has("id")) {
                    answers.add(message);
                } else if (message.path("method").asText().equals("Runtime.exceptionThrown")) {
                    fault = message.toString();
                }
            }
            from.request(1);
            return null;
        }

        JsonNode ask(String method, String parameters) throws Exception {
            socket.sendText("{\"id\":" + ++asked + ",\"method\":\"" + method + "\",\"params\":" + parameters + "}", true).get(30,
                    TimeUnit.SECONDS);
            JsonNode answer = answers.poll(30, TimeUnit.SECONDS);
            assertTrue(answer != null && answer.has("result"), method + ": " + answer);
            return answer.get("result");
        }

        /** The value of an expression, as text. */
        String value(String expression) throws Exception {
            String quoted = new ObjectMapper().writeValueAsString("String(" + expression + ")");
            return ask("Runtime.evaluate", "{\"expression\":" + quoted + "}").get("result").path("value").asText();
        }

        /** Waits until an expression is true. */
        void until(String expression) throws Exception {
            String last = "";
            for (int i = 0; i < 300; i++) {
                last = value(expression);
                if (last.equals("true")) {
                    assertEquals("", fault);
                    return;
                }
                Thread.sleep(100);
            }
            throw new AssertionError(expression + " stays " + last + "; the page says: " + value("document.body.innerText") + fault);
        }

        @Override
        public void close() throws Exception {
            socket.abort();
            process.destroy();
            process.waitFor(10, TimeUnit.SECONDS);
            process.destroyForcibly();
        }
    }

    private static String chromium() {
        for (String folder : System.getenv("PATH").split(":")) {
            for (String name : List.of("chromium", "chromium-browser", "google-chrome")) {
                if (Files.isExecutable(Path.of(folder, name))) {
                    return Path.of(folder, name).toString();
                }
            }
        }
        Assumptions.abort("skipped: no chromium, chromium-browser or google-chrome is installed");
        throw new IllegalStateException();
    }

    private static void rows(LiveStream live, String seat, int from, int to, double gain) {
        for (int i = from; i < to; i++) {
            double u = Math.sin(0.45 * i) + 0.7 * Math.sin(0.21 * i * (1 + 0.0001 * i));
            byte[] line = String.format(Locale.ROOT,
                    "{\"seat\":\"%s\",\"t\":%.6f,\"platform.acc.z\":%.6f,\"head.acc.z\":%.6f,\"seat.acc.z\":%.6f}", seat,
                    i / 60.0, u, 1.3 * u + 0.2 * Math.sin(0.9 * i), gain * u).getBytes(StandardCharsets.UTF_8);
            live.line("test", "", line, 0, line.length);
        }
    }

    private static LiveStream live() {
        return new LiveStream(LiveSettings.usual(), text -> {}, Aside.NONE, System::nanoTime);
    }

    private static PageServer server(int port, LiveStream live) throws IOException {
        return new PageServer(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), live::feed);
    }

    /** Values change, alarms appear, a name is only text, and a server that was started again is found again. */
    @Tag("slow")
    @Test
    void thePageIsAlive() throws Exception {
        String program = chromium();
        LiveStream live = live();
        live.begin("test", "1");
        rows(live, EVIL, 0, 300, 1);
        try (Browser browser = new Browser(program, folder)) {
            int port;
            try (PageServer server = server(0, live)) {
                port = server.port();
                browser.ask("Page.navigate", "{\"url\":\"" + server.address() + "\"}");
                browser.until("document.querySelectorAll('.tile').length === 5");
                String before = browser.value("document.querySelector('.tile .value').textContent");
                browser.value("window.alerted = 0, window.alert = () => window.alerted++");
                rows(live, EVIL, 300, 2400, 1);
                browser.until("document.querySelector('.tile .value').textContent !== '" + before + "'");
                rows(live, "loader", 0, 3600, 40);
                browser.until("document.querySelectorAll('#seats-rows tr').length === 2");
                browser.until("document.querySelector('#seats-rows tr a').textContent === 'loader'");
                browser.until("[...document.querySelectorAll('#seats-rows a')].some(a => a.textContent === '" + EVIL + "')");
                browser.until("document.querySelector('#alarms').textContent.includes('limit value is reached')");
                browser.value("document.querySelector('#seats-rows tr a').click()");
                browser.until("document.querySelector('#title').textContent === 'loader'");
                browser.until("document.querySelector('.tile').className.includes('fault')");
                assertEquals("0 0", browser.value("window.alerted + ' ' + document.querySelectorAll('img').length"));
            }
            browser.until("document.querySelector('#pulse').textContent.includes('lost')");
            LiveStream again = live();
            again.begin("another", "1");
            try (PageServer server = server(port, again)) {
                rows(again, "loader", 0, 300, 1);
                browser.until("document.querySelector('#source').textContent.startsWith('another')");
                browser.until("document.querySelector('#pulse').textContent.includes('live')");
                browser.until("document.querySelector('.tile').className.includes('good')");
            }
        }
    }

    /** Numbers of the page after its rubbish was taken out: nodes of the document and bytes of the script's heap. */
    private static double[] size(Browser browser) throws Exception {
        browser.ask("HeapProfiler.collectGarbage", "{}");
        double[] size = new double[2];
        for (JsonNode metric : browser.ask("Performance.getMetrics", "{}").get("metrics")) {
            String name = metric.get("name").asText();
            size[0] = name.equals("Nodes") ? metric.get("value").asDouble() : size[0];
            size[1] = name.equals("JSHeapUsedSize") ? metric.get("value").asDouble() : size[1];
        }
        return size;
    }

    /**
     * A long replay makes the page no larger: {@code -Dwbv.replay.hours=24 -Dwbv.replay.speed=100} replays a day in a quarter of an
     * hour. What is alive after a quarter of it is there at the end, and little more.
     */
    @Test
    @Tag("exam")
    @Timeout(3600)
    void aLongReplayMakesThePageNoLarger() throws Exception {
        double seconds = 3600 * Double.parseDouble(System.getProperty("wbv.replay.hours", "2"));
        double speed = Double.parseDouble(System.getProperty("wbv.replay.speed", "360"));
        String program = chromium();
        LiveStream live = live();
        live.begin("test", "1");
        rows(live, "loader", 0, 600, 1);
        try (Browser browser = new Browser(program, folder); PageServer server = server(0, live)) {
            browser.ask("Performance.enable", "{}");
            browser.ask("HeapProfiler.enable", "{}");
            browser.ask("Page.navigate", "{\"url\":\"" + server.address() + "\"}");
            browser.until("document.querySelectorAll('.tile').length === 5");
            long start = System.nanoTime();
            int sent = 600;
            double[] quarter = {};
            String before = "";
            while (sent < seconds * 60) {
                int due = (int) Math.min(seconds * 60, 600 + (System.nanoTime() - start) / 1e9 * speed * 60);
                rows(live, "loader", sent, due, 1);
                sent = Math.max(sent, due);
                if (quarter.length == 0 && sent > seconds * 15) {
                    quarter = size(browser);
                    before = browser.value("document.querySelector('.tile .value').textContent");
                }
                Thread.sleep(20);
            }
            String last = "document.querySelector('.tile .value').textContent";
            browser.until(last + " !== '" + before + "'");
            Thread.sleep(2000);
            double[] end = size(browser);
            System.out.printf(Locale.ROOT, "%.1f h at %.0f times: nodes %.0f, then %.0f; heap %.2f MB, then %.2f MB%n", seconds / 3600,
                    speed, quarter[0], end[0], quarter[1] / 1e6, end[1] / 1e6);
            assertTrue(end[0] < 1.3 * quarter[0], "nodes: " + quarter[0] + ", then " + end[0]);
            assertTrue(end[1] < 1.5 * quarter[1] + 1e6, "bytes of heap: " + quarter[1] + ", then " + end[1]);
        }
    }

    /** Pictures of the page, to be looked at: {@code java … wbv.live.BrowserTest FOLDER}. */
    public static void main(String[] words) throws Exception {
        Path to = Files.createDirectories(Path.of(words[0]));
        LiveStream live = live();
        live.begin("test", "1");
        rows(live, "digger", 0, 600, 1);
        rows(live, "loader", 0, 7200, 12);
        try (Browser browser = new Browser(chromium(), Files.createTempDirectory("browser")); PageServer server = server(0, live)) {
            for (int width : new int[] {1400, 390}) {
                browser.ask("Emulation.setDeviceMetricsOverride",
                        "{\"width\":" + width + ",\"height\":1000,\"deviceScaleFactor\":1,\"mobile\":"
                                + (width < 500) + "}");
                browser.ask("Page.navigate", "{\"url\":\"" + server.address() + "?seat=loader\"}");
                browser.until("document.querySelectorAll('.tile').length === 5");
                rows(live, "loader", 7200 + width, 9000 + width, 12);
                Thread.sleep(3000);
                String picture = browser.ask("Page.captureScreenshot", "{\"captureBeyondViewport\":true}").get("data").asText();
                Files.write(to.resolve("live-" + width + ".png"), Base64.getDecoder().decode(picture));
            }
        }
    }
}
