package wbv.fleet.flink;

import wbv.seat.Seat;
import wbv.seat.SeatPlan;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * A seat between its packets, and the number of the model of states that it goes by. Bytes until it is asked for: they need no plan.
 * A checkpoint that is being written holds it while its seat goes on with a copy: then the bytes stay here and the seat moves on,
 * since to write it is a tenth of the work of making it anew. Two threads meet here, and nowhere else.
 */
final class Kept {

    /** Of the model that the job began with. */
    static final long FIRST = -1;

    private final String name;
    private final long model;
    private byte[] saved;
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
    synchronized Seat seat(SeatPlan plan) {
        if (seat == null) {
            seat = new Seat(name, plan);
            StateReader.into(seat, "the state of " + name, saved);
        }
        return seat;
    }

    /** Its state as bytes. Not to be modified. */
    synchronized byte[] saved(StateWriter writer) {
        if (seat == null) {
            return saved;
        }
        writer.begin();
        writer.put(seat);
        return writer.finish();
    }

    /** The same, which goes on; this one stays as it is. */
    synchronized Kept copy(StateWriter writer) {
        saved = saved(writer);
        Kept copy = new Kept(name, model, saved);
        copy.seat = seat;
        seat = null;
        return copy;
    }
}
