package wbv.signal;

/**
 * Discrete Fourier transform of real sequences of any even length 2^a 3^b 5^c, for windows that no power of two fits.
 *
 * <p>The sequence is transformed as N/2 complex numbers by a self-sorting mixed-radix scheme (Stockham; radices 4, 2, 3, 5) and
 * split. Immutable: one object may serve many threads.
 */
public final class RealDft {

    private final int length;
    private final int half;
    private final double[] cosine;
    private final double[] sine;

    /** @param length points N, even, with no prime factor above 5 */
    public RealDft(int length) {
        if (length != fitting(length)) {
            throw new IllegalArgumentException("length of a transform must be even with factors 2, 3 and 5 only: " + length);
        }
        this.length = length;
        this.half = length / 2;
        cosine = new double[length];
        sine = new double[length];
        for (int k = 0; k < length; k++) {
            cosine[k] = Math.cos(2 * Math.PI * k / length);
            sine[k] = Math.sin(2 * Math.PI * k / length);
        }
    }

    /** The greatest length that fits, not above one given. @param most at least 2 */
    public static int fitting(int most) {
        for (int n = most - most % 2; n >= 2; n -= 2) {
            int rest = n;
            for (int prime : new int[] {2, 3, 5}) {
                while (rest % prime == 0) {
                    rest /= prime;
                }
            }
            if (rest == 1) {
                return n;
            }
        }
        throw new IllegalArgumentException("a transform needs at least 2 points: " + most);
    }

    public int length() {
        return length;
    }

    /**
     * The spectrum {@code X_k = Σ x_n exp(-j2πkn/N)} for k = 0 to N/2: real part at 2k, imaginary part at 2k + 1.
     *
     * @param x sequence of N values. Not modified.
     */
    public double[] forward(double[] x) {
        if (x.length != length) {
            throw new IllegalArgumentException("sequence must have " + length + " values: " + x.length);
        }
        double[] z = complex(x.clone());
        double[] out = new double[length + 2];
        for (int k = 0; k <= half; k++) {
            int a = k == half ? 0 : k;
            int b = k == 0 ? 0 : half - k;
            double evenRe = (z[2 * a] + z[2 * b]) / 2;
            double evenIm = (z[2 * a + 1] - z[2 * b + 1]) / 2;
            double oddRe = (z[2 * a + 1] + z[2 * b + 1]) / 2;
            double oddIm = (z[2 * b] - z[2 * a]) / 2;
            double c = k == half ? -1 : cosine[k];
            double s = k == half ? 0 : sine[k];
            out[2 * k] = evenRe + c * oddRe + s * oddIm;
            out[2 * k + 1] = evenIm + c * oddIm - s * oddRe;
        }
        return out;
    }

    /** Complex transform of half values. @param x consumed */
    private double[] complex(double[] x) {
        double[] from = x;
        double[] to = new double[2 * half];
        int n = half;
        int stride = 1;
        while (n > 1) {
            int radix = n % 4 == 0 ? 4 : n % 2 == 0 ? 2 : n % 3 == 0 ? 3 : 5;
            int m = n / radix;
            pass(from, to, radix, m, stride);
            double[] swap = from;
            from = to;
            to = swap;
            n = m;
            stride *= radix;
        }
        return from;
    }

    /** One step of decimation in frequency: y[q + s (r p + j)] = w^(pj) Σ_i x[q + s (p + m i)] exp(-j2π ij/r). */
    private void pass(double[] x, double[] y, int radix, int m, int stride) {
        if (radix == 4) {
            pass4(x, y, m, stride);
        } else if (radix == 2) {
            pass2(x, y, m, stride);
        } else {
            passOdd(x, y, radix, m, stride);
        }
    }

    private void pass4(double[] x, double[] y, int m, int stride) {
        int turn = length / (4 * m);
        int part = 2 * stride * m;
        for (int p = 0; p < m; p++) {
            double c1 = cosine[turn * p];
            double s1 = sine[turn * p];
            double c2 = c1 * c1 - s1 * s1;
            double s2 = 2 * c1 * s1;
            double c3 = c1 * c2 - s1 * s2;
            double s3 = s1 * c2 + c1 * s2;
            int from = 2 * stride * p;
            int to = 8 * stride * p;
            for (int q = 0; q < 2 * stride; q += 2) {
                int a = from + q;
                double apcRe = x[a] + x[a + 2 * part];
                double apcIm = x[a + 1] + x[a + 2 * part + 1];
                double amcRe = x[a] - x[a + 2 * part];
                double amcIm = x[a + 1] - x[a + 2 * part + 1];
                double bpdRe = x[a + part] + x[a + 3 * part];
                double bpdIm = x[a + part + 1] + x[a + 3 * part + 1];
                double bmdRe = x[a + part] - x[a + 3 * part];
                double bmdIm = x[a + part + 1] - x[a + 3 * part + 1];
                int b = to + q;
                y[b] = apcRe + bpdRe;
                y[b + 1] = apcIm + bpdIm;
                turned(y, b + 2 * stride, amcRe + bmdIm, amcIm - bmdRe, c1, s1);
                turned(y, b + 4 * stride, apcRe - bpdRe, apcIm - bpdIm, c2, s2);
                turned(y, b + 6 * stride, amcRe - bmdIm, amcIm + bmdRe, c3, s3);
            }
        }
    }

    private void pass2(double[] x, double[] y, int m, int stride) {
        int turn = length / (2 * m);
        int part = 2 * stride * m;
        for (int p = 0; p < m; p++) {
            double c = cosine[turn * p];
            double s = sine[turn * p];
            for (int q = 0; q < 2 * stride; q += 2) {
                int a = 2 * stride * p + q;
                int b = 4 * stride * p + q;
                y[b] = x[a] + x[a + part];
                y[b + 1] = x[a + 1] + x[a + part + 1];
                turned(y, b + 2 * stride, x[a] - x[a + part], x[a + 1] - x[a + part + 1], c, s);
            }
        }
    }

    /** (re + j im) exp(-jφ), of which c and s are cosine and sine. */
    private static void turned(double[] y, int at, double re, double im, double c, double s) {
        y[at] = re * c + im * s;
        y[at + 1] = im * c - re * s;
    }

    private void passOdd(double[] x, double[] y, int radix, int m, int stride) {
        int turn = length / (radix * m);      // one step of the twiddle for n = radix · m points, in units of 1/N
        int part = length / radix;
        double[] re = new double[radix];
        double[] im = new double[radix];
        for (int p = 0; p < m; p++) {
            for (int q = 0; q < stride; q++) {
                for (int i = 0; i < radix; i++) {
                    int at = 2 * (q + stride * (p + m * i));
                    re[i] = x[at];
                    im[i] = x[at + 1];
                }
                for (int j = 0; j < radix; j++) {
                    double sumRe = re[0];
                    double sumIm = im[0];
                    for (int i = 1; i < radix; i++) {
                        int w = part * (i * j % radix);
                        sumRe += re[i] * cosine[w] + im[i] * sine[w];
                        sumIm += im[i] * cosine[w] - re[i] * sine[w];
                    }
                    int w = (int) ((long) turn * p * j % length);
                    turned(y, 2 * (q + stride * (radix * p + j)), sumRe, sumIm, cosine[w], sine[w]);
                }
            }
        }
    }
}
