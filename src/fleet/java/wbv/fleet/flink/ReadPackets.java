package wbv.fleet.flink;

import org.apache.flink.api.java.tuple.Tuple2;
import org.apache.flink.api.java.tuple.Tuple3;
import org.apache.flink.streaming.api.functions.ProcessFunction;
import org.apache.flink.util.Collector;
import wbv.recording.DataFault;
import wbv.seat.Packet;

/** Finds whose packets are; those that cannot be read are put aside with the reason. */
final class ReadPackets extends ProcessFunction<Tuple2<Long, byte[]>, Tuple3<Long, String, byte[]>> {

    private static final long serialVersionUID = 1;

    @Override
    public void processElement(Tuple2<Long, byte[]> sent, Context context, Collector<Tuple3<Long, String, byte[]>> out) {
        byte[] bytes = sent.f1;
        try {
            String seat = Packet.frame(bytes, 0, bytes.length) == bytes.length ? Packet.seat(bytes) : Packet.of(bytes).seat();
            out.collect(Tuple3.of(sent.f0, seat, bytes));
        } catch (DataFault unread) {
            context.output(Rows.UNREAD, Rows.unread(sent.f0, 0, unread.getMessage(), bytes));
        }
    }
}
