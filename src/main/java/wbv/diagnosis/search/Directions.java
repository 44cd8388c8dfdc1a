package wbv.diagnosis.search;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import wbv.body.Assembly;
import wbv.body.LawAt;
import wbv.body.SensorFault;
import wbv.body.Spectra;
import wbv.body.Structure;
import wbv.body.law.Law;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.ModulatorSeries;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Knob;
import wbv.diagnosis.fit.Lateness;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Nuisances;
import wbv.diagnosis.fit.Slot;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * What hypotheses change in the whitened residual along what was measured: laws in links and hidden masses along the motion, faults of
 * sensors in what these read; and along the model's motion what is left.
 */
public final class Directions {

    private final Evidence evidence;
    private final Fitter.State state;
    private final Motion motion;
    private final ModulatorSeries modulators;
    private final Structure structure;
    private final Simulator simulator;
    private final Simulator.Linearised linear;
    private final Lateness late;
    /** What the model does; not all of it need be asked for. */
    private final Simulator.Response there;
    /** What outputs read, by output: every fault of a sensor asks. */
    private final Map<Integer, double[]> readings = new ConcurrentHashMap<>();

    /**
     * At a fit.
     *
     * @param modulators along the motion
     */
    Directions(Evidence evidence, Fitter.State state, Motion motion, ModulatorSeries modulators) {
        this.evidence = evidence;
        this.state = state;
        this.motion = motion;
        this.modulators = modulators;
        Assembly fitted = state.candidate().at(state.x());
        this.structure = fitted.structure();
        this.simulator = new Simulator(evidence.excitation());
        this.linear = simulator.linearised(fitted);
        this.there = simulator.run(fitted, false);
        Nuisances small = state.frame().nuisances();
        this.late = small.delays().lateness(evidence.excitation().omega(), small.off(state.candidate()), there.outputs().length);
    }

    /**
     * Whitened change of the residual, as long as that, that a hypothesis makes at given values: of laws that are not linear along the
     * motion as measured, of all else to the model as it is.
     *
     * @param values by number, in its unit. Not modified.
     */
    public double[] of(Hypothesis hypothesis, Candidate with, double[] values) {
        return isInLink(hypothesis) && hypothesis.runsFree() ? of(link(hypothesis), force(hypothesis, values))
                : seen(changed(changed(hypothesis, with, values)));
    }

    /** The same along what was measured, of whatever that tells. */
    double[] measured(Hypothesis hypothesis, Candidate with, double[] values) {
        if (isInLink(hypothesis)) {
            return of(link(hypothesis), force(hypothesis, values));
        }
        Assembly changed = changed(hypothesis, with, values);
        return hypothesis.additions().stream().allMatch(Addition.OfSensor.class::isInstance)
                ? seen(misread(hypothesis, changed).orElseGet(() -> changed(changed)))
                : hypothesis.additions().get(0) instanceof Addition.Hidden hidden && !hypothesis.runsFree()
                        ? ofHidden(hidden.body(), changed)
                        : seen(changed(changed));
    }

    private Assembly changed(Hypothesis hypothesis, Candidate with, double[] values) {
        return with.at(state.candidate().extended(state.x(), with, hypothesis, values));
    }

    /** By how much the outputs change. */
    private double[][] changed(Assembly changed) {
        double[][] out = simulator.run(changed, false, there.bends()).outputs();
        for (int o = 0; o < out.length; o++) {
            out[o] = out[o].clone();
            Spectra.add(out[o], there.outputs()[o], -1);
        }
        return out;
    }

    /** By how much faults, each the last of its sensor, change what is read; empty where that cannot be told from what was. */
    private Optional<double[][]> misread(Hypothesis hypothesis, Assembly with) {
        double[][] out = new double[there.outputs().length][2 * evidence.excitation().omega().length];
        for (Addition addition : hypothesis.additions()) {
            int output = ((Addition.OfSensor) addition).output();
            List<SensorFault> faults = with.outputs().get(output).faults();
            double[] read = readings.computeIfAbsent(output,
                    o -> evidence.spectra().reading(evidence.excitation(), o, there.outputs()[o]));
            Optional<double[]> undone = simulator.undone(faults.get(faults.size() - 1), read);
            if (undone.isEmpty()) {
                return Optional.empty();
            }
            Spectra.add(out[output], read, 1);
            Spectra.add(out[output], undone.get(), -1);
        }
        return Optional.of(out);
    }

    /** What the hidden mass that an assembly has last does along the motion of its body. */
    private double[] ofHidden(int body, Assembly with) {
        Structure own = with.structure();
        double mass = own.mass()[own.bodies() - 1];
        double stiffness = own.stiffness()[own.links() - 1];
        double damping = own.damping()[own.links() - 1];
        double[] omega = evidence.excitation().omega();
        double[] way = new double[2 * omega.length];
        for (int k = 0; k < omega.length; k++) {
            // -m (k + jωc) / (k - mω² + jωc), by which the body's acceleration is multiplied
            double off = stiffness - mass * omega[k] * omega[k];
            double jc = omega[k] * damping;
            double size = off * off + jc * jc;
            way[2 * k] = -mass * (stiffness * off + jc * jc) / size;
            way[2 * k + 1] = -mass * (jc * off - stiffness * jc) / size;
        }
        return onBody(body, Spectra.product(way, motion.accelerations()[body]));
    }

    /** A change of the outputs as a change of the residual. */
    private double[] seen(double[][] change) {
        return evidence.spectra().whitened(evidence.excitation(), late.of(change), -1, state.frame().whitening());
    }

    /**
     * The residual, with what sensors' errors explain, if the laws that the model has already made what they make along the motion as
     * measured. A new array.
     */
    double[] along() {
        double[] out = state.raw().clone();
        Assembly fitted = state.candidate().at(state.x());
        List<LawAt> own = nonlinear(fitted);
        if (!own.isEmpty()) {
            Motion simulated = Motion.simulated(evidence, fitted);
            own.forEach(at -> Spectra.add(out, of(at.link(), beyond(at, simulated)), 1));
        }
        return out;
    }

    /**
     * Whitened change of the residual, as long as that, that a force in a link makes.
     *
     * @param force at the free run's rate, by sample [N]. Not modified.
     */
    public double[] of(int link, double[] force) {
        return seen(linear.answer(link, force));
    }

    /**
     * The same of a force on a body, or a moment.
     *
     * @param force spectrum of one [N] or [N m]. Not modified.
     */
    double[] onBody(int body, double[] force) {
        return seen(linear.answerOn(body, force));
    }

    /** Whether a hypothesis is laws in a link. */
    static boolean isInLink(Hypothesis hypothesis) {
        return hypothesis.additions().stream().allMatch(addition -> addition instanceof Addition.OfLink);
    }

    /** The link that a hypothesis is laws in. */
    static int link(Hypothesis hypothesis) {
        return ((Addition.OfLink) hypothesis.additions().get(0)).link();
    }

    /**
     * The force of all laws of a hypothesis, at the free run's rate, by sample [N].
     *
     * @param hypothesis that is laws in a link
     * @param values by number, in its unit. Not modified.
     */
    double[] force(Hypothesis hypothesis, double[] values) {
        int link = link(hypothesis);
        return force(hypothesis, values, structure.stiffness()[link], structure.damping()[link]);
    }

    /**
     * The same in a link of which a number is so many times as large.
     *
     * @param of the number, of that link
     */
    double[] force(Hypothesis hypothesis, double[] values, Knob of, double times) {
        int link = link(hypothesis);
        boolean spring = of.slot().kind() == Slot.Kind.STIFFNESS;
        return force(hypothesis, values, (spring ? times : 1) * structure.stiffness()[link],
                (spring ? 1 : times) * structure.damping()[link]);
    }

    private double[] force(Hypothesis hypothesis, double[] values, double stiffness, double damping) {
        int link = link(hypothesis);
        double[] sum = new double[motion.displacement(link).length];
        for (Law law : hypothesis.laws(values)) {
            Spectra.add(sum, force(law, link, motion, stiffness, damping), 1);
        }
        return sum;
    }

    /** What a law of the model carries along this motion beyond what it does along another, likewise. */
    private double[] beyond(LawAt at, Motion other) {
        double stiffness = structure.stiffness()[at.link()];
        double damping = structure.damping()[at.link()];
        double[] out = force(at.law(), at.link(), motion, stiffness, damping);
        Spectra.add(out, force(at.law(), at.link(), other, stiffness, damping), -1);
        return out;
    }

    private double[] force(Law law, int link, Motion along, double stiffness, double damping) {
        return law.series(along.displacement(link), along.velocity(link), stiffness, damping, evidence.excitation().fineStep(),
                modulators.of(law.modulator()));
    }

    /** Those of an assembly that are not linear. */
    private static List<LawAt> nonlinear(Assembly assembly) {
        return assembly.laws().stream().filter(at -> !at.law().isLinear()).toList();
    }
}
