package wbv.network;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import wbv.recording.DataFault;

/**
 * A model as an ONNX file for other engines. Its input {@code image} are {@link Imaging#image images} as they come, batch, plane,
 * frequency, time; its outputs {@code value} and {@code deviation} are damping ratio and natural pulsation [rad/s] of each mode,
 * and how sure they are. Standardising, members and widening are inside.
 */
public final class OnnxExport {

    private final OnnxGraph graph = new OnnxGraph();
    private final TrainedNetwork model;
    private Iterator<SafeTensors.Tensor> weights = List.<SafeTensors.Tensor>of().iterator();

    private OnnxExport(TrainedNetwork model) {
        this.model = model;
    }

    /**
     * The file's bytes.
     *
     * @throws DataFault if the model's weights are not those of its architecture
     */
    public static byte[] of(TrainedNetwork model) {
        return new OnnxExport(model).bytes();
    }

    private byte[] bytes() {
        int planes = model.scaling().planeMean().length;
        int targets = model.scaling().targets();
        graph.input("image", planes, Imaging.BINS, Imaging.FRAMES);
        graph.output("value", targets);
        graph.output("deviation", targets);
        String image = graph.node("Div", List.of(graph.node("Sub", List.of("image",
                graph.constant(floats(model.scaling().planeMean()), 1, planes, 1, 1))),
                graph.constant(floats(model.scaling().planeDeviation()), 1, planes, 1, 1)));
        List<String> means = new ArrayList<>();
        List<String> squares = new ArrayList<>();
        for (Map<String, SafeTensors.Tensor> member : model.members()) {
            weights = member.values().iterator();
            String out = network(image);
            if (weights.hasNext()) {
                throw unlike("more arrays than belong to it");
            }
            boolean uncertain = model.architecture().uncertain();
            String mean = uncertain ? slice(out, 0, targets) : out;
            String variance = uncertain ? graph.node("Exp", List.of(slice(out, targets, 2L * targets)))
                    : graph.constant(new float[] {1}, 1);
            means.add(mean);
            squares.add(graph.node("Add", List.of(graph.node("Mul", List.of(mean, mean)), variance)));
        }
        String mean = graph.node("Mean", means);
        String variance = graph.node("Sub", List.of(graph.node("Mean", squares), graph.node("Mul", List.of(mean, mean))));
        double[] wide = model.scaling().deviation().clone();
        for (int j = 0; j < targets; j++) {
            wide[j] *= model.widening()[j];
        }
        graph.node("Add", List.of(graph.node("Mul", List.of(mean, graph.constant(floats(model.scaling().deviation()), 1,
                targets))),
                graph.constant(floats(model.scaling().mean()), 1, targets)), "value");
        graph.node("Mul", List.of(graph.node("Sqrt", List.of(graph.node("Relu", List.of(variance)))),
                graph.constant(floats(wide), 1, targets)), "deviation");
        return graph.bytes(model.architecture().word(), model.card());
    }

    private String network(String image) {
        String x = image;
        switch (model.architecture()) {
            case CNN -> {
                for (int i = 0; i < 3; i++) {
                    x = relu(normalised(convolution(x, 1)));
                    if (i < 2) {
                        x = graph.node("AveragePool", List.of(x), OnnxGraph.Attribute.list("kernel_shape", 2, 2),
                                OnnxGraph.Attribute.list("strides", 2, 2));
                    }
                }
            }
            case RESIDUAL -> {
                x = relu(normalised(convolution(x, 1)));
                for (int stride : new int[] {2, 2, 1}) {
                    String through = normalised(convolution(relu(normalised(convolution(x, stride))), 1));
                    String past = stride == 1 ? x : normalised(convolution(x, stride));
                    x = relu(graph.node("Add", List.of(through, past)));
                }
            }
            case POOLED, ANSWER_ONLY, THREE_AXES -> {
                x = relu(normalised(convolution(x, 1)));
                x = relu(normalised(convolution(x, 1)));
                String value = convolution(x, 1);
                String weight = graph.node("Softmax", List.of(convolution(x, 1)), OnnxGraph.Attribute.of("axis", 3));
                x = graph.node("ReduceSum", List.of(graph.node("Mul", List.of(value, weight)), graph.constant(3L)),
                        OnnxGraph.Attribute.of("keepdims", 0));
                x = relu(linear(flat(x)));
            }
        }
        return linear(flat(x));
    }

    private String convolution(String x, int stride) {
        SafeTensors.Tensor kernel = next(4);
        long high = kernel.shape()[2] / 2;
        long wide = kernel.shape()[3] / 2;
        return graph.node("Conv", List.of(x, constant(kernel), constant(next(1))),
                OnnxGraph.Attribute.list("pads", high, wide, high, wide), OnnxGraph.Attribute.list("strides", stride, stride));
    }

    /** The operator's own epsilon is 1e-5, as the engine's. */
    private String normalised(String x) {
        return graph.node("BatchNormalization", List.of(x, constant(next(1)), constant(next(1)), constant(next(1)),
                constant(next(1))));
    }

    /**
     * The next array of the member.
     *
     * @param axes that it must have
     */
    private SafeTensors.Tensor next(int axes) {
        if (!weights.hasNext()) {
            throw unlike("fewer arrays than belong to it");
        }
        SafeTensors.Tensor tensor = weights.next();
        if (tensor.shape().length != axes) {
            throw unlike("an array of " + tensor.shape().length + " axes where " + axes + " belong");
        }
        return tensor;
    }

    private DataFault unlike(String what) {
        return new DataFault("is no whole network '" + model.architecture().word() + "': a member has " + what);
    }

    private String relu(String x) {
        return graph.node("Relu", List.of(x));
    }

    private String flat(String x) {
        return graph.node("Flatten", List.of(x), OnnxGraph.Attribute.of("axis", 1));
    }

    private String linear(String x) {
        return graph.node("Gemm", List.of(x, constant(next(2)), constant(next(1))),
                OnnxGraph.Attribute.of("transB", 1));
    }

    private String slice(String x, long from, long to) {
        return graph.node("Slice", List.of(x, graph.constant(from), graph.constant(to), graph.constant(1L)));
    }

    private String constant(SafeTensors.Tensor tensor) {
        return graph.constant(tensor.values(), tensor.shape());
    }

    private static float[] floats(double[] values) {
        float[] floats = new float[values.length];
        for (int i = 0; i < values.length; i++) {
            floats[i] = (float) values[i];
        }
        return floats;
    }
}
