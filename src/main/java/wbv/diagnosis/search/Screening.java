package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import wbv.body.Structure;
import wbv.body.law.Law;
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
import wbv.diagnosis.mechanism.Addition;
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
    private final Motion motion;
    private final Simulator simulator;
    private final Simulator.Linearised linear;
    private final double[][] outputs;
    private final Optional<Simulator.Bends> bends;
    private final Lateness late;
    private final ModulatorSeries modulators;
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
        this.modulators = modulators;
        this.evidence = evidence;
        this.state = state;
        this.whitening = state.frame().whitening();
        this.motion = motion;
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
        if (isInLink(hypothesis)) {
            int link = ((Addition.OfLink) hypothesis.additions().get(0)).link();
            return seen(linear.answer(link, force(hypothesis, link, values)));
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

    /** Whether a hypothesis is laws in a link that are not linear. */
    static boolean isInLink(Hypothesis hypothesis) {
        return hypothesis.runsFree() && hypothesis.additions().stream().allMatch(addition -> addition instanceof Addition.OfLink);
    }

    /**
     * What the laws of a hypothesis carry over what the model carries in their link, root mean squares along the motion [1].
     *
     * @param hypothesis that is laws in a link
     * @param values by number, in its unit. Not modified.
     */
    double share(Hypothesis hypothesis, double[] values) {
        int link = ((Addition.OfLink) hypothesis.additions().get(0)).link();
        double[] own = motion.load(link);
        return Motion.rms(force(hypothesis, link, values), own.length) / Motion.rms(own, own.length);
    }

    /** What all laws of a hypothesis, which are in one link, make of its motion as measured. */
    private double[] force(Hypothesis hypothesis, int link, double[] values) {
        Structure structure = state.candidate().at(state.x()).structure();
        double[] sum = new double[motion.displacement(link).length];
        for (Law law : hypothesis.laws(values)) {
            double[] own = law.series(motion.displacement(link), motion.velocity(link), structure.stiffness()[link],
                    structure.damping()[link], evidence.excitation().fineStep(), modulators.of(law.modulator()));
            Arrays.setAll(sum, i -> sum[i] + own[i]);
        }
        return sum;
    }

    /** A change of the outputs as a change of the residual. */
    private double[] seen(double[][] change) {
        return evidence.spectra().whitened(evidence.excitation(), late.of(change), -1, whitening);
    }

    /**
     * Whitened change of the residual, as long as that, that a force in a link makes.
     *
     * @param force at the free run's rate, by sample [N]. Not modified.
     */
    public double[] direction(int link, double[] force) {
        return seen(linear.answer(link, force));
    }

    /** What may follow is partialled out of directions by this. */
    public PartialledOut left() {
        return left;
    }
}
