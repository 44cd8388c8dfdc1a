package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import wbv.body.Assembly;
import wbv.body.LawAt;
import wbv.body.Spectra;
import wbv.body.simulate.ModulatorSeries;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Lateness;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Nuisances;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.fit.Whitening;
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

    private final Evidence evidence;
    private final Fitter.State state;
    private final Whitening whitening;
    private final LinkLaws laws;
    private final Simulator simulator;
    private final Simulator.Linearised linear;
    private final double[][] outputs;
    private final Optional<Simulator.Bends> bends;
    private final Lateness late;
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
        this.evidence = evidence;
        this.state = state;
        this.whitening = state.frame().whitening();
        this.laws = new LinkLaws(evidence, state.candidate().at(state.x()).structure(), motion, modulators);
        this.simulator = new Simulator(evidence.excitation());
        this.linear = simulator.linearised(state.candidate().at(state.x()));
        Simulator.Response there = simulator.run(state.candidate().at(state.x()), false);
        this.outputs = there.outputs();
        this.bends = there.bends();
        Nuisances small = state.frame().nuisances();
        this.late = small.delays().lateness(evidence.excitation().omega(), small.off(state.candidate()), outputs.length);
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
        List<double[]> directions = new ArrayList<>();
        if (amplitude) {
            for (int c = 0; c < start.columns().size(); c++) {
                double[] only = new double[start.columns().size()];
                only[c] = 1;
                directions.add(direction(hypothesis, with, sized(hypothesis, start, only)));
            }
        } else {
            directions.add(direction(hypothesis, with, start.values()));
        }
        List<PartialledOut.Rest> rests = left.of(directions);
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
        if (impossible) {
            return new Score(hypothesis, with, 0, state.candidate().extended(state.x(), with, hypothesis, start.values()));
        }
        return new Score(hypothesis, with, gain, state.candidate().extended(state.x(), with, hypothesis, values));
    }

    /**
     * A start with its amplitudes so many times what they are looked at with.
     *
     * @param strength by column [1]; of a start without columns nothing changes. Not modified.
     */
    static double[] sized(Hypothesis hypothesis, Start start, double[] strength) {
        double[] values = start.values().clone();
        for (int c = 0; c < start.columns().size(); c++) {
            for (int i : start.columns().get(c)) {
                values[i] = hypothesis.numbers().get(i).nothing() + strength[c] * start.sizes()[i];
            }
        }
        return values;
    }

    /**
     * Whitened change of the residual, as long as that, that a hypothesis makes at given values.
     *
     * @param values by number, in its unit. Not modified.
     */
    public double[] direction(Hypothesis hypothesis, Candidate with, double[] values) {
        if (LinkLaws.isInLink(hypothesis)) {
            return direction(LinkLaws.link(hypothesis), laws.force(hypothesis, values));
        }
        double[] x = state.candidate().extended(state.x(), with, hypothesis, values);
        double[][] changed = simulator.run(with.at(x), false, bends).outputs();
        double[][] difference = new double[changed.length][];
        for (int o = 0; o < changed.length; o++) {
            difference[o] = changed[o].clone();
            for (int i = 0; i < difference[o].length; i++) {
                difference[o][i] -= outputs[o][i];
            }
        }
        return seen(difference);
    }

    /** A change of the outputs as a change of the residual. */
    private double[] seen(double[][] change) {
        return evidence.spectra().whitened(evidence.excitation(), late.of(change), -1, whitening);
    }

    /**
     * The residual, with what sensors' errors explain, if the laws that the model has already made what they make along the motion as
     * measured. A new array.
     */
    double[] along() {
        double[] out = state.raw().clone();
        Assembly fitted = state.candidate().at(state.x());
        List<LawAt> own = LinkLaws.of(fitted);
        if (!own.isEmpty()) {
            Motion simulated = Motion.simulated(evidence, fitted);
            own.forEach(at -> Spectra.add(out, direction(at.link(), laws.beyond(at, simulated)), 1));
        }
        return out;
    }

    /** Laws along the motion as measured. */
    LinkLaws laws() {
        return laws;
    }

    /**
     * Whitened change of the residual, as long as that, that a force in a link makes.
     *
     * @param force at the free run's rate, by sample [N]. Not modified.
     */
    public double[] direction(int link, double[] force) {
        return seen(linear.answer(link, force));
    }

    /**
     * The same of a force on a body, or a moment.
     *
     * @param force spectrum of one [N] or [N m]. Not modified.
     */
    double[] directionOn(int body, double[] force) {
        return seen(linear.answerOn(body, force));
    }

    /** What may follow is partialled out of directions by this. */
    public PartialledOut left() {
        return left;
    }
}
