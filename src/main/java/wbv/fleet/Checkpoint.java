package wbv.fleet;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.BufferedOutputStream;
import java.io.EOFException;
import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.Collection;
import java.util.Optional;
import java.util.function.Function;
import wbv.recording.DataFault;
import wbv.seat.Seat;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * Where a fleet stands, in one file: what it is a run of, how far its input and its outputs went, and every seat's state. Written
 * beside and renamed, so that the file is always whole; each part of it has a checksum of its own.
 *
 * @param run     what the run is, in words: another run does not go on from here
 * @param place   of the next packet
 * @param ended   whether there is none, and what waited has been told
 * @param results bytes of results.csv that belong to the packets before
 * @param alarms  bytes of alarms.csv likewise
 * @param unread  bytes of unread.csv likewise
 * @param samples taken so far
 */
record Checkpoint(String run, Feed.Place place, boolean ended, long results, long alarms, long unread, long samples) {

    private static final String NAME = "fleet.state";

    static Path file(Path folder) {
        return folder.resolve(NAME);
    }

    /** Writes the file, and returns when it is on the disk. */
    void write(Path folder, Collection<Seat> seats) throws IOException {
        Path part = folder.resolve(NAME + ".part");
        StateWriter writer = new StateWriter();
        try (FileOutputStream file = new FileOutputStream(part.toFile());
                DataOutputStream out = new DataOutputStream(new BufferedOutputStream(file, 1 << 16))) {
            writer.put(run);
            writer.put(place.count());
            writer.put(place.part());
            writer.put(place.at());
            writer.put(place.given());
            writer.put(ended);
            writer.put(results);
            writer.put(alarms);
            writer.put(unread);
            writer.put(samples);
            writer.put(seats.size());
            part(writer.finish(), out);
            for (Seat seat : seats) {
                writer.put(seat);
                part(writer.finish(), out);
            }
            out.flush();
            file.getFD().sync();
        }
        Files.move(part, file(folder), StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        forceFolder(folder);
    }

    private static void part(byte[] bytes, DataOutputStream out) throws IOException {
        out.writeInt(bytes.length);
        out.write(bytes);
    }

    /** Names are on the disk too, where the system lets a folder be asked for that. */
    static void forceFolder(Path folder) throws IOException {
        if (Files.getFileStore(folder).supportsFileAttributeView("posix")) {
            try (FileChannel names = FileChannel.open(folder, StandardOpenOption.READ)) {
                names.force(true);
            }
        }
    }

    /**
     * Reads the file of a folder, if there is one.
     *
     * @param seats gives the seat of a name, to be filled with its state
     * @throws DataFault if it is of another run, cut or damaged
     */
    static Optional<Checkpoint> read(Path folder, String run, Function<String, Seat> seats) throws IOException {
        Path file = file(folder);
        if (!Files.exists(file)) {
            return Optional.empty();
        }
        String name = file.toString();
        try (DataInputStream in = new DataInputStream(new BufferedInputStream(Files.newInputStream(file), 1 << 16))) {
            StateReader head = new StateReader(name, part(in, name));
            Checkpoint found = new Checkpoint(head.text(), new Feed.Place(head.count(), head.integer(), head.count(), head.integer()),
                    head.flag(), head.count(), head.count(), head.count(), head.count());
            int count = head.integer();
            head.end();
            if (!found.run.equals(run)) {
                throw DataFault.in(name, "is where another run stopped (" + found.run + "); finish that, choose another --out, or delete"
                        + " the file to begin anew");
            }
            for (int left = count; left > 0; left--) {
                byte[] state = part(in, name);
                StateReader.into(seats.apply(new StateReader(name, state).text()), name, state); // which begins with its name
            }
            return Optional.of(found);
        }
    }

    private static byte[] part(DataInputStream in, String name) throws IOException {
        try {
            int length = in.readInt();
            if (length >= 0 && length <= 1 << 28) {
                byte[] bytes = in.readNBytes(length);
                if (bytes.length == length) {
                    return bytes;
                }
            }
        } catch (EOFException cut) {
            // told below
        }
        throw DataFault.in(name, "was cut or damaged; delete it to begin anew");
    }
}
