package wbv.diagnosis.fit;

import wbv.signal.RealDft;

/**
 * A stretch of the recording on which models are judged, seen in frequency through a taper at both ends.
 */
public final class Window {

    private static final double LOW = 0.4;
    private static final double HIGH = 22.0 / 60;
    private static final double TAPER = 0.5;

    private final int start;
    private final RealDft transform;
    private final double[] taper;
    private final double scale;
    private final int first;
    private final int lines;
    private final double spacing;

    /**
     * @param start first sample
     * @param most samples at most; a few less are used where the transform wants it
     * @param rate [Hz]
     */
    Window(int start, int most, double rate) {
        this(start, most, rate, LOW);
    }

    /** @param low lowest frequency that counts [Hz]; 0 where constants count too */
    Window(int start, int most, double rate, double low) {
        this.start = start;
        int n = RealDft.fitting(most);
        transform = new RealDft(n);
        taper = new double[n];
        int edge = (int) Math.min(n / 4, TAPER * rate);
        double power = 0;
        for (int i = 0; i < n; i++) {
            int inside = Math.min(i, n - 1 - i);
            taper[i] = inside >= edge ? 1 : 0.5 - 0.5 * Math.cos(Math.PI * (inside + 0.5) / edge);
            power += taper[i] * taper[i];
        }
        scale = Math.sqrt(2 / power);
        spacing = rate / n;
        first = (int) Math.ceil(low / spacing);
        lines = (int) Math.floor(HIGH * rate / spacing) - first + 1;
    }

    /** Its first sample, counted in the recording. */
    public int start() {
        return start;
    }

    /** Number of its samples. */
    public int length() {
        return taper.length;
    }

    /** Number of spectral lines that count. */
    public int lines() {
        return lines;
    }

    /** Distance between lines [Hz]. */
    double spacing() {
        return spacing;
    }

    /** Sum of the taper's squares [1]: white noise of unit variance has this energy under it. */
    public double weight() {
        return 2 / (scale * scale);
    }

    /** Frequency of a line [Hz]. */
    public double frequency(int line) {
        return (first + line) * spacing;
    }

    /**
     * The spectrum of a series in this window: white noise of standard deviation s gives lines whose real and imaginary parts have
     * standard deviation s each, in the series' unit, however many samples count.
     *
     * @param series of the whole recording, of any unit. Not modified.
     * @param valid samples that count; the others are taken as 0
     */
    public double[] spectrum(double[] series, boolean[] valid) {
        double[] x = new double[taper.length];
        double power = 0;
        for (int i = 0; i < x.length; i++) {
            if (valid[start + i]) {
                x[i] = series[start + i] * taper[i];
                power += taper[i] * taper[i];
            }
        }
        double[] all = transform.forward(x, first + lines);
        double[] out = new double[2 * lines];
        double raised = power > 0 ? Math.sqrt(2 / power) : 0;
        for (int i = 0; i < out.length; i++) {
            out[i] = all[2 * first + i] * raised;
        }
        return out;
    }

    /**
     * Spectra at other lines, seen at the lines of this window: by straight lines between.
     *
     * @param omega frequencies of the other lines, evenly spaced from zero [rad/s]
     * @param spectra over these, by row. Neither is modified.
     */
    double[][] lines(double[] omega, double[][] spectra) {
        double spacing = omega[1] / (2 * Math.PI);
        double[][] out = new double[spectra.length][2 * lines];
        for (int o = 0; o < out.length; o++) {
            for (int line = 0; line < lines; line++) {
                double at = frequency(line) / spacing;
                int k = Math.min((int) at, omega.length - 2);
                double share = at - k;
                for (int part = 0; part < 2; part++) {
                    out[o][2 * line + part] = spectra[o][2 * k + part] * (1 - share) + spectra[o][2 * k + 2 + part] * share;
                }
            }
        }
        return out;
    }

    /**
     * The series, in the unit of the spectrum, of which a spectrum in this window is the {@link #spectrum}, over the window's length; lines
     * outside are 0.
     *
     * @param spectrum of any unit. Not modified.
     */
    public double[] series(double[] spectrum) {
        double[] all = new double[2 * (first + lines)];
        for (int i = 0; i < spectrum.length; i++) {
            all[2 * first + i] = spectrum[i] / scale;
        }
        return transform.inverse(all);
    }
}
