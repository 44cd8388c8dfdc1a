package wbv.diagnosis.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import wbv.body.Assembly;
import wbv.body.LawAt;
import wbv.body.Spectra;
import wbv.body.Structure;
import wbv.body.number.Modulator;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.ModulatorSeries;
import wbv.body.simulate.Simulator;
import wbv.body.simulate.Stroke;
import wbv.diagnosis.measured.AboveNoise;
import wbv.signal.Taper;

/**
 * Relative motion of the links, as measured or as a model moves. As measured it is the model's but for what sensors show above their noise
 * that the bodies do otherwise.
 *
 * <p>Good to rank laws, not to fit them: with the measured motion in it a link predicts its own channel, whatever its stiffness.
 */
public final class Motion implements ModulatorSeries.Links {

    /** Times that the slowest mode is above what is integrated, an effort. Far below a mode a model knows best how little moves. */
    private static final double BELOW = 5;
    /** Part of a series at either end over which what shows beside a model comes and goes, an effort: a jump is slow motion, integrated. */
    private static final double EDGE = 1.0 / 16;

    private final Assembly assembly;
    private final double step;
    private final double[][] displacement;
    private final double[][] velocity;
    /** Of each body, as a spectrum [m/s²]; none of what is driven, which has no masses. */
    private final double[][] accelerations;

    private Motion(Assembly assembly, double step, double[][] displacement, double[][] velocity, double[][] accelerations) {
        this.accelerations = accelerations;
        this.assembly = assembly;
        this.step = step;
        this.displacement = displacement;
        this.velocity = velocity;
    }

    /**
     * The motion of all links as a model moves: nearer to the truth than what two accelerometers say, twice integrated, where it explains
     * nearly all of them.
     */
    public static Motion simulated(Evidence evidence, Assembly assembly) {
        Simulator.Response run = run(evidence, assembly);
        return of(evidence, assembly, run.stretch(), assembly.structure().held() ? new double[0][] : accelerations(assembly, run));
    }

    /** A run whose last outputs are the accelerations of all bodies. */
    private static Simulator.Response run(Evidence evidence, Assembly assembly) {
        List<Assembly.Output> all = new ArrayList<>(assembly.outputs());
        for (int b = 0; b < assembly.structure().bodies() && !assembly.structure().held(); b++) {
            all.add(new Assembly.Output(b, Assembly.Reading.ACCELERATION, List.of()));
        }
        return new Simulator(evidence.excitation()).run(new Assembly(assembly.structure(), assembly.laws(), assembly.drives(), all), false);
    }

    private static double[][] accelerations(Assembly assembly, Simulator.Response run) {
        int own = assembly.outputs().size();
        return Arrays.copyOfRange(run.outputs(), own, own + assembly.structure().bodies());
    }

    /** The motion of all links as measured, which takes a run of the assembly but where links are driven: their stroke was measured. */
    public static Motion measured(Evidence evidence, Assembly assembly) {
        return evidence.excitation().stroke().map(stroke -> driven(evidence, assembly, stroke)).orElseGet(() -> beside(evidence, assembly));
    }

    private static Motion driven(Evidence evidence, Assembly assembly, Stroke stroke) {
        double[] displacement = Arrays.stream(stroke.position()).map(x -> -x).toArray();
        double[] velocity = Arrays.stream(stroke.velocity()).map(v -> -v).toArray();
        int links = assembly.structure().links();
        return new Motion(assembly, evidence.excitation().fineStep(), Collections.nCopies(links, displacement).toArray(double[][]::new),
                Collections.nCopies(links, velocity).toArray(double[][]::new), new double[0][]);
    }

    /** As the model moves, and beside it what shows above their noise that the bodies do otherwise. */
    private static Motion beside(Evidence evidence, Assembly assembly) {
        Excitation excitation = evidence.excitation();
        double[] omega = excitation.omega();
        Structure structure = assembly.structure();
        Simulator.Response run = run(evidence, assembly);
        double[][] apart = new double[structure.bodies()][2 * omega.length];
        for (int o = assembly.outputs().size() - 1; o >= 0; o--) {   // of two that read one body the first counts
            Assembly.Output output = assembly.outputs().get(o);
            if (output.reading() != Assembly.Reading.LINK_FORCE && output.reads().at().length == 1) {
                apart[output.reads().at()[0]] = apart(evidence, o, output, run.outputs()[o],
                        structure.slowestMode().orElse(0) / BELOW);
            }
        }
        double[][] stretch = Arrays.stream(run.stretch()).map(double[]::clone).toArray(double[][]::new);
        for (int l = 0; l < stretch.length; l++) {
            Spectra.add(stretch[l], structure.stretch(l).of(apart, stretch[l].length), 1);
        }
        double[][] all = Arrays.stream(accelerations(assembly, run)).map(double[]::clone).toArray(double[][]::new);
        for (int b = 0; b < all.length; b++) {
            Spectra.add(all[b], Spectra.timesJOmega(omega, Spectra.timesJOmega(omega, apart[b])), 1);
        }
        return of(evidence, assembly, stretch, all);
    }

    /** @param stretch of each link, a spectrum [m]. Not modified. */
    private static Motion of(Evidence evidence, Assembly assembly, double[][] stretch, double[][] accelerations) {
        Excitation excitation = evidence.excitation();
        return new Motion(assembly, excitation.fineStep(), Arrays.stream(stretch).map(excitation::fineSeries).toArray(double[][]::new),
                Arrays.stream(stretch).map(r -> excitation.fineSeries(Spectra.timesJOmega(excitation.omega(), r)))
                        .toArray(double[][]::new),
                accelerations);
    }

    /**
     * How far the body that an output reads is from where a model has it, a spectrum [m]: what it reads beside that and is no noise.
     *
     * @param model what the model makes of it, a spectrum in the output's unit. Not modified.
     * @param lowest frequency below which what is integrated is the model's [Hz]
     */
    private static double[] apart(Evidence evidence, int o, Assembly.Output output, double[] model, double lowest) {
        Excitation excitation = evidence.excitation();
        double[] beside = evidence.spectra().beside(excitation, o, model);
        Taper ends = Taper.ends(beside.length, EDGE);
        Arrays.setAll(beside, i -> beside[i] * ends.weight(i));
        int times = output.reading() == Assembly.Reading.ACCELERATION ? 2 : output.reading() == Assembly.Reading.VELOCITY ? 1 : 0;
        double[] out = AboveNoise.integral(excitation, excitation.spectrum(beside), evidence.noise()[o], times);
        for (int i = 0; i < out.length; i++) {
            out[i] *= (times == 0 ? 1 : above(excitation.omega()[i / 2] / (2 * Math.PI), lowest)) / output.reads().by()[0];
        }
        return out;
    }

    /** How much of what is measured at a frequency counts [1]. */
    private static double above(double f, double crossover) {
        return crossover == 0 ? 1 : 1 - 1 / (1 + Math.pow(f / crossover, 8));
    }

    @Override
    public double[] displacement(int link) {
        return displacement[link];
    }

    @Override
    public double[] velocity(int link) {
        return velocity[link];
    }

    /** Acceleration of each body [m/s²], a spectrum each; none of what is driven. Not a copy. */
    public double[][] accelerations() {
        return accelerations;
    }

    /** What the model's spring, dashpot and laws carry along the measured motion. Laws in it that something modulates are left out. */
    @Override
    public double[] load(int link) {
        double stiffness = assembly.structure().stiffness()[link];
        double damping = assembly.structure().damping()[link];
        double[] out = new double[displacement[link].length];
        Arrays.setAll(out, i -> stiffness * displacement[link][i] + damping * velocity[link][i]);
        for (LawAt at : assembly.laws()) {
            if (at.link() == link && at.law().modulator() instanceof Modulator.None) {
                Spectra.add(out, at.law().series(displacement[link], velocity[link], stiffness, damping, step, new double[0]), 1);
            }
        }
        return out;
    }

    /**
     * Root mean square of the values up to a sample, in their unit.
     *
     * @param x series of any unit. Not modified.
     */
    public static double rms(double[] x, int to) {
        return Math.sqrt(Arrays.stream(x, 0, to).map(v -> v * v).average().orElse(0));
    }

    /**
     * The values up to a sample, as many, in their unit, least first. A new array.
     *
     * @param x series of any unit. Not modified.
     */
    public static double[] sorted(double[] x, int to) {
        double[] sorted = Arrays.copyOf(x, to);
        Arrays.sort(sorted);
        return sorted;
    }

    /**
     * A quantile, in the unit of the values.
     *
     * @param sorted as many values as there are, of any unit, least first. Not modified.
     */
    public static double quantile(double[] sorted, double share) {
        int last = sorted.length - 1;
        return sorted[(int) Math.min(last, Math.round(share * last))];
    }
}
