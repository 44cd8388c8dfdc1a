package wbv.recording;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/** Looks at the times of a recording, row by row, and says what clock they keep and what is wrong with it. */
final class Times {

    private static final int FIRST = 512;
    private static final int BLOCK = 256;
    private static final int RESTART = 10;
    private static final double REAL_JITTER = 0.02;
    private static final double BURSTS = 0.05;
    /** Share of a sample by which a stated rate may misplace the last row and still be believed. */
    private static final double SLIP = 0.25;

    private final OptionalDouble nominal;
    private final Optional<SensorClock> sensor;
    private final double[] early = new double[FIRST];
    private final long[] earlyLines = new long[FIRST];
    private int held;
    private Tracker tracker;
    private double phase;
    private double step;
    private double blur;

    private final Line line = new Line();
    private long sample = -1;
    private long accepted;
    private double firstTime;
    private double lastTime;
    private double firstRounding;
    private double squares;
    private double roundingSquares;
    private long settled;

    private long gaps;
    private long missing;
    private double longest;
    private double longestAt;
    private long longestLine;
    private long repeats;
    private long repeatLine;
    private long collisions;
    private long backwards;
    private long backwardsLine;
    private double backwardsTime;
    private int backwardsRun;
    private long runLine;
    private double runTime;
    private Finding.TwoClocks twoClocks;

    private final double[] block = new double[BLOCK];
    private double previousTime = Double.NaN;
    private int blockFilled;
    private long blockLine;
    private double blockTime;
    private int oddBlocks;
    private long oddLine;
    private double oddTime;

    Times(OptionalDouble nominal, Optional<SensorClock> sensor) {
        this.nominal = nominal;
        this.sensor = sensor;
    }

    /** Looks at a row. @param repeated true if it is the row before once more, values and all */
    void accept(double time, long line, boolean repeated) {
        if (repeated) {
            repeat(line);
        } else if (tracker != null) {
            place(time, line);
        } else {
            early[held] = time;
            earlyLines[held] = line;
            held++;
            if (held == FIRST) {
                begin();
            }
        }
    }

    private void begin() {
        double[] increasing = new double[held];
        int count = 0;
        for (int i = 0; i < held; i++) {
            if (count == 0 || early[i] >= increasing[count - 1]) {
                increasing[count++] = early[i];
            }
        }
        if (count < 2 || increasing[count - 1] == increasing[0]) {
            return;
        }
        double[] times = Arrays.copyOf(increasing, count);
        step = FirstLook.step(times, nominal);
        phase = FirstLook.phase(times, step);
        blur = FirstLook.blur(times, step);
        tracker = new Tracker(new Timing(phase, step, blur, 0, 0, false));
        for (int i = 0; i < held; i++) {
            place(early[i], earlyLines[i]);
        }
    }

    private void place(double time, long atLine) {
        long advance = tracker.place(time);
        if (advance == Tracker.BACKWARDS) {
            backwards(time, atLine);
            return;
        }
        backwardsRun = 0;
        rate(time, atLine);
        if (advance == Tracker.REPEATED) {
            if (time - lastTime <= tracker.rounding() / 2) {
                repeat(atLine);
            }
            collisions++;
            return;
        }
        if (accepted == 0) {
            firstTime = time;
            firstRounding = tracker.rounding();
        } else if (advance > 1) {
            gap(advance - 1, time - lastTime, atLine);
        } else if (tracker.settled()) {
            double rounding = tracker.rounding();
            squares += tracker.residual() * tracker.residual();
            roundingSquares += rounding * rounding / 4;
            settled++;
        }
        sample += advance;
        line.accept(sample, time);
        accepted++;
        lastTime = time;
    }

    private void gap(long count, double length, long atLine) {
        gaps++;
        missing += count;
        if (length > longest) {
            longest = length;
            longestAt = lastTime;
            longestLine = atLine - 1;
        }
    }

    private void repeat(long atLine) {
        repeatLine = repeats == 0 ? atLine : repeatLine;
        repeats++;
    }

    private void backwards(double time, long atLine) {
        if (backwards == 0) {
            backwardsLine = atLine;
            backwardsTime = time;
        }
        if (backwardsRun == 0) {
            runLine = atLine;
            runTime = time;
        }
        backwards++;
        backwardsRun++;
        if (twoClocks == null && backwardsRun >= RESTART) {
            twoClocks = new Finding.TwoClocks(runLine, runTime, "time starts again");
        }
    }

    /** Watches the step over blocks of rows: two blocks at another rate are another clock, unless they only lost packets. */
    private void rate(double time, long atLine) {
        double difference = time - previousTime;
        previousTime = time;
        if (Double.isNaN(difference) || difference == 0) {
            return;
        }
        if (blockFilled == 0) {
            blockLine = atLine;
            blockTime = time;
        }
        block[blockFilled++] = difference;
        if (blockFilled < BLOCK) {
            return;
        }
        blockFilled = 0;
        Arrays.sort(block);
        double ratio = block[BLOCK / 2] / step;
        boolean odd = tracker.rounding() < step / 10 && Math.abs(ratio - Math.max(1, Math.rint(ratio))) > 0.05 * ratio;
        if (odd && oddBlocks == 0) {
            oddLine = blockLine;
            oddTime = blockTime;
        }
        oddBlocks = odd ? oddBlocks + 1 : 0;
        if (oddBlocks == 2 && twoClocks == null) {
            twoClocks = new Finding.TwoClocks(oddLine, oddTime, String.format("the rate changes from %.5g to %.5g Hz",
                    1 / step, 1 / (ratio * step)));
        }
    }

    /** Ends the look. @throws DataFault if the rows have fewer than two times */
    void finish(String name) {
        if (tracker == null && held > 1) {
            begin();
        }
        if (tracker == null) {
            throw DataFault.in(name, held == 0 ? "has a header but no row; a recording needs at least two samples"
                    : held == 1 ? "has 1 sample only; a recording needs at least two"
                    : "has " + held + " rows of one and the same time; a recording needs at least two times");
        }
        long rows = accepted + backwards + collisions;
        if (twoClocks == null && backwards >= RESTART && backwards > rows / 10) {
            twoClocks = new Finding.TwoClocks(backwardsLine, backwardsTime, "two clocks take turns");
        }
    }

    /** Samples on the clock from the first row to the last. */
    long samples() {
        return sample + 1;
    }

    Timing timing() {
        double jitter = settled > 0 ? Math.sqrt(squares / settled) : 0;
        boolean uneven = settled > 0 && squares > roundingSquares + settled * REAL_JITTER * REAL_JITTER * step * step;
        return new Timing(phase, step, blur, tracker.coarsest(), jitter, uneven || collisions > BURSTS * (accepted + collisions));
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
        } else if (whole > 0 && slip(whole, measured) < 0.01 + rounding() / 2) {
            rate = whole;
        }
        double start = line.intercept(1 / rate);
        boolean first = Math.abs(start - firstTime) <= firstRounding / 2 + 0.05 / rate;
        return new Clock(first ? firstTime : start, rate);
    }

    /** By how many samples rounding may put a time off. */
    private double rounding() {
        return Tracker.error(tracker.coarsest(), step) / step;
    }

    /** By how many samples a rate would misplace the last row. */
    private double slip(double rate, double measured) {
        return Math.abs(rate / measured - 1) * sample;
    }

    /** What is wrong with the times. */
    List<Finding> findings() {
        List<Finding> findings = new ArrayList<>();
        if (twoClocks != null) {
            findings.add(twoClocks);
        } else if (backwards > 0) {
            findings.add(new Finding.TimeBackwards(backwards, backwardsLine, backwardsTime));
        }
        Timing timing = timing();
        if (gaps > 0 && sensor.isPresent()) {
            findings.add(new Finding.DroppedPackets(gaps, missing, (double) missing / samples(), longest, longestAt, longestLine));
        } else if (gaps > 0) {
            findings.add(new Finding.Gap(gaps, missing, longest, longestAt, longestLine));
        }
        if (repeats > 0) {
            findings.add(new Finding.DuplicateTimes(repeats, repeatLine));
        }
        if (timing.irregular()) {
            findings.add(new Finding.Jitter(timing.jitter(), step, true));
        } else if (timing.jitter() > REAL_JITTER / 4 * step && squares > 2 * roundingSquares) {
            findings.add(new Finding.Jitter(timing.jitter(), step, false));
        }
        double measured = measuredRate();
        if (nominal.isPresent() && slip(nominal.getAsDouble(), measured) > 0.05 + rounding()
                && Math.abs(measured / nominal.getAsDouble() - 1) > 1e-6) {
            findings.add(new Finding.Drift(nominal.getAsDouble(), measured));
        }
        return findings;
    }
}
