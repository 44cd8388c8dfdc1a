package wbv.fleet;

import java.util.ArrayDeque;
import java.util.Optional;
import java.util.Queue;
import wbv.seat.Packet;

/** The packets of a replay, round by round, within a round seat by seat. */
final class ReplayFeed implements Feed {

    private final Replay replay;
    private final Queue<Packet> ready = new ArrayDeque<>();
    private int round;
    private int seat;
    private int given;
    private long count;

    ReplayFeed(Replay replay, Place from) {
        this.replay = replay;
        this.round = from.part();
        this.seat = (int) from.at();
        this.count = from.count();
        fill();
        for (given = 0; given < from.given(); given++) {
            ready.remove();
        }
    }

    private void fill() {
        given = 0;
        if (round < replay.rounds()) {
            replay.packets(seat, round, ready::add);
        }
    }

    @Override
    public String text() {
        return replay.text();
    }

    @Override
    public Optional<Sent> next() {
        return packet().map(Read::new);
    }

    /** As {@link #next}. */
    Optional<Packet> packet() {
        while (ready.isEmpty() && round < replay.rounds()) {
            seat++;
            if (seat == replay.seats()) {
                seat = 0;
                round++;
            }
            fill();
        }
        if (ready.isEmpty()) {
            return Optional.empty();
        }
        given++;
        count++;
        return Optional.of(ready.remove());
    }

    @Override
    public Place place() {
        return new Place(count, round, seat, given);
    }

    @Override
    public double share() {
        return (double) round / replay.rounds();
    }

    @Override
    public void close() {}
}
