package wbv.network;

import ai.djl.ndarray.NDArray;
import ai.djl.ndarray.NDManager;
import ai.djl.ndarray.types.Shape;
import java.util.List;

/**
 * Standardised images with standardised targets.
 *
 * @param images  of the same size each
 * @param targets of the same number each
 */
record Examples(List<float[]> images, List<float[]> targets, int planes) {

    static Examples of(Imaging imaging, Scaling scaling, List<LabelledMotion> trials) {
        List<float[]> images = trials.stream().map(trial -> imaging.image(trial.motion())).toList();
        images.forEach(scaling::standardise);
        List<float[]> targets = trials.stream().map(trial -> {
            float[] target = new float[scaling.targets()];
            for (int j = 0; j < target.length; j++) {
                target[j] = (float) ((trial.truth()[j] - scaling.mean()[j]) / scaling.deviation()[j]);
            }
            return target;
        }).toList();
        return new Examples(images, targets, imaging.planes().size());
    }

    int width() {
        return targets.get(0).length;
    }

    NDArray imageArray(NDManager manager) {
        return array(images, manager).reshape(new Shape(images.size(), planes, Imaging.BINS, Imaging.FRAMES));
    }

    NDArray targetArray(NDManager manager) {
        return array(targets, manager);
    }

    private static NDArray array(List<float[]> rows, NDManager manager) {
        int width = rows.get(0).length;
        float[] all = new float[rows.size() * width];
        for (int i = 0; i < rows.size(); i++) {
            System.arraycopy(rows.get(i), 0, all, i * width, width);
        }
        return manager.create(all, new Shape(rows.size(), width));
    }
}
