package wbv.fleet.flink;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import org.apache.flink.api.common.state.ValueState;
import org.apache.flink.util.Collector;
import org.apache.flink.util.OutputTag;
import wbv.fleet.ResultRows;
import wbv.fleet.SeatOrder;
import wbv.recording.DataFault;
import wbv.seat.Packet;
import wbv.seat.Seat;
import wbv.seat.SeatPlan;
import wbv.seat.SeatResult;
import wbv.state.StateModel;
import wbv.state.StateModelFile;

/** What is done with the packets of the seat whose turn it is, whatever came beside them. */
final class Follower {

    private final SeatOrder order;
    private final ValueState<Kept> seats;
    private final ResultRows rows;
    private final Map<Long, SeatPlan> plans = new HashMap<>();
    private final StringBuilder text = new StringBuilder();

    /** Where rows go. */
    record Told(Collector<String> results, BiConsumer<OutputTag<String>, String> others) {

        void result(String row) {
            results.collect(row);
        }

        void beside(OutputTag<String> tag, String row) {
            others.accept(tag, row);
        }
    }

    /** The model that a seat is to go by. */
    interface Models {

        /**
         * @param time of a packet [s]
         * @return number of the newest that holds then, at least so old; {@link Kept#FIRST} before any
         */
        long at(double time) throws Exception;

        /** Text of a model, by its number. */
        String text(long number) throws Exception;
    }

    Follower(byte[] order, ValueState<Kept> seats) {
        this.order = SeatOrder.of(order);
        this.seats = seats;
        SeatPlan first = this.order.plan();
        plans.put(Kept.FIRST, first);
        this.rows = new ResultRows(first);
    }

    /**
     * The plan with another model of states.
     *
     * @throws DataFault if the model does not go with the packets, or the job began without one: its rows have no place for states
     */
    static SeatPlan plan(SeatOrder order, String model) {
        StateModel states = StateModelFile.parse(model, "the model");
        if (order.states().isEmpty()) {
            throw new DataFault("the seats are followed without states; begin the job with a model");
        }
        SeatPlan plan = new SeatOrder(order.rate(), order.channels(), order.method(), order.boxcar(), Optional.of(states),
                order.interval()).plan();
        if (plan.states().isEmpty()) {
            throw new DataFault("the model's channels or rate are not those of the packets: " + states.features().channels() + " at "
                    + states.features().rate() + " Hz");
        }
        return plan;
    }

    private SeatPlan plan(long model, Models models) throws Exception {
        SeatPlan plan = plans.get(model);
        if (plan == null) {
            plan = plan(order, models.text(model));
            plans.put(model, plan);
        }
        return plan;
    }

    /**
     * Takes a packet.
     *
     * @return whether it is the first of its seat
     */
    boolean accept(long place, String name, byte[] bytes, Models models, Told told) throws Exception {
        Packet packet;
        try {
            packet = Packet.of(bytes);
        } catch (DataFault unread) {
            told.beside(Rows.UNREAD, Rows.unread(place, 1, unread.getMessage(), bytes));
            return false;
        }
        Kept kept = seats.value();
        boolean first = kept == null;
        long model = models.at(packet.time());
        Seat seat;
        if (first) {
            seat = new Seat(name, plan(model, models));
        } else {
            model = Math.max(model, kept.model());
            seat = kept.seat(plan(kept.model(), models));
            if (model != kept.model()) {
                seat = seat.under(plan(model, models));
            }
        }
        Numbered numbered = new Numbered(place, told);
        if (seat.accept(packet, numbered::write) == Seat.Taken.REFUSED) {
            told.beside(Rows.UNREAD, Rows.unread(place, 1, ResultRows.REFUSED, bytes));
        }
        seats.update(first || model != kept.model() ? new Kept(seat, model) : kept);
        return first;
    }

    /** Gives up what the seat's packets wait for. */
    void flush(long place, Models models, Told told) throws Exception {
        Kept kept = seats.value();
        kept.seat(plan(kept.model(), models)).flush(new Numbered(place, told)::write);
        seats.update(kept);
    }

    /** Rows of one packet, numbered. */
    private final class Numbered {

        private final long place;
        private final Told told;
        private int results;
        private int alarms;

        private Numbered(long place, Told told) {
            this.place = place;
            this.told = told;
        }

        private void write(SeatResult result) {
            text.setLength(0);
            rows.write(result, text);
            told.result(Rows.row(place, results++, text));
            result.alarms().forEach(alarm -> {
                text.setLength(0);
                ResultRows.write(result.seat(), alarm, text);
                told.beside(Rows.ALARMS, Rows.row(place, alarms++, text));
            });
        }
    }
}
