package wbv.bench;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import wbv.filter.Method;
import wbv.fleet.Replay;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;
import wbv.seat.Packet;
import wbv.seat.Seat;
import wbv.seat.SeatPlan;
import wbv.state.StateModel;
import wbv.state.StateModelFile;

/**
 * What each part of a seat costs a sample, in processor time: seats of a fleet, packet after packet of one second, round after round,
 * so that no seat's state lies in the processor's cache when its turn comes. Prints a table for {@code docs/benchmarks.md}, of the
 * rows that are named or of all.
 */
public final class SeatTable {

    private static final int SEATS = 1000;
    private static final int ROUNDS = 8;
    private static final int TURNS = 5;
    private static final int EVERY = 600;
    private static final List<String> ALL = List.of("platform.acc.z", "head.acc.z", "seat.acc.x", "seat.acc.y", "seat.acc.z");

    private final ThreadMXBean clock = ManagementFactory.getThreadMXBean();
    private final Recording ride;
    private double sink;

    private SeatTable() throws IOException {
        ride = new RecordingFile(Path.of("data/arff/ride-subject1.arff")).load();
    }

    public static void main(String[] words) throws IOException {
        SeatTable table = new SeatTable();
        double rate = table.ride.clock().rate();
        StateModel states = StateModelFile.shipped();
        Map<String, SeatPlan> rows = new LinkedHashMap<>();
        List<Channel> body = channels(ALL.subList(0, 2));
        for (String method : List.of("ekf", "ekf-adwin", "constrained")) {
            rows.put(method, new SeatPlan(rate, body, bodies(rate, method), Optional.empty(), false, Optional.empty(), EVERY));
        }
        List<Channel> axes = channels(ALL.subList(2, 5));
        rows.put("one-axis", SeatPlan.usual(rate, axes.subList(2, 3), Method.EKF, false, Optional.empty(), EVERY));
        rows.put("three-axes", SeatPlan.usual(rate, axes, Method.EKF, false, Optional.empty(), EVERY));
        List<Channel> motion = states.features().channels();
        rows.put("states", new SeatPlan(rate, motion, List.of(), Optional.empty(), false, Optional.of(states), EVERY));
        for (String method : List.of("ekf", "ekf-adwin")) {
            List<Channel> needed = SeatPlan.usual(rate, table.ride.channels(), Method.named(method).orElseThrow(), false,
                    Optional.of(states), EVERY).needed();
            rows.put("all-" + method, SeatPlan.usual(rate, needed, Method.named(method).orElseThrow(), false, Optional.of(states), EVERY));
        }
        System.out.println("| seat | µs a sample | samples/s a core | seats at 60 Hz a core |\n|---|---|---|---|");
        List<String> wanted = words.length == 0 ? List.copyOf(rows.keySet()) : List.of(words);
        for (String name : wanted) {
            double microseconds = table.time(rows.get(name));
            System.out.printf(Locale.ROOT, "| %s | %.2f | %.0f | %.0f |%n", name, microseconds, 1e6 / microseconds,
                    1e6 / rate / microseconds);
        }
        System.err.println(table.sink);
    }

    private static List<SeatPlan.Body> bodies(double rate, String method) {
        return SeatPlan.usual(rate, channels(ALL.subList(0, 2)), Method.named(method).orElseThrow(), false, Optional.empty(), EVERY)
                .bodies();
    }

    private static List<Channel> channels(List<String> names) {
        return names.stream().map(Channel::parse).toList();
    }

    /** Microseconds a sample, the median of the turns; packets are made before the clock starts. */
    private double time(SeatPlan plan) {
        Replay replay = new Replay(List.of(ride), plan.channels(), SEATS, (int) Math.round(plan.rate()), false, 0);
        Seat[] seats = new Seat[SEATS];
        Arrays.setAll(seats, k -> new Seat(replay.name(k), plan));
        double[] turns = new double[TURNS];
        int round = 0;
        for (int turn = -1; turn < TURNS; turn++) {
            long nanoseconds = 0;
            long samples = 0;
            for (int r = 0; r < ROUNDS && round < replay.rounds(); r++, round++) {
                List<Packet> packets = new ArrayList<>();
                for (int k = 0; k < SEATS; k++) {
                    replay.packets(k, round, packets::add);
                }
                long before = clock.getCurrentThreadCpuTime();
                for (int k = 0; k < SEATS; k++) {
                    seats[k].accept(packets.get(k), result -> sink += result.time());
                    samples += packets.get(k).samples();
                }
                nanoseconds += clock.getCurrentThreadCpuTime() - before;
            }
            if (turn >= 0) {
                turns[turn] = nanoseconds / 1e3 / samples;
            }
        }
        Arrays.sort(turns);
        return turns[TURNS / 2];
    }
}
