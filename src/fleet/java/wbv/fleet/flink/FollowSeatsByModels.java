package wbv.fleet.flink;

import java.nio.charset.StandardCharsets;
import java.util.Map;
import org.apache.flink.api.common.functions.OpenContext;
import org.apache.flink.api.common.state.BroadcastState;
import org.apache.flink.api.common.state.MapStateDescriptor;
import org.apache.flink.api.common.state.ReadOnlyBroadcastState;
import org.apache.flink.api.common.state.ValueStateDescriptor;
import org.apache.flink.api.common.typeinfo.Types;
import org.apache.flink.api.java.tuple.Tuple2;
import org.apache.flink.api.java.tuple.Tuple3;
import org.apache.flink.streaming.api.functions.co.KeyedBroadcastProcessFunction;
import org.apache.flink.util.Collector;
import wbv.fleet.SeatOrder;
import wbv.recording.DataFault;

/**
 * {@link FollowSeats} whose model of states may be replaced while it runs. A model has a number and the sensors' time from which it
 * holds; a seat goes by the one with the highest number that holds at its packet, and never back to an older one. It is sent before
 * its time: then results do not depend on when it came.
 */
final class FollowSeatsByModels
        extends KeyedBroadcastProcessFunction<String, Tuple3<Long, String, byte[]>, Tuple3<Long, Double, String>, String> {

    /** Number of a model, from when it holds [s], and its text. */
    static final MapStateDescriptor<Long, Tuple2<Double, String>> MODELS = new MapStateDescriptor<>("models", Types.LONG,
            Types.TUPLE(Types.DOUBLE, Types.STRING));
    private static final long serialVersionUID = 1;

    private final byte[] order;
    private transient Follower follower;

    /** @param order of the seats' plan */
    FollowSeatsByModels(byte[] order) {
        this.order = order;
    }

    @Override
    public void open(OpenContext context) {
        follower = new Follower(order,
                getRuntimeContext().getState(new ValueStateDescriptor<>(FollowSeats.STATE, new SeatSerializer(order))));
    }

    @Override
    public void processBroadcastElement(Tuple3<Long, Double, String> sent, Context context, Collector<String> out) throws Exception {
        try {
            if (Double.isNaN(sent.f1)) {
                throw new DataFault("a model's key is the sensors' time from which it holds [s]");
            }
            Follower.plan(SeatOrder.of(order), sent.f2);
        } catch (DataFault unread) {
            if (getRuntimeContext().getTaskInfo().getIndexOfThisSubtask() == 0) { // all of them hear it, one tells
                context.output(Rows.UNREAD, Rows.unread(Rows.place(sent.f0, 0), 2, unread.getMessage(),
                        sent.f2.getBytes(StandardCharsets.UTF_8)));
            }
            return;
        }
        BroadcastState<Long, Tuple2<Double, String>> models = context.getBroadcastState(MODELS);
        models.put(sent.f0, Tuple2.of(sent.f1, sent.f2));
    }

    @Override
    public void processElement(Tuple3<Long, String, byte[]> sent, ReadOnlyContext context, Collector<String> out) throws Exception {
        if (follower.accept(sent.f0, sent.f1, sent.f2, new Sent(context.getBroadcastState(MODELS)),
                new Follower.Told(out, context::output))) {
            context.timerService().registerEventTimeTimer(Long.MAX_VALUE);
        }
    }

    @Override
    public void onTimer(long time, OnTimerContext context, Collector<String> out) throws Exception {
        follower.flush(Rows.END, new Sent(context.getBroadcastState(MODELS)), new Follower.Told(out, context::output));
    }

    private record Sent(ReadOnlyBroadcastState<Long, Tuple2<Double, String>> models) implements Follower.Models {

        @Override
        public long at(double time) throws Exception {
            long newest = Kept.FIRST;
            for (Map.Entry<Long, Tuple2<Double, String>> each : models.immutableEntries()) {
                if (each.getValue().f0 <= time) {
                    newest = Math.max(newest, each.getKey());
                }
            }
            return newest;
        }

        @Override
        public String text(long number) throws Exception {
            return models.get(number).f1;
        }
    }
}
