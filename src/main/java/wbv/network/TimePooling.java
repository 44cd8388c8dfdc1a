package wbv.network;

import ai.djl.ndarray.NDArray;
import ai.djl.ndarray.NDList;
import ai.djl.ndarray.NDManager;
import ai.djl.ndarray.types.DataType;
import ai.djl.ndarray.types.Shape;
import ai.djl.nn.AbstractBlock;
import ai.djl.nn.convolutional.Conv2d;
import ai.djl.training.ParameterStore;
import ai.djl.util.PairList;

/**
 * A weighted mean over time at every frequency, values and weights both seen in the image:
 * {@code out = Σ_t softmax_t(g) v}, g and v convolutions of one pixel. What a moment without excitation says is worth nothing,
 * and the softmax can learn that. In: batch, channels, frequency, time; out: batch, units, frequency.
 */
final class TimePooling extends AbstractBlock {

    private static final byte VERSION = 1;
    private static final int TIME = 3;

    private final int units;
    private final Conv2d values;
    private final Conv2d gates;

    TimePooling(int units) {
        super(VERSION);
        this.units = units;
        values = addChildBlock("values", Conv2d.builder().setKernelShape(new Shape(1, 1)).setFilters(units).build());
        gates = addChildBlock("gates", Conv2d.builder().setKernelShape(new Shape(1, 1)).setFilters(units).build());
    }

    @Override
    protected NDList forwardInternal(ParameterStore store, NDList inputs, boolean training, PairList<String, Object> params) {
        NDArray value = values.forward(store, inputs, training).singletonOrThrow();
        NDArray weight = gates.forward(store, inputs, training).singletonOrThrow().softmax(TIME);
        return new NDList(value.mul(weight).sum(new int[] {TIME}));
    }

    @Override
    public Shape[] getOutputShapes(Shape[] inputs) {
        return new Shape[] {new Shape(inputs[0].get(0), units, inputs[0].get(2))};
    }

    @Override
    protected void initializeChildBlocks(NDManager manager, DataType type, Shape... inputs) {
        values.initialize(manager, type, inputs);
        gates.initialize(manager, type, inputs);
    }
}
