package wbv.learn;

import com.github.javacliparser.FileOption;
import com.github.javacliparser.FlagOption;
import com.yahoo.labs.samoa.instances.Instance;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import moa.classifiers.AbstractClassifier;
import moa.classifiers.MultiClassClassifier;
import moa.core.Measurement;
import moa.core.StringUtils;
import wbv.state.FeatureSpec;
import wbv.state.MotionState;
import wbv.state.StateFilter;
import wbv.state.StateModel;
import wbv.state.StateModelFile;
import wbv.state.markov.GrowingChain;
import wbv.state.mixture.CovarianceShape;

/**
 * MOA's face of hidden Markov models: votes for the class of every instance given all instances before it, in memory that does not
 * grow. Without a model it learns from labelled instances; with one, of {@code wbv states train}, it only follows. An instance is
 * taken when it is trained on: asking for votes changes nothing.
 *
 * <p>A class that comes with an instance that is trained on says where the chain is, as MOA's no-change classifier, against which
 * the temporal kappa holds a learner, takes it too. With {@code -b} the chain is told nothing: what it votes is what it would vote
 * where nobody labels.
 */
public class StateLearner extends AbstractClassifier implements MultiClassClassifier {

    private static final long serialVersionUID = 2;
    private static final String TIME = "t";

    public final FileOption modelOption = new FileOption("model", 'm',
            "model.json of 'wbv states train', to follow instead of learning; its features must be attributes.", null, "json",
            false);
    public final FlagOption diagonalOption = new FlagOption("diagonal", 'd', "Attributes are independent within a class.");
    public final FlagOption blindOption = new FlagOption("blind", 'b',
            "Labels teach only; where the chain is, is told from the attributes alone.");

    private GrowingChain chain = new GrowingChain(1, 1, CovarianceShape.FULL);
    /** What is followed: nothing, or one model and its filter. */
    private final List<StateModel> model = new ArrayList<>();
    private final List<StateFilter> filter = new ArrayList<>();
    private int[] attributes = new int[0];
    private double[] row = new double[0];
    private double[] byName = new double[0];
    private int[] classes = new int[0];
    private double[] votes = new double[0];
    private long taken;

    @Override
    public String getPurposeString() {
        return "Votes for the state of motion of every sample given all samples before it, by a hidden Markov model.";
    }

    @Override
    public void resetLearningImpl() {
        attributes = new int[0];
        taken = 0;
        model.clear();
        filter.clear();
    }

    /** Whether a model is followed rather than learned. */
    private boolean follows() {
        return modelOption.getValue() != null && !modelOption.getValue().isEmpty();
    }

    private void prepare(Instance instance) {
        if (attributes.length > 0) {
            return;
        }
        List<Integer> found = new ArrayList<>();
        for (int i = 0; i < instance.numAttributes(); i++) {
            String name = instance.attribute(i).name();
            boolean wanted = follows() ? FeatureSpec.NAMES.contains(name) : i != instance.classIndex() && !name.equals(TIME)
                    && instance.attribute(i).isNumeric();
            if (wanted) {
                found.add(i);
            }
        }
        if (found.isEmpty() || follows() && found.size() != FeatureSpec.NAMES.size()) {
            throw new IllegalArgumentException("attributes must be numeric" + (follows() ? ": " + FeatureSpec.NAMES : "") + "; "
                    + instance.dataset().getRelationName() + " has " + found.size() + " of them");
        }
        if (follows()) {
            found.sort(Comparator.comparingInt(i -> FeatureSpec.NAMES.indexOf(instance.attribute(i).name())));
        }
        attributes = found.stream().mapToInt(Integer::intValue).toArray();
        row = new double[attributes.length];
        votes = new double[instance.numClasses()];
        if (follows()) {
            follow(instance);
        } else {
            chain = new GrowingChain(instance.numClasses(), row.length,
                    diagonalOption.isSet() ? CovarianceShape.DIAGONAL : CovarianceShape.FULL);
        }
    }

    private void follow(Instance instance) {
        try {
            model.add(StateModelFile.read(Path.of(modelOption.getValue())));
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
        filter.add(new StateFilter(model.get(0)));
        byName = new double[MotionState.values().length];
        classes = new int[byName.length];
        for (int c = 0; c < classes.length; c++) {
            classes[c] = instance.classAttribute().indexOfValue(MotionState.values()[c].toString());
        }
    }

    private void read(Instance instance) {
        prepare(instance);
        for (int i = 0; i < row.length; i++) {
            row[i] = instance.isMissing(attributes[i]) ? Double.NaN : instance.value(attributes[i]);
        }
    }

    @Override
    public void trainOnInstanceImpl(Instance instance) {
        read(instance);
        taken++;
        if (follows()) {
            filter.get(0).step(row);
            if (!blindOption.isSet() && !instance.classIsMissing()) {
                MotionState.named(instance.classAttribute().value((int) instance.classValue())).ifPresent(filter.get(0)::know);
            }
        } else if (instance.classIsMissing()) {
            chain.follow(row);
        } else {
            chain.learn(row, (int) instance.classValue(), !blindOption.isSet());
        }
    }

    /** One for each class, summing to one. The same array every time. */
    @Override
    public double[] getVotesForInstance(Instance instance) {
        read(instance);
        if (!follows()) {
            chain.votes(row, votes);
            return votes;
        }
        filter.get(0).look(row, byName);
        Arrays.fill(votes, 0);
        for (int c = 0; c < classes.length; c++) {
            if (classes[c] >= 0) {
                votes[classes[c]] += byName[c];
            }
        }
        return votes;
    }

    @Override
    protected Measurement[] getModelMeasurementsImpl() {
        return new Measurement[] {new Measurement("samples", taken),
            new Measurement("states", !model.isEmpty() ? model.get(0).chain().states() : chain.known())};
    }

    @Override
    public void getModelDescription(StringBuilder out, int indent) {
        StringUtils.appendIndented(out, indent, "hidden Markov model after " + taken + " samples");
    }

    @Override
    public boolean isRandomizable() {
        return false;
    }
}
