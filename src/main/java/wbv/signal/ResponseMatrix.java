package wbv.signal;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import org.apache.commons.math3.distribution.TDistribution;
import wbv.recording.DataFault;

/**
 * Frequency responses from m inputs that act at once to p outputs, with what they are worth at every frequency.
 *
 * <p>With {@code G_ab = E[A B^H]}, X of m inputs and Y of p outputs, {@code H} is p by m:
 * <ul>
 * <li>{@code H1 = G_yx G_xx⁻¹}: unbiased where only the outputs are noisy;
 * <li>{@code H2 = G_yy G_xy⁺}: unbiased where only the inputs are; it needs as many outputs as inputs;
 * <li>Hv: {@code N = Y - H X = [-H | I] [X; Y]} of least power, each channel counted in units of its own root mean square at that
 *     frequency. {@code [-H | 1]} is the eigenvector of the smallest eigenvalue of the composite matrix of the inputs and one
 *     output (total least squares): unbiased where all channels have the same signal-to-noise ratio. With one input it is
 *     {@code (G_yx/|G_yx|) sqrt(G_yy/G_xx)}.
 * </ul>
 * The multiple coherence is the share of an output that all inputs explain, the partial coherence the share of what the other
 * inputs leave unexplained that one input explains. (Rocklin, Crowley and Vold, Proc. IMAC III, 1985; Bendat and Piersol, Random
 * Data, 2010, chapter 7.)
 *
 * <p>Given the inputs, H1 is a least-squares estimate, so the real and the imaginary part of an entry scatter by
 * {@code σ² = (1-γ²) G_yy (G_xx⁻¹)_ii / (2 (n_d - m))} each, n_d independent segments, which Student's t with 2 (n_d - m) degrees
 * of freedom turns into intervals.
 *
 * <p>Arrays are not copied, neither in nor out: treat them as read-only.
 * Thesis: Eq. 2-15, 2-29.
 */
public final class ResponseMatrix {

    /** An input of which the other inputs explain more than 98 % has too little of its own to be told apart from them. */
    private static final double LEAST_OWN = 0.02;

    final double[] frequency;
    final int inputs;
    final int outputs;
    final double averages;
    final double[][] densities;
    final ComplexSeries[][] h1;
    final ComplexSeries[][] h2;
    final ComplexSeries[][] hv;
    final double[][] multiple;
    final double[][][] ordinary;
    final double[][][] partial;
    final double[][] among;
    final double[][][] deviation;
    private final Backing[][][] backing;

    /**
     * The responses that spectra hold.
     *
     * @param spectra of the inputs first, then of the outputs
     * @param inputs  how many of the channels are inputs, at least 1, not all
     * @throws DataFault if too few segments were whole
     */
    public static ResponseMatrix of(SpectralMatrix spectra, int inputs, FrequencyResponse.Excited excited) {
        if (inputs < 1 || inputs >= spectra.channels()) {
            throw new IllegalArgumentException("inputs must be 1 to " + (spectra.channels() - 1) + ": " + inputs);
        }
        if (spectra.independent() <= inputs) {
            String holed = spectra.skipped() == 0 ? "" : " and " + spectra.skipped() + " with missing samples";
            throw new DataFault(String.format(Locale.ROOT, "a frequency response from %d %s needs more than %d independent "
                    + "segments of %.4g s without gaps: there are %.3g%s; take shorter segments or a longer recording", inputs,
                    inputs == 1 ? "input" : "inputs at once", inputs, spectra.segmentation().duration(), spectra.independent(),
                    holed));
        }
        return new ResponseMatrix(spectra, inputs, excited);
    }

    private ResponseMatrix(SpectralMatrix spectra, int inputs, FrequencyResponse.Excited excited) {
        this.inputs = inputs;
        this.outputs = spectra.channels() - inputs;
        this.frequency = spectra.segmentation().frequencies();
        this.averages = spectra.independent();
        int bins = frequency.length;
        densities = new double[inputs + outputs][];
        Arrays.setAll(densities, spectra::density);
        h1 = series(outputs, inputs, bins);
        h2 = series(outputs >= inputs ? outputs : 0, inputs, bins);
        hv = series(outputs, inputs, bins);
        multiple = new double[outputs][bins];
        ordinary = new double[outputs][inputs][bins];
        partial = new double[outputs][inputs][bins];
        among = new double[inputs][bins];
        deviation = new double[outputs][inputs][bins];
        backing = new Backing[outputs][inputs][];
        new ResponseAlgebra(this, spectra).run();
        judge(spectra.detrend().firstBin(), excited);
    }

    private static ComplexSeries[][] series(int rows, int columns, int bins) {
        ComplexSeries[][] all = new ComplexSeries[rows][columns];
        for (ComplexSeries[] row : all) {
            Arrays.setAll(row, i -> new ComplexSeries(new double[bins], new double[bins]));
        }
        return all;
    }

    private void judge(int firstBin, FrequencyResponse.Excited excited) {
        Judge judge = new Judge(averages, inputs, firstBin, excited);
        double[] noise = new double[outputs];
        Arrays.setAll(noise, o -> judge.noise(densities[inputs + o], multiple[o], Arrays.copyOf(densities, inputs)));
        for (int i = 0; i < inputs; i++) {
            double[] own = Arrays.stream(among[i]).map(shared -> 1 - shared).toArray();
            for (int o = 0; o < outputs; o++) {
                backing[o][i] = judge.of(densities[i], densities[inputs + o], noise[o], multiple[o], own, LEAST_OWN);
            }
        }
    }

    /** Bins from 0 Hz to half the sampling rate [Hz]. */
    public double[] frequency() {
        return frequency;
    }

    /** Number m of inputs. */
    public int inputs() {
        return inputs;
    }

    /** Number p of outputs. */
    public int outputs() {
        return outputs;
    }

    /** n_d, number of independent averages. */
    public double averages() {
        return averages;
    }

    /** Power spectral density of an input, by bin [unit²/Hz]. */
    public double[] inputDensity(int input) {
        return densities[input];
    }

    /** Power spectral density of an output, by bin [unit²/Hz]. */
    public double[] outputDensity(int output) {
        return densities[inputs + output];
    }

    /** H1 [unit_y/unit_x]; NaN where an input has no power, or none that the others have not. Thesis: Eq. 2-13, 2-14. */
    public ComplexSeries h1(int output, int input) {
        return h1[output][input];
    }

    /** H2 [unit_y/unit_x]; empty if there are fewer outputs than inputs. */
    public Optional<ComplexSeries> h2(int output, int input) {
        return h2.length == 0 ? Optional.empty() : Optional.of(h2[output][input]);
    }

    /** Hv [unit_y/unit_x]; NaN where H1 is. */
    public ComplexSeries hv(int output, int input) {
        return hv[output][input];
    }

    /** Multiple coherence γ²_y:x of an output with all inputs, by bin, 0 to 1. Chance alone gives m/n_d on average. */
    public double[] multipleCoherence(int output) {
        return multiple[output];
    }

    /** Ordinary coherence of an output with one input, by bin, 0 to 1, whatever the others share with both. */
    public double[] ordinaryCoherence(int output, int input) {
        return ordinary[output][input];
    }

    /** Partial coherence of an output with one input, by bin, 0 to 1, what the other inputs explain taken out of both. */
    public double[] partialCoherence(int output, int input) {
        return partial[output][input];
    }

    /** Share of an input that the other inputs explain, by bin, 0 to 1; all zero with a single input. */
    public double[] coherenceAmongInputs(int input) {
        return among[input];
    }

    /** Standard deviation of the real and of the imaginary part of an entry of H1, by bin [unit_y/unit_x]. */
    public double[] deviation(int output, int input) {
        return deviation[output][input];
    }

    /** What backs an entry, by its input's own excitation and the multiple coherence of its output, or what is missing. */
    public Backing[] backing(int output, int input) {
        return backing[output][input];
    }

    /** Where an entry may be used. */
    public boolean[] usable(int output, int input) {
        return Backing.usable(backing[output][input]);
    }

    /**
     * Half the interval, by bin [unit_y/unit_x], about the real part of an entry of H1, or about its modulus where that is large, for a
     * level of confidence.
     *
     * @param level of confidence, such as 0.95
     */
    public double[] margin(int output, int input, double level) {
        double t = new TDistribution(2 * (averages - inputs)).inverseCumulativeProbability((1 + level) / 2);
        return Arrays.stream(deviation[output][input]).map(sd -> t * sd).toArray();
    }

    /**
     * Half the interval about the phase of an entry of H1, by bin [rad]; π where the modulus may be 0.
     *
     * @param level of confidence
     */
    public double[] phaseMargin(int output, int input, double level) {
        double[] margin = margin(output, input, level);
        for (int k = 0; k < margin.length; k++) {
            double modulus = h1[output][input].magnitude(k);
            margin[k] = margin[k] < modulus ? Math.asin(margin[k] / modulus) : Math.PI;
        }
        return margin;
    }
}
