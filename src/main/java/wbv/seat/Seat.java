package wbv.seat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import wbv.filter.BodyEstimate;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * One occupant of a seat, followed packet by packet: see {@link SeatPlan} for what is done and {@link SeatResult} for what comes of
 * it. Packets may come out of order within {@value PacketOrder#LONGEST_WAIT} s, twice or not at all; samples that are lost count
 * as missing ones. Deterministic: the same packets in the same order give the same results, and a seat that was saved and loaded
 * gives them bit for bit.
 */
public final class Seat implements Snapshot {

    /** Time that is taken for missing where the sensor began again, so that the body's motion is found anew [s]. */
    private static final double RESTART = 1;
    /** Samples that are missing for so long are told of [s]. */
    private static final double LONG_LOSS = 0.5;

    private final String name;
    private final SeatPlan plan;
    private final PacketOrder order = new PacketOrder();
    private final BodyFollower[] bodies;
    private final Optional<ExposureFollower> exposure;
    private final Optional<StateFollower> states;
    private final double[] row;
    private final List<SeatAlarm> alarms = new ArrayList<>();
    private Onlooker onlooker = (at, body, input, output, track) -> {};
    private double time = Double.NaN;
    private long samples;
    private long packets;
    private long refused;
    private long lostSamples;
    private long missing;
    private long restarts;

    /** Sees every sample of a body that is followed. Not part of what is saved. */
    public interface Onlooker {

        /**
         * A sample.
         *
         * @param time   of it [s]
         * @param body number of the body in the plan
         * @param input  what shook it [m/s² or rad/s]
         * @param output what it did, in that unit; NaN where missing
         * @param track  what is known after it. Read it before the next.
         */
        void see(double time, int body, double input, double output, BodyEstimate track);
    }

    /** What became of a packet. */
    public enum Taken {
        /** It was the next one, and its samples were taken. */
        STEPPED,
        /** It waits for one before it. */
        HELD,
        /** It came before; dropped. */
        TWICE,
        /** It had been given up; dropped. */
        LATE,
        /** It is of another seat, or has other channels or another rate than the plan; put aside. */
        REFUSED
    }

    /**
     * A seat before its first packet.
     *
     * @param name of the seat, as its packets have it
     */
    public Seat(String name, SeatPlan plan) {
        this.name = name;
        this.plan = plan;
        this.bodies = plan.bodies().stream().map(body -> new BodyFollower(body, plan)).toArray(BodyFollower[]::new);
        this.exposure = plan.axes().isEmpty() ? Optional.empty() : Optional.of(new ExposureFollower(plan));
        this.states = plan.states().map(model -> new StateFollower(plan, model, plan.stateFilter()));
        this.row = new double[plan.channels().size()];
    }

    /** As its packets have it. */
    public String name() {
        return name;
    }

    /** Shows every sample from now on to someone. */
    public void show(Onlooker to) {
        onlooker = to;
    }

    /** What is done with its packets; shared with other seats. */
    public SeatPlan plan() {
        return plan;
    }

    /**
     * Takes a packet.
     *
     * @param results takes what comes of it and of those that waited for it, in order
     */
    public Taken accept(Packet packet, Consumer<? super SeatResult> results) {
        if (!packet.seat().equals(name) || !plan.fits(packet)) {
            refused++;
            return Taken.REFUSED;
        }
        return Taken.valueOf(order.accept(packet, new Steps(results)).name());
    }

    /** Takes packets that wait for one that will not come: the seat fell silent, or its stream ended. */
    public void flush(Consumer<? super SeatResult> results) {
        order.flush(new Steps(results));
    }

    /** Begins another shift: the exposure is counted from here. */
    public void beginShift() {
        exposure.ifPresent(each -> each.begin(time));
    }

    /** What came and what did not. */
    public SeatResult.Losses losses() {
        return new SeatResult.Losses(packets, order.reordered(), order.twice(), order.late(), order.lost(), refused, lostSamples,
                missing, restarts);
    }

    /** Samples as the order gives them. */
    private final class Steps implements PacketOrder.Sink {

        private final Consumer<? super SeatResult> results;

        private Steps(Consumer<? super SeatResult> results) {
            this.results = results;
        }

        @Override
        public void take(Packet packet) {
            packets++;
            int width = packet.channels();
            double[] values = packet.values();
            for (int i = 0; i < packet.samples(); i++) {
                for (int c = 0; c < width; c++) {
                    double value = values[i * width + c];
                    boolean number = Double.isFinite(value);
                    missing += number ? 0 : 1;
                    row[c] = number ? value : Double.NaN;
                }
                step(packet.time() + i / plan.rate(), results);
            }
        }

        @Override
        public void miss(long count, double from) {
            lostSamples += count;
            if (count >= LONG_LOSS * plan.rate()) {
                alarms.add(new SeatAlarm(SeatAlarm.Kind.SAMPLES_LOST, from, count + " samples are missing"));
            }
            stepOver(count, from);
        }

        @Override
        public void beginAgain(double from, String reason) {
            restarts++;
            alarms.add(new SeatAlarm(SeatAlarm.Kind.SENSOR_RESTARTED, from, reason));
            long count = Math.round(RESTART * plan.rate());
            stepOver(count, from - count / plan.rate());
        }

        private void stepOver(long count, double from) {
            Arrays.fill(row, Double.NaN);
            for (long i = 0; i < count; i++) {
                step(from + i / plan.rate(), results);
            }
        }
    }

    private void step(double at, Consumer<? super SeatResult> results) {
        time = at;
        samples++;
        for (int i = 0; i < bodies.length; i++) {
            BodyEstimate track = bodies[i].step(row, at, alarms::add);
            onlooker.see(at, i, bodies[i].input(row), bodies[i].output(row), track);
        }
        exposure.ifPresent(each -> each.step(row, at));
        states.ifPresent(each -> each.step(row));
        if (samples % plan.interval() == 0) {
            results.accept(tell());
        }
    }

    private SeatResult tell() {
        exposure.ifPresent(each -> each.tell(each.now(), time, alarms::add));
        SeatResult result = now();
        alarms.clear();
        return result;
    }

    /** What is known now, between results too. Changes nothing. */
    public SeatResult now() {
        List<SeatResult.Body> all = Arrays.stream(bodies).map(BodyFollower::now).toList();
        return new SeatResult(name, time, samples, all, exposure.map(ExposureFollower::now), states.flatMap(StateFollower::now),
                losses(), alarms);
    }

    /**
     * The same occupant under a plan with another model of states: body, exposure and packets that wait go on, what the person does is
     * found anew.
     *
     * @param other differs from this seat's in its model of states alone
     */
    public Seat under(SeatPlan other) {
        StateWriter writer = new StateWriter();
        save(writer, false);
        Seat same = new Seat(name, other);
        same.load(new StateReader("the state of " + name, writer.finish()), false);
        return same;
    }

    @Override
    public void save(StateWriter out) {
        save(out, true);
    }

    private void save(StateWriter out, boolean all) {
        out.put(name);
        order.save(out);
        out.put(bodies);
        exposure.ifPresent(out::put);
        if (all) {
            states.ifPresent(out::put);
        }
        out.put(time);
        out.put(samples);
        out.put(packets);
        out.put(refused);
        out.put(lostSamples);
        out.put(missing);
        out.put(restarts);
        out.put(alarms.size());
        for (SeatAlarm alarm : alarms) {
            out.put(alarm.kind().ordinal());
            out.put(alarm.time());
            out.put(alarm.reason());
        }
    }

    @Override
    public void load(StateReader in) {
        load(in, true);
    }

    private void load(StateReader in, boolean all) {
        String whose = in.text();
        if (!whose.equals(name)) {
            throw in.other("it is of seat '" + whose + "', not '" + name + "'");
        }
        order.load(in, name);
        in.parts(bodies);
        exposure.ifPresent(in::part);
        if (all) {
            states.ifPresent(in::part);
        }
        time = in.number();
        samples = in.count();
        packets = in.count();
        refused = in.count();
        lostSamples = in.count();
        missing = in.count();
        restarts = in.count();
        alarms.clear();
        int told = in.integer(0, Integer.MAX_VALUE, "alarms");
        for (int i = 0; i < told; i++) {
            SeatAlarm.Kind kind = SeatAlarm.Kind.values()[in.integer(0, SeatAlarm.Kind.values().length - 1, "an alarm")];
            alarms.add(new SeatAlarm(kind, in.number(), in.text()));
        }
    }
}
