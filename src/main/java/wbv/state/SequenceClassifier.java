package wbv.state;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.apache.commons.math3.random.Well19937c;
import wbv.signal.LogSum;
import wbv.state.markov.BaumWelch;
import wbv.state.markov.HiddenMarkov;
import wbv.state.markov.Rows;
import wbv.state.markov.Trellis;
import wbv.state.mixture.CovarianceShape;
import wbv.state.mixture.MessageLength;
import wbv.state.mixture.Mixture;
import weka.classifiers.RandomizableClassifier;
import weka.core.Capabilities;
import weka.core.Capabilities.Capability;
import weka.core.Instance;
import weka.core.Instances;
import weka.core.MultiInstanceCapabilitiesHandler;
import weka.core.OptionMetadata;
import weka.core.RevisionUtils;

/**
 * Weka's classifier of sequences: a bag of rows in their order (a relational attribute), one hidden Markov model for each
 * class, and
 * the class under whose model a sequence is likeliest. Rows with a missing value say nothing.
 */
public final class SequenceClassifier extends RandomizableClassifier implements MultiInstanceCapabilitiesHandler {

    private static final long serialVersionUID = 1;
    private static final int BAG = 1;

    private int states = 3;
    private int rounds = 10;
    private double[] priors = new double[0];
    /** By class: one model, or none where the class has no complete row. */
    private List<List<HiddenMarkov>> models = List.of();

    /** What it is, for Weka's help. */
    public String globalInfo() {
        return "Classifies sequences (bags of rows in their order) by one hidden Markov model for each class.";
    }

    @Override
    public Capabilities getCapabilities() {
        Capabilities result = super.getCapabilities();
        result.disableAll();
        result.enable(Capability.NOMINAL_ATTRIBUTES);
        result.enable(Capability.RELATIONAL_ATTRIBUTES);
        result.enable(Capability.NOMINAL_CLASS);
        result.enable(Capability.MISSING_CLASS_VALUES);
        result.enable(Capability.ONLY_MULTIINSTANCE);
        return result;
    }

    @Override
    public Capabilities getMultiInstanceCapabilities() {
        Capabilities result = super.getCapabilities();
        result.disableAll();
        result.enable(Capability.NUMERIC_ATTRIBUTES);
        result.enable(Capability.MISSING_VALUES);
        result.disableAllClasses();
        result.enable(Capability.NO_CLASS);
        result.setMinimumNumberInstances(0);
        return result;
    }

    @Override
    public void buildClassifier(Instances data) throws Exception {
        getCapabilities().testWithFail(data);
        Instances whole = new Instances(data);
        whole.deleteWithMissingClass();
        int classes = whole.numClasses();
        priors = new double[classes];
        Arrays.fill(priors, 1);
        List<List<double[][]>> sequences = new ArrayList<>();
        for (int c = 0; c < classes; c++) {
            sequences.add(new ArrayList<>());
        }
        for (Instance instance : whole) {
            priors[(int) instance.classValue()]++;
            double[][] rows = sequence(instance);
            if (rows.length > 0) {
                sequences.get((int) instance.classValue()).add(rows);
            }
        }
        HiddenMarkov.normalise(priors);
        models = new ArrayList<>();
        for (int c = 0; c < classes; c++) {
            models.add(new ArrayList<>(fit(sequences.get(c)).stream().toList()));
        }
    }

    /** Empty where a class has no complete row. */
    private Optional<HiddenMarkov> fit(List<double[][]> sequences) {
        double[][] rows = Rows.thinned(sequences, 5000);
        if (rows.length == 0) {
            return Optional.empty();
        }
        Mixture mixture = new MessageLength(Math.min(states, rows.length), Math.min(states, rows.length), CovarianceShape.FULL, 1e-5, 1e-4)
                .fit(rows, new Well19937c(getSeed()), share -> {}).mixture();
        return Optional.of(new BaumWelch(rounds, 1e-3, 0.1, CovarianceShape.FULL, 1e-4)
                .fit(HiddenMarkov.of(mixture, sequences, 0.1), sequences, share -> {}).model());
    }

    private static double[][] sequence(Instance instance) {
        if (instance.isMissing(BAG)) {
            return new double[0][];
        }
        Instances bag = instance.relationalValue(BAG);
        double[][] rows = new double[bag.numInstances()][];
        for (int i = 0; i < rows.length; i++) {
            rows[i] = bag.instance(i).toDoubleArray();
        }
        return rows;
    }

    @Override
    public double[] distributionForInstance(Instance instance) {
        double[] logs = new double[priors.length];
        double[][] rows = sequence(instance);
        for (int c = 0; c < logs.length; c++) {
            logs[c] = Math.log(priors[c]);
            if (rows.length > 0) {
                logs[c] += models.get(c).stream().mapToDouble(model -> new Trellis(model, rows).logLikelihood()).findFirst()
                        .orElse(Double.NEGATIVE_INFINITY);
            }
        }
        if (LogSum.of(logs, logs.length) == Double.NEGATIVE_INFINITY) {
            return priors.clone();
        }
        LogSum.share(logs, logs.length);
        return logs;
    }

    /** States of each model, 1 or more. */
    public int getStates() {
        return states;
    }

    /** Sets the states; what is below 1 is 1. */
    @OptionMetadata(displayName = "states", description = "states of each model", commandLineParamName = "states",
            commandLineParamSynopsis = "-states <number>", displayOrder = 1)
    public void setStates(int number) {
        states = Math.max(1, number);
    }

    /** Rounds of Baum and Welch, 1 or more. */
    public int getRounds() {
        return rounds;
    }

    /** Sets the rounds; what is below 1 is 1. */
    @OptionMetadata(displayName = "rounds", description = "rounds of Baum-Welch", commandLineParamName = "rounds",
            commandLineParamSynopsis = "-rounds <number>", displayOrder = 2)
    public void setRounds(int number) {
        rounds = Math.max(1, number);
    }

    @Override
    public String getRevision() {
        return RevisionUtils.extract("$Revision: 1 $");
    }

    @Override
    public String toString() {
        return models.size() == 0 ? "SequenceClassifier: no classifier built yet"
                : models.size() + " hidden Markov models of up to " + states + " states, priors " + Arrays.toString(priors);
    }

    public static void main(String[] words) {
        runClassifier(new SequenceClassifier(), words);
    }
}
