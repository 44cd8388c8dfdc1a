package wbv.network;

import ai.djl.engine.Engine;
import ai.djl.ndarray.NDArray;
import ai.djl.ndarray.NDList;
import ai.djl.ndarray.NDManager;
import ai.djl.ndarray.index.NDIndex;
import ai.djl.ndarray.types.DataType;
import ai.djl.ndarray.types.Shape;
import ai.djl.nn.Block;
import ai.djl.nn.Parameter;
import ai.djl.training.GradientCollector;
import ai.djl.training.ParameterStore;
import ai.djl.util.Pair;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.stream.IntStream;

/**
 * The training of one network, epoch by epoch. The order of the images and what dropout leaves out depend on the seed and the
 * epoch alone, so that a training that was interrupted ends as one that was not.
 */
final class Training implements AutoCloseable {

    private static final int ASKED_AT_ONCE = 256;
    /** Weight of σ^2β on each trial's likelihood: keeps trials thought uncertain from being given up (Seitzer et al. 2022). */
    private static final float BETA = 0.5f;

    private final Architecture architecture;
    private final Settings settings;
    private final Engine engine;
    private final NDManager manager;
    private final Block block;
    private final ParameterStore store;
    private final Steps steps;
    private final NDArray images;
    private final NDArray targets;
    private final NDArray heldImages;
    private final NDArray heldTargets;
    private int epoch;
    private long step;

    /**
     * @param train images and targets, standardised; as many values as the network asks for
     * @param held  the same of trials that the network does not learn from
     */
    Training(Architecture architecture, Settings settings, Examples train, Examples held) {
        this.architecture = architecture;
        this.settings = settings;
        engine = PyTorch.engine();
        manager = engine.newBaseManager();
        images = train.imageArray(manager);
        targets = train.targetArray(manager);
        heldImages = held.imageArray(manager);
        heldTargets = held.targetArray(manager);
        engine.setRandomSeed(Math.toIntExact(settings.seed()));
        int outputs = train.width() * (architecture.uncertain() ? 2 : 1);
        block = Layers.of(architecture, outputs, settings.dropout());
        block.initialize(manager, DataType.FLOAT32, new Shape(settings.batch(), train.planes(), Imaging.BINS, Imaging.FRAMES));
        store = new ParameterStore(manager, false);
        steps = new Steps(settings.method(), block.getParameters(), manager);
    }

    /** Epochs done. */
    int epochs() {
        return epoch;
    }

    boolean finished() {
        return epoch == settings.epochs();
    }

    /**
     * One epoch.
     *
     * @return loss on what was learned from, loss and root mean square error on what was not
     */
    Losses next() {
        int n = (int) images.getShape().get(0);
        long seed = settings.seed() * 100_003 + epoch;
        engine.setRandomSeed((int) (seed % Integer.MAX_VALUE));
        int[] order = shuffled(n, new SplittableRandom(seed));
        double rate = settings.rate(epoch);
        double sum = 0;
        int batches = Math.max(1, n / settings.batch());
        for (int b = 0; b < batches; b++) {
            int from = (int) ((long) b * n / batches);
            int to = (int) ((long) (b + 1) * n / batches);
            sum += learn(Arrays.copyOfRange(order, from, to), rate);
        }
        epoch++;
        double[] held = held();
        return new Losses(sum / batches, held[0], held[1]);
    }

    private double learn(int[] chosen, double rate) {
        step++;
        try (NDManager sub = manager.newSubManager()) {
            float loss;
            try (GradientCollector collector = engine.newGradientCollector()) {
                NDIndex rows = new NDIndex("{}", sub.create(chosen));
                NDArray batch = images.get(sub, rows);
                NDArray out = block.forward(store, new NDList(batch), true).singletonOrThrow();
                NDArray truth = targets.get(sub, rows);
                NDArray cost = cost(architecture, out, truth);
                collector.backward(loss(out, truth, cost));
                loss = cost.sum(new int[] {1}).mean().getFloat();
            }
            for (Pair<String, Parameter> each : block.getParameters()) {
                if (each.getValue().requiresGradient()) {
                    NDArray gradient = each.getValue().getArray().getGradient();
                    gradient.attach(sub);
                    steps.take(each.getKey(), each.getValue().getArray(), gradient, rate, step);
                    gradient.subi(gradient); // the engine adds the next one to it
                }
            }
            return loss;
        }
    }

    /** Half the mean square error, or what the likelihood of means and variances costs; a trial at a time. */
    static NDArray cost(Architecture architecture, NDArray out, NDArray truth) {
        if (!architecture.uncertain()) {
            return out.sub(truth).square().mul(0.5f);
        }
        long n = truth.getShape().get(1);
        NDArray logVariance = out.get(":, {}:", n);
        NDArray error = out.get(":, :{}", n).sub(truth).square();
        return error.mul(logVariance.neg().exp()).add(logVariance).mul(0.5f);
    }

    /** What is descended. */
    private NDArray loss(NDArray out, NDArray truth, NDArray cost) {
        if (!architecture.uncertain()) {
            return cost.sum(new int[] {1}).mean();
        }
        NDArray weight = out.get(":, {}:", truth.getShape().get(1)).stopGradient().mul(BETA).exp();
        return cost.mul(weight).sum(new int[] {1}).mean();
    }

    private double[] held() {
        int n = (int) heldImages.getShape().get(0);
        double loss = 0;
        double squares = 0;
        for (int from = 0; from < n; from += ASKED_AT_ONCE) {
            int to = Math.min(n, from + ASKED_AT_ONCE);
            try (NDManager sub = manager.newSubManager()) {
                NDIndex rows = new NDIndex("{}:{}", from, to);
                NDArray batch = heldImages.get(sub, rows);
                NDArray truth = heldTargets.get(sub, rows);
                NDArray out = block.forward(store, new NDList(batch), false).singletonOrThrow();
                loss += cost(architecture, out, truth).sum(new int[] {1}).mean().getFloat() * (to - from) / n;
                NDArray means = out.get(":, :{}", truth.getShape().get(1));
                squares += means.sub(truth).square().mean().getFloat() * (to - from) / n;
            }
        }
        return new double[] {loss, Math.sqrt(squares)};
    }

    private static int[] shuffled(int n, SplittableRandom random) {
        int[] order = IntStream.range(0, n).toArray();
        for (int i = n - 1; i > 0; i--) {
            int j = random.nextInt(i + 1);
            int swapped = order[i];
            order[i] = order[j];
            order[j] = swapped;
        }
        return order;
    }

    /** The network's weights, with the running means of its normalisations. */
    Map<String, SafeTensors.Tensor> weights() {
        Map<String, SafeTensors.Tensor> weights = new LinkedHashMap<>();
        for (Pair<String, Parameter> each : block.getParameters()) {
            weights.put(each.getKey(), Weights.out(each.getValue().getArray()));
        }
        return weights;
    }

    /** Everything that {@link #restore} needs: weights, moments, and how far the training has come. */
    SafeTensors state() {
        Map<String, SafeTensors.Tensor> all = new LinkedHashMap<>();
        weights().forEach((name, tensor) -> all.put("weights." + name, tensor));
        steps.moments().forEach((name, array) -> all.put(name, Weights.out(array)));
        return new SafeTensors(Map.of("epoch", Integer.toString(epoch), "step", Long.toString(step)), all);
    }

    /**
     * Goes on from a state.
     *
     * @param name of its file, for messages
     */
    void restore(String name, SafeTensors state) {
        for (Pair<String, Parameter> each : block.getParameters()) {
            Weights.in(name, state.tensors(), "weights." + each.getKey(), each.getValue().getArray());
        }
        steps.moments().forEach((each, array) -> Weights.in(name, state.tensors(), each, array));
        epoch = Integer.parseInt(state.words().get("epoch"));
        step = Long.parseLong(state.words().get("step"));
    }

    @Override
    public void close() {
        manager.close();
    }
}
