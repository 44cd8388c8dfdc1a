package wbv.network;

import ai.djl.ndarray.NDArray;
import java.util.Arrays;
import java.util.Map;
import wbv.recording.DataFault;

/** Arrays of the engine to and from those of a file. */
final class Weights {

    private Weights() {}

    static SafeTensors.Tensor out(NDArray array) {
        return new SafeTensors.Tensor(array.getShape().getShape(), array.toFloatArray());
    }

    /**
     * Fills an array.
     *
     * @param file for messages
     * @param into modified
     * @throws DataFault if the file has no such array, or one of another shape
     */
    static void in(String file, Map<String, SafeTensors.Tensor> tensors, String name, NDArray into) {
        try {
            in(tensors, name, into);
        } catch (DataFault unlike) {
            throw unlike.of(file);
        }
    }

    /** As {@link #in(String, Map, String, NDArray)}, where the file is not known. */
    static void in(Map<String, SafeTensors.Tensor> tensors, String name, NDArray into) {
        SafeTensors.Tensor tensor = tensors.get(name);
        if (tensor == null || !Arrays.equals(tensor.shape(), into.getShape().getShape())) {
            throw new DataFault("the model has no array '" + name + "' of shape " + into.getShape()
                    + "; it belongs to another network or another version of wbv");
        }
        boolean learned = into.hasGradient();
        into.setRequiresGradient(false);
        // Neither set() nor copyTo(): they make the engine warn of its own calls.
        try (NDArray source = into.getManager().create(tensor.values(), into.getShape())) {
            into.muli(0).addi(source);
        }
        into.setRequiresGradient(learned);
    }
}
