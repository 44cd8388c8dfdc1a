package wbv.body.simulate;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Drive;
import wbv.body.LawAt;
import wbv.body.SensorFault;
import wbv.body.Spectra;
import wbv.body.Structure;
import wbv.body.law.LinkMotion;
import wbv.recording.DataFault;

/**
 * Links whose ends both move as measured: the base by a {@link Stroke}, the other end held. Nothing swings, so the force in a
 * link is k r + c v and its laws along the measured motion, sample by sample, with exact derivatives to every parameter.
 *
 * <p>A law with memory starts where the force measured at the first sample puts it, and again after every gap, since nobody
 * knows what was done to the link before.
 */
final class DrivenLinks implements ModulatorSeries.Links {

    private final Excitation excitation;
    private final Assembly assembly;
    private final Structure structure;
    private final Stroke stroke;
    private final int count;
    private final int samples;
    private final double[] displacement;
    private final double[] velocity;
    private final double[][] total;
    private final double[][] lawForce;
    /** Derivative of the force in each link [link][parameter]; empty where there is none. */
    private final double[][][] slope;

    DrivenLinks(Excitation excitation, Assembly assembly, boolean sensitivities) {
        this.excitation = excitation;
        this.assembly = assembly;
        this.structure = assembly.structure();
        this.stroke = excitation.stroke()
                .orElseThrow(() -> new DataFault("driven links need the measured position or velocity of the base"));
        this.count = sensitivities ? assembly.values().length : 0;
        this.samples = stroke.position().length;
        // The base is the lower end: it moves up, and the link shortens.
        displacement = Arrays.stream(stroke.position()).map(x -> -x).toArray();
        velocity = Arrays.stream(stroke.velocity()).map(v -> -v).toArray();
        int links = structure.links();
        total = new double[links][samples];
        lawForce = new double[assembly.laws().size()][samples];
        slope = new double[links][count][0];
        for (int l = 0; l < links; l++) {
            linear(l);
        }
        drives();
        boolean[] started = new boolean[links];
        for (int i = 0; i < lawForce.length; i++) {
            int link = assembly.laws().get(i).link();
            boolean first = !started[link] && assembly.laws().get(i).law().hasMemory();
            law(i, first);
            started[link] |= first;
        }
    }

    /**
     * What the first law with memory carries where it starts.
     *
     * @param force [N]
     * @param slope of it to each parameter
     */
    private record Carried(double force, double[] slope) {}

    private void linear(int l) {
        for (int j = 0; j < samples; j++) {
            total[l][j] = structure.stiffness()[l] * displacement[j] + structure.damping()[l] * velocity[j];
        }
        if (count > 0) {
            slope[l][l] = displacement.clone();
            slope[l][structure.links() + l] = velocity.clone();
        }
    }

    private void drives() {
        for (int d = 0; d < assembly.drives().size(); d++) {
            Assembly.DriveAt at = assembly.drives().get(d);
            if (!(at.drive() instanceof Drive.Given given)) {
                throw new DataFault("a driven link takes no " + at.drive().mechanism());
            }
            double[] whole = excitation.series(excitation.other(given.channel()));
            for (int j = 0; j < samples; j++) {
                total[at.place()][j] += given.share() * whole[j];
            }
            if (count > 0) {
                slope[at.place()][assembly.driveIndex(d)] = whole;
            }
        }
    }

    /** The force measured at a start less all that has no memory. */
    private Carried carried(int link, Stroke.Start start) {
        double measured = start.in(link);
        double[] change = new double[count];
        if (Double.isNaN(measured)) {
            return new Carried(0, change);
        }
        double force = measured - total[link][start.sample()];
        for (int p = 0; p < count; p++) {
            change[p] = slope[link][p].length == 0 ? 0 : -slope[link][p][start.sample()];
        }
        for (int o = 0; o < assembly.outputs().size(); o++) {
            Assembly.Output output = assembly.outputs().get(o);
            for (int f = 0; f < output.faults().size() && output.place() == link; f++) {
                if (output.faults().get(f) instanceof SensorFault.Bias bias) {
                    force -= bias.bias();
                    if (count > 0) {
                        change[assembly.faultIndex(o, f)] = -1;
                    }
                }
            }
        }
        return new Carried(force, change);
    }

    /** @param starting whether it starts from what was measured; otherwise it starts with nothing */
    private void law(int i, boolean starting) {
        LawAt at = assembly.laws().get(i);
        int link = at.link();
        if (at.law().lateness() > 0) {
            throw new DataFault("a driven link takes no " + at.law().mechanism());
        }
        LawSlopes slopes = new LawSlopes(at);
        LinkMotion motion = new LinkMotion();
        motion.stiffness = structure.stiffness()[link];
        motion.damping = structure.damping()[link];
        motion.step = 1 / excitation.rate();
        double[] modulation = new Modulations(excitation).of(at.law().modulator(), this);
        int[] direct = directly(link, i, slopes);
        double[] memorySlope = new double[count];
        int[] moving = IntStream.range(0, count).filter(p -> direct[p] >= 0 || starting).toArray();
        int next = 0;
        for (int j = 0; j < samples; j++) {
            motion.time = j * motion.step + excitation.later(j);
            motion.before = displacement[Math.max(0, j - 1)];
            motion.displacement = displacement[j];
            motion.velocity = velocity[j];
            motion.modulation = modulation.length == 0 ? 1 : modulation[j];
            if (next < stroke.starts().size() && stroke.starts().get(next).sample() == j) {
                motion.before = displacement[j];
                start(starting ? carried(link, stroke.starts().get(next)) : new Carried(0, new double[count]), slopes, direct,
                        motion, memorySlope);
                next++;
            }
            lawForce[i][j] = at.law().force(motion);
            total[link][j] += lawForce[i][j];
            if (count > 0) {
                slopes.take(motion, DrivenLinks::neverLate, i, j);
                for (int p : moving) {
                    step(slopes, direct[p], link, p, j, memorySlope);
                }
            }
            motion.memory = at.law().remember(motion);
        }
    }

    private void start(Carried carried, LawSlopes slopes, int[] direct, LinkMotion motion, double[] memorySlope) {
        motion.memory = slopes.law.memoryOf(carried.force());
        double[] begun = slopes.startSlopes(carried.force());
        for (int p = 0; p < count; p++) {
            memorySlope[p] = begun[0] * carried.slope()[p] + (direct[p] >= LawSlopes.OWN ? begun[direct[p]] : 0);
        }
    }

    /** Adds what a sample's force changes by with a parameter, and carries the change of the memory on. */
    private void step(LawSlopes slopes, int direct, int link, int p, int j, double[] memorySlope) {
        double change = (direct >= 0 ? slopes.force[direct] : 0) + slopes.force[LawSlopes.MEMORY_BEFORE] * memorySlope[p];
        if (change != 0) {
            slope[link][p] = slope[link][p].length == 0 ? new double[samples] : slope[link][p];
            slope[link][p][j] += change;
        }
        memorySlope[p] = (direct >= 0 ? slopes.memory[direct] : 0) + slopes.memory[LawSlopes.MEMORY_BEFORE] * memorySlope[p];
    }

    @Override
    public double[] load(int link) {
        return excitation.fineSeries(excitation.spectrum(total[link]));
    }

    @Override
    public double[] displacement(int link) {
        return excitation.fineSeries(excitation.spectrum(displacement));
    }

    @Override
    public double[] velocity(int link) {
        return excitation.fineSeries(Spectra.timesJOmega(excitation.omega(), excitation.spectrum(displacement)));
    }

    private static void neverLate(LinkMotion motion, int law, int index, double ago) {
        throw new IllegalStateException("a late law in a driven link");
    }

    /** Which slope of a law each parameter takes directly; -1 for none. */
    private int[] directly(int link, int law, LawSlopes slopes) {
        int[] out = new int[count];
        Arrays.fill(out, -1);
        if (count > 0) {
            out[link] = LawSlopes.STIFFNESS;
            out[structure.links() + link] = LawSlopes.DAMPING;
            for (int i = 0; i < slopes.parameters; i++) {
                out[assembly.lawIndex(law) + i] = LawSlopes.OWN + i;
            }
        }
        return out;
    }

    Simulator.Response response() {
        List<Assembly.Output> outputs = assembly.outputs();
        int size = 2 * excitation.omega().length;
        Sensing sensing = new Sensing(excitation);
        double[][] out = new double[outputs.size()][];
        double[][][] slopes = new double[count][outputs.size()][];
        for (int o = 0; o < out.length; o++) {
            if (outputs.get(o).reading() != Assembly.Reading.LINK_FORCE) {
                throw new DataFault("a driven link's sensor reads its force; its fixed end does not move");
            }
            int link = outputs.get(o).place();
            double[][] own = new double[count][];
            for (int p = 0; p < count; p++) {
                own[p] = slope[link][p].length == 0 ? new double[size] : excitation.spectrum(slope[link][p]);
            }
            out[o] = sensing.report(assembly, o, excitation.spectrum(total[link]), own, 0);
            for (int p = 0; p < count; p++) {
                slopes[p][o] = own[p];
            }
        }
        double[] stretch = excitation.spectrum(displacement);
        return new Simulator.Response(out, slopes, Arrays.stream(lawForce).map(excitation::spectrum).toArray(double[][]::new),
                IntStream.range(0, structure.links()).mapToObj(l -> stretch.clone()).toArray(double[][]::new), false,
                java.util.Optional.empty(),
                IntStream.range(0, out.length).mapToObj(o -> sensing.recorded(assembly, o)).toArray(double[][]::new));
    }
}
