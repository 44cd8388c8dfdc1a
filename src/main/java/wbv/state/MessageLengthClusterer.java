package wbv.state;

import org.apache.commons.math3.random.RandomGenerator;
import wbv.state.mixture.CovarianceShape;
import wbv.state.mixture.MessageLength;
import wbv.state.mixture.Mixture;
import weka.core.OptionMetadata;

/** Weka's face of {@link MessageLength}: a normal mixture that finds its own number of components. */
public final class MessageLengthClusterer extends MixtureClusterer {

    private static final long serialVersionUID = 1;

    private int fewest = 1;
    private int most = MessageLength.USUAL.most();
    private boolean diagonal;

    @Override
    Mixture fit(double[][] rows, RandomGenerator random) {
        return new MessageLength(Math.min(fewest, most), most, diagonal ? CovarianceShape.DIAGONAL : CovarianceShape.FULL,
                MessageLength.USUAL.tolerance(),
                MessageLength.USUAL.floor()).fit(rows, random, share -> {}).mixture();
    }

    @Override
    public String globalInfo() {
        return "Normal mixture whose number of components is found by minimum message length (Figueiredo and Jain 2002).";
    }

    /** Fewest components, 1 or more. */
    public int getFewest() {
        return fewest;
    }

    /** Sets the fewest components; what is below 1 is 1. */
    @OptionMetadata(displayName = "fewest", description = "fewest components", commandLineParamName = "min",
            commandLineParamSynopsis = "-min <number>", displayOrder = 1)
    public void setFewest(int number) {
        fewest = Math.max(1, number);
    }

    /** Components to begin with, 1 or more. */
    public int getMost() {
        return most;
    }

    /** Sets the components to begin with; what is below 1 is 1. */
    @OptionMetadata(displayName = "most", description = "components to begin with", commandLineParamName = "max",
            commandLineParamSynopsis = "-max <number>", displayOrder = 2)
    public void setMost(int number) {
        most = Math.max(1, number);
    }

    /** Whether attributes are independent within a component. */
    public boolean getDiagonal() {
        return diagonal;
    }

    /** Sets whether they are. */
    @OptionMetadata(displayName = "diagonal", description = "attributes independent within a component",
            commandLineParamName = "diagonal",
            commandLineParamSynopsis = "-diagonal", commandLineParamIsFlag = true, displayOrder = 3)
    public void setDiagonal(boolean wanted) {
        diagonal = wanted;
    }

    public static void main(String[] words) {
        runClusterer(new MessageLengthClusterer(), words);
    }
}
