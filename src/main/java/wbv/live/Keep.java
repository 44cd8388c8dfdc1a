package wbv.live;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import wbv.recording.AtomicFile;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.seat.Packet;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * What survives the end of the program, whatever ended it: a snapshot of all seats, {@code state-N.bin}, and a journal of the packets
 * since, {@code journal-N.bin}, each written before it is taken. Packets of the journal are taken again at the next start, and their
 * results told where that may not have happened; one that was cut by the end was never taken. A journal belongs to its snapshot by
 * its number, so that nothing counts twice.
 */
public final class Keep implements Closeable {

    /** What is put back. */
    interface Restored {

        /** A seat, as it was. */
        LiveSeat seat(String name, double rate, List<Channel> channels, int sensors);

        Optional<LiveSeat> known(String name);
    }

    private static final Pattern SNAPSHOT = Pattern.compile("state-([0-9]{1,18})\\.bin");
    private static final byte SEAT = 'S';
    private static final byte PACKET = 'P';
    /** All results of the packets before it were told. */
    private static final byte TOLD = 'T';
    private static final int HEAD = Integer.BYTES + 1;
    private static final int MOST_ENTRY = 1 << 22;
    /** Length of a journal after which a snapshot is due. */
    private static final long LONG = 8 << 20;
    /** Time after which one is due [ns]. */
    private static final long OLD = 60_000_000_000L;

    private final Path folder;
    private final StateWriter writer = new StateWriter();
    private long number;
    private long length;
    private long written;
    private boolean untold;
    private OutputStream journal = OutputStream.nullOutputStream();

    /**
     * Makes the folder; nothing is put back or written yet.
     *
     * @param folder made if it is not there
     */
    public Keep(Path folder) throws IOException {
        this.folder = folder;
        Files.createDirectories(folder);
    }

    private Path snapshot(long of) {
        return folder.resolve("state-" + of + ".bin");
    }

    private Path journal(long of) {
        return folder.resolve("journal-" + of + ".bin");
    }

    private OptionalLong latest() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> SNAPSHOT.matcher(file.getFileName().toString())).filter(java.util.regex.Matcher::matches)
                    .mapToLong(name -> Long.parseLong(name.group(1))).max();
        }
    }

    /**
     * Puts back what was kept.
     *
     * @return what is wrong with the journal, in words; empty if nothing is
     * @throws DataFault if the snapshot is damaged or of other options
     */
    Optional<String> restore(Restored into) throws IOException {
        OptionalLong latest = latest();
        number = latest.orElse(0);
        if (latest.isPresent()) {
            StateReader in = new StateReader(snapshot(number).toString(), Files.readAllBytes(snapshot(number)));
            int seats = in.integer(0, Integer.MAX_VALUE, "seats");
            for (int i = 0; i < seats; i++) {
                described(in, into).load(in);
            }
            in.end();
        }
        return Files.exists(journal(number)) ? replay(Files.readAllBytes(journal(number)), into) : Optional.empty();
    }

    private static LiveSeat described(StateReader in, Restored into) {
        String name = in.text();
        double rate = in.number();
        List<Channel> channels = Arrays.stream(in.text().split(",")).map(Channel::parse).toList();
        LiveSeat seat = into.seat(name, rate, channels, in.integer(1, 512, "sensors"));
        String plan = in.text();
        if (!plan.equals(seat.plan().text())) {
            throw in.other("it was kept with other options; use those, or another --state folder");
        }
        return seat;
    }

    /** Takes the journal again: what was told before the end in silence, what may not have been aloud. */
    private Optional<String> replay(byte[] all, Restored into) {
        ByteBuffer in = ByteBuffer.wrap(all);
        int told = toldUpTo(ByteBuffer.wrap(all));
        while (in.remaining() >= HEAD) {
            int at = in.position();
            int size = in.getInt();
            byte type = in.get();
            if (size < 0 || size > MOST_ENTRY) {
                return damaged(at, "no entry is so long");
            }
            if (size > in.remaining()) {
                return Optional.empty(); // the entry that was being written when the program ended: never taken
            }
            byte[] entry = new byte[size];
            in.get(entry);
            try {
                if (type == SEAT) {
                    described(new StateReader(journal(number).toString(), entry), into);
                } else if (type == PACKET) {
                    Packet packet = Packet.of(entry);
                    into.known(packet.seat()).ifPresent(seat -> seat.again(packet, at >= told));
                }
            } catch (DataFault damaged) {
                return damaged(at, damaged.getMessage());
            }
        }
        return Optional.empty();
    }

    private static int toldUpTo(ByteBuffer in) {
        int told = 0;
        while (in.remaining() >= HEAD) {
            int size = in.getInt();
            told = in.get() == TOLD ? in.position() : told;
            if (size < 0 || size > in.remaining()) {
                break;
            }
            in.position(in.position() + size);
        }
        return told;
    }

    private Optional<String> damaged(int at, String why) {
        return Optional.of(journal(number) + " is damaged at byte " + at + " (" + why + "); what stands behind is not taken");
    }

    /** Notes a new seat. */
    void seat(LiveSeat seat) {
        writer.begin();
        describe(seat, writer);
        note(SEAT, writer.finish());
    }

    private static void describe(LiveSeat seat, StateWriter out) {
        out.put(seat.name());
        out.put(seat.rate());
        out.put(String.join(",", seat.channels().stream().map(Channel::toString).toList()));
        out.put(seat.sensors());
        out.put(seat.plan().text());
    }

    /** Notes a packet, before it is taken. */
    void packet(Packet packet) {
        note(PACKET, packet.bytes());
        untold = true;
    }

    /** Notes that all results up to now were told. */
    void told() {
        if (untold) {
            note(TOLD, new byte[0]);
            untold = false;
        }
    }

    private void note(byte type, byte[] bytes) {
        byte[] entry = ByteBuffer.allocate(HEAD + bytes.length).putInt(bytes.length).put(type).put(bytes).array();
        try {
            journal.write(entry); // at once, so that what the system took outlives this program
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
        length += entry.length;
    }

    /**
     * Whether the journal is long or old.
     *
     * @param now [ns]
     */
    boolean due(long now) {
        return length > LONG || length > 0 && now - written > OLD;
    }

    /**
     * Writes a snapshot of all seats, and begins another journal.
     *
     * @param now [ns]
     */
    void save(List<LiveSeat> seats, long now) {
        writer.begin();
        writer.put(seats.size());
        for (LiveSeat seat : seats) {
            describe(seat, writer);
            seat.save(writer);
        }
        try {
            long before = number;
            AtomicFile.write(snapshot(before + 1), writer.finish());
            number = before + 1;
            journal.close();
            journal = Files.newOutputStream(journal(number), StandardOpenOption.CREATE, StandardOpenOption.TRUNCATE_EXISTING);
            length = 0;
            untold = false;
            written = now;
            Files.deleteIfExists(snapshot(before));
            Files.deleteIfExists(journal(before));
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }

    @Override
    public void close() throws IOException {
        journal.close();
    }
}
