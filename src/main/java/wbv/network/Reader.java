package wbv.network;

import ai.djl.engine.Engine;
import ai.djl.ndarray.NDArray;
import ai.djl.ndarray.NDList;
import ai.djl.ndarray.NDManager;
import ai.djl.ndarray.types.DataType;
import ai.djl.ndarray.types.Shape;
import ai.djl.nn.Block;
import ai.djl.nn.Parameter;
import ai.djl.training.ParameterStore;
import ai.djl.util.Pair;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** A model at work: reads bodies from motion. Not for several threads. Holds memory of the engine until closed. */
public final class Reader implements AutoCloseable {

    private static final int AT_ONCE = 128;

    private final TrainedNetwork model;
    private final Imaging imaging;
    private final NDManager manager;
    private final ParameterStore store;
    private final FrequencyFit fit;
    private final List<Block> members = new ArrayList<>();

    /**
     * Loads all members into the engine.
     *
     * @throws wbv.recording.DataFault if PyTorch's library is missing, or the weights are not this network's
     */
    public Reader(TrainedNetwork model) {
        Engine engine = PyTorch.engine();
        this.model = model;
        this.imaging = model.architecture().imaging();
        this.manager = engine.newBaseManager();
        this.store = new ParameterStore(manager, false);
        this.fit = new FrequencyFit(model.modes(), model.architecture().others());
        int outputs = 2 * model.modes() * (model.architecture().uncertain() ? 2 : 1);
        for (Map<String, SafeTensors.Tensor> weights : model.members()) {
            Block block = Layers.of(model.architecture(), outputs, 0);
            block.initialize(manager, DataType.FLOAT32, new Shape(1, imaging.planes().size(), Imaging.BINS, Imaging.FRAMES));
            for (Pair<String, Parameter> each : block.getParameters()) {
                Weights.in(weights, each.getKey(), each.getValue().getArray());
                each.getValue().getArray().setRequiresGradient(false);
            }
            members.add(block);
        }
    }

    /** The model that reads. */
    public TrainedNetwork model() {
        return model;
    }

    /**
     * The body of one window.
     *
     * @param motion the model's channels, by channel and sample, each in its own unit, {@value Imaging#SAMPLES} samples at {@value
     *               Imaging#RATE} Hz. Not modified.
     */
    public Reading read(double[][] motion) {
        return readAll(List.<double[][]>of(motion)).get(0);
    }

    /** Many at once, which is faster than one after the other. */
    public List<Reading> readAll(List<double[][]> motions) {
        List<Estimate> estimates = ask(motions);
        List<Reading> readings = new ArrayList<>();
        if (!model.architecture().excited()) {
            return estimates.stream().map(each -> new Reading(each, each, Double.NaN)).toList();
        }
        double[] spread = model.scaling().deviation();
        for (int i = 0; i < estimates.size(); i++) {
            FrequencyFit.Found found = fit.from(motions.get(i), estimates.get(i));
            double[] deviation = found.deviation().clone();
            for (int j = 0; j < deviation.length; j++) {
                deviation[j] *= model.usual().widening()[j];
            }
            double misfit = model.usual().misfit(found);
            Estimate network = estimates.get(i);
            Estimate fitted = new Estimate(found.value(), deviation);
            readings.add(new Reading(Usual.doubted(network, fitted, misfit, spread),
                    Usual.doubted(fitted, network, misfit, spread), misfit));
        }
        return readings;
    }

    /** What the network alone says, from its images: no window is held against it. */
    public List<Estimate> ask(List<double[][]> motions) {
        List<Estimate> estimates = new ArrayList<>();
        for (int from = 0; from < motions.size(); from += AT_ONCE) {
            estimates.addAll(batch(motions.subList(from, Math.min(motions.size(), from + AT_ONCE))));
        }
        return estimates;
    }

    /** Members as a mixture: its mean, and its variance, in which their disagreement counts (Lakshminarayanan et al. 2017). */
    private List<Estimate> batch(List<double[][]> motions) {
        int n = motions.size();
        int targets = 2 * model.modes();
        double[][] mean = new double[n][targets];
        double[][] squares = new double[n][targets];
        try (NDManager sub = manager.newSubManager()) {
            float[] pixels = new float[n * imaging.size()];
            for (int i = 0; i < n; i++) {
                float[] image = imaging.image(motions.get(i));
                model.scaling().standardise(image);
                System.arraycopy(image, 0, pixels, i * imaging.size(), image.length);
            }
            NDArray images = sub.create(pixels, new Shape(n, imaging.planes().size(), Imaging.BINS, Imaging.FRAMES));
            for (Block member : members) {
                float[] out = member.forward(store, new NDList(images), false).singletonOrThrow().toFloatArray();
                int width = out.length / n;
                for (int i = 0; i < n; i++) {
                    for (int j = 0; j < targets; j++) {
                        double value = out[i * width + j];
                        double variance = model.architecture().uncertain() ? Math.exp(out[i * width + targets + j]) : 1;
                        mean[i][j] += value / members.size();
                        squares[i][j] += (value * value + variance) / members.size();
                    }
                }
            }
        }
        List<Estimate> estimates = new ArrayList<>();
        for (int i = 0; i < n; i++) {
            double[] value = new double[targets];
            double[] deviation = new double[targets];
            for (int j = 0; j < targets; j++) {
                double scale = model.scaling().deviation()[j];
                value[j] = model.scaling().mean()[j] + scale * mean[i][j];
                deviation[j] = scale * model.widening()[j] * Math.sqrt(Math.max(0, squares[i][j] - mean[i][j] * mean[i][j]));
            }
            estimates.add(new Estimate(value, deviation));
        }
        return estimates;
    }

    @Override
    public void close() {
        manager.close();
    }
}
