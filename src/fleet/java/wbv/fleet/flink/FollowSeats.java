package wbv.fleet.flink;

import org.apache.flink.api.common.functions.OpenContext;
import org.apache.flink.api.common.state.ValueStateDescriptor;
import org.apache.flink.api.java.tuple.Tuple3;
import org.apache.flink.streaming.api.functions.KeyedProcessFunction;
import org.apache.flink.util.Collector;

/**
 * One {@link wbv.seat.Seat} for each key. The only timer is one of the events' time, at the end of all of them, where packets that
 * wait for one that never came are given up.
 */
final class FollowSeats extends KeyedProcessFunction<String, Tuple3<Long, String, byte[]>, String> {

    static final String STATE = "seat";
    private static final long serialVersionUID = 1;

    private final byte[] order;
    private transient Follower follower;

    /** @param order of the seats' plan */
    FollowSeats(byte[] order) {
        this.order = order;
    }

    @Override
    public void open(OpenContext context) {
        follower = new Follower(order, getRuntimeContext().getState(new ValueStateDescriptor<>(STATE, new SeatSerializer(order))));
    }

    @Override
    public void processElement(Tuple3<Long, String, byte[]> sent, Context context, Collector<String> out) throws Exception {
        if (follower.accept(sent.f0, sent.f1, sent.f2, FirstModel.ONLY, new Follower.Told(out, context::output))) {
            context.timerService().registerEventTimeTimer(Long.MAX_VALUE);
        }
    }

    @Override
    public void onTimer(long time, OnTimerContext context, Collector<String> out) throws Exception {
        follower.flush(Rows.END, FirstModel.ONLY, new Follower.Told(out, context::output));
    }

    /** No other model comes. */
    private enum FirstModel implements Follower.Models {
        ONLY;

        @Override
        public long at(double time) {
            return Kept.FIRST;
        }

        @Override
        public String text(long number) {
            throw new IllegalStateException("a seat goes by model " + number + ", which is not in this job");
        }
    }
}
