package wbv.network;

import static org.junit.jupiter.api.Assertions.assertEquals;

import ai.djl.engine.Engine;
import ai.djl.ndarray.NDArray;
import ai.djl.ndarray.NDList;
import ai.djl.ndarray.NDManager;
import ai.djl.ndarray.types.DataType;
import ai.djl.ndarray.types.Shape;
import ai.djl.nn.Block;
import ai.djl.nn.Parameter;
import ai.djl.training.GradientCollector;
import ai.djl.training.ParameterStore;
import ai.djl.util.Pair;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The networks' forward passes against NumPy's, and their gradients against differences. */
class LayersTest {

    @BeforeAll
    static void needsTheEngine() {
        WithEngine.orSkip();
    }

    /**
     * Written out in NumPy 2 (convolutions as sums over the kernel), weights {@code sin(0.7 i + k)} scaled,
     * pixels {@code cos(0.37 i)}.
     */
    @Test
    void forwardPassesAreThoseOfNumpy() {
        check(Architecture.CNN, 2, -0.8314660987885482, -0.7482292267225749);
        check(Architecture.RESIDUAL, 2, 176.05202148389583, 109.84497296251867);
        check(Architecture.POOLED, 4, 0.15319732688805682, -0.012493314553915918, -0.1581187005783789, -0.1875958211991191);
    }

    private static void check(Architecture architecture, int outputs, double... expected) {
        Engine engine = PyTorch.engine();
        try (NDManager manager = engine.newBaseManager()) {
            int planes = architecture.imaging().planes().size();
            Block block = Layers.of(architecture, outputs, 0.5);
            block.initialize(manager, DataType.FLOAT64, new Shape(1, planes, 32, 32));
            int k = 0;
            for (Pair<String, Parameter> each : block.getParameters()) {
                fill(each, k++);
            }
            double[] pixels = IntStream.range(0, planes * Imaging.PLANE).mapToDouble(i -> Math.cos(0.37 * i)).toArray();
            NDArray image = manager.create(pixels, new Shape(1, planes, 32, 32));
            double[] out = block.forward(new ParameterStore(manager, false), new NDList(image), false).singletonOrThrow()
                    .toDoubleArray();
            assertEquals(expected.length, out.length);
            for (int i = 0; i < out.length; i++) {
                assertEquals(expected[i], out[i], 1e-6 * Math.max(1, Math.abs(expected[i])), architecture + " " + i);
            }
        }
    }

    private static void fill(Pair<String, Parameter> each, int k) {
        NDArray array = each.getValue().getArray();
        long[] shape = array.getShape().getShape();
        double fan = 1;
        for (int i = 1; i < shape.length; i++) {
            fan *= shape[i];
        }
        double scale = Math.sqrt(shape.length > 1 ? 2 / fan : 0.01);
        String name = each.getKey();
        double[] values = new double[(int) array.size()];
        for (int i = 0; i < values.length; i++) {
            double value = scale * Math.sin(0.7 * i + k);
            values[i] = name.endsWith("gamma") ? 1 + value : name.endsWith("runningVar") ? 1 + Math.abs(value) : value;
        }
        array.setRequiresGradient(false);
        put(values, array);
        array.setRequiresGradient(each.getValue().requiresGradient());
    }

    /** In 64 bits, thirty weights of every network: the gradient of what is descended equals central differences. */
    @ParameterizedTest
    @EnumSource(Architecture.class)
    void gradientsAreDifferences(Architecture architecture) {
        Engine engine = PyTorch.engine();
        engine.setRandomSeed(5);
        try (NDManager manager = engine.newBaseManager()) {
            int planes = architecture.imaging().planes().size();
            Block block = Layers.of(architecture, architecture.uncertain() ? 4 : 2, 0);
            block.initialize(manager, DataType.FLOAT64, new Shape(3, planes, 32, 32));
            ParameterStore store = new ParameterStore(manager, false);
            NDArray images = manager.randomNormal(0, 1, new Shape(3, planes, 32, 32), DataType.FLOAT64);
            NDArray truth = manager.randomNormal(0, 1, new Shape(3, 2), DataType.FLOAT64);
            try (GradientCollector collector = engine.newGradientCollector()) {
                collector.backward(cost(architecture, block, store, images, truth));
            }
            SplittableRandom random = new SplittableRandom(1);
            for (Pair<String, Parameter> each : block.getParameters()) {
                if (each.getValue().requiresGradient()) {
                    NDArray array = each.getValue().getArray();
                    double[] gradient = array.getGradient().toDoubleArray();
                    int i = random.nextInt(gradient.length);
                    double step = 1e-6; // the shorter, the fewer rectifiers change sides
                    double up = moved(architecture, block, store, images, truth, array, i, step);
                    double down = moved(architecture, block, store, images, truth, array, i, -step);
                    assertEquals((up - down) / (2 * step), gradient[i], 1e-6 + 1e-4 * Math.abs(gradient[i]), each.getKey());
                }
            }
        }
    }

    private static double moved(Architecture architecture, Block block, ParameterStore store, NDArray images, NDArray truth,
            NDArray array, int i, double step) {
        double[] values = array.toDoubleArray();
        double[] other = values.clone();
        other[i] += step;
        array.setRequiresGradient(false);
        put(other, array);
        double cost = cost(architecture, block, store, images, truth).getDouble();
        put(values, array);
        array.setRequiresGradient(true);
        return cost;
    }

    private static void put(double[] values, NDArray into) {
        try (NDArray source = into.getManager().create(values, into.getShape())) {
            into.muli(0).addi(source);
        }
    }

    private static NDArray cost(Architecture architecture, Block block, ParameterStore store, NDArray images, NDArray truth) {
        NDArray out = block.forward(store, new NDList(images), true).singletonOrThrow();
        return Training.cost(architecture, out, truth).sum(new int[] {1}).mean();
    }
}
