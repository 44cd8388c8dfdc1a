package wbv.rig.concealed;

import java.util.Map;
import java.util.function.DoubleFunction;
import java.util.stream.IntStream;
import org.apache.commons.math3.random.RandomGenerator;

/** Omissions at one sensor. */
final class SensorRecipes {

    private final RideScene scene;
    private final String place;
    private final RandomGenerator random;

    SensorRecipes(RideScene scene, String place, RandomGenerator random) {
        this.scene = scene;
        this.place = place;
        this.random = random;
    }

    OmissionRecipe of(String word) {
        double half = random.nextDouble();
        boolean coin = random.nextBoolean();
        double[] z = scene.calm().acceleration()[scene.chain().rider(place)];
        double rms = UniformSeries.rms(z);
        return switch (word) {
            case "sensor.mount" -> {
                double zeta = 0.15 + 0.2 * half;
                yield fault(0.8, 6, word, "strap", a -> Map.of("frequency_hz", 30 / a, "damping_ratio", zeta),
                        a -> Fault.strap(30 / a, zeta));
            }
            case "sensor.misalignment" -> fault(0.01, 0.45, word, "turned about y", a -> Map.of("angle_rad", coin ? a : -a),
                    a -> Fault.turned(coin ? a : -a));
            case "sensor.delay" -> half < 0.3
                    ? fault(0.0005, 0.08, word, "clock drifts", a -> Map.of("end_delay_s", a), a -> Fault.late(0, a))
                    : fault(0.0005, 0.06, word, "late", a -> Map.of("delay_s", a), a -> Fault.late(a, a));
            case "sensor.bias" -> fault(0.01, 1, word, "constant", a -> Map.of("bias", coin ? a : -a), a -> Fault.bias(coin ? a
                    : -a));
            case "sensor.gain" -> fault(0.01, 0.6, word, "constant", a -> Map.of("factor", coin ? 1 + a : 1 - a),
                    a -> Fault.gain(coin ? 1 + a : 1 - a));
            case "sensor.clipping" -> fault(0.35, 2.5, word, half < 0.5 ? "both sides" : "above", a -> Map.of("high", rms / a),
                    a -> Fault.clipping(half < 0.5 ? -rms / a : -1e3, rms / a));
            case "sensor.dropouts" -> {
                int rows = scene.shaking().length() / 16;
                int most = 160;
                int[] starts = numbers(most, rows);
                int[] lengths = numbers(most, 16);
                yield fault(4, most, word, "last value sent again", a -> Map.of("runs", Math.rint(a)), a -> Fault.dropouts(
                        head(starts, 60, a), head(lengths, 5, a)));
            }
            default -> throw new IllegalArgumentException("no sensor can have '" + word + "'");
        };
    }

    private int[] numbers(int count, int below) {
        return IntStream.range(0, count).map(i -> random.nextInt(below)).toArray();
    }

    private static int[] head(int[] x, int least, double count) {
        int[] out = new int[(int) Math.rint(count)];
        for (int i = 0; i < out.length; i++) {
            out[i] = Math.max(least, x[i]);
        }
        return out;
    }

    private OmissionRecipe fault(double least, double most, String word, String form, DoubleFunction<Map<String, Double>> parameters,
            DoubleFunction<Fault> fault) {
        return new OmissionRecipe(least, most, a -> new Omission(word, place + ".acc.z", form, parameters.apply(a),
                setup -> setup.fault(place, fault.apply(a))));
    }
}
