package wbv.recording.inspect;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.SensorClock;

/** Looks at the times of a recording, row by row, and says what clock they keep and what is wrong with it. */
final class Times {

    private static final int FIRST = 512;
    private static final double REAL_JITTER = 0.02;
    private static final double BURSTS = 0.05;
    /** Share of a sample by which a stated rate may misplace the last row and still be believed. */
    private static final double SLIP = 0.25;

    /** Share by which a measured rate may lie beyond those that a recording may state. */
    private static final double BEYOND = 0.01;
    /** What samples are counted to, so that nothing overflows; no reader fills as many. */
    private static final long MOST_SAMPLES = 1L << 50;

    private final OptionalDouble nominal;
    private final Optional<SensorClock> sensor;
    private final double[] early = new double[FIRST];
    private final long[] earlyLines = new long[FIRST];
    private int held;
    private final Order order = new Order();
    private long rows;
    private double presentTime;
    private long presentLine;
    private Tracker tracker;
    private RateWatch rates;
    private Timing look;
    private double step;

    private final Line line = new Line();
    private long sample = -1;
    private long accepted;
    private double firstTime;
    private double lastTime;
    private long lastLine;
    private double firstRounding;
    private double squares;
    private double roundingSquares;
    private long settled;

    private final Holes holes = new Holes();
    private final Disorder disorder = new Disorder();
    private long repeats;
    private long repeatLine;
    private long collisions;

    Times(OptionalDouble nominal, Optional<SensorClock> sensor) {
        this.nominal = nominal;
        this.sensor = sensor;
    }

    /**
     * Looks at a row.
     *
     * @param repeated true if it is the row before once more, values and all
     */
    void accept(double time, long line, boolean repeated) {
        rows++;
        if (repeated) {
            repeat(line);
            return;
        }
        if (rows > 1) {
            ordered(time);
        }
        presentTime = time;
        presentLine = line;
    }

    /** Takes the row that waits, now that the one after it is known. */
    private void ordered(double following) {
        if (!order.keeps(presentTime, following)) {
            disorder.out(presentTime, presentLine);
            return;
        }
        disorder.in();
        if (tracker != null) {
            place(presentTime, presentLine);
            return;
        }
        early[held] = presentTime;
        earlyLines[held] = presentLine;
        held++;
        if (held == FIRST) {
            begin();
            held = 1;
        }
    }

    private void begin() {
        if (held < 2 || early[held - 1] == early[0]) {
            return;
        }
        look = new FirstLook(Arrays.copyOf(early, held)).timing(nominal);
        step = look.step();
        tracker = new Tracker(look);
        rates = new RateWatch(step);
        for (int i = 0; i < held; i++) {
            place(early[i], earlyLines[i]);
        }
    }

    private void place(double time, long atLine) {
        long advance = tracker.place(time);
        rates.accept(time, atLine, Math.max(tracker.rounding(), look.blur()));
        if (advance == Tracker.REPEATED) {
            if (time == lastTime && tracker.rounding() < step / 2) {
                repeat(atLine);
            }
            collisions++;
            return;
        }
        if (accepted == 0) {
            firstTime = time;
            firstRounding = tracker.rounding();
        } else if (advance > 1) {
            holes.met(advance - 1, time - lastTime, lastTime, lastLine);
        } else if (tracker.settled()) {
            double rounding = tracker.rounding();
            squares += tracker.residual() * tracker.residual();
            roundingSquares += rounding * rounding / 4;
            settled++;
        }
        sample = Math.min(sample + advance, MOST_SAMPLES);
        line.accept(sample, time);
        accepted++;
        lastTime = time;
        lastLine = atLine;
    }

    private void repeat(long atLine) {
        repeatLine = repeats == 0 ? atLine : repeatLine;
        repeats++;
    }

    /**
     * Ends the look.
     *
     * @throws DataFault if the rows have fewer than two times
     */
    void finish(String name) {
        if (rows > 0) {
            ordered(Double.POSITIVE_INFINITY);
        }
        if (tracker == null) {
            begin();
        }
        if (tracker == null) {
            throw DataFault.in(name, rows == 0 ? "has a header but no row; a recording needs at least two samples"
                    : rows - repeats == 1 ? "has 1 sample only; a recording needs at least two"
                            : "the time never increases over its " + rows + " rows; a recording needs two different times");
        }
        double rate = measuredRate();
        if (!Clock.isRate(rate / (1 + BEYOND)) && !Clock.isRate(rate * (1 + BEYOND))) {
            throw DataFault.in(name, "its times tell a rate of " + rate + " Hz, which no recording has: are they in s?");
        }
    }

    /** Samples on the clock from the first row to the last. */
    long samples() {
        return sample + 1;
    }

    Timing timing() {
        double jitter = settled > 0 ? Math.sqrt(squares / settled) : 0;
        boolean uneven = settled > 0 && squares > roundingSquares + settled * REAL_JITTER * REAL_JITTER * step * step;
        boolean crowded = collisions > BURSTS * (accepted + collisions);
        return new Timing(look.phase(), step, look.blur(), tracker.coarsest(), jitter, uneven || crowded);
    }

    private double measuredRate() {
        double slope = line.slope();
        return slope > 0 ? 1 / slope : 1 / step;
    }

    Clock clock() {
        double measured = measuredRate();
        double rate = measured;
        double whole = Math.rint(measured);
        if (nominal.isPresent() && slip(nominal.getAsDouble(), measured) < SLIP) {
            rate = nominal.getAsDouble();
        } else if (whole > 0 && slip(whole, measured) < 0.01 + tracker.coarsest() / step / 2) {
            rate = whole;
        }
        double start = line.intercept(1 / rate);
        boolean first = Math.abs(start - firstTime) <= firstRounding / 2 + 0.05 / rate;
        return new Clock(first ? firstTime : start, rate);
    }

    /** By how many samples a rate would misplace the last row. */
    private double slip(double rate, double measured) {
        return Math.abs(rate / measured - 1) * sample;
    }

    /** What is wrong with the times. */
    List<Finding> findings() {
        List<Finding> findings = new ArrayList<>();
        disorder.finding(rows).ifPresent(findings::add);
        rates.found().ifPresent(findings::add);
        Timing timing = timing();
        holes.finding(samples(), sensor.isPresent()).ifPresent(findings::add);
        if (repeats > 0) {
            findings.add(new Finding.DuplicateTimes(repeats, repeatLine));
        }
        if (timing.irregular()) {
            findings.add(new Finding.Jitter(timing.jitter(), step, true));
        } else if (timing.jitter() > REAL_JITTER / 4 * step && squares > 2 * roundingSquares) {
            findings.add(new Finding.Jitter(timing.jitter(), step, false));
        }
        double measured = measuredRate();
        if (nominal.isPresent() && slip(nominal.getAsDouble(), measured) > 0.05 + tracker.coarsest() / step
                && Math.abs(measured / nominal.getAsDouble() - 1) > 1e-6) {
            findings.add(new Finding.Drift(nominal.getAsDouble(), measured));
        }
        return findings;
    }
}
