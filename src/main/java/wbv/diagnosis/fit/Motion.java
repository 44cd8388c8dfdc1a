package wbv.diagnosis.fit;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.LawAt;
import wbv.body.Spectra;
import wbv.body.number.Modulator;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.ModulatorSeries;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.measured.AboveNoise;
import wbv.signal.Taper;

/**
 * Relative motion of the links, as measured or as a model moves. As measured it comes from the accelerations of both ends over -ω² above
 * 1 Hz; below, where noise would drown it, and where an end is not measured, from the model. On a rig, of any frequency, it is the model's
 * but for what sensors show above their noise.
 *
 * <p>Good to rank laws, not to fit them: with the measured motion in it a link predicts its own channel, whatever its stiffness.
 */
public final class Motion implements ModulatorSeries.Links {

    private static final double CROSSOVER = 1;
    private static final double TOP = 18;
    private static final double BOTTOM = 0.15;
    /** Times that the slowest mode of a rig is above that: as often as a sitter's. Far below a mode a model knows best how little moves. */
    private static final double BELOW = 5;
    /** Part of a series at either end over which what shows beside a model comes and goes, an effort: a jump is slow motion, integrated. */
    private static final double EDGE = 1.0 / 16;

    private final Assembly assembly;
    private final double step;
    private final double[][] displacement;
    private final double[][] velocity;
    /** Of each body, as a spectrum [m/s²]. */
    private final Supplier<double[][]> accelerations;

    private Motion(Assembly assembly, double step, double[][] displacement, double[][] velocity, Supplier<double[][]> accelerations) {
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
        Excitation excitation = evidence.excitation();
        double[][] stretch = new Simulator(excitation).run(assembly, false).stretch();
        return new Motion(assembly, excitation.fineStep(), Arrays.stream(stretch).map(excitation::fineSeries).toArray(double[][]::new),
                Arrays.stream(stretch).map(r -> excitation.fineSeries(Spectra.timesJOmega(excitation.omega(), r)))
                        .toArray(double[][]::new),
                () -> new Simulator(excitation).accelerations(assembly));
    }

    /** Works out the motion of all links, which takes a run of the assembly where a link's end is not measured. */
    public Motion(Evidence evidence, Assembly assembly) {
        this.assembly = assembly;
        Excitation excitation = evidence.excitation();
        step = excitation.fineStep();
        double[] omega = excitation.omega();
        int links = assembly.structure().links();
        displacement = new double[links][];
        velocity = new double[links][];
        if (evidence.onRig()) {
            accelerations = onRig(evidence, assembly);
            return;
        }
        double[][] modelled = new Simulator(excitation).accelerations(assembly);
        double[][] blended = new double[assembly.structure().bodies()][];
        for (int b = 0; b < blended.length; b++) {
            int body = b;
            blended[b] = modelled[b].clone();
            measuring(assembly, body).ifPresent(output -> blend(blended[body], excitation.spectrum(evidence.measured(output)), omega));
        }
        accelerations = () -> blended;
        double[][] lifts = new Simulator(excitation).lifts(assembly);
        for (int l = 0; l < links; l++) {
            double[] relative = excitation.stretching(assembly.structure(), l, blended);
            for (int i = 0; i < lifts[l].length; i++) {
                relative[i] += omega[i / 2] * omega[i / 2] * lifts[l][i];   // less the acceleration with which its lower end is lifted
            }
            double[] r = new double[2 * omega.length];
            double[] v = new double[2 * omega.length];
            for (int k = 1; k < omega.length; k++) {
                if (omega[k] > 2 * Math.PI * BOTTOM) {
                    double w2 = omega[k] * omega[k];
                    r[2 * k] = -relative[2 * k] / w2;
                    r[2 * k + 1] = -relative[2 * k + 1] / w2;
                    v[2 * k] = -omega[k] * r[2 * k + 1];
                    v[2 * k + 1] = omega[k] * r[2 * k];
                }
            }
            displacement[l] = excitation.fineSeries(r);
            velocity[l] = excitation.fineSeries(v);
        }
    }

    /** The stroke as measured; else as the model moves, and beside it what shows above their noise that the bodies do otherwise. */
    private Supplier<double[][]> onRig(Evidence evidence, Assembly assembly) {
        Excitation excitation = evidence.excitation();
        double[] omega = excitation.omega();
        for (int l = 0; l < displacement.length && excitation.stroke().isPresent(); l++) {
            displacement[l] = Arrays.stream(excitation.stroke().get().position()).map(x -> -x).toArray();
            velocity[l] = Arrays.stream(excitation.stroke().get().velocity()).map(v -> -v).toArray();
        }
        if (excitation.stroke().isPresent()) {
            return () -> new Simulator(excitation).accelerations(assembly);
        }
        Simulator.Response run = new Simulator(excitation).run(assembly, false);
        double[][] apart = new double[assembly.structure().bodies()][2 * omega.length];
        for (int o = assembly.outputs().size() - 1; o >= 0; o--) {   // of two that read one body the first counts
            Assembly.Output output = assembly.outputs().get(o);
            if (output.reading() != Assembly.Reading.LINK_FORCE && output.reads().at().length == 1) {
                apart[output.reads().at()[0]] = apart(evidence, o, output, excitation.series(run.outputs()[o]),
                        assembly.structure().slowestMode().orElse(0) / BELOW);
            }
        }
        for (int l = 0; l < displacement.length; l++) {
            double[] r = run.stretch()[l].clone();
            Spectra.add(r, assembly.structure().stretch(l).of(apart, r.length), 1);
            displacement[l] = excitation.fineSeries(r);
            velocity[l] = excitation.fineSeries(Spectra.timesJOmega(omega, r));
        }
        return () -> {
            double[][] all = new Simulator(excitation).accelerations(assembly);
            for (int b = 0; b < all.length; b++) {
                Spectra.add(all[b], Spectra.timesJOmega(omega, Spectra.timesJOmega(omega, apart[b])), 1);
            }
            return all;
        };
    }

    /**
     * How far the body that an output reads is from where a model has it, a spectrum [m]: what it reads beside that and is no noise.
     *
     * @param model what the model makes of it, by sample, in the output's unit. Not modified.
     * @param lowest frequency below which what is integrated is the model's [Hz]
     */
    private static double[] apart(Evidence evidence, int o, Assembly.Output output, double[] model, double lowest) {
        Excitation excitation = evidence.excitation();
        int n = excitation.samples();
        boolean[] valid = evidence.valid(o);
        double[] measured = evidence.measured(o);
        double level = IntStream.range(0, n).filter(i -> valid[i]).mapToDouble(i -> measured[i] - model[i]).average().orElse(0);
        Taper ends = Taper.ends(n, EDGE);
        double[] beside = new double[n];
        Arrays.setAll(beside, i -> valid[i] ? (measured[i] - model[i] - level) * ends.weight(i) : 0);
        int times = output.reading() == Assembly.Reading.ACCELERATION ? 2 : output.reading() == Assembly.Reading.VELOCITY ? 1 : 0;
        double[] out = AboveNoise.integral(excitation, excitation.spectrum(beside), evidence.noise()[o], times);
        for (int i = 0; i < out.length; i++) {
            out[i] *= (times == 0 ? 1 : above(excitation.omega()[i / 2] / (2 * Math.PI), lowest)) / output.reads().by()[0];
        }
        return out;
    }

    /** The output that reads the acceleration of a body without a gross fault. */
    private static Optional<Integer> measuring(Assembly assembly, int body) {
        for (int o = 0; o < assembly.outputs().size(); o++) {
            Assembly.Output output = assembly.outputs().get(o);
            if (output.readsAcceleration(body)) {
                return Optional.of(o);
            }
        }
        return Optional.empty();
    }

    /** How much of what is measured at a frequency counts [1]. */
    private static double above(double f, double crossover) {
        return crossover == 0 ? 1 : 1 - 1 / (1 + Math.pow(f / crossover, 8));
    }

    private static void blend(double[] model, double[] measured, double[] omega) {
        for (int k = 0; k < omega.length; k++) {
            double f = omega[k] / (2 * Math.PI);
            double weight = above(f, CROSSOVER) / (1 + Math.pow(f / TOP, 12));
            for (int part = 2 * k; part < 2 * k + 2; part++) {
                model[part] += weight * (measured[part] - model[part]);
            }
        }
    }

    @Override
    public double[] displacement(int link) {
        return displacement[link];
    }

    @Override
    public double[] velocity(int link) {
        return velocity[link];
    }

    /** Acceleration of each body [m/s²], a spectrum each. Worked out anew. */
    public double[][] accelerations() {
        return accelerations.get();
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
     * Root mean square displacement of a link up to a sample [m].
     *
     * @param x by sample [m]. Not modified.
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
