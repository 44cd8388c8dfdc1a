package wbv.seat;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import wbv.exposure.DailyExposure;
import wbv.exposure.Directive;
import wbv.exposure.Meter;
import wbv.exposure.SeatAxis;
import wbv.filter.BodyEstimate;
import wbv.filter.Estimator;
import wbv.filter.EstimatorDesign;
import wbv.filter.Method;
import wbv.filter.SimulatedSitter;
import wbv.filter.drift.Adwin;
import wbv.filter.model.Spec;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.seat.Seat.Taken;

class SeatTest {

    private static final double RATE = SimulatedSitter.RATE;
    private static final List<Channel> CHANNELS = List.of(Channel.parse("platform.acc.z"), Channel.parse("head.acc.z"));

    private static SeatPlan plan() {
        return SeatPlan.usual(RATE, CHANNELS, Method.EKF_ADWIN, false, Optional.empty());
    }

    private static SimulatedSitter.Motion motion(int samples) {
        return new SimulatedSitter(4.6, 0.33).steady(0.8, samples, 7).measured(Spec.noise(RATE), 7);
    }

    /** @param size samples a packet */
    static List<Packet> packets(String seat, SimulatedSitter.Motion motion, int size) {
        List<Packet> all = new ArrayList<>();
        for (int from = 0; from + size <= motion.u().length; from += size) {
            double[] values = new double[2 * size];
            for (int i = 0; i < size; i++) {
                values[2 * i] = motion.u()[from + i];
                values[2 * i + 1] = motion.y()[from + i];
            }
            all.add(new Packet(seat, all.size(), 100 + from / RATE, RATE, 2, values));
        }
        return all;
    }

    private static List<SeatResult> run(Seat seat, List<Packet> packets) {
        List<SeatResult> results = new ArrayList<>();
        packets.forEach(packet -> seat.accept(packet, results::add));
        seat.flush(results::add);
        return results;
    }

    @Test
    void itSaysWhatItsPartsSay() {
        SimulatedSitter.Motion motion = motion(3600);
        List<SeatResult> results = run(new Seat("a", plan()), packets("a", motion, 6));
        Estimator estimator = EstimatorDesign.of(Method.EKF_ADWIN).estimator(Spec.at(RATE), Adwin::new);
        Meter meter = Meter.stream(SeatAxis.Z.weighting().filter(), RATE, false);
        for (int i = 0; i < 3600; i++) {
            BodyEstimate track = estimator.step(motion.u()[i], motion.y()[i]);
            meter.accept(motion.u()[i]);
            if ((i + 1) % 60 == 0) {
                SeatResult result = results.get(i / 60);
                assertEquals(i + 1, result.sample());
                assertEquals(100 + i / RATE, result.time(), 1e-9);
                SeatResult.Mode mode = result.bodies().get(0).modes().get(0);
                assertEquals(track.frequency(), mode.frequency(), 0);
                assertEquals(track.dampingDeviation(), mode.dampingDeviation(), 0);
                assertEquals(meter.vibration().rms(), result.exposure().orElseThrow().axes().get(0).rms(), 0);
            }
        }
        assertEquals(60, results.size());
        assertTrue(results.get(59).bodies().get(0).explained() > 0.95);
    }

    /** The oracle is the day's exposure by tasks: what it says of the same level going on. */
    @Test
    void timeLeftIsThatOfADayThatGoesOnLikeThis() {
        Seat seat = new Seat("a", plan());
        SeatResult.Exposure last = run(seat, packets("a", motion(60_000), 60)).get(999).exposure().orElseThrow();
        Meter meter = Meter.stream(SeatAxis.Z.weighting().filter(), RATE, false);
        for (double u : motion(60_000).u()) {
            meter.accept(u);
        }
        DailyExposure day = new DailyExposure(List.of(new wbv.exposure.DailyTask("so far", meter.vibration().seconds() / 60,
                java.util.Map.of(SeatAxis.Z, meter.vibration().level()))));
        assertEquals(day.a8(), last.a8(), 1e-9);
        assertEquals(day.vdv(), last.vdv(), 1e-9);
        assertEquals(day.minutesUntil(Directive.ACTION) - day.minutes(), last.minutesToAction(), 1e-6);
        assertEquals(day.minutesUntil(Directive.LIMIT) - day.minutes(), last.minutesToLimit(), 1e-6);
    }

    @Test
    void thatPacketsComeShuffledAndTwiceChangesNothing() {
        List<Packet> ordered = packets("a", motion(7200), 6);
        List<SeatResult> undisturbed = run(new Seat("a", plan()), ordered);
        for (int seed = 0; seed < 5; seed++) {
            Random random = new Random(seed);
            List<Packet> sent = shuffled(ordered, random, 1.9);
            long twice = 0;
            for (int i = sent.size() - 1; i >= 0; i--) {
                if (random.nextInt(100) == 0) {
                    sent.add(Math.min(sent.size(), i + 1 + random.nextInt(15)), sent.get(i));
                    twice++;
                }
            }
            Seat seat = new Seat("a", plan());
            List<SeatResult> results = run(seat, sent);
            assertEquals(told(undisturbed), told(results));
            assertEquals(twice, seat.losses().twice());
            assertEquals(0, seat.losses().lost() + seat.losses().late() + seat.losses().restarts());
        }
    }

    /** Packets by the time at which they arrive, each late by up to so many seconds. */
    static List<Packet> shuffled(List<Packet> packets, Random random, double most) {
        List<double[]> arrival = new ArrayList<>();
        for (int i = 0; i < packets.size(); i++) {
            arrival.add(new double[] {packets.get(i).time() + most * random.nextDouble(), i});
        }
        arrival.sort(Comparator.comparingDouble(each -> each[0]));
        return new ArrayList<>(arrival.stream().map(each -> packets.get((int) each[1])).toList());
    }

    /** Results without what counts packets. */
    private static List<String> told(List<SeatResult> results) {
        return results.stream().map(each -> each.time() + " " + each.sample() + each.bodies() + each.exposure() + each.state()).toList();
    }

    @Test
    void whatIsLostCountsAsMissingWhereverItWouldHaveCome() {
        List<Packet> ordered = packets("a", motion(7200), 6);
        Random random = new Random(4);
        List<Packet> kept = ordered.stream().filter(each -> each.counter() == 0 || each.counter() == ordered.size() - 1
                || random.nextInt(100) > 0).toList();
        Seat inOrder = new Seat("a", plan());
        List<SeatResult> undisturbed = run(inOrder, kept);
        Seat disturbed = new Seat("a", plan());
        assertEquals(told(undisturbed), told(run(disturbed, shuffled(kept, random, 1.9))));
        for (Seat seat : List.of(inOrder, disturbed)) {
            assertEquals(ordered.size() - kept.size(), seat.losses().lost());
            assertEquals(6L * (ordered.size() - kept.size()), seat.losses().samples());
        }
        assertEquals(120, undisturbed.size());
    }

    @Test
    void aPacketThatWasGivenUpIsLate() {
        List<Packet> ordered = packets("a", motion(1200), 6);
        List<Packet> sent = new ArrayList<>(ordered);
        sent.add(60, sent.remove(30));
        Seat seat = new Seat("a", plan());
        List<SeatResult> results = new ArrayList<>();
        List<Taken> taken = sent.stream().map(packet -> seat.accept(packet, results::add)).toList();
        assertEquals(1, Collections.frequency(taken, Taken.LATE));
        assertEquals(Taken.LATE, taken.get(60));
        assertEquals(1, seat.losses().lost());
    }

    @Test
    void aSensorThatBeganAgainIsNoticed() {
        List<Packet> ordered = packets("a", motion(3600), 6);
        for (double ahead : new double[] {5, -100}) { // its clock goes on, or begins again too
            Seat seat = new Seat("a", plan());
            List<SeatResult> results = run(seat, ordered);
            List<Packet> second = ordered.subList(300, 600).stream().map(each -> new Packet("a", each.counter() - 300,
                    ahead > 0 ? each.time() + 30 + ahead : each.time() - 130, RATE, 2, each.values())).toList();
            results.addAll(run(seat, shuffled(second, new Random(1), 1)));
            assertEquals(1, seat.losses().restarts(), "clock " + ahead);
            assertEquals(0, seat.losses().twice() + seat.losses().late() + seat.losses().lost());
            assertEquals(900, seat.losses().packets());
            SeatAlarm alarm = results.stream().flatMap(each -> each.alarms().stream())
                    .filter(each -> each.kind() == SeatAlarm.Kind.SENSOR_RESTARTED).findFirst().orElseThrow();
            assertTrue(alarm.reason().contains("packet 0 after packet 599"), alarm.reason());
            double frequency = results.get(results.size() - 1).bodies().get(0).modes().get(0).frequency();
            assertEquals(4.6, frequency, 0.1);
        }
    }

    @Test
    void packetsOfBeforeARestartOfOursAreNoRestartOfTheSensors() {
        List<Packet> ordered = packets("a", motion(3600), 6);
        Seat seat = new Seat("a", plan());
        run(seat, ordered);
        run(seat, ordered);
        assertEquals(600, seat.losses().twice() + seat.losses().late());
        assertEquals(0, seat.losses().restarts());
    }

    @Test
    void aPacketOfAnotherPlanIsRefused() {
        Seat seat = new Seat("a", plan());
        assertEquals(Taken.REFUSED, seat.accept(new Packet("b", 0, 0, RATE, 2, new double[2]), each -> {}));
        assertEquals(Taken.REFUSED, seat.accept(new Packet("a", 0, 0, RATE, 1, new double[2]), each -> {}));
        assertEquals(Taken.REFUSED, seat.accept(new Packet("a", 0, 0, 100, 2, new double[2]), each -> {}));
        assertEquals(3, seat.losses().refused());
    }

    @Test
    void mutatedPacketsAreRefusedInOneLine() {
        byte[] bytes = packets("seat 7", motion(60), 6).get(3).bytes();
        assertEquals(packets("seat 7", motion(60), 6).get(3), Packet.of(bytes));
        Random random = new Random(11);
        for (int i = 0; i < 100_000; i++) {
            byte[] mutated = java.util.Arrays.copyOf(bytes, random.nextInt(4) == 0 ? random.nextInt(2 * bytes.length) : bytes.length);
            for (int k = random.nextInt(4); k >= 0 && mutated.length > 0; k--) {
                mutated[random.nextInt(mutated.length)] ^= (byte) (1 + random.nextInt(255));
            }
            if (!java.util.Arrays.equals(mutated, bytes)) {
                DataFault fault = assertThrows(DataFault.class, () -> Packet.of(mutated));
                assertTrue(fault.getMessage().indexOf('\n') < 0);
            }
        }
    }
}
