package wbv.state;

import java.util.Locale;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import wbv.state.mixture.Gaussian;
import wbv.state.mixture.Mixture;
import weka.clusterers.RandomizableDensityBasedClusterer;
import weka.core.Capabilities;
import weka.core.Capabilities.Capability;
import weka.core.Instance;
import weka.core.Instances;
import weka.core.RevisionUtils;
import weka.filters.Filter;
import weka.filters.unsupervised.attribute.ReplaceMissingValues;

/**
 * What Weka's two faces of a normal mixture have in common. Attributes must be numeric; missing values become the mean of their
 * attribute, as in Weka's own EM.
 */
public abstract sealed class MixtureClusterer extends RandomizableDensityBasedClusterer
        permits MessageLengthClusterer, DirichletClusterer {

    private static final long serialVersionUID = 1;

    private final ReplaceMissingValues filler = new ReplaceMissingValues();
    private Mixture mixture;

    MixtureClusterer() {
        m_SeedDefault = 1;
        setSeed(m_SeedDefault);
    }

    abstract Mixture fit(double[][] rows, RandomGenerator random);

    /** What it is, for Weka's help. */
    public abstract String globalInfo();

    /** The mixture that was fitted. */
    public Mixture mixture() {
        if (mixture == null) {
            throw new IllegalStateException("no clusterer built yet");
        }
        return mixture;
    }

    @Override
    public Capabilities getCapabilities() {
        Capabilities result = super.getCapabilities();
        result.disableAll();
        result.enable(Capability.NUMERIC_ATTRIBUTES);
        result.enable(Capability.MISSING_VALUES);
        result.enable(Capability.NO_CLASS);
        return result;
    }

    @Override
    public void buildClusterer(Instances data) throws Exception {
        getCapabilities().testWithFail(data);
        filler.setInputFormat(data);
        mixture = fit(Instancing.rows(Filter.useFilter(data, filler)), new Well19937c(getSeed()));
    }

    @Override
    public double[] clusterPriors() {
        return mixture().weights().clone();
    }

    @Override
    public double[] logDensityPerClusterForInstance(Instance instance) {
        filler.input(instance);
        double[] row = Instancing.row(filler.output());
        double[] scratch = new double[row.length];
        return mixture().components().stream().mapToDouble(each -> each.logDensity(row, scratch)).toArray();
    }

    @Override
    public int numberOfClusters() {
        return mixture().size();
    }

    @Override
    public String getRevision() {
        return RevisionUtils.extract("$Revision: 1 $");
    }

    @Override
    public String toString() {
        if (mixture == null) {
            return getClass().getSimpleName() + ": no clusterer built yet";
        }
        StringBuilder text = new StringBuilder(mixture.size() + " components\n");
        for (int m = 0; m < mixture.size(); m++) {
            text.append(String.format(Locale.ROOT, "%3d weight %.4f mean", m, mixture.weights()[m]));
            for (int i = 0; i < mixture.dimensions(); i++) {
                Gaussian gaussian = mixture.components().get(m);
                text.append(String.format(Locale.ROOT, " %.4g ± %.3g", gaussian.mean(i), Math.sqrt(gaussian.covariance(i, i))));
            }
            text.append('\n');
        }
        return text.toString();
    }
}
