package wbv.fleet;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import wbv.filter.Method;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.seat.SeatPlan;
import wbv.state.StateModel;
import wbv.state.StateModelFile;

/**
 * What the usual plan is made of, so that another machine makes the same.
 *
 * @param rate     of the samples [Hz]
 * @param channels of a packet
 * @param method   that follows bodies
 * @param boxcar   true if samples are means over the sampling period
 * @param states   model of states
 * @param interval between results [samples]
 */
public record SeatOrder(double rate, List<Channel> channels, Method method, boolean boxcar, Optional<StateModel> states, int interval) {

    private static final int VERSION = 1;

    public SeatOrder {
        channels = List.copyOf(channels);
    }

    /** The plan. Takes a while: made once for all seats. */
    public SeatPlan plan() {
        return SeatPlan.usual(rate, channels, method, boxcar, states, interval);
    }

    /** As bytes, for {@link #of}. */
    public byte[] bytes() {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(bytes)) {
            out.writeInt(VERSION);
            out.writeDouble(rate);
            out.writeInt(channels.size());
            for (Channel channel : channels) {
                out.writeUTF(channel.toString());
            }
            out.writeUTF(method.word());
            out.writeBoolean(boxcar);
            out.writeInt(interval);
            byte[] model = states.map(each -> StateModelFile.text(each, Map.of())).orElse("").getBytes(StandardCharsets.UTF_8);
            out.writeInt(model.length);
            out.write(model);
        } catch (IOException never) {
            throw new UncheckedIOException(never);
        }
        return bytes.toByteArray();
    }

    /**
     * Reads an order.
     *
     * @param bytes Not modified.
     * @throws DataFault if they are not those of {@link #bytes}
     */
    public static SeatOrder of(byte[] bytes) {
        try (DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes))) {
            int version = in.readInt();
            if (version != VERSION) {
                throw new DataFault("is an order of version " + version + "; this program reads " + VERSION);
            }
            double rate = in.readDouble();
            List<Channel> channels = new ArrayList<>();
            for (int left = in.readInt(); left > 0; left--) {
                channels.add(Channel.parse(in.readUTF()));
            }
            String word = in.readUTF();
            Method method = Method.named(word).orElseThrow(() -> new DataFault("is an order for an unknown estimator '" + word + "'"));
            boolean boxcar = in.readBoolean();
            int interval = in.readInt();
            String model = new String(in.readNBytes(in.readInt()), StandardCharsets.UTF_8);
            Optional<StateModel> states = model.isEmpty() ? Optional.empty() : Optional.of(StateModelFile.parse(model, "the order"));
            return new SeatOrder(rate, channels, method, boxcar, states, interval);
        } catch (IOException | IllegalArgumentException wrong) {
            throw new DataFault("is no order of seats: " + wrong.getMessage(), wrong);
        }
    }
}
