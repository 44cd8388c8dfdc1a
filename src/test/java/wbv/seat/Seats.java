package wbv.seat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import wbv.filter.Method;
import wbv.filter.SimulatedSitter;
import wbv.filter.model.Spec;
import wbv.recording.Channel;
import wbv.state.StateModelFile;

/** Plans and packets of simulated seats, for tests. */
final class Seats {

    static final double RATE = SimulatedSitter.RATE;
    static final List<Channel> CHANNELS = Stream.of("seat.acc.x", "seat.acc.y", "seat.acc.z", "seat.gyr.x", "seat.gyr.y",
            "head.acc.z").map(Channel::parse).toList();

    private Seats() {}

    /** A plan with everything in it: a body, three axes, states. */
    static SeatPlan plan(Method method, boolean boxcar) {
        return SeatPlan.usual(RATE, CHANNELS, method, boxcar, Optional.of(StateModelFile.shipped()));
    }

    /** Shaken with jolts and rocking, a value missing now and then. @param size samples a packet */
    static List<Packet> packets(String seat, int count, int size, long seed) {
        Random random = new Random(seed);
        SimulatedSitter.Motion motion = SimulatedSitter.of(seed).steady(0.8, count * size, seed).measured(Spec.noise(RATE), seed);
        List<Packet> all = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            double[] values = new double[CHANNELS.size() * size];
            for (int i = 0; i < size; i++) {
                int sample = k * size + i;
                double loud = sample / 300 % 3 == 0 ? 3 : 1;
                double[] row = {0.3 * random.nextGaussian(), 0.2 * random.nextGaussian(), 9.81 + loud * motion.u()[sample],
                    0.2 * Math.sin(sample * 0.05), 0.02 * random.nextGaussian(), loud * motion.y()[sample]};
                for (int c = 0; c < row.length; c++) {
                    values[i * row.length + c] = random.nextInt(400) == 0 ? Double.NaN : row[c];
                }
            }
            all.add(new Packet(seat, k, 1000 + k * size / RATE, RATE, CHANNELS.size(), values));
        }
        return all;
    }
}
