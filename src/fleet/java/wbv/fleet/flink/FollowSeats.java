package wbv.fleet.flink;

import java.io.IOException;
import org.apache.flink.api.common.functions.OpenContext;
import org.apache.flink.api.common.state.ValueState;
import org.apache.flink.api.common.state.ValueStateDescriptor;
import org.apache.flink.api.java.tuple.Tuple3;
import org.apache.flink.streaming.api.functions.KeyedProcessFunction;
import org.apache.flink.util.Collector;
import wbv.fleet.ResultRows;
import wbv.seat.Packet;
import wbv.seat.Seat;
import wbv.seat.SeatPlan;
import wbv.seat.SeatResult;

/**
 * One {@link Seat} for each key. The only timer is one of the events' time, at the end of all of them, where packets that wait for
 * one that never came are given up.
 */
final class FollowSeats extends KeyedProcessFunction<String, Tuple3<Long, String, byte[]>, String> {

    private static final long serialVersionUID = 1;

    private final byte[] order;
    private final long end;
    private transient SeatPlan plan;
    private transient ResultRows rows;
    private transient ValueState<Seat> seats;
    private transient StringBuilder text;

    /** @param order of the seats' plan @param end place behind the last, under which what still waits is told */
    FollowSeats(byte[] order, long end) {
        this.order = order;
        this.end = end;
    }

    @Override
    public void open(OpenContext context) {
        SeatSerializer serializer = new SeatSerializer(order);
        plan = serializer.plan();
        rows = new ResultRows(plan);
        text = new StringBuilder();
        seats = getRuntimeContext().getState(new ValueStateDescriptor<>("seat", serializer));
    }

    @Override
    public void processElement(Tuple3<Long, String, byte[]> sent, Context context, Collector<String> out) throws IOException {
        Seat seat = seats.value();
        if (seat == null) {
            seat = new Seat(sent.f1, plan);
            context.timerService().registerEventTimeTimer(Long.MAX_VALUE);
        }
        Told told = new Told(sent.f0, context, out);
        if (seat.accept(Packet.of(sent.f2), told::write) == Seat.Taken.REFUSED) {
            context.output(Rows.UNREAD, Rows.unread(sent.f0, 1, "has other channels or another rate than the seats' plan", sent.f2));
        }
        seats.update(seat);
    }

    @Override
    public void onTimer(long time, OnTimerContext context, Collector<String> out) throws IOException {
        Seat seat = seats.value();
        seat.flush(new Told(end, context, out)::write);
        seats.update(seat);
    }

    /** Rows of one packet, numbered. */
    private final class Told {

        private final long place;
        private final Context context;
        private final Collector<String> out;
        private int results;
        private int alarms;

        private Told(long place, Context context, Collector<String> out) {
            this.place = place;
            this.context = context;
            this.out = out;
        }

        private void write(SeatResult result) {
            text.setLength(0);
            rows.write(result, text);
            out.collect(Rows.row(place, results++, text));
            result.alarms().forEach(alarm -> {
                text.setLength(0);
                ResultRows.write(result.seat(), alarm, text);
                context.output(Rows.ALARMS, Rows.row(place, alarms++, text));
            });
        }
    }
}
