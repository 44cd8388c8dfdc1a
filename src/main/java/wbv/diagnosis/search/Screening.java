package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import wbv.body.simulate.ModulatorSeries;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Start;

/**
 * The score test (Lagrange multiplier): how much of the residual each hypothesis would explain to first order, once everything
 * that the model can already move has taken its part.
 *
 * <p>With J the whitened derivative of the residual to the model's knobs, d that to a hypothesis' strength and P the projection off
 * J (priors counted): gain = (dᵀ P r)² / (dᵀ P d), which is χ² with one degree of freedom where the hypothesis is wrong.
 */
public final class Screening {

    private final Fitter.State state;
    private final Directions directions;
    private final PartialledOut left;

    /**
     * What a hypothesis promises.
     *
     * @param gain reduction of χ² to first order [1]
     * @param x coordinates [1], one a knob, from which to refit
     */
    public record Score(Hypothesis hypothesis, Candidate candidate, double gain, double[] x) {

        /** Whether a fit on top of a base is one of this hypothesis, and has not got to what that promises yet. */
        boolean promisesMore(Fitter.State base, Fitter.State fit) {
            return fit.candidate().last().equals(hypothesis) && base.square() - fit.square() < gain;
        }
    }

    /**
     * Those that promise nearly as much as the first does.
     *
     * @param scores greatest first
     */
    static List<Score> alike(List<Score> scores) {
        return scores.stream().takeWhile(score -> score.gain() >= Priors.NEARLY_ALL * scores.get(0).gain()).toList();
    }

    /**
     * Screens at a fit, modulators worked out where they are needed.
     *
     * @param state a fit with slopes
     */
    public Screening(Evidence evidence, Fitter.State state, Motion motion) {
        this(evidence, state, motion, new ModulatorSeries(evidence.excitation(), motion));
    }

    /**
     * The same with modulators that others share.
     *
     * @param modulators along the motion
     */
    public Screening(Evidence evidence, Fitter.State state, Motion motion, ModulatorSeries modulators) {
        this.state = state;
        this.directions = new Directions(evidence, state, motion, modulators);
        this.left = new PartialledOut(state);
    }

    /** The scores of all hypotheses, greatest first. */
    public List<Score> scores(List<Hypothesis> hypotheses) {
        List<Score> scores = new ArrayList<>(Parallel.map(hypotheses, this::score));
        scores.sort(Comparator.comparingDouble(Score::gain).reversed());
        return scores;
    }

    private Score score(Hypothesis hypothesis) {
        Candidate with = state.candidate().with(hypothesis);
        Score best = new Score(hypothesis, with, 0,
                state.candidate().extended(state.x(), with, hypothesis, hypothesis.starts().get(0).values()));
        for (Start start : hypothesis.starts()) {
            Score score = score(hypothesis, with, start);
            best = score.gain() > best.gain() ? score : best;
        }
        return best;
    }

    private Score score(Hypothesis hypothesis, Candidate with, Start start) {
        boolean amplitude = !start.columns().isEmpty();
        List<PartialledOut.Rest> rests = left.of(IntStream.range(0, Math.max(1, start.columns().size()))
                .mapToObj(c -> directions.of(hypothesis, with, alone(hypothesis, start, c))).toList());
        Optional<Combination> combination = rests.stream().anyMatch(PartialledOut.Rest::isOld) ? Optional.empty()
                : Optional.of(Combination.of(rests));
        double gain = combination.map(Combination::gain).orElse(0.0);
        double[] strength = combination.map(Combination::strengths).orElseGet(() -> new double[rests.size()]);
        double[] values = sized(hypothesis, start, strength);
        boolean impossible = !amplitude && strength[0] < 0;
        for (int c = 0; c < start.columns().size(); c++) {
            for (int i : start.columns().get(c)) {
                Hypothesis.Number number = hypothesis.numbers().get(i);
                impossible |= strength[c] < 0 && (number.unit() == 0 || number.low() >= number.nothing());
            }
        }
        return new Score(hypothesis, with, impossible ? 0 : gain,
                state.candidate().extended(state.x(), with, hypothesis, impossible ? start.values() : values));
    }

    /**
     * A start with its amplitudes so many times what they are looked at with: numbers of the hypothesis, an array with one of each, in its
     * unit.
     *
     * @param strength by column [1]; of a start without columns nothing changes. Not modified.
     */
    public static double[] sized(Hypothesis hypothesis, Start start, double[] strength) {
        double[] values = start.values().clone();
        for (int c = 0; c < start.columns().size(); c++) {
            for (int i : start.columns().get(c)) {
                values[i] = hypothesis.numbers().get(i).nothing() + strength[c] * start.sizes()[i];
            }
        }
        return values;
    }

    /** The same with one amplitude alone, as it is looked at with: an array with one of each number, in its unit. */
    public static double[] alone(Hypothesis hypothesis, Start start, int column) {
        double[] strength = new double[Math.max(1, start.columns().size())];
        strength[column] = 1;
        return sized(hypothesis, start, strength);
    }

    /** What hypotheses change along what was measured. */
    public Directions directions() {
        return directions;
    }

    /** What may follow is partialled out of directions by this. */
    public PartialledOut left() {
        return left;
    }
}
