package wbv.live;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.inspect.RowClock;
import wbv.recording.inspect.Severity;
import wbv.seat.Packet;
import wbv.seat.Seat;
import wbv.seat.SeatAlarm;
import wbv.seat.SeatPlan;
import wbv.seat.SeatResult;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * One seat of a live stream: rows as they come, laid on their clock and watched, go in packets to a {@link Seat}; what that tells is
 * kept for who looks. The first rows wait until their rate is known.
 */
final class LiveSeat {

    /** Who is told. */
    interface Listener {

        /** The rate is known, and what will be done. */
        void planned(LiveSeat seat);

        /** A packet is about to be taken. */
        void packet(Packet packet);

        void result(LiveSeat seat, SeatResult result);

        void notice(LiveSeat seat, double time, Severity severity, String kind, String reason, String advice, boolean over);
    }

    /** Makes plans; seats alike share one. */
    interface Planner {

        /** @throws DataFault if nothing can be done with these channels */
        SeatPlan plan(double rate, List<Channel> channels);
    }

    /** Rows of all sensors that may wait for the rate. */
    private static final int MOST_EARLY = 4096;
    private static final int MOST_CHANNELS = 512;
    /** Share by which a clock may be off before it is told: a hundred times what a quartz is. */
    private static final double OFF = 0.005;
    /** How often the same kind of thing is told each time. */
    private static final int OFTEN = 20;

    private final String name;
    private final Planner planner;
    private final Listener listener;
    private RowClock clock;
    private final Map<List<Channel>, int[]> known = new IdentityHashMap<>();
    private final List<List<Channel>> lists = new ArrayList<>();
    private final List<Channel> channels = new ArrayList<>();
    private final List<double[]> early = new ArrayList<>();
    private double[] whole = {};
    private Joiner joiner;
    private int sensors = 1;
    private Watch watch;
    private Seat seat;
    private Curves curves;
    private Packing packing;
    private long rows;
    private long repeated;
    private long late;
    private long missing;
    private long restarts;
    private double time = Double.NaN;
    private long heard;
    private boolean silent;
    private final Map<String, Long> kinds = new HashMap<>();
    private boolean offTold;
    private boolean missingTold;
    private boolean refused;

    LiveSeat(String name, OptionalDouble rate, Planner planner, Listener listener) {
        this.name = name;
        this.planner = planner;
        this.listener = listener;
        this.clock = new RowClock(rate);
    }

    /**
     * Takes a row.
     *
     * @param of its channels, the same list for rows alike
     * @param row time, then the channels. Not kept.
     * @param now [ns]
     */
    void accept(List<Channel> of, double[] row, long now) {
        heard = now;
        if (silent) {
            silent = false;
            tell(Severity.NOTE, "silent", "samples come again", "", true);
        }
        if (refused) {
            return;
        }
        int[] columns = known.computeIfAbsent(of, this::columns);
        if (seat == null) {
            learn(of, columns, row);
            return;
        }
        Arrays.fill(whole, Double.NaN);
        spread(columns, row, whole);
        if (joiner == null) {
            place(whole);
        } else {
            joiner.accept(whole, this::place);
        }
    }

    /** Where the channels of a list stand in a whole row; -1 for one that is not taken. */
    private int[] columns(List<Channel> of) {
        if (known.size() > 256) {
            known.clear(); // a sender that names its columns anew with each row must not fill the memory
        }
        List<Channel> unknown = of.stream().filter(channel -> !channels.contains(channel)).toList();
        if (seat == null && channels.size() + unknown.size() <= MOST_CHANNELS) {
            channels.addAll(unknown);
            lists.add(of);
        } else if (!unknown.isEmpty()) {
            tell(Severity.WARNING, "channels",
                    unknown.get(0) + (unknown.size() > 1 ? " and " + (unknown.size() - 1) + " more channels" : "")
                            + " came after the seat had begun and are not taken",
                    "send all channels from the beginning", false);
        }
        return of.stream().mapToInt(channels::indexOf).toArray();
    }

    private static void spread(int[] columns, double[] row, double[] into) {
        into[0] = row[0];
        for (int i = 0; i < columns.length; i++) {
            if (columns[i] >= 0) {
                into[1 + columns[i]] = row[1 + i];
            }
        }
    }

    private void learn(List<Channel> of, int[] columns, double[] row) {
        double[] kept = new double[1 + channels.size()];
        Arrays.fill(kept, Double.NaN);
        spread(columns, row, kept);
        early.add(kept);
        boolean ofTheFirst = of == lists.get(0);
        if (ofTheFirst && clock.learn(row[0])) {
            begin();
        } else if (early.size() == MOST_EARLY) {
            if (clock.learnNow()) {
                begin();
            } else {
                early.clear();
            }
        }
    }

    private void begin() {
        double rate = clock.rate();
        SeatPlan plan;
        try {
            plan = planner.plan(rate, List.copyOf(channels));
        } catch (DataFault cannot) {
            refused = true;
            early.clear();
            tell(Severity.FAULT, "refused", cannot.getMessage(), "", false);
            return;
        }
        long apart = lists.stream().filter(each -> lists.stream().noneMatch(other -> other != each && other.containsAll(each)
                && (other.size() > each.size() || lists.indexOf(other) < lists.indexOf(each)))).count();
        prepare(plan, (int) apart);
        listener.planned(this);
        if (clock.jitter() > 0) {
            tell(Severity.WARNING, "jitter",
                    String.format(Locale.ROOT, "times jitter by up to %.3g ms; rows are taken as even", 1e3 * clock.jitter() / 2),
                    "send the sensor's own clock", false);
        }
        for (double[] row : early) {
            double[] padded = Arrays.copyOf(row, whole.length);
            Arrays.fill(padded, row.length, padded.length, Double.NaN);
            if (joiner == null) {
                place(padded);
            } else {
                joiner.accept(padded, this::place);
            }
        }
        early.clear();
    }

    /** @param apart how many sensors send apart */
    private void prepare(SeatPlan plan, int apart) {
        double rate = plan.rate();
        whole = new double[1 + channels.size()];
        seat = new Seat(name, plan);
        watch = new Watch(plan.channels(), rate, this::tell);
        curves = new Curves(plan);
        seat.show(curves);
        packing = new Packing(name, rate, channels.size(), this::take);
        sensors = apart;
        joiner = apart > 1 ? new Joiner(rate, whole.length, apart) : null;
    }

    /**
     * A seat that was kept, before its state is loaded.
     *
     * @throws DataFault if nothing can be done with it any more
     */
    static LiveSeat kept(String name, double rate, List<Channel> channels, int apart, Planner planner, Listener listener, long now) {
        LiveSeat kept = new LiveSeat(name, OptionalDouble.of(rate), planner, listener);
        kept.channels.addAll(channels);
        kept.heard = now;
        kept.prepare(planner.plan(rate, List.copyOf(channels)), apart);
        kept.clock = RowClock.resumed(rate, Double.NaN);
        return kept;
    }

    /**
     * Takes a packet that was taken before the program ended.
     *
     * @param aloud whether its results are told
     */
    void again(Packet packet, boolean aloud) {
        seat.accept(packet, aloud ? this::told : curves::remember);
        resume(packet.counter() + 1, packet.end());
    }

    private void resume(long number, double due) {
        time = due - 1 / clock.rate();
        clock = RowClock.resumed(clock.rate(), time);
        packing.goOn(number, due);
    }

    /** Writes what {@link #load} reads; a packet that is not full is not in it. */
    void save(StateWriter out) {
        out.put(packing.counter());
        out.put(packing.due());
        out.put(seat);
    }

    void load(StateReader in) {
        long number = in.count();
        double due = in.number();
        in.part(seat);
        if (Double.isNaN(due)) {
            packing.goOn(number, due);
        } else {
            resume(number, due);
        }
    }

    /** Takes a whole row. */
    private void place(double[] row) {
        rows++;
        switch (clock.place(row[0])) {
            case REPEATED -> repeated++;
            case LATE -> late++;
            case RESTARTED -> {
                restarts++;
                packing.restart();
                tell(Severity.WARNING, SeatAlarm.Kind.SENSOR_RESTARTED.word(),
                        "the sensor's clock jumped by " + (float) (row[0] - time) + " s", "it is followed from there", false);
                take(row);
            }
            default -> {
                for (long i = 0; i < clock.missing(); i++) {
                    missing++;
                    packing.miss();
                }
                take(row);
            }
        }
        time = row[0];
        judge();
    }

    private void take(double[] row) {
        watch.accept(row);
        if (seat.plan().bodies().isEmpty()) {
            curves.draw(row[0], row[1 + channels.indexOf(drawnAlone())]);
        }
        packing.take(row);
    }

    /** Sends a packet of what there is, full or not. */
    void send() {
        if (seat != null) {
            packing.send();
        }
    }

    private void take(Packet full) {
        listener.packet(full);
        seat.accept(full, this::told);
    }

    private void told(SeatResult result) {
        curves.remember(result);
        listener.result(this, result);
        tellAlarms(result);
    }

    private void tellAlarms(SeatResult result) {
        for (SeatAlarm alarm : result.alarms()) {
            if (alarm.kind() == SeatAlarm.Kind.SENSOR_RESTARTED) {
                continue; // told when its clock was seen to jump
            }
            if (ofTheBody(alarm) && seat.plan().bodies().stream()
                    .anyMatch(body -> watch.ails(body.output().location()) || watch.ails(body.input().location()))) {
                continue; // a sensor that fails was told already; what an estimator makes of it is nothing of the body
            }
            Severity severity = switch (alarm.kind()) {
                case LIMIT_VALUE -> Severity.FAULT;
                case ACTION_VALUE, SENSOR_RESTARTED, SAMPLES_LOST -> Severity.WARNING;
                default -> Severity.NOTE;
            };
            if (alarm.kind() == SeatAlarm.Kind.ESTIMATE_LOST) { // where there is no body it happens for ever
                tell(severity, alarm.kind().word(), alarm.reason(), "", false);
            } else {
                listener.notice(this, alarm.time(), severity, alarm.kind().word(), alarm.reason(), "", false);
            }
        }
    }

    private static boolean ofTheBody(SeatAlarm alarm) {
        return alarm.kind() == SeatAlarm.Kind.BODY_CHANGED || alarm.kind() == SeatAlarm.Kind.ESTIMATE_LOST;
    }

    private void judge() {
        if (!offTold && rows % 4096 == 0 && Math.abs(clock.measured() / clock.rate() - 1) > OFF) {
            offTold = true;
            tell(Severity.WARNING, "rate",
                    String.format(Locale.ROOT, "rows come at %.5g Hz; %.5g Hz was learned from the first", clock.measured(),
                            clock.rate()),
                    "say the rate by --rate, or begin anew", false);
        }
        if (!missingTold && missing > 0.05 * rows && rows > 10 * clock.rate()) {
            missingTold = true;
            tell(Severity.WARNING, "losses",
                    String.format(Locale.ROOT, "%.0f %% of the samples are missing", 100.0 * missing / (missing + rows)),
                    "a nearer receiver or a cable avoids losses; nothing is made up for them", false);
        }
    }

    /** Tells; what happens again and again is told at every doubling. */
    private void tell(Severity severity, String kind, String reason, String advice, boolean over) {
        long times = kinds.merge(kind, 1L, Long::sum);
        if (times <= OFTEN || Long.bitCount(times) == 1) {
            listener.notice(this, time, severity, kind, times <= OFTEN ? reason : reason + " (" + times + " times up to now)", advice,
                    over);
        }
    }

    /**
     * Time passes.
     *
     * @param now [ns]
     * @param longest silence that needs no telling [ns]
     */
    void tick(long now, long longest) {
        if (!silent && now - heard > longest) {
            silent = true;
            tell(Severity.WARNING, "silent", String.format(Locale.ROOT, "no sample has come for %.0f s", (now - heard) / 1e9),
                    "check the sensor, its battery and its way here", false);
        }
    }

    /** The stream ended. */
    void finish() {
        if (seat == null && !refused && clock.learnNow()) {
            begin();
        }
        if (seat != null) {
            if (joiner != null) {
                joiner.flush(this::place);
            }
            send();
            seat.flush(this::told);
        }
    }

    String name() {
        return name;
    }

    /** Whether the rate is known and work has begun. */
    boolean begun() {
        return seat != null;
    }

    SeatPlan plan() {
        return seat.plan();
    }

    List<Channel> channels() {
        return List.copyOf(channels);
    }

    /** How many sensors send apart. */
    int sensors() {
        return sensors;
    }

    double rate() {
        return clock.rate();
    }

    /** The last result; empty before the first. */
    Optional<SeatResult> latest() {
        return begun() ? curves.latest() : Optional.empty();
    }

    /** What is drawn where no body is followed: the last axis of the seat, its vertical where that is measured. */
    Channel drawnAlone() {
        return channels.get(seat.plan().axes().values().stream().reduce((one, other) -> other).orElse(0));
    }

    /** What is kept for who looks, once it has begun. */
    Curves curves() {
        return curves;
    }

    Watch watch() {
        return watch;
    }

    /** Time of the last row by the sensor's clock [s]; NaN before the first. */
    double time() {
        return time;
    }

    boolean silent() {
        return silent;
    }

    boolean refused() {
        return refused;
    }

    long rows() {
        return rows;
    }

    /** Rows that repeated a time or fell on a sample that was there. */
    long repeated() {
        return repeated;
    }

    /** Rows that came after later ones, and were left out. */
    long late() {
        return late;
    }

    /** Samples that never came. */
    long missing() {
        return missing;
    }

    long restarts() {
        return restarts;
    }
}
