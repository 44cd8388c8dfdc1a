package wbv.fleet.flink;

import java.io.IOException;
import org.apache.flink.api.common.typeutils.TypeSerializer;
import org.apache.flink.api.common.typeutils.TypeSerializerSchemaCompatibility;
import org.apache.flink.api.common.typeutils.TypeSerializerSnapshot;
import org.apache.flink.core.memory.DataInputView;
import org.apache.flink.core.memory.DataOutputView;
import wbv.fleet.SeatOrder;

import wbv.snapshot.StateWriter;

/**
 * What a checkpoint says about its seats: the version of their form and what their plan is made of, so that they can be read by the
 * checkpoint alone. Older forms are read; seats of another plan are refused.
 */
public final class SeatSerializerSnapshot implements TypeSerializerSnapshot<Kept> {

    private byte[] order = {};

    /** For Flink, which reads it then. */
    public SeatSerializerSnapshot() {}

    SeatSerializerSnapshot(byte[] order) {
        this.order = order;
    }

    @Override
    public int getCurrentVersion() {
        return StateWriter.VERSION;
    }

    @Override
    public void writeSnapshot(DataOutputView out) throws IOException {
        out.writeInt(order.length);
        out.write(order);
    }

    @Override
    public void readSnapshot(int version, DataInputView in, ClassLoader loader) throws IOException {
        if (version < 1 || version > StateWriter.VERSION) {
            throw new IOException("the checkpoint's seats are of version " + version + "; this program reads 1 to " + StateWriter.VERSION);
        }
        order = new byte[in.readInt()];
        in.readFully(order);
    }

    @Override
    public TypeSerializer<Kept> restoreSerializer() {
        return new SeatSerializer(order);
    }

    @Override
    public TypeSerializerSchemaCompatibility<Kept> resolveSchemaCompatibility(TypeSerializerSnapshot<Kept> old) {
        boolean samePlan = old instanceof SeatSerializerSnapshot that
                && SeatOrder.of(that.order).plan().text().equals(SeatOrder.of(order).plan().text());
        return samePlan ? TypeSerializerSchemaCompatibility.compatibleAsIs() : TypeSerializerSchemaCompatibility.incompatible();
    }
}
