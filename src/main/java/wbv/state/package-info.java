/**
 * Motion states: mixtures of inertial data, a hidden Markov model over them, names that people understand, and a forecast
 * (chapter 7 of J. L. Coyte's thesis, Wollongong 2020, corrected).
 *
 * <p>{@link wbv.state.mixture.MessageLength} and {@link wbv.state.mixture.DirichletProcess} find a {@link wbv.state.mixture.Mixture} and
 * how many components it has; {@link wbv.state.markov.BaumWelch} fits a {@link wbv.state.markov.HiddenMarkov} whose states begin as these
 * components; {@link wbv.state.markov.ForwardFilter} follows it through a stream and {@link wbv.state.markov.Forecast} looks ahead.
 * {@link wbv.state.FeatureStream} makes the data from channels, {@link wbv.state.PhysicalLabels} says by stated thresholds
 * what a sample is, and a state is named after what most of its samples are. {@link wbv.state.StateModelFile} keeps all of it.
 *
 * <p>Classes that end in {@code Clusterer} and {@link wbv.state.SequenceClassifier} are Weka's faces of the same.
 */
package wbv.state;
