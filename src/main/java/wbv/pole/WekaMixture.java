package wbv.pole;

import java.util.ArrayList;
import java.util.List;
import weka.clusterers.EM;
import weka.core.Attribute;
import weka.core.DenseInstance;
import weka.core.Instances;

/** Weka's Gaussian mixture by expectation and maximisation, beside the density clusters; it knows no noise. */
final class WekaMixture {

    private WekaMixture() {}

    /**
     * A label for each point, 0, 1, … in the order of first appearance; the number of components is chosen by cross-validation.
     *
     * @param points by row, at least one. Not modified.
     * @param most components
     */
    static int[] labels(double[][] points, int most, int seed) {
        ArrayList<Attribute> attributes = new ArrayList<>(List.of(new Attribute("re"), new Attribute("im")));
        Instances data = new Instances("poles", attributes, points.length);
        for (double[] point : points) {
            data.add(new DenseInstance(1, point.clone()));
        }
        EM mixture = new EM();
        try {
            mixture.setNumClusters(-1);
            mixture.setMaximumNumberOfClusters(most);
            mixture.setSeed(seed);
            mixture.buildClusterer(data);
            int[] labels = new int[points.length];
            for (int i = 0; i < labels.length; i++) {
                labels[i] = mixture.clusterInstance(data.instance(i));
            }
            return Density.inOrder(labels);
        } catch (Exception e) { // Weka declares nothing narrower
            throw new IllegalStateException("Weka's EM failed on " + points.length + " points", e);
        }
    }
}
