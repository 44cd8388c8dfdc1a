package wbv.network;

import ai.djl.ndarray.NDArray;
import ai.djl.ndarray.NDManager;
import ai.djl.nn.Parameter;
import ai.djl.util.Pair;
import java.util.LinkedHashMap;
import java.util.Map;

/** Steps down the gradient, with moments that can be stored, so that a training can go on where it stopped. */
final class Steps {

    private static final float MOMENTUM = 0.9f;
    private static final float SQUARES = 0.999f;
    private static final float TINY = 1e-8f;

    private final Settings.Method method;
    private final Map<String, NDArray> first = new LinkedHashMap<>();
    private final Map<String, NDArray> second = new LinkedHashMap<>();

    /** @param manager owner of the moments */
    Steps(Settings.Method method, Iterable<Pair<String, Parameter>> parameters, NDManager manager) {
        this.method = method;
        for (Pair<String, Parameter> each : parameters) {
            if (each.getValue().requiresGradient()) {
                NDArray like = each.getValue().getArray();
                first.put(each.getKey(), manager.zeros(like.getShape(), like.getDataType()));
                if (method == Settings.Method.ADAM) {
                    second.put(each.getKey(), manager.zeros(like.getShape(), like.getDataType()));
                }
            }
        }
    }

    /**
     * One step of one parameter.
     *
     * @param gradient its own manager holds what is worked out here
     * @param number   of the step, from 1
     */
    void take(String name, NDArray weights, NDArray gradient, double rate, long number) {
        weights.setRequiresGradient(false);
        NDArray m = first.get(name);
        if (method == Settings.Method.MOMENTUM) {
            m.muli(MOMENTUM).subi(gradient.mul((float) rate));
            weights.addi(m);
        } else {
            NDArray v = second.get(name);
            m.muli(MOMENTUM).addi(gradient.mul(1 - MOMENTUM));
            v.muli(SQUARES).addi(gradient.square().muli(1 - SQUARES));
            double size = rate * Math.sqrt(1 - Math.pow(SQUARES, number)) / (1 - Math.pow(MOMENTUM, number));
            NDArray root = v.sqrt();
            root.attach(gradient.getManager());
            NDArray change = m.div(root.addi(TINY));
            change.attach(gradient.getManager());
            weights.subi(change.muli((float) size));
        }
        weights.setRequiresGradient(true);
    }

    /** All moments by name. */
    Map<String, NDArray> moments() {
        Map<String, NDArray> all = new LinkedHashMap<>();
        first.forEach((name, array) -> all.put("first." + name, array));
        second.forEach((name, array) -> all.put("second." + name, array));
        return all;
    }
}
