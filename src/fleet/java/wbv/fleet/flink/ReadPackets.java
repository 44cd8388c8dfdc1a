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
        try {
            out.collect(Tuple3.of(sent.f0, Packet.of(sent.f1).seat(), sent.f1));
        } catch (DataFault unread) {
            context.output(Rows.UNREAD, Rows.unread(sent.f0, 0, unread.getMessage(), sent.f1));
        }
    }
}
