package wbv.snapshot;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32C;
import wbv.recording.DataFault;

/** Reads what {@link StateWriter} wrote, in the same order. Bytes that are cut, damaged or of a newer version are refused first. */
public final class StateReader {

    private final String name;
    private final ByteBuffer buffer;
    private final int version;

    /**
     * Checks all bytes; what they hold is read after.
     *
     * @param name  of the bytes, for messages
     * @param bytes Not modified; not to be modified while they are read.
     * @throws DataFault if they are no state, damaged, or of a version that is not known
     */
    public StateReader(String name, byte[] bytes) {
        this.name = name;
        if (bytes.length < StateWriter.HEAD + StateWriter.TAIL) {
            throw DataFault.in(name, "is no saved state: " + bytes.length + " bytes; begin without it");
        }
        ByteBuffer all = ByteBuffer.wrap(bytes).order(ByteOrder.BIG_ENDIAN);
        if (all.getInt() != StateWriter.MARK) {
            throw DataFault.in(name, "is no saved state: it does not begin with 'wbvS'");
        }
        version = all.get();
        int length = bytes.length - StateWriter.TAIL;
        CRC32C checksum = new CRC32C();
        checksum.update(bytes, 0, length);
        if ((int) checksum.getValue() != all.getInt(length)) {
            throw DataFault.in(name, "is a saved state that was cut or damaged (its checksum is wrong); begin without it");
        }
        if (version < 1 || version > StateWriter.VERSION) {
            throw DataFault.in(name, "is a saved state of version " + version + "; this program reads 1 to " + StateWriter.VERSION);
        }
        buffer = all.slice(StateWriter.HEAD, length - StateWriter.HEAD);
    }

    /** Version of the form, 1 to {@link StateWriter#VERSION}. */
    public int version() {
        return version;
    }

    /** The bytes' name, for messages. */
    public String name() {
        return name;
    }

    /** The next number, of any unit, to the last bit. */
    public double number() {
        require(Double.BYTES);
        return buffer.getDouble();
    }

    /** The next {@code long}. */
    public long count() {
        require(Long.BYTES);
        return buffer.getLong();
    }

    /** The next {@code int}. */
    public int integer() {
        require(Integer.BYTES);
        return buffer.getInt();
    }

    /**
     * A whole number within bounds.
     *
     * @throws DataFault if it is not
     */
    public int integer(int least, int most, String what) {
        int value = integer();
        if (value < least || value > most) {
            throw other(what + " must be " + least + " to " + most + ": " + value);
        }
        return value;
    }

    /** The next truth value. */
    public boolean flag() {
        require(1);
        return buffer.get() != 0;
    }

    /** Fills an array, as long as it is, with numbers of any unit. Modified. */
    public void numbers(double[] into) {
        numbers(into, 0, into.length);
    }

    /**
     * Fills a part of an array, from an index to before another.
     *
     * @param into as long as it is, numbers of any unit. Modified.
     */
    public void numbers(double[] into, int from, int to) {
        require((to - from) * Double.BYTES);
        for (int i = from; i < to; i++) {
            into[i] = buffer.getDouble();
        }
    }

    /**
     * Reads as many {@code long}s as the array has.
     *
     * @param into Modified.
     */
    public void counts(long[] into) {
        require(into.length * Long.BYTES);
        for (int i = 0; i < into.length; i++) {
            into[i] = buffer.getLong();
        }
    }

    /**
     * Reads as many truth values as the array has.
     *
     * @param into Modified.
     */
    public void flags(boolean[] into) {
        require(into.length);
        for (int i = 0; i < into.length; i++) {
            into[i] = buffer.get() != 0;
        }
    }

    /** The next text, of UTF-8. */
    public String text() {
        require(Short.BYTES);
        int length = Short.toUnsignedInt(buffer.getShort());
        require(length);
        byte[] bytes = new byte[length];
        buffer.get(bytes);
        return new String(bytes, StandardCharsets.UTF_8);
    }

    /** Lets a part load what it saved. */
    public void part(Snapshot part) {
        part.load(this);
    }

    /** Lets parts load what they saved, in their order. The array is not modified, its parts are. */
    public void parts(Snapshot[] parts) {
        for (Snapshot part : parts) {
            part.load(this);
        }
    }

    /**
     * Says that all has been read.
     *
     * @throws DataFault if something is left
     */
    public void end() {
        if (buffer.hasRemaining()) {
            throw other(buffer.remaining() + " bytes are left");
        }
    }

    /** What to throw where a state is not the one that was looked for. */
    public DataFault other(String what) {
        return DataFault.in(name, "is the saved state of something else: " + what);
    }

    private void require(int bytes) {
        if (buffer.remaining() < bytes) {
            throw other("it ends too soon");
        }
    }

    /**
     * Loads one object's state.
     *
     * @param name of the bytes, for messages
     * @param bytes Not modified.
     */
    public static void into(Snapshot part, String name, byte[] bytes) {
        StateReader reader = new StateReader(name, bytes);
        reader.part(part);
        reader.end();
    }
}
