package wbv.seat;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.filter.Method;
import wbv.recording.DataFault;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/** A seat that was saved and loaded gives the results of the undisturbed run, bit for bit. */
class SeatStateTest {

    private static final int PACKETS = 400;
    private static final int POINTS = 220;
    private static final int GOES_ON = 25;

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aSavedSeatGoesOnBitForBit(boolean boxcar) {
        SeatPlan plan = Seats.plan(Method.EKF_ADWIN, boxcar);
        Random random = new Random(6);
        List<Packet> sent = disturbed(Seats.packets("a", PACKETS, 6, 3), random);
        int points = 0;
        Seat seat = new Seat("a", plan);
        byte[][] states = new byte[sent.size() + 1][];
        List<List<SeatResult>> said = new ArrayList<>();
        for (int i = 0; i <= sent.size(); i++) {
            states[i] = StateWriter.of(seat);
            if (i < sent.size()) {
                List<SeatResult> now = new ArrayList<>();
                seat.accept(sent.get(i), now::add);
                said.add(now);
            }
        }
        assertTrue(seat.losses().twice() > 0 && seat.losses().lost() > 0 && seat.losses().restarts() == 1
                && seat.losses().reordered() > 50, seat.losses().toString());
        while (points++ < POINTS) {
            int at = random.nextInt(sent.size() - GOES_ON);
            Seat resumed = new Seat("a", plan);
            StateReader.into(resumed, "seat", states[at]);
            for (int i = at; i < at + GOES_ON; i++) {
                List<SeatResult> now = new ArrayList<>();
                resumed.accept(sent.get(i), now::add);
                assertEquals(said.get(i), now);
            }
            assertArrayEquals(states[at + GOES_ON], StateWriter.of(resumed), "state after packet " + (at + GOES_ON));
        }
    }

    /** Shuffled within 1.5 s, some twice, some lost, and in the middle the sensor begins again. */
    private static List<Packet> disturbed(List<Packet> packets, Random random) {
        List<Packet> sent = new ArrayList<>();
        int half = packets.size() / 2;
        List<Packet> second = packets.subList(half, packets.size()).stream().map(each -> new Packet(each.seat(),
                each.counter() - half, each.time() + 7, each.rate(), each.channels(), each.values())).toList();
        for (List<Packet> part : List.of(packets.subList(0, half), second)) {
            for (Packet packet : SeatTest.shuffled(part, random, 1.5)) {
                for (int k = random.nextInt(40) == 0 ? 0 : random.nextInt(40) == 0 ? 2 : 1; k > 0; k--) {
                    sent.add(packet);
                }
            }
        }
        return sent;
    }

    @Test
    void aStateOfAnotherSeatOrPlanIsRefused() {
        Seat seat = new Seat("a", Seats.plan(Method.EKF, false));
        Seats.packets("a", 30, 6, 1).forEach(packet -> seat.accept(packet, each -> {}));
        byte[] state = StateWriter.of(seat);
        refused("b", Method.EKF, state, "it is of seat 'a', not 'b'");
        refused("a", Method.EKF_ADWIN, state, "saved state of something else");
        Random random = new Random(2);
        for (int i = 0; i < 500; i++) {
            byte[] mutated = random.nextInt(3) == 0 ? Arrays.copyOf(state, random.nextInt(state.length)) : state.clone();
            if (mutated.length == state.length) {
                mutated[random.nextInt(state.length)] ^= (byte) (1 + random.nextInt(255));
            }
            refused("a", Method.EKF, mutated, "state.bin: ");
        }
    }

    private static void refused(String name, Method method, byte[] state, String saying) {
        Seat other = new Seat(name, Seats.plan(method, false));
        DataFault fault = assertThrows(DataFault.class, () -> StateReader.into(other, "state.bin", state));
        assertTrue(fault.getMessage().contains(saying) && fault.getMessage().indexOf('\n') < 0, fault.getMessage());
    }

    /** What 10 000 seats weigh, roughly. */
    @Test
    void aSeatIsSmall() {
        Seat seat = new Seat("a", Seats.plan(Method.EKF_ADWIN, false));
        Seats.packets("a", 600, 6, 1).forEach(packet -> seat.accept(packet, each -> {}));
        int bytes = StateWriter.of(seat).length;
        assertTrue(bytes < 10_000, bytes + " bytes");
    }
}
