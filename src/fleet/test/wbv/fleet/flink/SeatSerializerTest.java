package wbv.fleet.flink;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.apache.flink.api.common.typeutils.TypeSerializer;
import org.apache.flink.api.common.typeutils.TypeSerializerSnapshot;
import org.apache.flink.api.java.tuple.Tuple2;
import org.apache.flink.core.memory.DataInputDeserializer;
import org.apache.flink.core.memory.DataOutputSerializer;
import org.apache.flink.util.InstantiationUtil;
import org.junit.jupiter.api.Test;
import wbv.filter.Method;
import wbv.fleet.FleetOrder;
import wbv.fleet.FleetSource;
import wbv.fleet.Replay;
import wbv.fleet.SeatOrder;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.rig.RigSpec;
import wbv.seat.Packet;
import wbv.seat.Seat;
import wbv.seat.SeatPlan;
import wbv.seat.SeatResult;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;
import wbv.state.StateModelFile;

class SeatSerializerTest {

    private static final Recording RECORDING = RigSpec.oneDof(0.35, 5, 1, 30, 3).recording();

    private static FleetOrder order(int interval) {
        SeatOrder follow = new SeatOrder(60, RECORDING.channels(), Method.EKF_ADWIN, false, Optional.empty(), interval);
        return new FleetOrder(List.of(RECORDING), follow, 5, 6, Optional.of(2L));
    }

    private static SeatSerializer serializer() {
        return new SeatSerializer(order(60).follow().bytes());
    }

    private static byte[] bytes(TypeSerializer<Kept> serializer, Seat seat) throws IOException {
        DataOutputSerializer out = new DataOutputSerializer(64);
        serializer.serialize(new Kept(seat, 3), out);
        return out.getCopyOfBuffer();
    }

    /** Serialised, copied in either way and read by what the checkpoint alone says: all go on bit for bit. */
    @Test
    void copiesGoOnAsTheSeatItself() throws Exception {
        SeatSerializer serializer = serializer();
        SeatPlan plan = order(60).follow().plan();
        Replay replay = order(60).replay();
        Random random = new Random(5);
        for (int k = 0; k < 5; k++) {
            Seat seat = new Seat(replay.name(k), plan);
            List<Packet> packets = new ArrayList<>();
            for (int round = 0; round < replay.rounds(); round++) {
                replay.packets(k, round, packets::add);
            }
            int stop = random.nextInt(packets.size());
            packets.subList(0, stop).forEach(packet -> seat.accept(packet, each -> {}));
            DataOutputSerializer streamed = new DataOutputSerializer(64);
            serializer.copy(new DataInputDeserializer(bytes(serializer, seat)), streamed);
            DataOutputSerializer kept = new DataOutputSerializer(64);
            TypeSerializerSnapshot.writeVersionedSnapshot(kept, serializer.snapshotConfiguration());
            TypeSerializer<Kept> restored = TypeSerializerSnapshot.<Kept>readVersionedSnapshot(
                    new DataInputDeserializer(kept.getCopyOfBuffer()), getClass().getClassLoader()).restoreSerializer();
            assertEquals(serializer, restored);
            TypeSerializer<Kept> shipped = InstantiationUtil.clone(serializer);
            Kept live = new Kept(another(seat, plan), 3);
            List<Kept> copies = List.of(serializer.copy(live), serializer.duplicate().copy(live), shipped.copy(serializer.copy(live)), live,
                    restored.deserialize(new DataInputDeserializer(streamed.getCopyOfBuffer())));
            List<SeatResult> expected = rest(seat, packets.subList(stop, packets.size()));
            for (Kept each : copies) {
                assertEquals(3, each.model());
                Seat copy = each.seat(plan);
                assertNotSame(seat, copy);
                assertEquals(expected, rest(copy, packets.subList(stop, packets.size())));
                assertArrayEquals(StateWriter.of(seat), StateWriter.of(copy));
            }
        }
    }

    private static Seat another(Seat seat, SeatPlan plan) {
        Seat same = new Seat(seat.name(), plan);
        StateReader.into(same, "the test", StateWriter.of(seat));
        return same;
    }

    private static List<SeatResult> rest(Seat seat, List<Packet> packets) {
        List<SeatResult> results = new ArrayList<>();
        packets.forEach(packet -> seat.accept(packet, results::add));
        seat.flush(results::add);
        return results;
    }

    @Test
    void seatsOfAnotherPlanAreRefused() {
        TypeSerializerSnapshot<Kept> mine = serializer().snapshotConfiguration();
        TypeSerializerSnapshot<Kept> other = new SeatSerializer(order(30).follow().bytes()).snapshotConfiguration();
        assertTrue(mine.resolveSchemaCompatibility(serializer().snapshotConfiguration()).isCompatibleAsIs());
        assertTrue(mine.resolveSchemaCompatibility(other).isIncompatible());
    }

    @Test
    void anOrderIsReadAsItWasWritten() {
        FleetOrder order = order(60);
        FleetOrder read = FleetOrder.of(order.bytes());
        assertEquals(order.replay().text(), read.replay().text());
        assertEquals(order.follow().plan().text(), read.follow().plan().text());
        SeatOrder states = new SeatOrder(60, StateModelFile.shipped().features().channels(), Method.EKF, true,
                Optional.of(StateModelFile.shipped()), 7);
        SeatOrder again = SeatOrder.of(states.bytes());
        assertTrue(again.states().isPresent());
        assertArrayEquals(states.bytes(), again.bytes());
        byte[] bytes = order.bytes();
        for (int length : new int[] {0, 3, 40, bytes.length / 2, bytes.length - 1}) {
            assertThrows(DataFault.class, () -> FleetOrder.of(Arrays.copyOf(bytes, length)));
        }
    }

    @Test
    void ordersOfFilesAndTopicsAreReadAsTheyWereWritten() {
        SeatOrder follow = order(60).follow();
        for (FleetSource source : List.of(new FleetSource.Packets(List.of(Path.of("/a.packets"), Path.of("/b.packets"))),
                new FleetSource.Topic("localhost:9092", "packets", "out", true))) {
            FleetOrder read = FleetOrder.of(new FleetOrder(follow, source, 7).bytes());
            assertEquals(source, read.source());
            assertEquals(7, read.period());
        }
    }

    /** A replay that is kept after any packet and gone on with gives the same packets. */
    @Test
    void aReplayGoesOnWhereItStood() throws IOException {
        ReplaySource source = new ReplaySource(order(60).bytes(), 2);
        ReplaySource.Block block = new ReplaySource.Block(source, 1, 4, 0, 1, 0);
        List<Tuple2<Long, byte[]>> whole = new ArrayList<>();
        block.getIterator().forEachRemaining(whole::add);
        long count = 0;
        Replay replay = order(60).replay();
        for (int k = 1; k < 4; k++) {
            for (int round = 0; round < replay.rounds(); round++) {
                long[] came = new long[1];
                replay.packets(k, round, packet -> came[0]++);
                count += came[0];
            }
        }
        assertEquals(count, whole.size());
        var form = source.getSplitSerializer();
        for (int stop = 0; stop <= whole.size(); stop += 7) {
            ReplaySource.Packets first = block.getIterator();
            for (int i = 0; i < stop; i++) {
                first.next();
            }
            ReplaySource.Block kept = (ReplaySource.Block) block.getUpdatedSplitForIterator(first);
            ReplaySource.Packets second = form.deserialize(1, form.serialize(kept)).getIterator();
            for (int i = stop; i < whole.size(); i++) {
                Tuple2<Long, byte[]> next = second.next();
                assertEquals(whole.get(i).f0, next.f0);
                assertArrayEquals(whole.get(i).f1, next.f1);
            }
            assertFalse(second.hasNext());
        }
    }
}
