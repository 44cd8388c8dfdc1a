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
import java.util.List;
import java.util.Locale;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Assumptions;
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
                    "--user-data-dir=" + folder, "about:blank").redirectErrorStream(true).redirectOutput(folder.resolve("log").toFile()).start();
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
            socket.sendText("{\"id\":" + ++asked + ",\"method\":\"" + method + "\",\"params\":" + parameters + "}", true).get(30, TimeUnit.SECONDS);
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

    private static void rows(Live live, String seat, int from, int to, double gain) {
        for (int i = from; i < to; i++) {
            double u = Math.sin(0.45 * i) + 0.7 * Math.sin(0.21 * i * (1 + 0.0001 * i));
            byte[] line = String.format(Locale.ROOT, "{\"seat\":\"%s\",\"t\":%.6f,\"platform.acc.z\":%.6f,\"head.acc.z\":%.6f,\"seat.acc.z\":%.6f}", seat,
                    i / 60.0, u, 1.3 * u + 0.2 * Math.sin(0.9 * i), gain * u).getBytes(StandardCharsets.UTF_8);
            live.line("test", "", line, 0, line.length);
        }
    }

    private static Live live() {
        return new Live(LiveSettings.usual(), text -> { }, Aside.NONE, System::nanoTime);
    }

    private static PageServer server(int port, Live live) throws IOException {
        return new PageServer(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), live::feed);
    }

    /** Values change, alarms appear, a name is only text, and a server that was started again is found again. */
    @Test
    void thePageIsAlive() throws Exception {
        String program = chromium();
        Live live = live();
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
            Live again = live();
            again.begin("another", "1");
            try (PageServer server = server(port, again)) {
                rows(again, "loader", 0, 300, 1);
                browser.until("document.querySelector('#source').textContent.startsWith('another')");
                browser.until("document.querySelector('#pulse').textContent.includes('live')");
                browser.until("document.querySelector('.tile').className.includes('good')");
            }
        }
    }
}
