package wbv.state;

import weka.core.Instance;
import weka.core.Instances;

/** Weka's instances as rows. */
final class Instancing {

    private Instancing() {}

    /** All attributes of all instances but the class. */
    static double[][] rows(Instances data) {
        double[][] rows = new double[data.numInstances()][];
        for (int i = 0; i < rows.length; i++) {
            rows[i] = row(data.instance(i));
        }
        return rows;
    }

    static double[] row(Instance instance) {
        double[] row = new double[instance.numAttributes() - (instance.classIndex() >= 0 ? 1 : 0)];
        for (int i = 0, j = 0; i < instance.numAttributes(); i++) {
            if (i != instance.classIndex()) {
                row[j++] = instance.value(i);
            }
        }
        return row;
    }
}
