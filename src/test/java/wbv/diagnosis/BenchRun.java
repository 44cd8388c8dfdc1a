package wbv.diagnosis;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;

/**
 * Writes the bench that ships, {@code data/arff/bench}: a mass on a beam, under which a roller goes to and fro, pushed by a measured force;
 * simulated.
 */
final class BenchRun {

    private BenchRun() {}

    /** @param args folder */
    public static void main(String[] args) throws IOException {
        Random random = new Random(19);
        DoubleUnaryOperator push = Bench.tones(40, 0.3, 0.4925, 2.5, random);
        DoubleUnaryOperator roller = t -> 0.010 * Math.sin(2 * Math.PI * 0.06 * t) + 0.005 * Math.sin(2 * Math.PI * 0.17 * t + 1);
        Bench bench = new Bench(200, 30, 50, 2).run(
                (t, x, v, out) -> out[0] = push.applyAsDouble(t) - 8000 / Math.pow(1 + 12 * roller.applyAsDouble(t), 3) * x[0] - 25 * v[0]);
        double[] pushed = Bench.noisy(bench.sampled(push), 1e-3, random);
        double[] read = Bench.noisyBy(0.003, bench.sampled(bench.position(0)), random);
        double[] rolled = Bench.noisy(bench.sampled(roller), 2e-5, random);
        StringBuilder csv = new StringBuilder("t,mass.force.z,mass.pos.z,roller.pos.x\n");
        for (int j = 0; j < pushed.length; j++) {
            csv.append(String.format(Locale.ROOT, "%.3f,%.4f,%.8f,%.6f%n", j / 200.0, pushed[j], read[j], rolled[j]));
        }
        Path folder = Path.of(args[0]);
        Files.createDirectories(folder);
        Files.writeString(folder.resolve("roller.csv"), csv, StandardCharsets.UTF_8);
    }
}
