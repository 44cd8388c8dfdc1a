package wbv.live;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.LongSupplier;
import wbv.filter.EstimatorDesign;
import wbv.filter.Method;
import wbv.filter.model.Spec;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;
import wbv.recording.format.RowLines;
import wbv.recording.inspect.Severity;
import wbv.seat.Packet;
import wbv.seat.SeatPlan;
import wbv.seat.SeatResult;

/**
 * A live stream: lines in, from one source or several; what is known of every seat out, as lines of JSON and for those who look.
 * One thread at a time is inside. A line that cannot be read is counted, told and put aside, and the stream goes on; memory is
 * bounded by the number of seats, whatever senders say.
 */
public final class LiveStream implements LineSource.Receiver {

    /** Takes what is told. */
    public interface Lines {

        /** A line of JSON, without its end. */
        void line(String text);

        /** All that can be told for now was told. */
        default void flush() {}
    }

    /** The seat of rows that name none. */
    public static final String ONLY = "seat";
    /** Senders whose headers are remembered. */
    private static final int MOST_SENDERS = 1024;
    private static final int MOST_NOTICES = 200;
    /** Silence that is told [ns]. */
    private static final long SILENCE = 3_000_000_000L;

    private final LiveSettings settings;
    private final Lines out;
    private final Aside aside;
    private final LongSupplier clock;
    private final Optional<Keep> keep;
    private final Map<String, RowLines> senders = new LinkedHashMap<>(16, 0.75f, true);
    private final Map<String, LiveSeat> seats = new LinkedHashMap<>();
    private final Map<Object, SeatPlan> plans = new HashMap<>();
    private final Set<LiveSeat> touched = new LinkedHashSet<>();
    private final Deque<Notice> notices = new ArrayDeque<>();
    private final LiveSeat.Listener listener = new Telling();
    private final String run = Long.toHexString(new java.security.SecureRandom().nextLong());
    private String source = "";
    private long told;
    private long lines;
    private long rows;
    private long unreadable;
    private long refused;
    private double time = Double.NaN;
    private boolean ended;

    /**
     * A stream whose seats are forgotten when the program ends.
     *
     * @param out   takes lines of JSON, without their ends
     * @param aside takes lines that cannot be read
     * @param clock tells the time that passes [ns]
     */
    public LiveStream(LiveSettings settings, Lines out, Aside aside, LongSupplier clock) {
        this(settings, out, aside, Optional.empty(), clock);
    }

    /**
     * A stream that can go on where it ended.
     *
     * @param keep where seats are kept over the end of the program; empty for nowhere
     */
    public LiveStream(LiveSettings settings, Lines out, Aside aside, Optional<Keep> keep, LongSupplier clock) {
        this.settings = settings;
        this.out = out;
        this.aside = aside;
        this.keep = keep;
        this.clock = clock;
    }

    /**
     * Goes on where the program was when it ended.
     *
     * @throws DataFault if what was kept is damaged, or was kept with other options
     */
    public synchronized void resume() throws IOException {
        if (keep.isEmpty()) {
            return;
        }
        Optional<String> wrong = keep.get().restore(new Keep.Restored() {
            @Override
            public LiveSeat seat(String name, double rate, List<Channel> channels, int sensors) {
                LiveSeat seat = LiveSeat.kept(name, rate, channels, sensors, LiveStream.this::plan, listener, clock.getAsLong());
                seats.put(name, seat);
                return seat;
            }

            @Override
            public Optional<LiveSeat> known(String name) {
                return LiveStream.this.seat(name);
            }
        });
        out.flush();
        keep.get().save(kept(), clock.getAsLong());
        for (LiveSeat seat : kept()) {
            out.line(Records.seat(seat));
        }
        wrong.ifPresent(words -> notice("", time, Severity.WARNING, "state", words, "the rest goes on", false));
    }

    /** Seats that have begun. */
    private List<LiveSeat> kept() {
        return seats.values().stream().filter(LiveSeat::begun).toList();
    }

    @Override
    public synchronized void line(String sender, String seat, byte[] text, int from, int to) {
        lines++;
        try {
            RowLines reader = senders.get(sender);
            if (reader == null) {
                reader = sender(sender);
            }
            reader.accept(text, from, to, (own, channels, row) -> row(own.isEmpty() ? seat : own, channels, row));
        } catch (DataFault wrong) {
            putAside(wrong.getMessage(), text, from, to);
        }
    }

    private RowLines sender(String sender) {
        if (senders.size() == MOST_SENDERS) {
            senders.remove(senders.keySet().iterator().next());
        }
        RowLines reader = new RowLines(sender, settings.reading());
        settings.columns().ifPresent(header -> {
            byte[] named = header.getBytes(StandardCharsets.UTF_8);
            reader.accept(named, 0, named.length, (own, channels, row) -> {});
        });
        senders.put(sender, reader);
        return reader;
    }

    @Override
    public synchronized void tooLong(String sender, byte[] start, int length) {
        lines++;
        putAside(sender + ": a line is longer than " + StreamSource.LONGEST + " bytes; this is no row", start, 0, Math.min(length, 1024));
    }

    @Override
    public synchronized void idle() {
        if (keep.isPresent()) { // what a sender holds for taken is taken
            touched.forEach(LiveSeat::send);
        }
        touched.clear();
        aside.flush();
        out.flush();
        keep.ifPresent(Keep::told);
        if (keep.isPresent() && keep.get().due(clock.getAsLong())) {
            keep.get().save(kept(), clock.getAsLong());
        }
    }

    private void putAside(String why, byte[] text, int from, int to) {
        unreadable++;
        aside.put(text, from, to);
        if (unreadable <= 5 || Long.bitCount(unreadable) == 1) { // the first few, then at every doubling
            notice("", time, Severity.WARNING, "unreadable", why + (unreadable > 5 ? " (" + unreadable + " lines up to now)" : ""),
                    "the line is put aside, the stream goes on", false);
        }
    }

    private void row(String name, List<Channel> channels, double[] row) {
        rows++;
        String whose = name.isEmpty() ? ONLY : name;
        LiveSeat seat = seats.get(whose);
        if (seat == null) {
            if (seats.size() == settings.mostSeats()) {
                refuse(whose);
                return;
            }
            if (whose.codePoints().anyMatch(Character::isISOControl) || whose.getBytes(StandardCharsets.UTF_8).length > 128) {
                throw new DataFault("a seat's name has 1 to 128 bytes of UTF-8 and no control characters");
            }
            seat = new LiveSeat(whose, settings.reading().rate(), this::plan, listener);
            seats.put(whose, seat);
        }
        time = Double.isNaN(time) ? row[0] : Math.max(time, row[0]);
        touched.add(seat);
        seat.accept(channels, row, clock.getAsLong());
    }

    private void refuse(String name) {
        refused++;
        if (Long.bitCount(refused) == 1) {
            notice("", time, Severity.WARNING, "seats", "there are " + settings.mostSeats() + " seats already: rows of '" + name
                    + "' are not taken (" + refused + " rows up to now)", "allow more by --seats", false);
        }
    }

    private SeatPlan plan(double rate, List<Channel> channels) {
        Object key = List.of(rate, channels);
        SeatPlan plan = plans.get(key);
        if (plan == null) {
            plan = made(rate, channels);
            if (plans.size() > 64) {
                plans.clear();
            }
            plans.put(key, plan);
        }
        return plan;
    }

    /** The usual plan, but for what was asked for. */
    private SeatPlan made(double rate, List<Channel> channels) {
        SeatPlan usual = SeatPlan.usual(rate, channels, settings.method(), settings.boxcar(), settings.states());
        Optional<Channel> input = settings.input().or(() -> usual.bodies().stream().map(SeatPlan.Body::input).findFirst());
        List<Channel> outputs = settings.outputs().isEmpty() ? usual.bodies().stream().map(SeatPlan.Body::output).toList()
                : settings.outputs();
        if (!outputs.isEmpty() && input.isEmpty()) {
            throw new DataFault("nothing shakes " + outputs.get(0) + ": name an --input; there are " + channels);
        }
        List<SeatPlan.Body> bodies = outputs.stream().map(output -> body(rate, input.orElseThrow(), output)).toList();
        Optional<String> place = settings.place()
                .or(() -> usual.axes().values().stream().map(column -> channels.get(column).location()).findFirst());
        int interval = (int) Math.max(1, Math.round(settings.every() * rate));
        return new SeatPlan(rate, channels, bodies, place, settings.boxcar(), usual.states(), interval);
    }

    private SeatPlan.Body body(double rate, Channel input, Channel output) {
        Spec spec = input.quantity() == Quantity.ANGULAR_RATE ? Spec.rotary(rate) : Spec.at(rate);
        if (output.equals(input) || output.quantity() != input.quantity()) {
            throw new DataFault(output + " cannot answer " + input + ": input and output are two accelerations or two angular rates");
        }
        return new SeatPlan.Body(input, output, EstimatorDesign.of(settings.method()), spec);
    }

    /** What seats tell. */
    private final class Telling implements LiveSeat.Listener {

        @Override
        public void planned(LiveSeat seat) {
            out.line(Records.seat(seat));
            keep.ifPresent(kept -> kept.seat(seat));
        }

        @Override
        public void packet(Packet packet) {
            keep.ifPresent(kept -> kept.packet(packet));
        }

        @Override
        public void result(LiveSeat seat, SeatResult result) {
            out.line(Records.result(result));
        }

        @Override
        public void notice(LiveSeat seat, double at, Severity severity, String kind, String reason, String advice, boolean over) {
            LiveStream.this.notice(seat.name(), at, severity, kind, reason, advice, over);
        }
    }

    private void notice(String seat, double at, Severity severity, String kind, String reason, String advice, boolean over) {
        Notice notice = new Notice(++told, seat, at, severity, kind, reason, advice, over);
        if (notices.size() == MOST_NOTICES) {
            notices.removeFirst();
        }
        notices.addLast(notice);
        out.line(Records.notice(notice));
    }

    /** Time passes while nothing may come: called now and then. */
    public synchronized void tick() {
        if (!ended) {
            long now = clock.getAsLong();
            seats.values().forEach(seat -> seat.tick(now, SILENCE));
            out.flush();
        }
    }

    /** Something happened to the whole stream. */
    public synchronized void tell(Severity severity, String kind, String reason, String advice) {
        notice("", time, severity, kind, reason, advice, false);
    }

    /**
     * Begins: tells where samples come from.
     *
     * @param version of the program
     */
    public synchronized void begin(String from, String version) {
        source = from;
        out.line(Records.begin(from, version));
    }

    /** The stream ended: what waits is taken. */
    public synchronized void finish() {
        if (ended) {
            return;
        }
        seats.values().forEach(LiveSeat::finish);
        ended = true;
        out.flush();
        keep.ifPresent(kept -> kept.save(kept(), clock.getAsLong()));
        out.line(Records.end(this));
        idle();
    }

    /** What someone is shown who looks at a seat, or at none. */
    public PageServer.Feed feed(String seat) {
        return new Board(this, seat);
    }

    /** Latest time by any sensor's clock [s]; NaN before the first row. */
    public synchronized double time() {
        return time;
    }

    /** Lines that came. */
    public synchronized long lines() {
        return lines;
    }

    /** Rows that were read. */
    public synchronized long rows() {
        return rows;
    }

    /** Lines that could not be read. */
    public synchronized long unreadable() {
        return unreadable;
    }

    /** Rows of seats that were too many. */
    public synchronized long refused() {
        return refused;
    }

    /** Number of seats. */
    public synchronized int seats() {
        return seats.size();
    }

    /** A word that is another after each start of the program. */
    String run() {
        return run;
    }

    /** Where samples come from, as {@link #begin} was told. */
    public synchronized String source() {
        return source;
    }

    boolean ended() {
        return ended;
    }

    List<LiveSeat> all() {
        return new ArrayList<>(seats.values());
    }

    Optional<LiveSeat> seat(String name) {
        return Optional.ofNullable(seats.get(name));
    }

    /** Notices after one of a number, in order, as far as they are still held. */
    List<Notice> noticesAfter(long number) {
        return notices.stream().filter(notice -> notice.number() > number).toList();
    }

    Method method() {
        return settings.method();
    }
}
