package wbv.network;

import java.io.Serializable;
import java.util.List;

/**
 * Mean and standard deviation of every plane of the images, and of every target, over the trials that were learned from: stored
 * with a model. Arrays are not copied: treat them as read-only.
 *
 * @param planeMean      by plane, in the plane's unit
 * @param planeDeviation likewise
 * @param mean           by target, in the target's unit
 * @param deviation      likewise
 */
public record Scaling(double[] planeMean, double[] planeDeviation, double[] mean, double[] deviation) implements Serializable {

    private static final double LEAST = 1e-6;

    /** @param images not yet standardised. Not modified. */
    static Scaling of(List<float[]> images, List<LabelledMotion> trials) {
        int planes = images.get(0).length / Imaging.PLANE;
        int targets = trials.get(0).truth().length;
        double[][] values = new double[4][];
        values[0] = new double[planes];
        values[1] = new double[planes];
        for (int p = 0; p < planes; p++) {
            double sum = 0;
            double squares = 0;
            for (float[] image : images) {
                for (int i = p * Imaging.PLANE; i < (p + 1) * Imaging.PLANE; i++) {
                    sum += image[i];
                    squares += (double) image[i] * image[i];
                }
            }
            double n = (double) images.size() * Imaging.PLANE;
            values[0][p] = sum / n;
            values[1][p] = Math.max(LEAST, Math.sqrt(Math.max(0, squares / n - sum / n * (sum / n))));
        }
        values[2] = new double[targets];
        values[3] = new double[targets];
        for (int j = 0; j < targets; j++) {
            int at = j;
            double mean = trials.stream().mapToDouble(trial -> trial.truth()[at]).average().orElseThrow();
            double variance = trials.stream().mapToDouble(trial -> Math.pow(trial.truth()[at] - mean, 2)).average().orElseThrow();
            values[2][j] = mean;
            values[3][j] = Math.max(LEAST, Math.sqrt(variance));
        }
        return new Scaling(values[0], values[1], values[2], values[3]);
    }

    /**
     * Standardises an image in place.
     *
     * @param image modified
     */
    void standardise(float[] image) {
        for (int p = 0; p < planeMean.length; p++) {
            for (int i = p * Imaging.PLANE; i < (p + 1) * Imaging.PLANE; i++) {
                image[i] = (float) ((image[i] - planeMean[p]) / planeDeviation[p]);
            }
        }
    }

    int targets() {
        return mean.length;
    }
}
