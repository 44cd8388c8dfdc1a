package wbv.fleet;

import java.io.Closeable;
import java.io.IOException;
import java.util.Optional;
import wbv.seat.Packet;

/** Packets of a fleet in one order, which can be gone on with from any place: the same place gives the same packets. */
interface Feed extends Closeable {

    /** What the packets are, in one line: another feed is not gone on with. */
    String text();

    /** What comes next; empty at the end. */
    Optional<Sent> next() throws IOException;

    /** Where the next one stands. */
    Place place();

    /** Share that has been given, 0 to 1. */
    double share();

    /**
     * A place among packets.
     *
     * @param count of all before
     * @param part  file or round
     * @param at byte in the file or seat
     * @param given packets of that seat and round that were given before
     */
    record Place(long count, int part, long at, int given) {

        static final Place BEGINNING = new Place(0, 0, 0, 0);
    }

    /** What was sent. */
    sealed interface Sent {}

    /** A packet. */
    record Read(Packet packet) implements Sent {}

    /**
     * Bytes that are none.
     *
     * @param reason in one line
     */
    record Unread(byte[] bytes, String reason) implements Sent {}
}
