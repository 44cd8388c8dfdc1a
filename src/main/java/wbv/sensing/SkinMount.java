package wbv.sensing;

import wbv.signal.ComplexSeries;

/**
 * A sensor on soft tissue: it rides on the skin as a mass on a spring and a dashpot, and so reads
 * {@code X_measured/X_bone = (1 + 2jζβ)/(1 - β² + 2jζβ)} with {@code β = f/f_0} (Kitazaki and Griffin, J. Biomechanics 28, 1995;
 * thesis Eq. 2-33 to 2-37). Frequency and damping are those of the sensor at its site; a tap beside it shows them: {@link
 * TapTest}.
 *
 * @param frequency undamped natural frequency f_0 of sensor and tissue [Hz], &gt; 0
 * @param damping   its damping ratio ζ, &gt; 0
 */
public record SkinMount(double frequency, double damping) {

    public SkinMount {
        if (!(frequency > 0) || Double.isInfinite(frequency)) {
            throw new IllegalArgumentException("natural frequency of a skin mount must be > 0 Hz: " + frequency);
        }
        if (!(damping > 0) || Double.isInfinite(damping)) {
            throw new IllegalArgumentException("damping ratio of a skin mount must be > 0: " + damping);
        }
    }

    /**
     * What a measured spectrum is to be multiplied by to become that of the bone: {@code (1 - β² + 2jζβ)/(1 + 2jζβ)}.
     * Thesis: Eq. 2-34, 2-36.
     *
     * @param frequencies by line [Hz]. Not modified.
     */
    public ComplexSeries correction(double[] frequencies) {
        double[] re = new double[frequencies.length];
        double[] im = new double[frequencies.length];
        for (int k = 0; k < re.length; k++) {
            double beta = frequencies[k] / frequency;
            double a = 1 - beta * beta;
            double b = 2 * damping * beta;
            double square = 1 + b * b;
            re[k] = (a + b * b) / square;
            im[k] = (b - a * b) / square;
        }
        return new ComplexSeries(re, im);
    }
}
