package wbv.fleet;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import wbv.recording.AtomicFile;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.seat.Packet;

/**
 * Recordings as the packets of many seats. Seat k plays recording k modulo their number, from a place of its own to the end and then
 * from the beginning to that place, so that at any moment seats are at different places of a ride. What goes wrong on the way is
 * drawn by seat and packet alone: the packets of any round can be asked for again.
 */
public final class Replay {

    /** By how much packets are late at most, where they are disturbed [s]. */
    private static final double LATE = 1.9;
    private static final double TWICE = 0.01;
    private static final double LOST = 0.01;
    /** Where seats begin: shares of the golden section, so that they lie as far apart as they can whatever their number. */
    private static final double GOLDEN = (Math.sqrt(5) - 1) / 2;

    private final List<Channel> channels;
    private final double rate;
    private final List<double[][]> recordings = new ArrayList<>();
    private final int seats;
    private final int size;
    private final boolean disturbed;
    private final long seed;
    private final int delay;

    /**
     * Holds the channels' samples of all recordings.
     *
     * @param recordings of one rate, each with all the channels
     * @param channels   of a packet
     * @param seats      number of them
     * @param size       samples of a packet
     * @param disturbed  whether packets are shuffled within two seconds, one in a hundred comes twice and one in a hundred never
     * @param seed       of what disturbs them
     * @throws DataFault if recordings have several rates, or lack a channel
     */
    public Replay(List<Recording> recordings, List<Channel> channels, int seats, int size, boolean disturbed, long seed) {
        this.channels = List.copyOf(channels);
        this.rate = recordings.get(0).clock().rate();
        this.seats = seats;
        this.size = size;
        this.disturbed = disturbed;
        this.seed = seed;
        this.delay = disturbed ? (int) (LATE * rate / size) : 0;
        for (Recording recording : recordings) {
            if (Math.abs(recording.clock().rate() / rate - 1) > 0.001) {
                throw new DataFault("recordings of a fleet must have one rate: " + rate + " and " + recording.clock().rate() + " Hz");
            }
            if (recording.length() < size) {
                throw new DataFault("a recording of a fleet must hold one packet at least: " + recording.length() + " samples of " + size);
            }
            double[][] columns = new double[channels.size()][];
            for (int c = 0; c < columns.length; c++) {
                if (!recording.has(channels.get(c))) {
                    throw new DataFault("all recordings of a fleet must have the same channels: one has no " + channels.get(c));
                }
                columns[c] = recording.values(channels.get(c));
            }
            this.recordings.add(columns);
        }
    }

    /** Number of seats that play. */
    public int seats() {
        return seats;
    }

    /** Of the samples [Hz]. */
    public double rate() {
        return rate;
    }

    /** Rounds of one packet of every seat, and those in which late ones come. */
    public int rounds() {
        int longest = 0;
        for (double[][] columns : recordings) {
            longest = Math.max(longest, columns[0].length / size);
        }
        return longest + delay;
    }

    /** Samples of all seats. */
    public long samples() {
        long sum = 0;
        for (int k = 0; k < seats; k++) {
            sum += (long) packets(k) * size;
        }
        return sum;
    }

    /** Name of a seat. */
    public String name(int seat) {
        return String.format("seat-%05d", seat);
    }

    private double[][] columns(int seat) {
        return recordings.get(seat % recordings.size());
    }

    private int packets(int seat) {
        return columns(seat)[0].length / size;
    }

    /** Gives the packets of a seat that come in a round, in their order. */
    public void packets(int seat, int round, Consumer<Packet> to) {
        for (int p = Math.max(0, round - delay); p <= Math.min(round, packets(seat) - 1); p++) {
            long draw = draw(seat, p);
            if (disturbed && share(draw) < LOST) {
                continue;
            }
            boolean comes = p + late(draw >>> 8) == round;
            boolean again = disturbed && share(draw >>> 16) < TWICE && p + late(draw >>> 24) == round;
            for (int k = 0; k < (comes ? 1 : 0) + (again ? 1 : 0); k++) {
                to.accept(packet(seat, p));
            }
        }
    }

    /**
     * Writes all packets to a file, in their order.
     *
     * @return their number
     */
    public long write(Path file) throws IOException {
        long count = 0;
        try (AtomicFile whole = AtomicFile.begin(file); OutputStream out = new BufferedOutputStream(whole.stream(), 1 << 16)) {
            ReplayFeed feed = new ReplayFeed(this, Feed.Place.BEGINNING);
            for (Optional<Packet> next = feed.packet(); next.isPresent(); next = feed.packet()) {
                out.write(next.get().bytes());
                count++;
            }
            out.flush();
            whole.finish();
        }
        return count;
    }

    private Packet packet(int seat, int number) {
        double[][] columns = columns(seat);
        int length = columns[0].length;
        int begin = (int) (seat / recordings.size() * GOLDEN % 1 * length);
        double[] values = new double[size * columns.length];
        for (int i = 0; i < size; i++) {
            int at = (begin + number * size + i) % length;
            for (int c = 0; c < columns.length; c++) {
                values[i * columns.length + c] = columns[c][at];
            }
        }
        return new Packet(name(seat), number, number * size / rate, rate, columns.length, values);
    }

    private int late(long draw) {
        return (int) ((delay + 1) * share(draw * 0xBF58476D1CE4E5B9L));
    }

    private static double share(long draw) {
        return (mixed(draw) >>> 11) * 0x1p-53;
    }

    private long draw(int seat, int packet) {
        return mixed(mixed(seed * 0x9E3779B97F4A7C15L + seat) + packet);
    }

    /** SplitMix64 (Steele, Lea and Flood, OOPSLA 2014). */
    private static long mixed(long state) {
        long z = state + 0x9E3779B97F4A7C15L;
        z = (z ^ z >>> 30) * 0xBF58476D1CE4E5B9L;
        z = (z ^ z >>> 27) * 0x94D049BB133111EBL;
        return z ^ z >>> 31;
    }

    /** Everything that packets depend on but the recordings' values, in one line. */
    public String text() {
        StringBuilder lengths = new StringBuilder();
        for (double[][] columns : recordings) {
            long sum = 1;
            for (double[] column : columns) {
                for (double value : column) {
                    sum = 31 * sum + Double.doubleToLongBits(value);
                }
            }
            lengths.append(' ').append(columns[0].length).append(':').append(Long.toHexString(sum));
        }
        return seats + " seats, " + size + " samples a packet at " + rate + " Hz of " + channels + ", "
                + (disturbed ? "disturbed by seed " + seed : "undisturbed") + ", recordings" + lengths;
    }
}
