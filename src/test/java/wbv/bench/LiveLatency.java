package wbv.bench;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.locks.LockSupport;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * How long after the row that ends it a result of {@code wbv live} comes out, in real time: rows at 60 Hz into a process of its own, its
 * lines back, and the same rows at the same time through {@code cat}, which says what the machine alone takes.
 *
 * <pre>java -cp … wbv.bench.LiveLatency SECONDS SEATS [options of wbv live]</pre>
 *
 * Every result waits for its packet of 50 ms, which is not counted: the clock starts when the row that fills it is written.
 */
public final class LiveLatency {

    private static final double RATE = 60;
    /** Time at the beginning in which Java still compiles; told apart [s]. */
    private static final double WARM = 15;
    private static final Pattern TIME = Pattern.compile("\"seat\":\"(\\d+)\".*?\"t(?:_s)?\":([0-9.]+)");

    private LiveLatency() {}

    public static void main(String[] words) throws IOException, InterruptedException {
        double seconds = Double.parseDouble(words[0]);
        int seats = Integer.parseInt(words[1]);
        List<String> live = new ArrayList<>(List.of(System.getProperty("wbv", "./wbv"), "live", "-", "--every", "0.1"));
        live.addAll(List.of(words).subList(2, words.length));
        Peer cat = new Peer(List.of("cat"));
        Peer own = new Peer(live);
        int page = live.indexOf("--page");
        if (page >= 0) {
            Thread onlooker = new Thread(() -> look("http://localhost:" + live.get(page + 1) + "/events"));
            onlooker.setDaemon(true);
            onlooker.start();
        }
        send(List.of(cat, own), seconds, seats);
        System.out.printf(Locale.ROOT, "`wbv live` took %.1f s of processor time for %.0f s of %d seats%n%n",
                own.process.info().totalCpuDuration()
                        .orElseThrow().toMillis() / 1e3,
                seconds, seats);
        System.out.println("| process | when | results | p50 [ms] | p90 | p99 | greatest |\n|---|---|---|---|---|---|---|");
        cat.tell("`cat`");
        own.tell("`wbv live`");
    }

    /** A process that rows go to and lines come from. */
    private static final class Peer {

        private final Process process;
        private final Map<Long, Long> sent = new ConcurrentHashMap<>();
        private final List<double[]> heard = new ArrayList<>();
        private final Thread reader = new Thread(this::hear);

        Peer(List<String> command) throws IOException {
            process = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT).start();
            reader.start();
        }

        void send(int seat, int i, byte[] row) throws IOException {
            sent.put(key(seat, i / RATE), System.nanoTime());
            process.getOutputStream().write(row);
            process.getOutputStream().flush();
        }

        private void hear() {
            try (BufferedReader in = new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
                for (String line = in.readLine(); line != null; line = in.readLine()) {
                    long now = System.nanoTime();
                    Matcher found = TIME.matcher(line);
                    if (found.find() && !line.contains("\"alarm\"")) {
                        double time = Double.parseDouble(found.group(2));
                        Long from = sent.get(key(Integer.parseInt(found.group(1)), time));
                        if (from != null) {
                            heard.add(new double[] {time, (now - from) / 1e6});
                        }
                    }
                }
            } catch (IOException gone) {
                // it has ended
            }
        }

        /** Ends it; one that shows a page would stay. */
        void tell(String name) throws IOException, InterruptedException {
            process.getOutputStream().close();
            reader.join(5000);
            process.destroy();
            reader.join();
            tell(name, "first " + (int) WARM + " s", heard.stream().filter(each -> each[0] < WARM).mapToDouble(each -> each[1]).toArray());
            tell(name, "then", heard.stream().filter(each -> each[0] >= WARM).mapToDouble(each -> each[1]).toArray());
        }

        private static void tell(String name, String when, double[] milliseconds) {
            Arrays.sort(milliseconds);
            int n = milliseconds.length;
            if (n > 0) {
                System.out.printf(Locale.ROOT, "| %s | %s | %d | %.1f | %.1f | %.1f | %.1f |%n", name, when, n, milliseconds[n / 2],
                        milliseconds[n * 9 / 10], milliseconds[n * 99 / 100], milliseconds[n - 1]);
            }
        }
    }

    private static void send(List<Peer> peers, double seconds, int seats) throws IOException {
        long start = System.nanoTime();
        for (int i = 0; i < seconds * RATE; i++) {
            long due = start + (long) (1e9 * i / RATE);
            while (System.nanoTime() < due) {
                LockSupport.parkNanos(due - System.nanoTime());
            }
            for (int seat = 0; seat < seats; seat++) {
                byte[] row = row(seat, i);
                for (Peer peer : peers) {
                    peer.send(seat, i, row);
                }
            }
        }
    }

    /** Someone who looks at the page. */
    private static void look(String url) {
        while (true) {
            try (InputStream in = URI.create(url).toURL().openStream()) {
                in.transferTo(OutputStream.nullOutputStream());
                return;
            } catch (IOException notYet) {
                LockSupport.parkNanos(200_000_000);
            }
        }
    }

    private static byte[] row(int seat, int i) {
        double u = Math.sin(0.45 * i + seat) + 0.7 * Math.sin(0.21 * i * (1 + 0.0001 * i));
        return String.format(Locale.ROOT, "{\"seat\":\"%d\",\"t\":%.6f,\"platform.acc.z\":%.6f,\"head.acc.z\":%.6f,\"seat.acc.x\":%.6f,"
                + "\"seat.acc.y\":%.6f,\"seat.acc.z\":%.6f}%n", seat, i / RATE, u, 1.3 * u + 0.2 * Math.sin(0.9 * i), 0.1 * u, 0.2 * u, u)
                .getBytes(StandardCharsets.UTF_8);
    }

    /** A seat's sample, whose time is a multiple of the interval between samples. */
    private static long key(int seat, double time) {
        return (long) seat << 32 | Math.round(time * RATE);
    }
}
