package wbv.fleet;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.DoubleBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.Recording;

/**
 * A run of a fleet, so that another machine does the same.
 *
 * @param follow what is done with a seat
 * @param source of the packets
 * @param period of the tables [s of the sensors' time]
 */
public record FleetOrder(SeatOrder follow, FleetSource source, double period) {

    private static final byte REPLAYED = 1;
    private static final byte FILED = 2;
    private static final byte SENT = 3;

    /** Period of the tables where nobody says another [s]. */
    public static final double HOUR = 3600;

    /** Recordings to replay, as {@link FleetSource.Recordings}. */
    public FleetOrder(List<Recording> recordings, SeatOrder follow, int seats, int size, Optional<Long> disturb) {
        this(follow, new FleetSource.Recordings(recordings, seats, size, disturb), HOUR);
    }

    /**
     * The packets of a replay.
     *
     * @throws IllegalStateException if they come from elsewhere
     */
    public Replay replay() {
        if (source instanceof FleetSource.Recordings replayed) {
            return new Replay(replayed.recordings(), follow.channels(), replayed.seats(), replayed.size(), replayed.disturb().isPresent(),
                    replayed.disturb().orElse(0L));
        }
        throw new IllegalStateException("packets come from " + source);
    }

    /** As bytes, for {@link #of}: the channels that seats need, and no others. */
    public byte[] bytes() {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(bytes)) {
            byte[] seat = follow.bytes();
            out.writeInt(seat.length);
            out.write(seat);
            out.writeDouble(period);
            if (source instanceof FleetSource.Recordings replayed) {
                out.writeByte(REPLAYED);
                write(replayed, out);
            } else if (source instanceof FleetSource.Packets given) {
                out.writeByte(FILED);
                out.writeInt(given.files().size());
                for (Path file : given.files()) {
                    out.writeUTF(file.toAbsolutePath().normalize().toString());
                }
            } else if (source instanceof FleetSource.Topic topic) {
                out.writeByte(SENT);
                out.writeUTF(topic.brokers());
                out.writeUTF(topic.topic());
                out.writeUTF(topic.results());
                out.writeBoolean(topic.ends());
            }
        } catch (IOException never) {
            throw new UncheckedIOException(never);
        }
        return bytes.toByteArray();
    }

    private void write(FleetSource.Recordings replayed, DataOutputStream out) throws IOException {
        out.writeInt(replayed.seats());
        out.writeInt(replayed.size());
        out.writeBoolean(replayed.disturb().isPresent());
        out.writeLong(replayed.disturb().orElse(0L));
        out.writeInt(replayed.recordings().size());
        for (Recording recording : replayed.recordings()) {
            out.writeDouble(recording.clock().rate());
            out.writeInt(recording.length());
            for (Channel channel : follow.channels()) {
                ByteBuffer column = ByteBuffer.allocate(Double.BYTES * recording.length());
                column.asDoubleBuffer().put(recording.values(channel));
                out.write(column.array());
            }
        }
    }

    /**
     * Reads an order.
     *
     * @param bytes Not modified.
     * @throws DataFault if they are not those of {@link #bytes}
     */
    public static FleetOrder of(byte[] bytes) {
        try (DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes))) {
            SeatOrder follow = SeatOrder.of(in.readNBytes(in.readInt()));
            double period = in.readDouble();
            return new FleetOrder(follow, source(in, follow), period);
        } catch (IOException | RuntimeException wrong) {
            throw new DataFault("is no order of a fleet: " + wrong.getMessage(), wrong);
        }
    }

    private static FleetSource source(DataInputStream in, SeatOrder follow) throws IOException {
        byte kind = in.readByte();
        switch (kind) {
            case REPLAYED:
                return recordings(in, follow);
            case FILED:
                List<Path> files = new ArrayList<>();
                for (int left = in.readInt(); left > 0; left--) {
                    files.add(Path.of(in.readUTF()));
                }
                return new FleetSource.Packets(files);
            case SENT:
                return new FleetSource.Topic(in.readUTF(), in.readUTF(), in.readUTF(), in.readBoolean());
            default:
                throw new DataFault("has packets of an unknown kind " + kind);
        }
    }

    private static FleetSource recordings(DataInputStream in, SeatOrder follow) throws IOException {
        int seats = in.readInt();
        int size = in.readInt();
        boolean disturbed = in.readBoolean();
        long seed = in.readLong();
        List<Recording> recordings = new ArrayList<>();
        for (int left = in.readInt(); left > 0; left--) {
            Clock clock = new Clock(0, in.readDouble());
            int length = in.readInt();
            Map<Channel, double[]> columns = new LinkedHashMap<>();
            for (Channel channel : follow.channels()) {
                DoubleBuffer column = ByteBuffer.wrap(in.readNBytes(Double.BYTES * length)).asDoubleBuffer();
                double[] values = new double[length];
                column.get(values);
                columns.put(channel, values);
            }
            recordings.add(new Recording(clock, columns, Metadata.NONE));
        }
        return new FleetSource.Recordings(recordings, seats, size, disturbed ? Optional.of(seed) : Optional.empty());
    }
}
