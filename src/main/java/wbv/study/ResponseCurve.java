package wbv.study;

import java.util.Optional;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.signal.ApparentMass;
import wbv.signal.Backing;
import wbv.signal.CoherenceDistribution;
import wbv.signal.ComplexSeries;
import wbv.signal.Peak;
import wbv.signal.ResponseMatrix;

/**
 * One output's response to one input as a report shows it.
 *
 * @param index of the input
 * @param all   the output's responses to all inputs
 * @param h2    H2 where there is one
 * @param model what a model answers, where one does
 * @param plate mass to be taken off an apparent mass [kg]
 * @param level confidence of the bands
 */
public record ResponseCurve(Channel input, Channel output, int index, ResponseMatrix all, Optional<ComplexSeries> h2,
        Optional<ComplexSeries> model, double plate, double level) {

    /**
     * How a model and a response differ where it is usable.
     *
     * @param relative rms of the difference over rms
     * @param inside share of it within the band
     */
    public record Misfit(double relative, double inside) {}

    /** Of every bin [Hz]. Not a copy. */
    public double[] frequency() {
        return all.frequency();
    }

    /** H1; an apparent mass without the plate. */
    public ComplexSeries h1() {
        return bare(all.h1(0, index));
    }

    /** Hv; an apparent mass without the plate. */
    public ComplexSeries hv() {
        return bare(all.hv(0, index));
    }

    /** H2 where there is one; an apparent mass without the plate. */
    public Optional<ComplexSeries> bareH2() {
        return h2.map(this::bare);
    }

    private ComplexSeries bare(ComplexSeries ratio) {
        return isApparentMass() && plate > 0 ? new ApparentMass(frequency(), ratio).without(plate).mass() : ratio;
    }

    /** Half the interval about |H1| at the curve's level, by bin, in {@link #unit}; likewise about its real and imaginary part. */
    public double[] margin() {
        return all.margin(0, index, level);
    }

    /** Half the interval about the phase of H1, by bin [rad]; π where the modulus may be 0. */
    public double[] phaseMargin() {
        double[] margin = margin();
        ComplexSeries h = h1();
        for (int k = 0; k < margin.length; k++) {
            double modulus = h.magnitude(k);
            margin[k] = margin[k] < modulus ? Math.asin(margin[k] / modulus) : Math.PI;
        }
        return margin;
    }

    /** Where H1 is backed, by bin. */
    public boolean[] usable() {
        return all.usable(0, index);
    }

    /** What backs it at each frequency, or what is missing there. */
    public Backing[] backing() {
        return all.backing(0, index);
    }

    /** The coherence that unrelated signals would show on average with as many independent averages. */
    public double coherenceByChance() {
        return new CoherenceDistribution(all.averages(), all.inputs()).byChance();
    }

    /** Whether the input has power of its own at the bin nearest to a frequency [Hz]. */
    boolean excited(double frequency) {
        int nearest = (int) Math.round(frequency / frequency()[1]);
        return nearest < backing().length && backing()[nearest] != Backing.NOT_EXCITED;
    }

    /** Whether this is a force over an acceleration along the same axis. */
    public boolean isApparentMass() {
        return output.quantity() == Quantity.FORCE && input.axis() == output.axis()
                && (input.quantity() == Quantity.ACCELERATION || input.quantity() == Quantity.SPECIFIC_FORCE);
    }

    /** H1 as a mass [kg]; means something only where {@link #isApparentMass}. */
    public ApparentMass apparentMass() {
        return new ApparentMass(frequency(), h1());
    }

    /** Unit of the modulus. */
    public String unit() {
        if (isApparentMass()) {
            return "kg";
        }
        return ratio(output, input);
    }

    /** Unit of one channel over another's. */
    public static String ratio(Channel output, Channel input) {
        String in = input.quantity().unit();
        String out = output.quantity().unit();
        return in.equals(out) ? "1" : bracketed(out) + '/' + bracketed(in);
    }

    private static String bracketed(String unit) {
        return unit.contains("/") ? '(' + unit + ')' : unit;
    }

    /** {@code INPUT to OUTPUT}, as channels are written. */
    public String name() {
        return input + " to " + output;
    }

    /** The peak of |H1| where it is usable. */
    public Optional<Peak> peak() {
        return Peak.of(frequency(), h1().magnitudes(), usable());
    }

    /** The peak, or the highest usable value where that stands at the end of what is usable; NaN where nothing is. */
    public Peak highest() {
        double[] modulus = h1().magnitudes();
        int best = -1;
        for (int k = 0; k < modulus.length; k++) {
            best = usable()[k] && (best < 0 || modulus[k] > modulus[best]) ? k : best;
        }
        int found = best;
        return peak().orElseGet(() -> found < 0 ? new Peak(Double.NaN, Double.NaN)
                : new Peak(frequency()[found], modulus[found]));
    }

    /** Half the band about the highest value, in {@link #unit}. */
    public double highestMargin() {
        Peak peak = highest();
        if (Double.isNaN(peak.frequency())) {
            return Double.NaN;
        }
        return margin()[(int) Math.round(peak.frequency() / frequency()[1])];
    }

    /** Two numbers, the lowest and the highest usable frequency [Hz]; NaN where none is. */
    public double[] usableBand() {
        double low = Double.NaN;
        double high = Double.NaN;
        for (int k = 0; k < usable().length; k++) {
            if (usable()[k]) {
                low = Double.isNaN(low) ? frequency()[k] : low;
                high = frequency()[k];
            }
        }
        return new double[] {low, high};
    }

    /**
     * Median of an array over the usable frequencies, in its unit; NaN where none is.
     *
     * @param values by bin, of any unit. Not modified.
     */
    public double typical(double[] values) {
        double[] kept = java.util.stream.IntStream.range(0, values.length).filter(k -> usable()[k]).mapToDouble(k -> values[k])
                .sorted().toArray();
        return kept.length == 0 ? Double.NaN : kept[kept.length / 2];
    }

    /** How the model's answer differs; empty if there is none, or nothing is usable. */
    public Optional<Misfit> misfit() {
        if (model.isEmpty()) {
            return Optional.empty();
        }
        ComplexSeries h = h1();
        ComplexSeries m = model.get();
        double[] margin = margin();
        double squares = 0;
        double power = 0;
        int inside = 0;
        int count = 0;
        for (int k = 0; k < margin.length; k++) {
            if (usable()[k] && Double.isFinite(m.re()[k])) {
                double a = m.re()[k] - h.re()[k];
                double b = m.im()[k] - h.im()[k];
                squares += a * a + b * b;
                power += Math.pow(h.magnitude(k), 2);
                inside += Math.abs(m.magnitude(k) - h.magnitude(k)) <= margin[k] ? 1 : 0;
                count++;
            }
        }
        return count == 0 ? Optional.empty() : Optional.of(new Misfit(Math.sqrt(squares / power), (double) inside / count));
    }
}
