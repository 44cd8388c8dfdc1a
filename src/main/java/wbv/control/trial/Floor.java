package wbv.control.trial;

import org.apache.commons.math3.random.RandomGenerator;
import wbv.control.FloorBand;
import wbv.signal.RealDft;

/** How the floor under a seat shakes along z: Gaussian noise of a power spectrum. */
public sealed interface Floor permits EarthMover, RoadFloor {

    /** Lines of the spectrum end here [Hz]. */
    double HIGHEST = 40;

    /** A short name, such as {@code EM1}. */
    String word();

    /** What it is, and where its numbers come from. */
    String description();

    /**
     * Power spectral density of the acceleration [(m/s²)²/Hz].
     *
     * @param frequency [Hz], &gt; 0
     */
    double density(double frequency);

    /**
     * One ride of it.
     *
     * @param samples at {@value SuspendedPerson#RATE} Hz, &gt; 0
     * @return accelerations by sample [m/s²]
     */
    default double[] ride(int samples, RandomGenerator random) {
        RealDft transform = new RealDft(RealDft.covering(Math.max(samples, 2)));
        int n = transform.length();
        double line = (double) SuspendedPerson.RATE / n;
        double[] spectrum = new double[n + 2];
        for (int k = 1; k <= n / 2 && k * line <= HIGHEST; k++) {
            double size = n / 2.0 * Math.sqrt(density(k * line) * line);
            spectrum[2 * k] = size * random.nextGaussian();
            spectrum[2 * k + 1] = size * random.nextGaussian();
        }
        double[] ride = new double[samples];
        System.arraycopy(transform.inverse(spectrum), 0, ride, 0, samples);
        return ride;
    }

    /** Root mean square [m/s²]. */
    default double rms() {
        return Math.sqrt(moment(0));
    }

    /** What a controller's maker may know of it: middle and width of the spectrum, by its moments. */
    default FloorBand band() {
        double mean = moment(1) / moment(0);
        double spread = Math.sqrt(Math.max(0, moment(2) / moment(0) - mean * mean));
        return new FloorBand(mean, Math.max(0.05, Math.min(0.7, spread / mean)), rms());
    }

    private double moment(int order) {
        double step = 0.02;
        double sum = 0;
        for (double f = step; f <= HIGHEST; f += step) {
            sum += Math.pow(f, order) * density(f) * step;
        }
        return sum;
    }
}
