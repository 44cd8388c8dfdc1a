package wbv.signal;

import java.util.List;
import java.util.Optional;

/**
 * The mean response of several people that keeps their resonance.
 *
 * <p>People resonate at different frequencies, so that the mean of their curves is lower and broader than anyone's (thesis 2.2).
 * Here each curve is stretched along frequency so that its peak stands at the mean peak frequency, and then the mean is taken:
 * its
 * peak has the mean of the peak frequencies and the mean of the peak heights. The plain mean of the curves is kept beside it.
 * Frequencies that one of the curves does not reach are NaN. Arrays are not copied: treat them as read-only.
 *
 * @param frequency       by bin [Hz]
 * @param mean            mean of the stretched curves by bin, in their unit
 * @param deviation       standard deviation of the stretched curves over people, likewise
 * @param plain           mean of the curves as they are, likewise
 * @param peak            mean of the peaks
 * @param peakDeviation   standard deviation over people of peak frequency [Hz] and height, as a peak
 * @param people          how many
 */
public record SubjectMean(double[] frequency, double[] mean, double[] deviation, double[] plain, Peak peak, Peak peakDeviation,
        int people) {

    /**
     * The response of one person.
     *
     * @param frequency by bin, rising in equal steps [Hz]
     * @param modulus as many values, of the curves' unit
     * @param usable which of them are backed by excitation
     */
    public record Curve(double[] frequency, double[] modulus, boolean[] usable) {

        public Curve {
            if (frequency.length < 3 || modulus.length != frequency.length || usable.length != frequency.length) {
                throw new IllegalArgumentException("a curve needs as many values as frequencies, at least 3: "
                        + frequency.length + ", " + modulus.length + ", " + usable.length);
            }
        }

        /** Where it peaks; empty if it does not where it is usable. */
        public Optional<Peak> peak() {
            return Peak.of(frequency, modulus, usable);
        }

        /** The value at a frequency, linear between usable samples; NaN elsewhere. */
        double at(double f) {
            double place = (f - frequency[0]) / (frequency[1] - frequency[0]);
            int k = (int) Math.floor(place);
            double part = place - k;
            if (k < 0 || k >= frequency.length || !usable[k]) {
                return Double.NaN;
            }
            if (part < 1e-9) {
                return modulus[k];
            }
            return k + 1 < frequency.length && usable[k + 1] ? modulus[k] + part * (modulus[k + 1] - modulus[k]) : Double.NaN;
        }
    }

    /**
     * The mean of the curves that peak.
     *
     * @param curves of one person each; those without a peak where they are usable are left out. Not modified.
     * @return empty if fewer than two peak
     */
    public static Optional<SubjectMean> of(List<Curve> curves) {
        List<Curve> peaking = curves.stream().filter(curve -> curve.peak().isPresent()).toList();
        int people = peaking.size();
        if (people < 2) {
            return Optional.empty();
        }
        double[] at = peaking.stream().mapToDouble(curve -> curve.peak().orElseThrow().frequency()).toArray();
        double[] height = peaking.stream().mapToDouble(curve -> curve.peak().orElseThrow().height()).toArray();
        double[] place = meanAndDeviation(at);
        double[] tall = meanAndDeviation(height);
        double[] frequency = peaking.get(0).frequency();
        double[] mean = new double[frequency.length];
        double[] deviation = new double[frequency.length];
        double[] plain = new double[frequency.length];
        double[] values = new double[people];
        for (int k = 0; k < frequency.length; k++) {
            for (int i = 0; i < people; i++) {
                values[i] = peaking.get(i).at(frequency[k]);
            }
            plain[k] = meanAndDeviation(values)[0];
            for (int i = 0; i < people; i++) {
                values[i] = peaking.get(i).at(frequency[k] * at[i] / place[0]);
            }
            double[] both = meanAndDeviation(values);
            mean[k] = both[0];
            deviation[k] = both[1];
        }
        return Optional.of(new SubjectMean(frequency, mean, deviation, plain, new Peak(place[0], tall[0]),
                new Peak(place[1], tall[1]), people));
    }

    private static double[] meanAndDeviation(double[] values) {
        double mean = 0;
        for (double value : values) {
            mean += value / values.length;
        }
        double squares = 0;
        for (double value : values) {
            squares += (value - mean) * (value - mean);
        }
        return new double[] {mean, Math.sqrt(squares / (values.length - 1))};
    }
}
