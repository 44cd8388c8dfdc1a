package wbv.fleet.flink;

import java.io.IOException;
import java.util.Arrays;
import org.apache.flink.api.common.typeutils.TypeSerializer;
import org.apache.flink.api.common.typeutils.TypeSerializerSnapshot;
import org.apache.flink.core.memory.DataInputView;
import org.apache.flink.core.memory.DataOutputView;
import wbv.fleet.SeatOrder;
import wbv.snapshot.StateWriter;

/** Seats as bytes: name, number of the model of states, length, and the saved state with its version and checksum. */
final class SeatSerializer extends TypeSerializer<Kept> {

    private static final long serialVersionUID = 1;

    private final byte[] order;
    /** Made when it is first needed: Flink sends serializers from machine to machine without. */
    private transient StateWriter writer;

    /** @param order of the plan that the job began with, {@link SeatOrder#bytes} */
    SeatSerializer(byte[] order) {
        this.order = order;
    }

    private StateWriter writer() {
        if (writer == null) {
            writer = new StateWriter();
        }
        return writer;
    }

    @Override
    public void serialize(Kept seat, DataOutputView out) throws IOException {
        byte[] bytes = seat.saved(writer());
        out.writeUTF(seat.name());
        out.writeLong(seat.model());
        out.writeInt(bytes.length);
        out.write(bytes);
    }

    @Override
    public Kept deserialize(DataInputView in) throws IOException {
        String name = in.readUTF();
        long model = in.readLong();
        byte[] bytes = new byte[in.readInt()];
        in.readFully(bytes);
        return new Kept(name, model, bytes);
    }

    @Override
    public Kept copy(Kept from) {
        return from.copy(writer());
    }

    @Override
    public void copy(DataInputView in, DataOutputView out) throws IOException {
        serialize(deserialize(in), out);
    }

    @Override
    public Kept copy(Kept from, Kept reuse) {
        return copy(from);
    }

    @Override
    public Kept deserialize(Kept reuse, DataInputView in) throws IOException {
        return deserialize(in);
    }

    @Override
    public Kept createInstance() {
        return new Kept("-", Kept.FIRST, new byte[0]);
    }

    /** Another one for another thread: writers are not shared. */
    @Override
    public TypeSerializer<Kept> duplicate() {
        return new SeatSerializer(order);
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
    public TypeSerializerSnapshot<Kept> snapshotConfiguration() {
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
