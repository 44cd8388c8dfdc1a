package wbv.state.markov;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleConsumer;
import wbv.state.mixture.CovarianceShape;
import wbv.state.mixture.Gaussian;
import wbv.state.mixture.Mixture;
import wbv.state.mixture.Spread;

/**
 * Fits a hidden Markov model to sequences by expectation and maximisation (L. E. Baum and others 1970; Rabiner 1989, section
 * III.C), with a Dirichlet prior on the rows of the transitions and on the initial probabilities: the likelihood plus the log
 * prior never falls.
 *
 * @param rounds    at most, &gt;= 1
 * @param tolerance change of ln p [nat] that ends it
 * @param pseudo    counts [1] that the prior adds to every transition and first state, &gt;= 0; 0 is maximum likelihood
 * @param shape     of the covariances
 * @param floor share of the variance of the data below which none falls; a lift by it may cost likelihood
 */
public record BaumWelch(int rounds, double tolerance, double pseudo, CovarianceShape shape, double floor) {

    /** Expected rows below which a component keeps what it was. */
    private static final double FEWEST = 1e-6;

    public BaumWelch {
        if (!(rounds >= 1 && tolerance >= 0 && pseudo >= 0 && floor > 0)) {
            throw new IllegalArgumentException("rounds must be >= 1, tolerance and pseudo >= 0, floor > 0: " + rounds + ", "
                    + tolerance + ", " + pseudo + ", " + floor);
        }
    }

    /**
     * What was reached.
     *
     * @param history ln p of the sequences plus the log prior before each round, and at the end
     */
    public record Result(HiddenMarkov model, List<Double> history) {
        public Result {
            history = List.copyOf(history);
        }
    }

    /**
     * Fits.
     * Thesis: Eq. 7-5.
     *
     * @param start     where to begin
     * @param sequences each T by d, T &gt;= 1; rows with NaN say nothing. Not modified.
     * @param progress  hears the share of rounds done
     * @throws IllegalArgumentException if there is no complete row
     */
    public Result fit(HiddenMarkov start, List<double[][]> sequences, DoubleConsumer progress) {
        double[][] rows = Rows.thinned(sequences, Integer.MAX_VALUE);
        if (rows.length == 0) {
            throw new IllegalArgumentException("a hidden Markov model needs at least one complete row");
        }
        double[] least = Spread.floor(rows, floor);
        HiddenMarkov model = start;
        List<Double> history = new ArrayList<>();
        for (int round = 0; round < rounds; round++) {
            Expected expected = new Expected(model);
            for (double[][] sequence : sequences) {
                expected.add(sequence);
            }
            history.add(expected.logLikelihood + logPrior(model));
            HiddenMarkov next = expected.maximise(least);
            progress.accept((round + 1.0) / rounds);
            int last = history.size() - 1;
            if (last > 0 && Math.abs(history.get(last) - history.get(last - 1)) <= tolerance) {
                return new Result(model, history);
            }
            model = next;
        }
        history.add(logLikelihood(model, sequences) + logPrior(model));
        return new Result(model, history);
    }

    /** ln p of sequences under a model [nat]. */
    public static double logLikelihood(HiddenMarkov model, List<double[][]> sequences) {
        return sequences.stream().mapToDouble(sequence -> new Trellis(model, sequence).logLikelihood()).sum();
    }

    private double logPrior(HiddenMarkov model) {
        double sum = 0;
        if (pseudo > 0) {
            for (int i = 0; i < model.states(); i++) {
                sum += pseudo * Math.log(model.initial()[i]);
                for (double a : model.transition()[i]) {
                    sum += pseudo * Math.log(a);
                }
            }
        }
        return sum;
    }

    /** Expected counts and moments under a model. */
    private final class Expected {
        private final HiddenMarkov model;
        private final double[] first;
        private final double[][] transitions;
        private final List<List<Spread>> spreads = new ArrayList<>();
        private double logLikelihood;

        Expected(HiddenMarkov model) {
            this.model = model;
            first = new double[model.states()];
            transitions = new double[model.states()][model.states()];
            for (Mixture emission : model.emissions()) {
                spreads.add(emission.components().stream().map(each -> new Spread(shape, each.mean())).toList());
            }
        }

        void add(double[][] rows) {
            Trellis trellis = new Trellis(model, rows);
            logLikelihood += trellis.logLikelihood();
            trellis.addTransitions(transitions);
            double[][] posterior = trellis.posterior();
            double[] logs = new double[model.mostComponents()];
            double[] scratch = new double[model.dimensions()];
            for (int j = 0; j < first.length; j++) {
                first[j] += posterior[0][j];
                Mixture emission = model.emissions().get(j);
                List<Spread> own = spreads.get(j);
                for (int t = 0; t < rows.length; t++) {
                    double weight = posterior[t][j];
                    if (weight < 1e-15 || !trellis.told(t)) {
                        continue;
                    }
                    if (own.size() == 1) {
                        own.get(0).add(weight, rows[t]);
                        continue;
                    }
                    double whole = emission.logDensity(rows[t], logs, scratch);
                    for (int m = 0; m < own.size(); m++) {
                        own.get(m).add(weight * Math.exp(logs[m] - whole), rows[t]);
                    }
                }
            }
        }

        HiddenMarkov maximise(double[] least) {
            double[][] transition = new double[first.length][];
            for (int i = 0; i < first.length; i++) {
                transition[i] = shares(transitions[i], model.transition()[i]);
            }
            List<Mixture> emissions = new ArrayList<>();
            for (int j = 0; j < first.length; j++) {
                emissions.add(emission(model.emissions().get(j), spreads.get(j), least));
            }
            return new HiddenMarkov(shares(first, model.initial()), transition, emissions);
        }

        /** Counts with the prior's; a state that was never left keeps its row. */
        private double[] shares(double[] counts, double[] before) {
            double[] shares = Arrays.stream(counts).map(count -> count + pseudo).toArray();
            if (!(Arrays.stream(shares).sum() > FEWEST)) {
                return before;
            }
            HiddenMarkov.normalise(shares);
            return shares;
        }

        private Mixture emission(Mixture before, List<Spread> own, double[] least) {
            double whole = own.stream().mapToDouble(Spread::weight).sum();
            if (!(whole > FEWEST)) {
                return before;
            }
            double[] weights = own.stream().mapToDouble(spread -> spread.weight() / whole).toArray();
            List<Gaussian> components = new ArrayList<>();
            for (int m = 0; m < weights.length; m++) {
                Spread spread = own.get(m);
                components.add(spread.weight() > FEWEST ? Gaussian.of(shape, spread.mean(), spread.covariance(), least)
                        : before.components().get(m));
            }
            return new Mixture(weights, components);
        }
    }
}
