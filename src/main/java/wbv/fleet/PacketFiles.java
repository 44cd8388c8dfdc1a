package wbv.fleet;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import wbv.recording.DataFault;
import wbv.seat.Packet;

/**
 * The bytes of {@link Packet packets} in files, one behind the other, one file after the other. Bytes between them that are no whole packet
 * are given as they are, in pieces of {@value #MOST_UNREAD} at most: whatever is damaged, the next whole packet is found.
 */
public final class PacketFiles implements Closeable {

    private static final int MOST_UNREAD = 1 << 16;
    private static final int ROOM = 1 << 16;

    private final List<Path> files;
    private int part;
    private long at;
    private long count;
    private Optional<FileChannel> open = Optional.empty();
    private byte[] bytes = new byte[ROOM];
    private int from;
    private int to;
    private boolean ended;

    /**
     * Nothing is opened before it is read.
     *
     * @param files in their order
     * @param part file that is next
     * @param at byte in it
     * @param count packets and pieces before that
     */
    public PacketFiles(List<Path> files, int part, long at, long count) {
        this.files = List.copyOf(files);
        this.part = part;
        this.at = at;
        this.count = count;
    }

    /** The files and their lengths, in one line. */
    static String text(List<Path> files) throws IOException {
        StringBuilder text = new StringBuilder("packets of");
        for (Path file : files) {
            text.append(' ').append(file.toAbsolutePath().normalize()).append(':').append(Files.size(file));
        }
        return text.toString();
    }

    /** Whether a file begins as one of packets does. */
    public static boolean holdsPackets(Path file) throws IOException {
        byte[] head = new byte[4];
        if (Files.isRegularFile(file)) {
            try (var in = Files.newInputStream(file)) {
                return in.readNBytes(head, 0, head.length) == head.length
                        && Arrays.equals(head, "wbvP".getBytes(StandardCharsets.US_ASCII));
            }
        }
        return false;
    }

    /**
     * The first packet.
     *
     * @throws DataFault if there is none
     */
    public static Packet first(List<Path> files) throws IOException {
        try (PacketFiles all = new PacketFiles(files, 0, 0, 0)) {
            for (Optional<byte[]> next = all.next(); next.isPresent(); next = all.next()) {
                if (Packet.frame(next.get(), 0, next.get().length) > 0) {
                    return Packet.of(next.get());
                }
            }
        }
        throw DataFault.in(files.get(0).toString(), "holds no whole packet");
    }

    /** File that is next. */
    public int part() {
        return part;
    }

    /** Byte of it that is next. */
    public long at() {
        return at;
    }

    /** Packets and pieces before. */
    public long count() {
        return count;
    }

    /** A whole packet's bytes, or a piece of what is none; empty behind the last file. */
    public Optional<byte[]> next() throws IOException {
        while (part < files.size()) {
            int length = length();
            if (length > 0) {
                byte[] piece = Arrays.copyOfRange(bytes, from, from + length);
                from += length;
                at += length;
                count++;
                return Optional.of(piece);
            }
            close();
            part++;
            at = 0;
        }
        return Optional.empty();
    }

    /** Bytes of the next piece; 0 at the file's end. */
    private int length() throws IOException {
        int whole = frame(0);
        if (whole > 0) {
            return whole;
        }
        int passed = 0;
        while (has(passed + 1) && passed < MOST_UNREAD && (passed == 0 || frame(passed) == 0)) {
            passed++;
        }
        return passed;
    }

    /** Length of the whole packet that begins so many bytes on; 0 if none does. */
    private int frame(int ahead) throws IOException {
        if (!has(ahead + 1)) {
            return 0;
        }
        int length = Packet.frame(bytes, from + ahead, to);
        while (length < 0 && has(ahead - length)) {
            length = Packet.frame(bytes, from + ahead, to);
        }
        return Math.max(0, length);
    }

    /**
     * Reads on until so many bytes are there.
     *
     * @return whether they are
     */
    private boolean has(int wanted) throws IOException {
        while (to - from < wanted && !ended) {
            if (open.isEmpty()) {
                open = Optional.of(FileChannel.open(files.get(part), StandardOpenOption.READ).position(at));
            }
            if (bytes.length - from < Math.max(wanted, ROOM / 2)) {
                byte[] room = bytes.length < wanted + ROOM ? new byte[2 * (wanted + ROOM)] : bytes;
                System.arraycopy(bytes, from, room, 0, to - from);
                bytes = room;
                to -= from;
                from = 0;
            }
            int read = open.get().read(ByteBuffer.wrap(bytes, to, bytes.length - to));
            ended = read < 0;
            to += Math.max(0, read);
        }
        return to - from >= wanted;
    }

    @Override
    public void close() throws IOException {
        if (open.isPresent()) {
            open.get().close();
        }
        open = Optional.empty();
        ended = false;
        from = 0;
        to = 0;
    }
}
