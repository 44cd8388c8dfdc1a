package wbv.fleet.flink;

import wbv.seat.Seat;
import wbv.seat.SeatPlan;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/** A seat between its packets, and the number of the model of states that it goes by. Bytes until it is asked for: they need no plan. */
final class Kept {

    /** Of the model that the job began with. */
    static final long FIRST = -1;

    private final String name;
    private final long model;
    private final byte[] saved;
    private Seat seat;

    /** @param saved state of the seat. Not modified. */
    Kept(String name, long model, byte[] saved) {
        this.name = name;
        this.model = model;
        this.saved = saved;
    }

    Kept(Seat seat, long model) {
        this(seat.name(), model, new byte[0]);
        this.seat = seat;
    }

    String name() {
        return name;
    }

    /** Number of its model of states. */
    long model() {
        return model;
    }

    /** @param plan with its model of states */
    Seat seat(SeatPlan plan) {
        if (seat == null) {
            seat = new Seat(name, plan);
            StateReader.into(seat, "the state of " + name, saved);
        }
        return seat;
    }

    /** Its state as bytes. Not to be modified. */
    byte[] saved(StateWriter writer) {
        if (seat == null) {
            return saved;
        }
        writer.begin();
        writer.put(seat);
        return writer.finish();
    }
}
