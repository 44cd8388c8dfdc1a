package wbv.fleet;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.DoubleConsumer;
import wbv.seat.Seat;
import wbv.seat.SeatPlan;
import wbv.seat.SeatResult;

/**
 * A fleet in one process: round by round the packets of every seat, results in the order of rounds and seats whatever the number of
 * threads. Now and then everything is kept in the folder; a run that was killed, at whatever moment, is gone on with by the next
 * with the same words, and its files come out byte for byte as without.
 */
public final class FleetRun {

    private static final String RESULTS = "results.csv";
    private static final String ALARMS = "alarms.csv";

    private final Replay replay;
    private final SeatPlan plan;
    private final Path folder;
    private final int threads;
    private final double between;
    private final String run;
    private final ResultRows rows;
    private final ThreadMXBean clock = ManagementFactory.getThreadMXBean();

    /**
     * What became of a run.
     *
     * @param samples   of all seats, in this run and those before it that it went on with
     * @param resumed   round that it went on from, 0 for a run from the beginning
     * @param processor time of the threads that followed the seats, in this run [s]
     * @param taken     samples that they took in it
     * @param seats     as they are at the end
     */
    public record Outcome(long samples, int resumed, double processor, long taken, List<SeatResult> seats) {

        public Outcome {
            seats = List.copyOf(seats);
        }

        /** Samples that one core takes in a second. */
        public double samplesPerCore() {
            return taken / processor;
        }
    }

    /** What one thread brought back from its seats in a round. */
    private record Part(StringBuilder results, StringBuilder alarms, long samples, long nanoseconds) { }

    /**
     * @param folder  where results and the state are kept; made where it is not there
     * @param threads &gt;= 1
     * @param between time between two times that everything is kept [s]; 0 keeps it after every round
     */
    public FleetRun(Replay replay, SeatPlan plan, Path folder, int threads, double between) {
        this.replay = replay;
        this.plan = plan;
        this.folder = folder;
        this.threads = threads;
        this.between = between;
        this.run = replay.text() + "; " + plan.text();
        this.rows = new ResultRows(plan);
    }

    /**
     * Runs to the end.
     *
     * @param progress told the share that is done, 0 to 1
     * @throws wbv.recording.DataFault if the folder holds the state of another run, or a damaged one
     */
    public Outcome run(DoubleConsumer progress) throws IOException {
        Files.createDirectories(folder);
        Seat[] seats = new Seat[replay.seats()];
        Arrays.setAll(seats, k -> new Seat(replay.name(k), plan));
        Optional<Checkpoint> kept = Checkpoint.read(folder, run, seats);
        Checkpoint from = kept.orElse(new Checkpoint(run, 0, 0, 0, 0));
        int rounds = replay.rounds();
        long taken = 0;
        long nanoseconds = 0;
        if (from.round() <= rounds) {
            try (Workers workers = new Workers(threads);
                    GrowingFile results = new GrowingFile(folder.resolve(RESULTS), from.results());
                    GrowingFile alarms = new GrowingFile(folder.resolve(ALARMS), from.alarms())) {
                if (kept.isEmpty()) {
                    results.write(rows.header());
                    alarms.write(ResultRows.alarmHeader());
                }
                long due = System.nanoTime() + (long) (1e9 * between);
                for (int round = from.round(); round <= rounds; round++) {
                    for (Part part : parts(workers, seats, round)) {
                        results.write(part.results);
                        alarms.write(part.alarms);
                        taken += part.samples;
                        nanoseconds += part.nanoseconds;
                    }
                    if (round == rounds || System.nanoTime() >= due) {
                        new Checkpoint(run, round + 1, results.force(), alarms.force(), from.samples() + taken).write(folder, seats);
                        due = System.nanoTime() + (long) (1e9 * between);
                    }
                    progress.accept((round + 1.0) / (rounds + 1));
                }
            }
        }
        GrowingFile.finish(folder.resolve(RESULTS));
        GrowingFile.finish(folder.resolve(ALARMS));
        Checkpoint.forceFolder(folder);
        Files.delete(Checkpoint.file(folder));
        return new Outcome(from.samples() + taken, from.round(), nanoseconds / 1e9, taken,
                Arrays.stream(seats).map(Seat::now).toList());
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

    /** A round of all seats; after the last the packets that still wait. In the order of the seats. */
    private List<Part> parts(Workers workers, Seat[] seats, int round) throws IOException {
        List<Callable<Part>> work = new ArrayList<>();
        for (int t = 0; t < threads; t++) {
            int from = (int) ((long) seats.length * t / threads);
            int to = (int) ((long) seats.length * (t + 1) / threads);
            work.add(() -> part(seats, from, to, round));
        }
        try {
            List<Part> parts = new ArrayList<>();
            for (Future<Part> done : workers.pool.invokeAll(work)) {
                parts.add(done.get());
            }
            return parts;
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            throw new IOException("the run was interrupted; the same command goes on with it", stopped);
        } catch (ExecutionException failed) {
            throw failed.getCause() instanceof RuntimeException cause ? cause : new IllegalStateException(failed.getCause());
        }
    }

    private Part part(Seat[] seats, int from, int to, int round) {
        long before = clock.getCurrentThreadCpuTime();
        StringBuilder results = new StringBuilder();
        StringBuilder alarms = new StringBuilder();
        long[] samples = new long[1];
        for (int k = from; k < to; k++) {
            Seat seat = seats[k];
            if (round == replay.rounds()) {
                seat.flush(result -> write(result, results, alarms));
            } else {
                replay.packets(k, round, packet -> {
                    samples[0] += packet.samples();
                    seat.accept(packet, result -> write(result, results, alarms));
                });
            }
        }
        return new Part(results, alarms, samples[0], clock.getCurrentThreadCpuTime() - before);
    }

    private void write(SeatResult result, StringBuilder results, StringBuilder alarms) {
        rows.write(result, results);
        result.alarms().forEach(alarm -> ResultRows.write(result.seat(), alarm, alarms));
    }
}
