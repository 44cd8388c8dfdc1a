package wbv.signal;

/**
 * Discrete Fourier transform of real sequences whose length is a power of two, in place, with precomputed twiddle factors.
 *
 * <p>{@code X_k = Σ_n x_n exp(-j2πkn/N)}. A spectrum is packed into the array of the sequence: index 0 holds X_0, index 1 holds
 * X_{N/2} (both are real), then for 0 &lt; k &lt; N/2 index 2k holds Re X_k and 2k+1 holds Im X_k. The sequence is
 * transformed as N/2 complex numbers (Cooley and Tukey 1965, radix 2, decimation in time) and then split.
 *
 * <p>Immutable: one object may serve many threads.
 */
public final class Fft {

    private final int length;
    private final double[] cosine;
    private final double[] sine;

    /**
     * Works out the twiddle factors.
     *
     * @param length points N of the sequence, a power of two, at least 4
     */
    public Fft(int length) {
        if (length < 4 || Integer.bitCount(length) != 1) {
            throw new IllegalArgumentException("length of a transform must be a power of two >= 4: " + length);
        }
        this.length = length;
        this.cosine = new double[length / 2];
        this.sine = new double[length / 2];
        for (int k = 0; k < length / 2; k++) {
            cosine[k] = Math.cos(2 * Math.PI * k / length);
            sine[k] = Math.sin(2 * Math.PI * k / length);
        }
    }

    /** Points N of the sequence. */
    public int length() {
        return length;
    }

    /**
     * Transforms a sequence in place.
     *
     * @param data sequence, N long, of any unit; becomes its packed spectrum. Modified.
     */
    public void forward(double[] data) {
        requireLength(data);
        complex(data);
        double dc = data[0];
        data[0] = dc + data[1];
        data[1] = dc - data[1];
        split(data, 1);
    }

    /**
     * Transforms a spectrum back in place.
     *
     * @param data packed spectrum, N long, of any unit; becomes the sequence, scaled by 1/N. Modified.
     */
    public void inverse(double[] data) {
        requireLength(data);
        double dc = data[0];
        data[0] = (dc + data[1]) / 2;
        data[1] = (dc - data[1]) / 2;
        split(data, -1);
        // The inverse is the conjugate of the forward transform of the conjugate, over the number of points.
        for (int i = 1; i < length; i += 2) {
            data[i] = -data[i];
        }
        complex(data);
        double scale = 2.0 / length;
        for (int i = 0; i < length; i += 2) {
            data[i] *= scale;
            data[i + 1] *= -scale;
        }
    }

    /** Turns the spectrum Z of N/2 complex points into bins 1 to N/2-1 of the real sequence (direction 1), or back (-1). */
    private void split(double[] data, int direction) {
        for (int k = 1, m = length / 2 - 1; k <= m; k++, m--) {
            double evenRe = (data[2 * k] + data[2 * m]) / 2;
            double evenIm = (data[2 * k + 1] - data[2 * m + 1]) / 2;
            double halfRe = (data[2 * k] - data[2 * m]) / 2;
            double halfIm = (data[2 * k + 1] + data[2 * m + 1]) / 2;
            double c = cosine[k];
            double s = direction * sine[k];
            // odd = half · exp(∓j2πk/N) · (∓j): direction 1 takes the odd samples out of Z, -1 puts them back.
            double oddRe = direction * (c * halfIm - s * halfRe);
            double oddIm = -direction * (c * halfRe + s * halfIm);
            data[2 * k] = evenRe + oddRe;
            data[2 * k + 1] = evenIm + oddIm;
            data[2 * m] = evenRe - oddRe;
            data[2 * m + 1] = oddIm - evenIm;
        }
    }

    /** Forward transform of N/2 interleaved complex numbers. */
    private void complex(double[] data) {
        int points = length / 2;
        reverseBits(data, points);
        for (int half = 1; half < points; half *= 2) {
            int stride = points / half; // steps of 2π/N from one twiddle factor to the next
            for (int block = 0; block < points; block += 2 * half) {
                for (int j = 0; j < half; j++) {
                    int upper = 2 * (block + j);
                    int lower = upper + 2 * half;
                    double c = cosine[j * stride];
                    double s = sine[j * stride];
                    double re = c * data[lower] + s * data[lower + 1];
                    double im = c * data[lower + 1] - s * data[lower];
                    data[lower] = data[upper] - re;
                    data[lower + 1] = data[upper + 1] - im;
                    data[upper] += re;
                    data[upper + 1] += im;
                }
            }
        }
    }

    private static void reverseBits(double[] data, int points) {
        int shift = Integer.numberOfLeadingZeros(points) + 1;
        for (int i = 1; i < points; i++) {
            int j = Integer.reverse(i) >>> shift;
            if (j > i) {
                double re = data[2 * i];
                double im = data[2 * i + 1];
                data[2 * i] = data[2 * j];
                data[2 * i + 1] = data[2 * j + 1];
                data[2 * j] = re;
                data[2 * j + 1] = im;
            }
        }
    }

    private void requireLength(double[] data) {
        if (data.length != length) {
            throw new IllegalArgumentException("a sequence of this transform has " + length + " values: " + data.length);
        }
    }
}
