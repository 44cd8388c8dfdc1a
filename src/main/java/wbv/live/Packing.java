package wbv.live;

import java.util.Arrays;
import java.util.function.Consumer;
import wbv.seat.Packet;

/** The samples of a seat as packets, numbered as its sensor would. Times that jitter are even in them. */
final class Packing {

    /** Length of a packet: what a result waits for at most [s]. */
    private static final double PACKET = 0.05;
    /** Times that are off by less are even [samples]; the packets' clock follows them slowly. */
    private static final double EVEN = 1.5;
    private static final double FOLLOWS = 0.05;

    private final String seat;
    private final int width;
    private final Consumer<Packet> to;
    private final double[] values;
    private final double[] nothing;
    private final double rate;
    private int held;
    private double begins;
    private double due = Double.NaN;
    private long counter;

    /**
     * @param rate of the samples [Hz]
     * @param width values of a sample
     * @param to takes packets
     */
    Packing(String seat, double rate, int width, Consumer<Packet> to) {
        this.seat = seat;
        this.rate = rate;
        this.width = width;
        this.to = to;
        this.values = new double[(int) Math.max(1, Math.round(PACKET * rate)) * width];
        this.nothing = new double[width];
        Arrays.fill(nothing, Double.NaN);
    }

    /**
     * Goes on behind a packet.
     *
     * @param number of the next
     * @param end where it begins [s]
     */
    void goOn(long number, double end) {
        counter = number;
        due = end;
    }

    /**
     * A sample.
     *
     * @param row time, then the values. Not kept.
     */
    void take(double[] row) {
        add(row[0], row, 1);
    }

    /** A sample that is missing. */
    void miss() {
        add(Double.NaN, nothing, 0);
    }

    private void add(double at, double[] row, int from) {
        double step = 1 / rate;
        double expected = Double.isNaN(due) ? at : due;
        double even = Double.isNaN(at) ? expected : Math.abs(at - expected) < EVEN * step ? expected + FOLLOWS * (at - expected) : at;
        if (held == 0) {
            begins = even;
        }
        due = even + step;
        System.arraycopy(row, from, values, held * width, width);
        held++;
        if (held * width == values.length) {
            send();
        }
    }

    /** Sends a packet of what there is, full or not. */
    void send() {
        if (held > 0) {
            double[] full = Arrays.copyOf(values, held * width);
            held = 0;
            to.accept(new Packet(seat, counter++, begins, rate, width, full));
        }
    }

    /** Sends what there is, and begins again as a sensor does that starts: what lies between is not stepped through. */
    void restart() {
        send();
        counter = 0;
        due = Double.NaN;
    }

    /** Number of the next packet. */
    long counter() {
        return counter;
    }

    /** Where a packet that is not full begins, or the next one will [s]; NaN where nothing is known. */
    double due() {
        return held == 0 ? due : begins;
    }
}
