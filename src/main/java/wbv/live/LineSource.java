package wbv.live;

import java.io.Closeable;
import java.io.IOException;

/** Where lines come from. */
public interface LineSource extends Closeable {

    /** Takes what came. */
    interface Receiver {

        /**
         * A line.
         *
         * @param sender who sent it: each has a header of his own
         * @param seat   whose samples they are, by the sender; empty where the lines say so themselves
         * @param text   holds the line, without its end; used again, and not to be modified
         * @param from its first byte
         * @param to behind its last
         */
        void line(String sender, String seat, byte[] text, int from, int to);

        /**
         * Bytes that are no line: longer than any.
         *
         * @param start the first of them. Not to be modified.
         * @param length how many are there
         */
        void tooLong(String sender, byte[] start, int length);

        /** All lines at hand were taken; some time may pass until the next. */
        void idle();
    }

    /** What it is, in a few words: {@code standard input}, {@code UDP port 5555}. */
    String name();

    /**
     * Hands on what comes, until there is no more, or someone closes the source.
     *
     * @throws IOException if it cannot be read on
     */
    void run(Receiver receiver) throws IOException;

    /** Ends {@link #run}, from another thread. */
    @Override
    void close() throws IOException;
}
