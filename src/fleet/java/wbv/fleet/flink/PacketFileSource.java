package wbv.fleet.flink;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Iterator;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.Optional;
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
import wbv.fleet.PacketFiles;

/**
 * Files of packets, one after the other: their order is the seats' order, so one reader reads them all. It takes a fiftieth of what
 * those who follow the seats take.
 */
final class PacketFileSource implements Source<Tuple2<Long, byte[]>, PacketFileSource.Rest, Collection<PacketFileSource.Rest>> {

    private static final long serialVersionUID = 1;

    private final ArrayList<String> files;

    PacketFileSource(List<Path> files) {
        this.files = new ArrayList<>(files.stream().map(Path::toString).toList());
    }

    @Override
    public Boundedness getBoundedness() {
        return Boundedness.BOUNDED;
    }

    @Override
    public SourceReader<Tuple2<Long, byte[]>, Rest> createReader(SourceReaderContext context) {
        return new IteratorSourceReader<>(context);
    }

    @Override
    public SplitEnumerator<Rest, Collection<Rest>> createEnumerator(SplitEnumeratorContext<Rest> context) {
        return new IteratorSourceEnumerator<>(context, new ArrayList<>(List.of(new Rest(this, 0, 0, 0))));
    }

    @Override
    public SplitEnumerator<Rest, Collection<Rest>> restoreEnumerator(SplitEnumeratorContext<Rest> context, Collection<Rest> left) {
        return new IteratorSourceEnumerator<>(context, left);
    }

    @Override
    public SimpleVersionedSerializer<Rest> getSplitSerializer() {
        return new RestForm(this);
    }

    @Override
    public SimpleVersionedSerializer<Collection<Rest>> getEnumeratorCheckpointSerializer() {
        return new RestsForm(new RestForm(this));
    }

    /**
     * What is to be read.
     *
     * @param part file that is next
     * @param at byte in it
     * @param count packets before
     */
    record Rest(PacketFileSource source, int part, long at, long count) implements IteratorSourceSplit<Tuple2<Long, byte[]>, Packets> {

        @Override
        public String splitId() {
            return "files";
        }

        @Override
        public Packets getIterator() {
            return new Packets(this);
        }

        @Override
        public IteratorSourceSplit<Tuple2<Long, byte[]>, Packets> getUpdatedSplitForIterator(Packets packets) {
            return new Rest(source, packets.part, packets.at, packets.count);
        }
    }

    /** The packets. */
    static final class Packets implements Iterator<Tuple2<Long, byte[]>> {

        private final PacketFiles files;
        private int part;
        private long at;
        private long count;
        private Optional<byte[]> ready;

        private Packets(Rest rest) {
            files = new PacketFiles(rest.source.files.stream().map(Path::of).toList(), rest.part, rest.at, rest.count);
            advance();
        }

        private void advance() {
            try {
                part = files.part();
                at = files.at();
                count = files.count();
                ready = files.next();
            } catch (IOException failed) {
                throw new UncheckedIOException(failed);
            }
        }

        @Override
        public boolean hasNext() {
            return ready.isPresent();
        }

        @Override
        public Tuple2<Long, byte[]> next() {
            Tuple2<Long, byte[]> next = Tuple2.of(Rows.place(count, 0), ready.orElseThrow(NoSuchElementException::new));
            advance();
            return next;
        }
    }

    private record RestForm(PacketFileSource source) implements SimpleVersionedSerializer<Rest> {

        @Override
        public int getVersion() {
            return 1;
        }

        @Override
        public byte[] serialize(Rest rest) throws IOException {
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            DataOutputStream out = new DataOutputStream(bytes);
            out.writeInt(rest.part);
            out.writeLong(rest.at);
            out.writeLong(rest.count);
            return bytes.toByteArray();
        }

        @Override
        public Rest deserialize(int version, byte[] bytes) throws IOException {
            if (version != 1) {
                throw new IOException("the place in the files is of version " + version + "; this program reads 1");
            }
            DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes));
            return new Rest(source, in.readInt(), in.readLong(), in.readLong());
        }
    }

    private record RestsForm(RestForm one) implements SimpleVersionedSerializer<Collection<Rest>> {

        @Override
        public int getVersion() {
            return 1;
        }

        @Override
        public byte[] serialize(Collection<Rest> rests) throws IOException {
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            for (Rest rest : rests) { // one at most
                bytes.write(one.serialize(rest));
            }
            return bytes.toByteArray();
        }

        @Override
        public Collection<Rest> deserialize(int version, byte[] bytes) throws IOException {
            Collection<Rest> rests = new ArrayList<>();
            if (bytes.length > 0) {
                rests.add(one.deserialize(version, bytes));
            }
            return rests;
        }
    }
}
