package wbv.network;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.DoubleConsumer;
import java.util.stream.IntStream;
import wbv.rig.RigRun;
import wbv.rig.RigSpec;

/** Trials of the virtual rig. The same kind and seed give the same trials, in the same order, on any number of cores. */
public final class RigTrials {

    private RigTrials() {}

    /**
     * Plays trials; each has a body, an excitation and sensors of its own, so that no split divides a subject or a trial.
     *
     * @param progress share done, 0 to 1
     */
    public static List<LabelledMotion> of(Bodies bodies, int count, long seed, DoubleConsumer progress) {
        AtomicInteger done = new AtomicInteger();
        return IntStream.range(0, count).parallel().mapToObj(i -> {
            long own = new SplittableRandom(seed * 1_000_003L + i).nextLong();
            LabelledMotion trial = play(bodies, bodies.draw(new SplittableRandom(own), own >>> 1));
            progress.accept(done.incrementAndGet() / (double) count);
            return trial;
        }).toList();
    }

    private static LabelledMotion play(Bodies bodies, RigSpec spec) {
        RigRun run = spec.run();
        int rows = Math.toIntExact(spec.rows()) - (int) Math.round(Bodies.FADE * Imaging.RATE);
        int first = rows - Imaging.SAMPLES;
        double[][] motion = new double[spec.channels().size()][Imaging.SAMPLES];
        double[] row = new double[1 + motion.length];
        for (int i = 0; i < rows; i++) {
            run.read(row);
            for (int c = 0; c < motion.length && i >= first; c++) {
                motion[c][i - first] = row[1 + c];
            }
        }
        double[] parameters = new double[run.parameters().size()];
        run.parameters(parameters);
        int from = run.parameters().indexOf(bodies.modes() == 1 && run.parameters().contains("zeta") ? "zeta" : "zeta1");
        return new LabelledMotion(motion, Arrays.copyOfRange(parameters, from, from + 2 * bodies.modes()), spec.toString());
    }
}
