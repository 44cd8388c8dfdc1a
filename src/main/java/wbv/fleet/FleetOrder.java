package wbv.fleet;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.DoubleBuffer;
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
 * A run of a fleet, so that another machine does the same: recordings to replay and what is done with each seat.
 *
 * @param recordings of one rate, each with all the channels of the seats
 * @param follow     what is done with a seat
 * @param seats      number of them
 * @param size       samples of a packet
 * @param disturb    seed of a bad network, if there is one
 */
public record FleetOrder(List<Recording> recordings, SeatOrder follow, int seats, int size, Optional<Long> disturb) {

    public FleetOrder {
        recordings = List.copyOf(recordings);
    }

    /** The packets. */
    public Replay replay() {
        return new Replay(recordings, follow.channels(), seats, size, disturb.isPresent(), disturb.orElse(0L));
    }

    /** As bytes, for {@link #of}: the channels that seats need, and no others. */
    public byte[] bytes() {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(bytes)) {
            byte[] seat = follow.bytes();
            out.writeInt(seat.length);
            out.write(seat);
            out.writeInt(seats);
            out.writeInt(size);
            out.writeBoolean(disturb.isPresent());
            out.writeLong(disturb.orElse(0L));
            out.writeInt(recordings.size());
            for (Recording recording : recordings) {
                out.writeDouble(recording.clock().rate());
                out.writeInt(recording.length());
                for (Channel channel : follow.channels()) {
                    ByteBuffer column = ByteBuffer.allocate(Double.BYTES * recording.length());
                    column.asDoubleBuffer().put(recording.values(channel));
                    out.write(column.array());
                }
            }
        } catch (IOException never) {
            throw new UncheckedIOException(never);
        }
        return bytes.toByteArray();
    }

    /** @throws DataFault if the bytes are not those of {@link #bytes} */
    public static FleetOrder of(byte[] bytes) {
        try (DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes))) {
            SeatOrder follow = SeatOrder.of(in.readNBytes(in.readInt()));
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
            return new FleetOrder(recordings, follow, seats, size, disturbed ? Optional.of(seed) : Optional.empty());
        } catch (IOException | RuntimeException wrong) {
            throw new DataFault("is no order of a fleet: " + wrong.getMessage(), wrong);
        }
    }
}
