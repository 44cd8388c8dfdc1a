package wbv.live;

import com.sun.net.httpserver.Headers;
import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.BindException;
import java.net.InetSocketAddress;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;
import wbv.recording.DataFault;

/**
 * The page: one document, its style and script, and a stream of server-sent events for everyone who looks. Nothing is loaded from
 * elsewhere, and nothing can be changed through it. Each onlooker is served by a thread of its own that asks for what is new, so
 * that a slow one costs nobody anything.
 */
public final class PageServer implements Closeable {

    /** What one onlooker is shown. */
    public interface Feed {

        /** What is new since the last call, as one JSON object; empty if nothing is. */
        String next();
    }

    private static final int MOST_ONLOOKERS = 32;
    private static final long PERIOD = 50; // ms between looks at what is new: twenty a second move smoothly
    private static final int HEARTBEAT = 200; // looks without news after which a comment keeps the connection
    private static final int LONGEST_PATH = 2048;
    private static final String REPORT = "/wbv/report/page/";
    private static final String OWN = "/wbv/live/";
    private static final String SAFE = "default-src 'none'; style-src 'self'; script-src 'self'; connect-src 'self'; img-src data:; "
            + "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

    private final HttpServer server;
    private final ExecutorService threads;
    private final Function<String, Feed> feeds;
    private final AtomicInteger onlookers = new AtomicInteger();
    private final boolean loopback;
    private final byte[] document = resource(OWN + "live.html");
    private final byte[] style = joined("", List.of(REPORT + "report.css", OWN + "live.css"), "");
    private final byte[] script = joined("(() => {\n'use strict';\n", List.of(REPORT + "axes.js", REPORT + "view.js", REPORT + "chart.js",
            REPORT + "lines.js", OWN + "live.js"), "})();\n");
    private volatile boolean closed;

    /**
     * Opens the page.
     *
     * @param at    where; port 0 takes a free one
     * @param feeds makes what someone is shown who looks at a seat, or at none (an empty name)
     * @throws DataFault if the port is taken or not ours
     */
    public PageServer(InetSocketAddress at, Function<String, Feed> feeds) throws IOException {
        this.feeds = feeds;
        this.loopback = at.getAddress().isLoopbackAddress();
        try {
            server = HttpServer.create(at, 64);
        } catch (BindException taken) {
            throw DataFault.in("page " + at.getHostString() + ":" + at.getPort(), "cannot be served there: " + taken.getMessage()
                    + "; choose another --page PORT", taken);
        }
        threads = new ThreadPoolExecutor(2, 2 * MOST_ONLOOKERS, 30, TimeUnit.SECONDS, new SynchronousQueue<>(), task -> {
            Thread thread = new Thread(task, "wbv-page");
            thread.setDaemon(true);
            return thread;
        }, new ThreadPoolExecutor.CallerRunsPolicy());
        server.setExecutor(threads);
        server.createContext("/", this::answer);
        server.start();
    }

    /** Where it is to be seen. */
    public String address() {
        String host = server.getAddress().getAddress().isAnyLocalAddress() ? "localhost" : server.getAddress().getHostString();
        return "http://" + (host.contains(":") ? "[" + host + "]" : host) + ":" + server.getAddress().getPort() + "/";
    }

    /** The port that it is served at. */
    public int port() {
        return server.getAddress().getPort();
    }

    private void answer(HttpExchange exchange) throws IOException {
        try (exchange) {
            Headers headers = exchange.getResponseHeaders();
            headers.set("Content-Security-Policy", SAFE);
            headers.set("X-Content-Type-Options", "nosniff");
            headers.set("Referrer-Policy", "no-referrer");
            headers.set("Cache-Control", "no-store");
            if (!exchange.getRequestMethod().equals("GET")) {
                headers.set("Allow", "GET");
                refuse(exchange, 405);
            } else if (!isMeant(exchange)) {
                refuse(exchange, 400);
            } else {
                switch (exchange.getRequestURI().getPath()) {
                    case "/" -> send(exchange, "text/html; charset=utf-8", document);
                    case "/live.css" -> send(exchange, "text/css; charset=utf-8", style);
                    case "/live.js" -> send(exchange, "text/javascript; charset=utf-8", script);
                    case "/events" -> events(exchange);
                    default -> refuse(exchange, 404);
                }
            }
        }
    }

    private boolean isMeant(HttpExchange exchange) {
        return meant(exchange.getRequestHeaders().getFirst("Host")) && exchange.getRequestURI().toString().length() <= LONGEST_PATH;
    }

    /** A page on this computer alone is asked for by its name: another name leads here only by a foreign page's trick (DNS rebinding). */
    private boolean meant(String host) {
        if (!loopback) {
            return true;
        }
        String name = host == null ? "" : host.toLowerCase(Locale.ROOT).replaceFirst(":[0-9]+$", "");
        return List.of("localhost", "127.0.0.1", "[::1]").contains(name);
    }

    private static void refuse(HttpExchange exchange, int code) throws IOException {
        exchange.sendResponseHeaders(code, -1);
    }

    private static void send(HttpExchange exchange, String type, byte[] content) throws IOException {
        exchange.getResponseHeaders().set("Content-Type", type);
        exchange.sendResponseHeaders(200, content.length);
        exchange.getResponseBody().write(content);
    }

    private void events(HttpExchange exchange) throws IOException {
        if (onlookers.incrementAndGet() > MOST_ONLOOKERS) {
            onlookers.decrementAndGet();
            refuse(exchange, 503);
            return;
        }
        try {
            exchange.getResponseHeaders().set("Content-Type", "text/event-stream");
            exchange.sendResponseHeaders(200, 0);
            show(feeds.apply(seat(exchange.getRequestURI().getRawQuery())), exchange.getResponseBody());
        } catch (InterruptedException ended) {
            Thread.currentThread().interrupt();
        } finally {
            onlookers.decrementAndGet();
        }
    }

    /** Writes what is new until the onlooker has gone, which a write tells. */
    private void show(Feed feed, OutputStream out) throws IOException, InterruptedException {
        out.write("retry: 1000\n\n".getBytes(StandardCharsets.UTF_8));
        for (int quiet = 0; !closed;) {
            String news = feed.next();
            quiet = news.isEmpty() ? quiet + 1 : 0;
            if (!news.isEmpty()) {
                out.write(("data: " + news + "\n\n").getBytes(StandardCharsets.UTF_8));
                out.flush();
            } else if (quiet % HEARTBEAT == 1) {
                out.write(":\n\n".getBytes(StandardCharsets.UTF_8));
                out.flush();
            }
            Thread.sleep(PERIOD);
        }
    }

    private static String seat(String query) {
        if (query == null || !query.startsWith("seat=")) {
            return "";
        }
        try {
            return URLDecoder.decode(query.substring("seat=".length()), StandardCharsets.UTF_8);
        } catch (IllegalArgumentException wrong) {
            return "";
        }
    }

    private static byte[] joined(String before, List<String> names, String after) {
        StringBuilder text = new StringBuilder(before);
        names.forEach(name -> text.append(new String(resource(name), StandardCharsets.UTF_8)).append('\n'));
        return text.append(after).toString().getBytes(StandardCharsets.UTF_8);
    }

    private static byte[] resource(String name) {
        try (InputStream in = PageServer.class.getResourceAsStream(name)) {
            if (in == null) {
                throw new IllegalStateException("the program lacks its own file " + name);
            }
            return in.readAllBytes();
        } catch (IOException failed) {
            throw new java.io.UncheckedIOException(failed);
        }
    }

    @Override
    public void close() {
        closed = true;
        server.stop(0);
        threads.shutdownNow();
    }
}
