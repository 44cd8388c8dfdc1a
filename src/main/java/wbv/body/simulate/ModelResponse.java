package wbv.body.simulate;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Model;
import wbv.body.Spectra;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;
import wbv.signal.ComplexSeries;
import wbv.signal.Segmentation;

/**
 * What the linear part of a model answers at the frequencies of averaged spectra, exact at every bin below 45 % of the sampling
 * rate and NaN above and at 0 Hz: laws that are not linear, drives and offsets are left out.
 */
public final class ModelResponse {

    /** Lines as dense as a silence of so long wants them, which an excitation pads with [s]. */
    private static final double SILENCE = 4;

    private final Model model;
    private final Segmentation segmentation;
    private final int every;
    private final Excitation excitation;

    /** Lays lines that fall on the bins of the spectra. */
    public ModelResponse(Model model, Segmentation segmentation) {
        this.model = model;
        this.segmentation = segmentation;
        // A record that, silence included, is a whole number of segments: then every bin is a line.
        double rate = segmentation.rate();
        int padded = segmentation.length();
        while (padded < 2 * SILENCE * rate + 2) {
            padded *= 2;
        }
        this.every = padded / segmentation.length();
        int samples = padded - (int) Math.ceil(SILENCE * rate);
        this.excitation = new Excitation(rate, new double[samples], java.util.Map.of());
        if (Math.abs(excitation.omega()[every] - 2 * Math.PI * segmentation.frequency(1)) > 1e-9 * excitation.omega()[every]) {
            throw new IllegalStateException("lines of the model do not fall on the bins of the spectra");
        }
    }

    /**
     * An output over the model's excitation: its base's motion, or its one measured force.
     *
     * @param input  the excitation, as the recording measures it: acceleration, velocity or position of the base, or the force
     * @param output what a sensor of the model reads
     * @throws DataFault if the model has no such sensor, or is not excited by that input alone
     */
    public ComplexSeries of(Channel input, Channel output) {
        if (model.driven()) {
            throw new DataFault("the model '" + model.name() + "' has driven links only, which swing at no frequency");
        }
        if (!model.excitations().equals(List.of(input))) {
            throw new DataFault("the model '" + model.name() + "' is excited by " + model.excitations() + ", not by " + input
                    + " alone");
        }
        int index = model.outputs().indexOf(output);
        if (index < 0) {
            throw new DataFault("the model '" + model.name() + "' has no sensor " + output + "; it has " + model.outputs());
        }
        double[] lines = new Simulator(excitation).transmissibility(model.assembly())[index];
        int derivatives = input.quantity() == Quantity.POSITION ? 2 : input.quantity() == Quantity.VELOCITY ? 1 : 0;
        for (int times = 0; times < derivatives; times++) {
            differentiate(lines);
        }
        return bins(lines);
    }

    /**
     * Multiplies by jω.
     *
     * @param lines Modified.
     */
    private void differentiate(double[] lines) {
        for (int k = 0; 2 * k < lines.length; k++) {
            double re = lines[2 * k];
            lines[2 * k] = -excitation.omega()[k] * lines[2 * k + 1];
            lines[2 * k + 1] = excitation.omega()[k] * re;
        }
    }

    /** Whether {@link #of} has an answer. */
    public boolean has(Channel input, Channel output) {
        return !model.driven() && model.excitations().equals(List.of(input)) && model.outputs().contains(output);
    }

    /**
     * Apparent mass at the base along its first axis [kg]: what of the sitter is one with it, and {@code Σ m A/A_base} of everything that
     * it carries. Thesis: Eq. 2-5, 2-11, 2-12.
     */
    public ComplexSeries apparentMass() {
        Assembly assembly = model.assembly();
        double[] mass = assembly.structure().mass();
        List<Assembly.Output> all = new ArrayList<>();
        IntStream.range(0, mass.length).forEach(b -> all.add(new Assembly.Output(b, Assembly.Reading.ACCELERATION, List.of())));
        double[][] ratio = new Simulator(excitation).transmissibility(new Assembly(assembly.structure(), assembly.laws(),
                List.of(),
                all));
        double[] sum = new double[ratio[0].length];
        for (int b = 0; b < mass.length; b++) {
            Spectra.add(sum, ratio[b], mass[b] * assembly.structure().kinematics().carried()[b][0]);
        }
        for (int k = 0; k < sum.length; k += 2) {
            sum[k] += model.base().mass();
        }
        return bins(sum);
    }

    private ComplexSeries bins(double[] lines) {
        double[] re = new double[segmentation.bins()];
        double[] im = new double[segmentation.bins()];
        for (int bin = 0; bin < re.length; bin++) {
            int at = 2 * bin * every;
            boolean there = bin > 0 && at + 1 < lines.length;
            re[bin] = there ? lines[at] : Double.NaN;
            im[bin] = there ? lines[at + 1] : Double.NaN;
        }
        return new ComplexSeries(re, im);
    }
}
