package wbv.fleet.flink;

import java.io.IOException;
import java.util.Arrays;
import org.apache.flink.api.common.typeutils.TypeSerializer;
import org.apache.flink.api.common.typeutils.TypeSerializerSnapshot;
import org.apache.flink.core.memory.DataInputView;
import org.apache.flink.core.memory.DataOutputView;
import wbv.fleet.SeatOrder;
import wbv.seat.Seat;
import wbv.seat.SeatPlan;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/** Seats as bytes: name, length, and the saved state with its version and checksum. The plan is kept once, not with each seat. */
final class SeatSerializer extends TypeSerializer<Seat> {

    private static final long serialVersionUID = 1;

    private final byte[] order;
    /** Both made when they are first needed: Flink sends serializers from machine to machine without. */
    private transient SeatPlan plan;
    private transient StateWriter writer;

    /** @param order of the plan, {@link SeatOrder#bytes} */
    SeatSerializer(byte[] order) {
        this.order = order;
    }

    SeatPlan plan() {
        if (plan == null) {
            plan = SeatOrder.of(order).plan();
        }
        return plan;
    }

    private byte[] saved(Seat seat) {
        if (writer == null) {
            writer = new StateWriter();
        }
        writer.begin();
        writer.put(seat);
        return writer.finish();
    }

    @Override
    public void serialize(Seat seat, DataOutputView out) throws IOException {
        byte[] bytes = saved(seat);
        out.writeUTF(seat.name());
        out.writeInt(bytes.length);
        out.write(bytes);
    }

    @Override
    public Seat deserialize(DataInputView in) throws IOException {
        String name = in.readUTF();
        byte[] bytes = new byte[in.readInt()];
        in.readFully(bytes);
        return loaded(name, bytes);
    }

    @Override
    public Seat copy(Seat from) {
        return loaded(from.name(), saved(from));
    }

    private Seat loaded(String name, byte[] bytes) {
        Seat seat = new Seat(name, plan());
        StateReader.into(seat, "the state of " + name, bytes);
        return seat;
    }

    @Override
    public void copy(DataInputView in, DataOutputView out) throws IOException {
        out.writeUTF(in.readUTF());
        byte[] bytes = new byte[in.readInt()]; // not write(in, length): Flink's own buffer does not grow for it
        in.readFully(bytes);
        out.writeInt(bytes.length);
        out.write(bytes);
    }

    @Override
    public Seat copy(Seat from, Seat reuse) {
        return copy(from);
    }

    @Override
    public Seat deserialize(Seat reuse, DataInputView in) throws IOException {
        return deserialize(in);
    }

    @Override
    public Seat createInstance() {
        return new Seat("-", plan());
    }

    /** Another one for another thread: writers are not shared, the plan is. */
    @Override
    public TypeSerializer<Seat> duplicate() {
        SeatSerializer other = new SeatSerializer(order);
        other.plan = plan();
        return other;
    }

    @Override
    public boolean isImmutableType() {
        return false;
    }

    @Override
    public int getLength() {
        return -1;
    }

    @Override
    public TypeSerializerSnapshot<Seat> snapshotConfiguration() {
        return new SeatSerializerSnapshot(order);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof SeatSerializer that && Arrays.equals(order, that.order);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(order);
    }
}
