package wbv.exposure;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.CholeskyDecomposition;

/**
 * What a cascade of biquads lacks of the analog weighting that it was made of by the bilinear transform, which squeezes all frequencies
 * below half the rate: a few taps, by least squares of the complex response over the band of the signal (a discrete Wiener filter). Above
 * the band, where nothing comes, taps that are not needed are small.
 */
final class Correction {

    /** Taps, of which the middle one is the present. */
    static final int LENGTH = 9;
    private static final int POINTS = 512;
    /** Of the response's error, what a tap's own size weighs. */
    private static final double RIDGE = 1e-9;

    private Correction() {}

    /**
     * The taps, in the order of the values that they weigh, the oldest first.
     *
     * @param cascade of the filter at the rate
     * @param rate of the values [Hz]
     * @param band where the signal ends [Hz], below half the rate
     */
    static double[] taps(AnalogFilter filter, Cascade cascade, double rate, double band) {
        double[][] products = new double[LENGTH][LENGTH];
        double[] wanted = new double[LENGTH];
        double[] analog = new double[2];
        double[] digital = new double[2];
        int middle = LENGTH / 2;
        for (int i = 0; i < POINTS; i++) {
            double frequency = band * (i + 0.5) / POINTS;
            filter.response(frequency, analog);
            cascade.response(frequency / rate, digital);
            double size = digital[0] * digital[0] + digital[1] * digital[1];
            double re = (analog[0] * digital[0] + analog[1] * digital[1]) / size;
            double im = (analog[1] * digital[0] - analog[0] * digital[1]) / size;
            double w = 2 * Math.PI * frequency / rate;
            for (int k = 0; k < LENGTH; k++) {
                double at = w * (k - middle); // what is k places after the first is middle - k behind the present
                wanted[k] += (re * Math.cos(at) + im * Math.sin(at)) / POINTS;
                for (int l = 0; l < LENGTH; l++) {
                    products[k][l] += Math.cos(w * (k - l)) / POINTS;
                }
            }
        }
        for (int k = 0; k < LENGTH; k++) {
            products[k][k] += RIDGE;
        }
        return new CholeskyDecomposition(new Array2DRowRealMatrix(products, false), 1e-12, 0).getSolver()
                .solve(new ArrayRealVector(wanted, false)).toArray();
    }
}
