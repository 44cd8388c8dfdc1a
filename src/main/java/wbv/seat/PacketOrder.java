package wbv.seat;

import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * Puts the packets of one seat in order, by counter and sensor time alone.
 *
 * <p>A packet that is due goes on at once; one ahead of it waits until what is missing has come, or until {@value #LONGEST_WAIT} s
 * of sensor time lie behind the gap: then what is missing is lost. A counter below the next has come twice or too late, unless
 * the sensor has begun again: its time is ahead of all before it, or its number is one of the first and its content is not what
 * came under that number. At the beginning packets wait likewise, unless number 0 is among them.
 */
final class PacketOrder {

    /** Sensor time that may pass before what is missing is given up [s]. */
    static final double LONGEST_WAIT = 2;
    /** Packets that wait at most, whatever their times say. */
    private static final int MOST_HELD = 256;
    /** A longer jump of the clock is no loss of samples, but a clock that was set [s]. */
    private static final double LONGEST_GAP = 600;
    /** Numbers after the first of which checksums are kept. */
    private static final int NOTED = 8;

    private final TreeMap<Long, Packet> held = new TreeMap<>();
    private final int[] checksums = new int[NOTED];
    private boolean begun;
    private boolean again;
    private long first;
    private double firstTime;
    private long next;
    private double due;
    /** Bit k: whether packet {@code next - 1 - k} came. */
    private long recent;
    private long reordered;
    private long twice;
    private long late;
    private long lost;

    /** What became of a packet. */
    enum Taken { STEPPED, HELD, TWICE, LATE }

    /** Who takes packets in order. */
    interface Sink {

        /** The next one. */
        void take(Packet packet);

        /**
         * Samples that never came.
         *
         * @param from time of the first of them [s]
         */
        void miss(long samples, double from);

        /**
         * The counter or the clock has begun again.
         *
         * @param time of the next sample by the new clock [s]
         */
        void beginAgain(double time, String reason);
    }

    Taken accept(Packet packet, Sink sink) {
        if (begun && packet.counter() < next) {
            if (!startedAgain(packet)) {
                return older(packet);
            }
            flush(sink);
            begun = false;
            again = true;
        }
        if (held.containsKey(packet.counter())) {
            twice++;
            return Taken.TWICE;
        }
        held.put(packet.counter(), packet);
        release(sink, false);
        if (held.containsKey(packet.counter())) {
            reordered++;
            return Taken.HELD;
        }
        return Taken.STEPPED;
    }

    /** Whether a packet with an old number is a new one. */
    private boolean startedAgain(Packet packet) {
        if (packet.time() > due - 0.5 / packet.rate()) {
            return true;
        }
        long place = packet.counter() - first;
        if (place < 0) {
            boolean justBefore = packet.time() < firstTime && packet.time() >= firstTime - LONGEST_WAIT;
            return !justBefore;
        }
        return place < NOTED && checksums[(int) place] != 0 && checksums[(int) place] != packet.checksum();
    }

    private Taken older(Packet packet) {
        long ago = next - 1 - packet.counter();
        boolean missed = packet.counter() < first || ago < Long.SIZE && (recent >>> ago & 1) == 0;
        if (missed) {
            late++;
            return Taken.LATE;
        }
        twice++;
        return Taken.TWICE;
    }

    /** Gives up what is missing before packets that wait: the seat has fallen silent, or the stream has ended. */
    void flush(Sink sink) {
        release(sink, true);
    }

    private void release(Sink sink, boolean all) {
        while (!held.isEmpty()) {
            Map.Entry<Long, Packet> earliest = held.firstEntry();
            boolean givesUp = all || held.size() > MOST_HELD || waited() > LONGEST_WAIT;
            if (!begun) {
                if (earliest.getKey() != 0 && !givesUp) {
                    return;
                }
                begin(earliest.getValue(), sink);
            } else if (earliest.getKey() != next && !givesUp) {
                return;
            }
            held.pollFirstEntry();
            take(earliest.getValue(), sink);
        }
    }

    /** How much sensor time lies in what waits, or behind what is due [s]. */
    private double waited() {
        Packet latest = held.lastEntry().getValue();
        double sinceFirst = latest.time() - held.firstEntry().getValue().time();
        return begun ? Math.max(sinceFirst, latest.time() - due) : sinceFirst;
    }

    private void begin(Packet packet, Sink sink) {
        if (again) {
            sink.beginAgain(packet.time(), "the sensor began again: packet " + packet.counter() + " after packet " + (next - 1));
        }
        begun = true;
        again = false;
        first = packet.counter();
        firstTime = packet.time();
        next = first;
        due = packet.time();
        recent = -1;
        Arrays.fill(checksums, 0);
    }

    private void take(Packet packet, Sink sink) {
        long missed = packet.counter() - next;
        lost += missed;
        recent = missed < Long.SIZE ? recent << missed : 0;
        double jump = packet.time() - due;
        long samples = Math.round(jump * packet.rate());
        if (jump > LONGEST_GAP || jump < -LONGEST_WAIT) {
            sink.beginAgain(packet.time(), "the sensor's clock jumped by " + Math.round(jump * 10) / 10.0 + " s");
        } else if (samples >= (missed > 0 ? 1 : 2)) {
            sink.miss(samples, due);
        }
        sink.take(packet);
        if (packet.counter() - first < NOTED) {
            checksums[(int) (packet.counter() - first)] = packet.checksum();
        }
        next = packet.counter() + 1;
        recent = recent << 1 | 1;
        due = packet.end();
    }

    void save(StateWriter out) {
        out.put(begun);
        out.put(again);
        out.put(first);
        out.put(firstTime);
        out.put(next);
        out.put(due);
        out.put(recent);
        out.put(reordered);
        out.put(twice);
        out.put(late);
        out.put(lost);
        for (int checksum : checksums) {
            out.put(checksum);
        }
        out.put(held.size());
        for (Packet packet : held.values()) {
            out.put(packet.counter());
            out.put(packet.time());
            out.put(packet.rate());
            out.put(packet.channels());
            out.put(packet.values().length);
            out.put(packet.values());
        }
    }

    /** @param seat whose packets they are */
    void load(StateReader in, String seat) {
        begun = in.flag();
        again = in.flag();
        first = in.count();
        firstTime = in.number();
        next = in.count();
        due = in.number();
        recent = in.count();
        reordered = in.count();
        twice = in.count();
        late = in.count();
        lost = in.count();
        for (int i = 0; i < NOTED; i++) {
            checksums[i] = in.integer();
        }
        held.clear();
        int waiting = in.integer(0, MOST_HELD, "packets that wait");
        for (int i = 0; i < waiting; i++) {
            long counter = in.count();
            double time = in.number();
            double rate = in.number();
            int channels = in.integer();
            double[] values = new double[in.integer(1, Packet.MOST_VALUES, "values of a packet")];
            in.numbers(values);
            held.put(counter, new Packet(seat, counter, time, rate, channels, values));
        }
    }

    /** Packets that came before one that was due. */
    long reordered() {
        return reordered;
    }

    /** Packets that came twice and were dropped. */
    long twice() {
        return twice;
    }

    /** Packets that came after they had been given up, and were dropped. */
    long late() {
        return late;
    }

    /** Packets that never came in time. */
    long lost() {
        return lost;
    }
}
