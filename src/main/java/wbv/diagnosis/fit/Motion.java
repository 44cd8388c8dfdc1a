package wbv.diagnosis.fit;

import java.util.Arrays;
import java.util.Optional;
import wbv.body.Assembly;
import wbv.body.LawAt;
import wbv.body.Spectra;
import wbv.body.number.Modulator;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.ModulatorSeries;
import wbv.body.simulate.Simulator;

/**
 * Relative motion of the links, as measured or as a model moves. As measured it comes from the accelerations of both ends over -ω² above
 * 1 Hz; below, where noise would drown it, and where an end is not measured, from the model.
 *
 * <p>Good to rank laws, not to fit them: with the measured motion in it a link predicts its own channel, whatever its stiffness.
 */
public final class Motion implements ModulatorSeries.Links {

    private static final double CROSSOVER = 1;
    private static final double TOP = 18;
    private static final double BOTTOM = 0.15;

    private final Assembly assembly;
    private final double step;
    private final double[][] displacement;
    private final double[][] velocity;

    private Motion(Assembly assembly, double step, double[][] displacement, double[][] velocity) {
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
                        .toArray(double[][]::new));
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
            onRig(evidence, assembly);
            return;
        }
        double[][] modelled = new Simulator(excitation).accelerations(assembly);
        double[][] blended = new double[assembly.structure().bodies()][];
        for (int b = 0; b < blended.length; b++) {
            int body = b;
            blended[b] = modelled[b].clone();
            measuring(assembly, body).ifPresent(output -> blend(blended[body], excitation.spectrum(evidence.measured(output)), omega));
        }
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

    /** The stroke as measured, or positions where sensors read them over a base at rest, and the model elsewhere. */
    private void onRig(Evidence evidence, Assembly assembly) {
        Excitation excitation = evidence.excitation();
        for (int l = 0; l < displacement.length && excitation.stroke().isPresent(); l++) {
            displacement[l] = Arrays.stream(excitation.stroke().get().position()).map(x -> -x).toArray();
            velocity[l] = Arrays.stream(excitation.stroke().get().velocity()).map(v -> -v).toArray();
        }
        if (excitation.stroke().isPresent()) {
            return;
        }
        double[] omega = excitation.omega();
        if (evidence.model().base().sensor().isPresent()) {
            double[][] stretch = new Simulator(excitation).run(assembly, false).stretch();
            for (int l = 0; l < displacement.length; l++) {
                displacement[l] = excitation.fineSeries(stretch[l]);
                velocity[l] = excitation.fineSeries(Spectra.timesJOmega(omega, stretch[l]));
            }
            return;
        }
        double[][] moved = new Simulator(excitation).accelerations(assembly);
        for (double[] body : moved) {
            for (int i = 0; i < body.length; i++) {
                body[i] /= -omega[i / 2] * omega[i / 2];
            }
        }
        for (int o = 0; o < assembly.outputs().size(); o++) {
            if (assembly.outputs().get(o).reading() == Assembly.Reading.POSITION && assembly.outputs().get(o).reads().at().length == 1) {
                moved[assembly.outputs().get(o).place()] = excitation.spectrum(Arrays.copyOf(evidence.measured(o), excitation.samples()));
            }
        }
        for (int l = 0; l < displacement.length; l++) {
            double[] r = assembly.structure().stretch(l).of(moved, 2 * omega.length);
            displacement[l] = excitation.fineSeries(r);
            velocity[l] = excitation.fineSeries(Spectra.timesJOmega(omega, r));
        }
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

    private static void blend(double[] model, double[] measured, double[] omega) {
        for (int k = 0; k < omega.length; k++) {
            double f = omega[k] / (2 * Math.PI);
            double u = Math.pow(f / CROSSOVER, 8);
            double weight = u / (1 + u) / (1 + Math.pow(f / TOP, 12));
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
