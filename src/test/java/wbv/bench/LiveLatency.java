package wbv.bench;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
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
 * lines back, and beside it the same rows through {@code cat}, which says what the machine alone takes.
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

    private LiveLatency() { }

    public static void main(String[] words) throws IOException, InterruptedException {
        double seconds = Double.parseDouble(words[0]);
        int seats = Integer.parseInt(words[1]);
        List<String> live = new ArrayList<>(List.of(System.getProperty("wbv", "./wbv"), "live", "-", "--every", "0.1"));
        live.addAll(List.of(words).subList(2, words.length));
        System.out.println("| process | when | results | p50 [ms] | p90 | p99 | greatest |\n|---|---|---|---|---|---|---|");
        measure("`cat`", List.of("cat"), seconds, seats);
        measure("`wbv live`", live, seconds, seats);
    }

    /** Sends rows and hears lines back. */
    private static void measure(String name, List<String> command, double seconds, int seats) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT).start();
        Map<Long, Long> sent = new ConcurrentHashMap<>();
        List<double[]> heard = new ArrayList<>();
        Thread reader = new Thread(() -> hear(process, sent, heard));
        reader.start();
        try (OutputStream out = process.getOutputStream()) {
            long start = System.nanoTime();
            for (int i = 0; i < seconds * RATE; i++) {
                long due = start + (long) (1e9 * i / RATE);
                while (System.nanoTime() < due) {
                    LockSupport.parkNanos(due - System.nanoTime());
                }
                for (int seat = 0; seat < seats; seat++) {
                    sent.put(key(seat, i / RATE), System.nanoTime());
                    out.write(row(seat, i));
                    out.flush();
                }
            }
        }
        reader.join();
        process.waitFor();
        tell(name, "first " + (int) WARM + " s", heard.stream().filter(each -> each[0] < WARM).mapToDouble(each -> each[1]).toArray());
        tell(name, "then", heard.stream().filter(each -> each[0] >= WARM).mapToDouble(each -> each[1]).toArray());
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

    private static void hear(Process process, Map<Long, Long> sent, List<double[]> heard) {
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
            throw new java.io.UncheckedIOException(gone);
        }
    }

    private static void tell(String name, String when, double[] milliseconds) {
        Arrays.sort(milliseconds);
        int n = milliseconds.length;
        if (n > 0) {
            System.out.printf(Locale.ROOT, "| %s | %s | %d | %.1f | %.1f | %.1f | %.1f |%n", name, when, n, milliseconds[n / 2], milliseconds[n * 9 / 10],
                    milliseconds[n * 99 / 100], milliseconds[n - 1]);
        }
    }
}
