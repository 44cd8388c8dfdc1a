package wbv.snapshot;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.zip.CRC32C;

/**
 * State as bytes: mark, version, numbers in the order in which they are put (big-endian), and CRC-32C (Castagnoli) of all before
 * it. One writer is used again and again; it grows to the largest state and stays there.
 */
public final class StateWriter {

    /** "wbvS". */
    static final int MARK = 0x77627653;
    /** Version of the form of all states. One that {@link StateReader} no longer reads is refused by its number. */
    public static final int VERSION = 4;
    static final int HEAD = Integer.BYTES + 1;
    static final int TAIL = Integer.BYTES;
    private static final int FIRST = 4096;

    private final CRC32C checksum = new CRC32C();
    private ByteBuffer buffer = ByteBuffer.allocate(FIRST);

    /** A writer of an empty state. */
    public StateWriter() {
        begin();
    }

    /** Begins another state: what was put before is forgotten. */
    public void begin() {
        buffer.clear();
        buffer.putInt(MARK).put((byte) VERSION);
    }

    /** A number, of any unit, to the last bit: 8 bytes. */
    public void put(double value) {
        reserve(Double.BYTES);
        buffer.putDouble(value);
    }

    /** 8 bytes. */
    public void put(long value) {
        reserve(Long.BYTES);
        buffer.putLong(value);
    }

    /** 4 bytes. */
    public void put(int value) {
        reserve(Integer.BYTES);
        buffer.putInt(value);
    }

    /** 1 byte, 1 or 0. */
    public void put(boolean value) {
        reserve(1);
        buffer.put((byte) (value ? 1 : 0));
    }

    /** All numbers, of any unit, of an array whose length the reader knows. Not modified. */
    public void put(double[] values) {
        put(values, 0, values.length);
    }

    /**
     * Those of them from an index to before another.
     *
     * @param values as long as it is, of any unit. Not modified.
     */
    public void put(double[] values, int from, int to) {
        reserve((to - from) * Double.BYTES);
        for (int i = from; i < to; i++) {
            buffer.putDouble(values[i]);
        }
    }

    /** All of an array whose length the reader knows. Not modified. */
    public void put(long[] values) {
        reserve(values.length * Long.BYTES);
        for (long value : values) {
            buffer.putLong(value);
        }
    }

    /** All of an array whose length the reader knows, a byte each. Not modified. */
    public void put(boolean[] values) {
        reserve(values.length);
        for (boolean value : values) {
            buffer.put((byte) (value ? 1 : 0));
        }
    }

    /** A text of at most 65 535 bytes of UTF-8. */
    public void put(String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        if (bytes.length > 0xFFFF) {
            throw new IllegalArgumentException("a text of a state has at most 65535 bytes: " + bytes.length);
        }
        reserve(Short.BYTES + bytes.length);
        buffer.putShort((short) bytes.length).put(bytes);
    }

    /** What a part has to keep. */
    public void put(Snapshot part) {
        part.save(this);
    }

    /** What parts have to keep, in their order. The array is not modified. */
    public void put(Snapshot[] parts) {
        for (Snapshot part : parts) {
            part.save(this);
        }
    }

    private void reserve(int bytes) {
        if (buffer.remaining() < bytes + TAIL) {
            int position = buffer.position();
            buffer = ByteBuffer.wrap(Arrays.copyOf(buffer.array(), Math.max(2 * buffer.capacity(), position + bytes + TAIL)));
            buffer.position(position);
        }
    }

    /** Everything put since {@link #begin}, mark, version and checksum around it. A copy; the next state may begin. */
    public byte[] finish() {
        int length = buffer.position();
        checksum.reset();
        checksum.update(buffer.array(), 0, length);
        buffer.putInt((int) checksum.getValue());
        byte[] all = Arrays.copyOf(buffer.array(), length + TAIL);
        begin();
        return all;
    }

    /** The state of one object. */
    public static byte[] of(Snapshot part) {
        StateWriter writer = new StateWriter();
        writer.put(part);
        return writer.finish();
    }
}
