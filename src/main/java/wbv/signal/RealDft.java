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

    /** The least length that fits, not below one given. @param least at least 2 */
    public static int covering(int least) {
        int n = least + least % 2;
        while (fitting(n) != n) {
            n += 2;
        }
        return n;
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

    /**
     * The sequence of which {@link #forward} gives this spectrum.
     *
     * @param spectrum real part of line k at 2k, imaginary part at 2k + 1; lines beyond its end are 0. Those at 0 and N/2 are real in
     *                 the spectrum of any real sequence: their imaginary parts do not count. Not modified.
     */
    public double[] inverse(double[] spectrum) {
        if (spectrum.length > length + 2) {
            throw new IllegalArgumentException("spectrum must have at most " + (length + 2) + " values: " + spectrum.length);
        }
        double[] x = java.util.Arrays.copyOf(spectrum, length + 2);
        x[1] = 0;
        x[length + 1] = 0;
        double[] z = new double[length];
        for (int k = 0; k < half; k++) {
            int m = half - k;
            // Z_k = E_k + j O_k with E_k = (X_k + X*_m)/2 and O_k = (X_k - X*_m)/2 exp(j2πk/N); conjugated for the inverse.
            double evenRe = (x[2 * k] + x[2 * m]) / 2;
            double evenIm = (x[2 * k + 1] - x[2 * m + 1]) / 2;
            double diffRe = (x[2 * k] - x[2 * m]) / 2;
            double diffIm = (x[2 * k + 1] + x[2 * m + 1]) / 2;
            double oddRe = diffRe * cosine[k] - diffIm * sine[k];
            double oddIm = diffRe * sine[k] + diffIm * cosine[k];
            z[2 * k] = evenRe - oddIm;
            z[2 * k + 1] = -(evenIm + oddRe);
        }
        double[] out = complex(z);
        double scale = 1.0 / half;
        for (int i = 0; i < length; i += 2) {
            out[i] *= scale;
            out[i + 1] *= -scale;
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
        } else if (radix == 3) {
            pass3(x, y, m, stride);
        } else {
            pass5(x, y, m, stride);
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

    private void pass3(double[] x, double[] y, int m, int stride) {
        int turn = length / (3 * m);
        int part = 2 * stride * m;
        double h = Math.sqrt(3) / 2;
        for (int p = 0; p < m; p++) {
            double c1 = cosine[turn * p];
            double s1 = sine[turn * p];
            double c2 = c1 * c1 - s1 * s1;
            double s2 = 2 * c1 * s1;
            for (int q = 0; q < 2 * stride; q += 2) {
                int a = 2 * stride * p + q;
                int b = 6 * stride * p + q;
                double sumRe = x[a + part] + x[a + 2 * part];
                double sumIm = x[a + part + 1] + x[a + 2 * part + 1];
                double difRe = h * (x[a + part] - x[a + 2 * part]);
                double difIm = h * (x[a + part + 1] - x[a + 2 * part + 1]);
                double midRe = x[a] - sumRe / 2;
                double midIm = x[a + 1] - sumIm / 2;
                y[b] = x[a] + sumRe;
                y[b + 1] = x[a + 1] + sumIm;
                turned(y, b + 2 * stride, midRe + difIm, midIm - difRe, c1, s1);
                turned(y, b + 4 * stride, midRe - difIm, midIm + difRe, c2, s2);
            }
        }
    }

    private void pass5(double[] x, double[] y, int m, int stride) {
        int turn = length / (5 * m);
        int part = 2 * stride * m;
        double a1 = Math.cos(2 * Math.PI / 5);
        double a2 = Math.cos(4 * Math.PI / 5);
        double b1 = Math.sin(2 * Math.PI / 5);
        double b2 = Math.sin(4 * Math.PI / 5);
        for (int p = 0; p < m; p++) {
            double c1 = cosine[turn * p];
            double s1 = sine[turn * p];
            double c2 = c1 * c1 - s1 * s1;
            double s2 = 2 * c1 * s1;
            double c3 = c1 * c2 - s1 * s2;
            double s3 = s1 * c2 + c1 * s2;
            double c4 = c2 * c2 - s2 * s2;
            double s4 = 2 * c2 * s2;
            for (int q = 0; q < 2 * stride; q += 2) {
                int a = 2 * stride * p + q;
                int b = 10 * stride * p + q;
                double p1Re = x[a + part] + x[a + 4 * part];
                double p1Im = x[a + part + 1] + x[a + 4 * part + 1];
                double m1Re = x[a + part] - x[a + 4 * part];
                double m1Im = x[a + part + 1] - x[a + 4 * part + 1];
                double p2Re = x[a + 2 * part] + x[a + 3 * part];
                double p2Im = x[a + 2 * part + 1] + x[a + 3 * part + 1];
                double m2Re = x[a + 2 * part] - x[a + 3 * part];
                double m2Im = x[a + 2 * part + 1] - x[a + 3 * part + 1];
                double oneRe = x[a] + a1 * p1Re + a2 * p2Re;
                double oneIm = x[a + 1] + a1 * p1Im + a2 * p2Im;
                double twoRe = x[a] + a2 * p1Re + a1 * p2Re;
                double twoIm = x[a + 1] + a2 * p1Im + a1 * p2Im;
                double threeRe = b1 * m1Re + b2 * m2Re;
                double threeIm = b1 * m1Im + b2 * m2Im;
                double fourRe = b2 * m1Re - b1 * m2Re;
                double fourIm = b2 * m1Im - b1 * m2Im;
                y[b] = x[a] + p1Re + p2Re;
                y[b + 1] = x[a + 1] + p1Im + p2Im;
                turned(y, b + 2 * stride, oneRe + threeIm, oneIm - threeRe, c1, s1);
                turned(y, b + 4 * stride, twoRe + fourIm, twoIm - fourRe, c2, s2);
                turned(y, b + 6 * stride, twoRe - fourIm, twoIm + fourRe, c3, s3);
                turned(y, b + 8 * stride, oneRe - threeIm, oneIm + threeRe, c4, s4);
            }
        }
    }
}
