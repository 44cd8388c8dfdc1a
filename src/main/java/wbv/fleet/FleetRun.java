package wbv.fleet;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.DoubleConsumer;
import wbv.seat.Packet;
import wbv.seat.Seat;
import wbv.seat.SeatPlan;
import wbv.seat.SeatResult;

/**
 * A fleet in one process: packet by packet in their order, results in the order of the packets whatever the number of threads. Now
 * and then everything is kept in the folder; a run that was killed, at whatever moment, is gone on with by the next with the same
 * words, and its files come out byte for byte as without.
 */
public final class FleetRun {

    private static final String RESULTS = "results.csv";
    private static final String ALARMS = "alarms.csv";
    private static final String UNREAD = "unread.csv";
    /** Packets that are given to the threads together; fewer where everything is kept after each time. */
    private static final int TOGETHER = 4096;
    private static final int TOGETHER_KEPT = 64;

    private final Opening opening;
    private final SeatPlan plan;
    private final double period;
    private final Path folder;
    private final int threads;
    private final double between;
    private final ResultRows rows;
    private final ThreadMXBean clock = ManagementFactory.getThreadMXBean();

    /** Opens packets at a place. */
    private interface Opening {
        Feed at(Feed.Place place) throws IOException;
    }

    /**
     * What became of a run.
     *
     * @param samples   of all seats, in this run and those before it that it went on with
     * @param resumed   packets before those of this run, 0 for a run from the beginning
     * @param processor time of the threads that read the packets and followed the seats, in this run [s]
     * @param taken     samples that they took in it
     * @param unread    packets that could not be read, or were of another plan
     * @param seats     as they are at the end, in the order of their names
     */
    public record Outcome(long samples, long resumed, double processor, long taken, boolean unread, List<SeatResult> seats) {

        public Outcome {
            seats = List.copyOf(seats);
        }

        /** Samples that one core takes in a second [1/s]. */
        public double samplesPerCore() {
            return taken / processor;
        }
    }

    /** What came of packets that one thread followed: rows of them all, and where those of each end. */
    private static final class Part {

        private final StringBuilder results = new StringBuilder();
        private final StringBuilder alarms = new StringBuilder();
        private final StringBuilder unread = new StringBuilder();
        private final List<int[]> ends = new ArrayList<>();
        private int[] told = new int[3];
        private int next;
        private long samples;
        private long nanoseconds;

        private void mark() {
            ends.add(new int[] {results.length(), alarms.length(), unread.length()});
        }
    }

    /** The three files that grow. */
    private record Output(GrowingFile results, GrowingFile alarms, GrowingFile unread) {}

    /**
     * A run of a replay.
     *
     * @param folder  where results and the state are kept; made where it is not there
     * @param threads &gt;= 1
     * @param between time between two times that everything is kept [s]; 0 keeps it after every few packets
     */
    public FleetRun(Replay replay, SeatPlan plan, Path folder, int threads, double between) {
        this(place -> new ReplayFeed(replay, place), FleetOrder.HOUR, plan, folder, threads, between);
    }

    /**
     * A run of an order.
     *
     * @param between time between two times that everything is kept [s]
     * @param order of packets that are replayed or in files
     * @param plan  of it
     */
    public FleetRun(FleetOrder order, SeatPlan plan, Path folder, int threads, double between) {
        this(opening(order), order.period(), plan, folder, threads, between);
    }

    private FleetRun(Opening opening, double period, SeatPlan plan, Path folder, int threads, double between) {
        this.opening = opening;
        this.period = period;
        this.plan = plan;
        this.folder = folder;
        this.threads = threads;
        this.between = between;
        this.rows = new ResultRows(plan);
    }

    private static Opening opening(FleetOrder order) {
        if (order.source() instanceof FleetSource.Packets given) {
            return place -> new FileFeed(given.files(), place);
        }
        Replay replay = order.replay();
        return place -> new ReplayFeed(replay, place);
    }

    /**
     * Runs to the end.
     *
     * @param progress told the share that is done, 0 to 1
     * @throws wbv.recording.DataFault if the folder holds the state of another run, or a damaged one
     */
    public Outcome run(DoubleConsumer progress) throws IOException {
        Files.createDirectories(folder);
        Map<String, Seat> seats = new HashMap<>();
        String run;
        try (Feed feed = opening.at(Feed.Place.BEGINNING)) {
            run = feed.text() + "; " + plan.text();
        }
        Optional<Checkpoint> kept = Checkpoint.read(folder, run, name -> seat(seats, name));
        Checkpoint from = kept.orElse(new Checkpoint(run, Feed.Place.BEGINNING, false, 0, 0, 0, 0));
        long taken = 0;
        long nanoseconds = 0;
        long unread = from.unread();
        if (!from.ended()) {
            try (Workers workers = new Workers(threads);
                    Feed feed = opening.at(from.place());
                    GrowingFile results = new GrowingFile(folder.resolve(RESULTS), from.results());
                    GrowingFile alarms = new GrowingFile(folder.resolve(ALARMS), from.alarms());
                    GrowingFile aside = new GrowingFile(folder.resolve(UNREAD), from.unread())) {
                if (kept.isEmpty()) {
                    results.write(rows.header());
                    alarms.write(ResultRows.alarmHeader());
                    aside.write(ResultRows.unreadHeader());
                }
                Output output = new Output(results, alarms, aside);
                long due = System.nanoTime() + (long) (1e9 * between);
                boolean ended = false;
                while (!ended) {
                    long before = clock.getCurrentThreadCpuTime();
                    List<Feed.Sent> sent = together(feed);
                    nanoseconds += clock.getCurrentThreadCpuTime() - before;
                    ended = sent.isEmpty();
                    for (Part part : ended ? List.of(last(seats)) : parts(workers, seats, sent, output)) {
                        taken += part.samples;
                        nanoseconds += part.nanoseconds;
                        if (ended) {
                            write(part, part.ends.get(0), output);
                        }
                    }
                    if (ended || System.nanoTime() >= due) {
                        unread = aside.force();
                        new Checkpoint(run, feed.place(), ended, results.force(), alarms.force(), unread, from.samples() + taken)
                                .write(folder, seats.values());
                        due = System.nanoTime() + (long) (1e9 * between);
                    }
                    progress.accept(feed.share());
                }
            }
        }
        boolean any = unread > ResultRows.unreadHeader().length();
        GrowingFile.finish(folder.resolve(RESULTS));
        GrowingFile.finish(folder.resolve(ALARMS));
        if (any) {
            GrowingFile.finish(folder.resolve(UNREAD));
        } else {
            GrowingFile.forget(folder.resolve(UNREAD));
        }
        new FleetTable(rows.header(), period, plan.rate()).write(folder.resolve(RESULTS), folder);
        Checkpoint.forceFolder(folder);
        Files.delete(Checkpoint.file(folder));
        return new Outcome(from.samples() + taken, from.place().count(), nanoseconds / 1e9, taken, any,
                inOrder(seats).stream().map(Seat::now).toList());
    }

    private Seat seat(Map<String, Seat> seats, String name) {
        return seats.computeIfAbsent(name, each -> new Seat(each, plan));
    }

    private List<Feed.Sent> together(Feed feed) throws IOException {
        List<Feed.Sent> sent = new ArrayList<>();
        int most = between == 0 ? TOGETHER_KEPT : TOGETHER;
        for (Optional<Feed.Sent> next = feed.next(); next.isPresent(); next = feed.next()) {
            sent.add(next.get());
            if (sent.size() == most) {
                break;
            }
        }
        return sent;
    }

    /** Threads that end with the run. */
    private record Workers(ExecutorService pool) implements AutoCloseable {

        private Workers(int threads) {
            this(Executors.newFixedThreadPool(threads));
        }

        @Override
        public void close() {
            pool.shutdownNow();
        }
    }

    /** Follows packets, those of a seat in one thread, and writes what comes of them in their order. */
    private List<Part> parts(Workers workers, Map<String, Seat> seats, List<Feed.Sent> sent, Output output) throws IOException {
        List<List<Feed.Sent>> shares = new ArrayList<>();
        for (int t = 0; t < threads; t++) {
            shares.add(new ArrayList<>());
        }
        int[] whose = new int[sent.size()];
        for (int k = 0; k < whose.length; k++) {
            if (sent.get(k) instanceof Feed.Read read) {
                whose[k] = Math.floorMod(read.packet().seat().hashCode(), threads);
                seat(seats, read.packet().seat());
            }
            shares.get(whose[k]).add(sent.get(k));
        }
        List<Callable<Part>> work = new ArrayList<>();
        shares.forEach(share -> work.add(() -> part(seats, share)));
        try {
            List<Part> parts = new ArrayList<>();
            for (Future<Part> done : workers.pool.invokeAll(work)) {
                parts.add(done.get());
            }
            for (int thread : whose) {
                Part part = parts.get(thread);
                write(part, part.ends.get(part.next++), output);
            }
            return parts;
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            throw new IOException("the run was interrupted; the same command goes on with it", stopped);
        } catch (ExecutionException failed) {
            throw failed.getCause() instanceof RuntimeException cause ? cause : new IllegalStateException(failed.getCause());
        }
    }

    private static void write(Part part, int[] end, Output output) throws IOException {
        write(part.results, part.told[0], end[0], output.results);
        write(part.alarms, part.told[1], end[1], output.alarms);
        write(part.unread, part.told[2], end[2], output.unread);
        part.told = end;
    }

    private static void write(StringBuilder rows, int from, int to, GrowingFile file) throws IOException {
        if (to > from) {
            file.write(rows.subSequence(from, to));
        }
    }

    private Part part(Map<String, Seat> seats, List<Feed.Sent> share) {
        long before = clock.getCurrentThreadCpuTime();
        Part part = new Part();
        for (Feed.Sent each : share) {
            if (each instanceof Feed.Read read) {
                Packet packet = read.packet();
                part.samples += packet.samples();
                if (seats.get(packet.seat()).accept(packet, result -> write(result, part)) == Seat.Taken.REFUSED) {
                    part.unread.append(ResultRows.unread(ResultRows.REFUSED, packet.bytes()));
                }
            } else if (each instanceof Feed.Unread unread) {
                part.unread.append(ResultRows.unread(unread.reason(), unread.bytes()));
            }
            part.mark();
        }
        part.nanoseconds = clock.getCurrentThreadCpuTime() - before;
        return part;
    }

    /** By their names as rows have them, shorter ones first: those with numbers in the order of their numbers. */
    private static List<Seat> inOrder(Map<String, Seat> seats) {
        Map<String, Seat> named = new TreeMap<>(Comparator.comparingInt(String::length).thenComparing(Comparator.naturalOrder()));
        seats.forEach((name, seat) -> named.put(ResultRows.name(name), seat));
        return List.copyOf(named.values());
    }

    /** What seats tell when nothing comes any more. */
    private Part last(Map<String, Seat> seats) {
        Part part = new Part();
        inOrder(seats).forEach(seat -> seat.flush(result -> write(result, part)));
        part.mark();
        return part;
    }

    private void write(SeatResult result, Part part) {
        rows.write(result, part.results);
        result.alarms().forEach(alarm -> ResultRows.write(result.seat(), alarm, part.alarms));
    }
}
