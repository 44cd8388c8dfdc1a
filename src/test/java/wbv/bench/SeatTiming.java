package wbv.bench;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.Locale;
import java.util.function.IntConsumer;
import wbv.control.ApparentSitter;
import wbv.control.FloorBand;
import wbv.control.FollowedSitter;
import wbv.control.OptimalSeat;
import wbv.control.SeatCommand;
import wbv.control.SeatController;
import wbv.control.SeatHardware;
import wbv.control.SeatReadings;
import wbv.control.SitterPrior;
import wbv.control.SkyhookSeat;
import wbv.control.ToldSitter;

/**
 * Processor time of one step of a seat's controllers, best of nine runs of a minute of samples: {@code java -cp
 * target/classes:target/test-classes:$(cat target/classpath) wbv.bench.SeatTiming}.
 */
public final class SeatTiming {

    private static final int SAMPLES = (int) (60 * SeatController.RATE);
    private static final int RUNS = 9;

    private SeatTiming() {}

    /** Prints the table. */
    public static void main(String[] arguments) {
        SeatHardware seat = SeatHardware.ASSUMED;
        FloorBand floor = new FloorBand(2.2, 0.3, 1.7);
        ApparentSitter middle = new ApparentSitter(5, 60, 5, 0.35);
        SitterPrior prior = SitterPrior.wide(middle, 4.8, 0.35);
        print("skyhook", new SkyhookSeat(seat, SkyhookSeat.Kind.CONTINUOUS, 1500));
        print("active-lqg, fixed",
                new OptimalSeat(seat, OptimalSeat.Drive.ACTUATOR, OptimalSeat.Aim.MEAN, floor, 0.4, new ToldSitter(middle)));
        print("active-lqg, scheduled",
                new OptimalSeat(seat, OptimalSeat.Drive.ACTUATOR, OptimalSeat.Aim.MEAN, floor, 0.4, new FollowedSitter(seat, prior)));
        ToldSitter restless = new ToldSitter(middle);
        SeatController designing = new OptimalSeat(seat, OptimalSeat.Drive.ACTUATOR, OptimalSeat.Aim.MEAN, floor, 0.4, restless);
        print("active-lqg, always designing", designing, i -> restless.tell(middle, 1 + 0.2 * Math.sin(0.1 * i)));
        ToldSitter another = new ToldSitter(middle);
        SeatController searching = new OptimalSeat(seat, OptimalSeat.Drive.ACTUATOR, OptimalSeat.Aim.WORST, floor, 0.4, another);
        print("active-h-infinity, always designing", searching, i -> another.tell(middle, 1 + 0.2 * Math.sin(0.1 * i)));
    }

    private static void print(String name, SeatController controller) {
        print(name, controller, i -> {});
    }

    private static void print(String name, SeatController controller, IntConsumer before) {
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        SeatReadings readings = new SeatReadings();
        SeatCommand command = new SeatCommand();
        double[] times = new double[RUNS];
        for (int run = 0; run < RUNS; run++) {
            long start = threads.getCurrentThreadCpuTime();
            for (int i = 0; i < SAMPLES; i++) {
                double swing = Math.sin(0.055 * i) + 0.3 * Math.sin(0.13 * i);
                readings.set(swing, -swing, 0.01 * swing, 780, -1.2 * Math.sin(0.055 * i - 0.1));
                before.accept(i);
                controller.step(readings, command);
            }
            times[run] = (threads.getCurrentThreadCpuTime() - start) / 1e3 / SAMPLES;
        }
        System.out.printf(Locale.ROOT, "| %s | %.2f |%n", name, Arrays.stream(times).min().orElseThrow());
    }
}
