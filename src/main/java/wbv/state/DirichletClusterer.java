package wbv.state;

import org.apache.commons.math3.random.RandomGenerator;
import wbv.state.mixture.CovarianceShape;
import wbv.state.mixture.DirichletProcess;
import wbv.state.mixture.Mixture;
import weka.core.OptionMetadata;

/** Weka's face of {@link DirichletProcess}: a normal mixture of as many components as the data show. */
public final class DirichletClusterer extends MixtureClusterer {

    private static final long serialVersionUID = 1;

    private int sweeps = 100;
    private double share = 0.1;
    private int rows = 5;

    @Override
    Mixture fit(double[][] data, RandomGenerator random) {
        return DirichletProcess.fit(data, share, sweeps, rows, CovarianceShape.FULL, random, done -> {});
    }

    @Override
    public String globalInfo() {
        return "Normal mixture with a Dirichlet process for its weights, by collapsed Gibbs sampling (Neal 2000, algorithm 3; "
                + "Escobar and West 1995).";
    }

    /** Sweeps of the chain, 1 or more. */
    public int getSweeps() {
        return sweeps;
    }

    /** Sets the sweeps; what is below 1 is 1. */
    @OptionMetadata(displayName = "sweeps", description = "sweeps of the chain", commandLineParamName = "sweeps",
            commandLineParamSynopsis = "-sweeps <number>", displayOrder = 1)
    public void setSweeps(int number) {
        sweeps = Math.max(1, number);
    }

    /** Ratio of the variance of a component to that of the data, before they are seen; above 0. */
    public double getShare() {
        return share;
    }

    /** Sets that share; what is not above 0 is 0.1. */
    @OptionMetadata(displayName = "share", description = "variance of a component over that of the data, before they are seen",
            commandLineParamName = "share", commandLineParamSynopsis = "-share <number>", displayOrder = 2)
    public void setShare(double number) {
        share = number > 0 ? number : 0.1;
    }

    /** Fewest instances of a component that is kept, 1 or more. */
    public int getRows() {
        return rows;
    }

    /** Sets that number; what is below 1 is 1. */
    @OptionMetadata(displayName = "rows", description = "fewest instances of a component that is kept",
            commandLineParamName = "rows",
            commandLineParamSynopsis = "-rows <number>", displayOrder = 3)
    public void setRows(int number) {
        rows = Math.max(1, number);
    }

    public static void main(String[] words) {
        runClusterer(new DirichletClusterer(), words);
    }
}
