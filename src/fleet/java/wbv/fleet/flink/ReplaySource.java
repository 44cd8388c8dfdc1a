package wbv.fleet.flink;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Iterator;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.Queue;
import org.apache.flink.api.connector.source.Boundedness;
import org.apache.flink.api.connector.source.Source;
import org.apache.flink.api.connector.source.SourceReader;
import org.apache.flink.api.connector.source.SourceReaderContext;
import org.apache.flink.api.connector.source.SplitEnumerator;
import org.apache.flink.api.connector.source.SplitEnumeratorContext;
import org.apache.flink.api.connector.source.lib.util.IteratorSourceEnumerator;
import org.apache.flink.api.connector.source.lib.util.IteratorSourceReader;
import org.apache.flink.api.connector.source.lib.util.IteratorSourceSplit;
import org.apache.flink.api.java.tuple.Tuple2;
import org.apache.flink.core.io.SimpleVersionedSerializer;
import wbv.fleet.FleetOrder;
import wbv.fleet.Replay;

/**
 * The packets of {@link Replay} in bytes, each with its place. A split is a block of seats, round by round: all
 * packets of a seat come from one split in their order, whatever the number of readers.
 */
final class ReplaySource implements Source<Tuple2<Long, byte[]>, ReplaySource.Block, Collection<ReplaySource.Block>> {

    private static final long serialVersionUID = 1;

    private final byte[] order;
    private final int blocks;
    private transient Replay replay;

    /**
     * @param order {@link FleetOrder#bytes}
     * @param blocks that seats are divided into
     */
    ReplaySource(byte[] order, int blocks) {
        this.order = order;
        this.blocks = blocks;
    }

    private synchronized Replay replay() {
        if (replay == null) {
            replay = FleetOrder.of(order).replay();
        }
        return replay;
    }

    @Override
    public Boundedness getBoundedness() {
        return Boundedness.BOUNDED;
    }

    @Override
    public SourceReader<Tuple2<Long, byte[]>, Block> createReader(SourceReaderContext context) {
        return new IteratorSourceReader<>(context);
    }

    @Override
    public SplitEnumerator<Block, Collection<Block>> createEnumerator(SplitEnumeratorContext<Block> context) {
        int seats = replay().seats();
        int count = Math.min(blocks, seats);
        List<Block> all = new ArrayList<>();
        for (int b = 0; b < count; b++) {
            int from = (int) ((long) seats * b / count);
            all.add(new Block(this, from, (int) ((long) seats * (b + 1) / count), 0, from, 0));
        }
        return new IteratorSourceEnumerator<>(context, all);
    }

    @Override
    public SplitEnumerator<Block, Collection<Block>> restoreEnumerator(SplitEnumeratorContext<Block> context, Collection<Block> left) {
        return new IteratorSourceEnumerator<>(context, left);
    }

    @Override
    public SimpleVersionedSerializer<Block> getSplitSerializer() {
        return new BlockForm(this);
    }

    @Override
    public SimpleVersionedSerializer<Collection<Block>> getEnumeratorCheckpointSerializer() {
        return new BlocksForm(this);
    }

    /**
     * Seats and where their replay stands.
     *
     * @param from  first seat
     * @param to behind the last
     * @param round of the next packet
     * @param seat of it
     * @param given packets of this seat and round that were given before
     */
    record Block(ReplaySource source, int from, int to, int round, int seat, int given)
            implements IteratorSourceSplit<Tuple2<Long, byte[]>, Packets> {

        @Override
        public String splitId() {
            return from + "-" + to;
        }

        @Override
        public Packets getIterator() {
            return new Packets(this);
        }

        @Override
        public IteratorSourceSplit<Tuple2<Long, byte[]>, Packets> getUpdatedSplitForIterator(Packets packets) {
            return new Block(source, from, to, packets.round, packets.seat, packets.given);
        }
    }

    /** The packets of a block. */
    static final class Packets implements Iterator<Tuple2<Long, byte[]>> {

        private final Replay replay;
        private final Block block;
        private final Queue<byte[]> ready = new ArrayDeque<>();
        private int round;
        private int seat;
        private int given;

        private Packets(Block block) {
            this.replay = block.source.replay();
            this.block = block;
            this.round = block.round;
            this.seat = block.seat;
            fill();
            for (int skipped = 0; skipped < block.given; skipped++) {
                ready.remove();
            }
            this.given = block.given;
            advance();
        }

        private void fill() {
            given = 0;
            if (round < replay.rounds()) {
                replay.packets(seat, round, packet -> ready.add(packet.bytes()));
            }
        }

        /** To the next seat, or the next round's first, that has a packet. */
        private void advance() {
            while (ready.isEmpty() && round < replay.rounds()) {
                seat++;
                if (seat == block.to) {
                    seat = block.from;
                    round++;
                }
                fill();
            }
        }

        @Override
        public boolean hasNext() {
            return !ready.isEmpty();
        }

        @Override
        public Tuple2<Long, byte[]> next() {
            if (ready.isEmpty()) {
                throw new NoSuchElementException();
            }
            Tuple2<Long, byte[]> next = Tuple2.of(Rows.place(round, given), ready.remove());
            given++;
            advance();
            return next;
        }
    }

    private static void write(Block block, DataOutputStream out) throws IOException {
        for (int each : new int[] {block.from, block.to, block.round, block.seat, block.given}) {
            out.writeInt(each);
        }
    }

    private static Block read(ReplaySource source, DataInputStream in) throws IOException {
        return new Block(source, in.readInt(), in.readInt(), in.readInt(), in.readInt(), in.readInt());
    }

    private static void require(int version) throws IOException {
        if (version != 1) {
            throw new IOException("the replay's place is of version " + version + "; this program reads 1");
        }
    }

    private record BlockForm(ReplaySource source) implements SimpleVersionedSerializer<Block> {

        @Override
        public int getVersion() {
            return 1;
        }

        @Override
        public byte[] serialize(Block block) throws IOException {
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            write(block, new DataOutputStream(bytes));
            return bytes.toByteArray();
        }

        @Override
        public Block deserialize(int version, byte[] bytes) throws IOException {
            require(version);
            return read(source, new DataInputStream(new ByteArrayInputStream(bytes)));
        }
    }

    private record BlocksForm(ReplaySource source) implements SimpleVersionedSerializer<Collection<Block>> {

        @Override
        public int getVersion() {
            return 1;
        }

        @Override
        public byte[] serialize(Collection<Block> blocks) throws IOException {
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            DataOutputStream out = new DataOutputStream(bytes);
            out.writeInt(blocks.size());
            for (Block block : blocks) {
                write(block, out);
            }
            return bytes.toByteArray();
        }

        @Override
        public Collection<Block> deserialize(int version, byte[] bytes) throws IOException {
            require(version);
            DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes));
            List<Block> blocks = new ArrayList<>();
            for (int left = in.readInt(); left > 0; left--) {
                blocks.add(read(source, in));
            }
            return blocks;
        }
    }
}
