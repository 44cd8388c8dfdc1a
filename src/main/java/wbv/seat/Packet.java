package wbv.seat;

import java.io.DataInput;
import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Objects;
import java.util.Optional;
import java.util.zip.CRC32C;
import wbv.recording.DataFault;

/**
 * Samples of one seat that were sent together.
 *
 * <p>As bytes, big-endian: mark "wbvP", version 1, length of all of it (4 bytes), seat (length in one byte, UTF-8), counter (8), time
 * (8), rate (8), channels (2), samples (2), the values, CRC-32C of everything before (4).
 *
 * @param seat     its name, 1 to {@value #LONGEST_NAME} bytes of UTF-8 without control characters
 * @param counter  number of the packet; a sensor counts from 0 when it starts
 * @param time     of the first sample, by the sensor's own clock [s]
 * @param rate     of the samples [Hz]
 * @param channels values of a sample, in an order that both ends know
 * @param values   sample by sample, each in the unit of its channel, NaN where missing. Not copied; do not change them.
 */
public record Packet(String seat, long counter, double time, double rate, int channels, double[] values) {

    /** Bytes of a seat's name at most. */
    public static final int LONGEST_NAME = 128;
    /** Channels at most. */
    public static final int MOST_CHANNELS = 1024;
    /** Samples of a channel at most. */
    public static final int MOST_SAMPLES = 8192;
    /** "wbvP". */
    static final int MARK = 0x77627650;
    static final byte VERSION = 1;
    private static final int BEFORE_NAME = Integer.BYTES + 1 + Integer.BYTES + 1;
    private static final int AFTER_NAME = Long.BYTES + 2 * Double.BYTES + 2 * Short.BYTES;
    private static final int TAIL = Integer.BYTES;
    static final int MOST_VALUES = 1 << 18;
    /** Bytes of the longest packet. */
    public static final int MOST_BYTES = BEFORE_NAME + LONGEST_NAME + AFTER_NAME + MOST_VALUES * Double.BYTES + TAIL;
    private static final int LEAST_BYTES = BEFORE_NAME + 1 + AFTER_NAME + Double.BYTES + TAIL;

    public Packet {
        if (seat.isEmpty() || seat.getBytes(StandardCharsets.UTF_8).length > LONGEST_NAME
                || seat.codePoints().anyMatch(Character::isISOControl)) {
            throw new DataFault("a seat's name has 1 to " + LONGEST_NAME + " bytes and no control characters: '" + seat + "'");
        }
        if (counter < 0) {
            throw new DataFault("a packet's counter must be >= 0: " + counter);
        }
        if (!Double.isFinite(time)) {
            throw new DataFault("a packet's time must be a number [s]: " + time);
        }
        if (!(rate > 0 && rate <= 1e6)) {
            throw new DataFault("a packet's rate must be > 0 to 1e6 Hz: " + rate);
        }
        if (channels < 1 || channels > MOST_CHANNELS || values.length == 0 || values.length % channels != 0
                || values.length / channels > MOST_SAMPLES || values.length > MOST_VALUES) {
            throw new DataFault("a packet has 1 to " + MOST_CHANNELS + " channels and 1 to " + MOST_SAMPLES
                    + " samples: " + channels + " channels, " + values.length + " values");
        }
    }

    /** Number of samples. */
    public int samples() {
        return values.length / channels;
    }

    /** What a channel reads at a sample, in the channel's unit; NaN where missing. */
    public double value(int sample, int channel) {
        return values[sample * channels + channel];
    }

    /** Time just behind the last sample, where the next packet begins [s]. */
    public double end() {
        return time + samples() / rate;
    }

    /** CRC-32C of the bytes. */
    public int checksum() {
        byte[] bytes = bytes();
        return ByteBuffer.wrap(bytes).getInt(bytes.length - TAIL);
    }

    /** The packet as bytes. */
    public byte[] bytes() {
        byte[] name = seat.getBytes(StandardCharsets.UTF_8);
        int length = BEFORE_NAME + name.length + AFTER_NAME + values.length * Double.BYTES + TAIL;
        ByteBuffer out = ByteBuffer.allocate(length);
        out.putInt(MARK).put(VERSION).putInt(length).put((byte) name.length).put(name);
        out.putLong(counter).putDouble(time).putDouble(rate).putShort((short) channels).putShort((short) samples());
        for (double value : values) {
            out.putDouble(value);
        }
        out.putInt(sum(out.array(), 0, length - TAIL));
        return out.array();
    }

    /**
     * Looks for a packet at a place among bytes.
     *
     * @param bytes Not modified.
     * @param to behind the last of them
     * @return length of the whole packet that begins there; 0 if none does; if one may that goes on behind these, minus its length
     *         so far as it is known
     */
    public static int frame(byte[] bytes, int from, int to) {
        if (to - from < BEFORE_NAME) {
            return -BEFORE_NAME;
        }
        ByteBuffer head = ByteBuffer.wrap(bytes, from, to - from);
        int mark = head.getInt();
        head.get();
        int length = head.getInt();
        if (mark != MARK || length < LEAST_BYTES || length > MOST_BYTES) {
            return 0;
        }
        if (length > to - from) {
            return -length;
        }
        return sum(bytes, from, length - TAIL) == head.getInt(from + length - TAIL) ? length : 0;
    }

    /**
     * Whose a whole packet is, without its values.
     *
     * @param bytes that {@link #frame} found to be one. Not modified.
     * @throws DataFault if it is of another version, or says what cannot be
     */
    public static String seat(byte[] bytes) {
        int length = Byte.toUnsignedInt(bytes[BEFORE_NAME - 1]);
        if (bytes[Integer.BYTES] != VERSION || length == 0 || bytes.length < BEFORE_NAME + length + AFTER_NAME + Double.BYTES + TAIL) {
            return of(bytes).seat();
        }
        return new String(bytes, BEFORE_NAME, length, StandardCharsets.UTF_8);
    }

    private static int sum(byte[] bytes, int from, int length) {
        CRC32C sum = new CRC32C();
        sum.update(bytes, from, length);
        return (int) sum.getValue();
    }

    /**
     * Reads a packet's bytes.
     *
     * @param bytes one packet, nothing before or behind it. Not modified.
     * @throws DataFault in one line, if they are cut, damaged or no packet
     */
    public static Packet of(byte[] bytes) {
        if (bytes.length < LEAST_BYTES) {
            throw new DataFault("is no packet: " + bytes.length + " bytes");
        }
        ByteBuffer in = ByteBuffer.wrap(bytes);
        if (in.getInt() != MARK) {
            throw new DataFault("is no packet: it does not begin with 'wbvP'");
        }
        byte version = in.get();
        int length = in.getInt();
        if (length != bytes.length || in.getInt(length - TAIL) != sum(bytes, 0, length - TAIL)) {
            throw new DataFault("is a packet that was cut or damaged: its length or its checksum is wrong");
        }
        if (version != VERSION) {
            throw new DataFault("is a packet of version " + version + "; this program reads " + VERSION);
        }
        byte[] name = new byte[Byte.toUnsignedInt(in.get())];
        if (in.remaining() < name.length + AFTER_NAME + Double.BYTES + TAIL) {
            throw new DataFault("is a packet whose name is longer than it is");
        }
        in.get(name);
        long counter = in.getLong();
        double time = in.getDouble();
        double rate = in.getDouble();
        int channels = Short.toUnsignedInt(in.getShort());
        int samples = Short.toUnsignedInt(in.getShort());
        if (in.remaining() - TAIL != (long) channels * samples * Double.BYTES) {
            throw new DataFault("is a packet of " + channels + " channels and " + samples + " samples that has "
                    + (in.remaining() - TAIL) + " bytes of values");
        }
        double[] values = new double[channels * samples];
        for (int i = 0; i < values.length; i++) {
            values[i] = in.getDouble();
        }
        return new Packet(new String(name, StandardCharsets.UTF_8), counter, time, rate, channels, values);
    }

    /**
     * Reads the next packet of a stream of packets.
     *
     * @return empty at the end of the stream
     * @throws DataFault if the bytes are no packet; the stream then stands somewhere within
     */
    public static Optional<Packet> read(DataInput in) throws IOException {
        byte[] head = new byte[BEFORE_NAME];
        try {
            in.readFully(head, 0, 1);
        } catch (EOFException end) {
            return Optional.empty();
        }
        try {
            in.readFully(head, 1, head.length - 1);
            int length = ByteBuffer.wrap(head).getInt(Integer.BYTES + 1);
            if (ByteBuffer.wrap(head).getInt() != MARK || length < head.length || length > MOST_BYTES) {
                throw new DataFault("is no packet: it does not begin with 'wbvP' and a length");
            }
            byte[] all = Arrays.copyOf(head, length);
            in.readFully(all, head.length, length - head.length);
            return Optional.of(of(all));
        } catch (EOFException cut) {
            throw new DataFault("ends within a packet", cut);
        }
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Packet that && seat.equals(that.seat) && counter == that.counter && time == that.time
                && rate == that.rate && channels == that.channels && Arrays.equals(values, that.values);
    }

    @Override
    public int hashCode() {
        return Objects.hash(seat, counter, time, Arrays.hashCode(values));
    }

    @Override
    public String toString() {
        return "packet " + counter + " of " + seat + " at " + time + " s, " + samples() + " samples of " + channels + " channels";
    }
}
