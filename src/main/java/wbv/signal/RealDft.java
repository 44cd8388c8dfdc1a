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

    /**
     * Works out the twiddle factors.
     *
     * @param length points N, even, with no prime factor above 5
     */
    public RealDft(int length) {
        if (!fits(length)) {
            throw new IllegalArgumentException("length of a transform must be even with factors 2, 3 and 5 only: " + length);
        }
        this.length = length;
        this.half = length / 2;
        cosine = new double[half];
        sine = new double[half];
        for (int k = 0; k < half; k++) {
            cosine[k] = Math.cos(2 * Math.PI * k / length);
            sine[k] = Math.sin(2 * Math.PI * k / length);
        }
    }

    /**
     * The greatest length that fits, not above one given.
     *
     * @param most at least 2
     */
    public static int fitting(int most) {
        if (most < 2) {
            throw new IllegalArgumentException("a transform needs at least 2 points: " + most);
        }
        int n = most - most % 2;
        while (!fits(n)) {
            n -= 2;
        }
        return n;
    }

    /**
     * The least length that fits, not below one given.
     *
     * @param least at least 2
     */
    public static int covering(int least) {
        int n = least + least % 2;
        while (!fits(n)) {
            n += 2;
        }
        return n;
    }

    /** Whether a sequence of n values can be transformed. */
    public static boolean fits(int n) {
        if (n < 2 || n % 2 != 0) {
            return false;
        }
        int rest = n;
        for (int prime : new int[] {2, 3, 5}) {
            while (rest % prime == 0) {
                rest /= prime;
            }
        }
        return rest == 1;
    }

    /** Points N of the sequence. */
    public int length() {
        return length;
    }

    /**
     * The spectrum, in the unit of the sequence, {@code X_k = Σ x_n exp(-j2πkn/N)} for k = 0 to N/2: real part at 2k, imaginary part at 2k
     * + 1.
     *
     * @param x sequence of any unit, N long. Not modified.
     */
    public double[] forward(double[] x) {
        if (x.length != length) {
            throw new IllegalArgumentException("sequence must have " + length + " values: " + x.length);
        }
        Halves z = new Halves(half);
        for (int k = 0; k < half; k++) {
            z.re[k] = x[2 * k];
            z.im[k] = x[2 * k + 1];
        }
        z = complex(z);
        double[] re = z.re;
        double[] im = z.im;
        double[] out = new double[length + 2];
        for (int k = 0; k <= half; k++) {
            int a = k == half ? 0 : k;
            int b = k == 0 ? 0 : half - k;
            double evenRe = (re[a] + re[b]) / 2;
            double evenIm = (im[a] - im[b]) / 2;
            double oddRe = (im[a] + im[b]) / 2;
            double oddIm = (re[b] - re[a]) / 2;
            double c = k == half ? -1 : cosine[k];
            double s = k == half ? 0 : sine[k];
            out[2 * k] = evenRe + c * oddRe + s * oddIm;
            out[2 * k + 1] = evenIm + c * oddIm - s * oddRe;
        }
        return out;
    }

    /**
     * The sequence, N long, of which {@link #forward} gives this spectrum, in its unit.
     *
     * @param spectrum of any unit: real part of line k at 2k, imaginary part at 2k + 1; lines beyond its end are 0. Those at 0 and N/2 are
     *                 real in the spectrum of any real sequence: their imaginary parts do not count. Not modified.
     */
    public double[] inverse(double[] spectrum) {
        if (spectrum.length > length + 2) {
            throw new IllegalArgumentException("spectrum must have at most " + (length + 2) + " values: " + spectrum.length);
        }
        Halves z = new Halves(half);
        for (int k = 0; k < half; k++) {
            int m = half - k;
            // Z_k = E_k + j O_k with E_k = (X_k + X*_m)/2 and O_k = (X_k - X*_m)/2 exp(j2πk/N); conjugated for the inverse.
            double re = 2 * k < spectrum.length ? spectrum[2 * k] : 0;
            double im = k > 0 && 2 * k + 1 < spectrum.length ? spectrum[2 * k + 1] : 0;
            double mirroredRe = 2 * m < spectrum.length ? spectrum[2 * m] : 0;
            double mirroredIm = m < half && 2 * m + 1 < spectrum.length ? spectrum[2 * m + 1] : 0;
            double evenRe = (re + mirroredRe) / 2;
            double evenIm = (im - mirroredIm) / 2;
            double diffRe = (re - mirroredRe) / 2;
            double diffIm = (im + mirroredIm) / 2;
            double oddRe = diffRe * cosine[k] - diffIm * sine[k];
            double oddIm = diffRe * sine[k] + diffIm * cosine[k];
            z.re[k] = evenRe - oddIm;
            z.im[k] = -(evenIm + oddRe);
        }
        z = complex(z);
        double scale = 1.0 / half;
        double[] out = new double[length];
        for (int k = 0; k < half; k++) {
            out[2 * k] = z.re[k] * scale;
            out[2 * k + 1] = z.im[k] * -scale;
        }
        return out;
    }

    /** Complex numbers, real parts and imaginary parts each side by side, so that steps of many at once are plain loops over arrays. */
    private static final class Halves {
        final double[] re;
        final double[] im;

        Halves(int count) {
            re = new double[count];
            im = new double[count];
        }
    }

    /**
     * Complex transform of half values.
     *
     * @param x consumed
     */
    private Halves complex(Halves x) {
        Halves from = x;
        Halves to = new Halves(half);
        int n = half;
        int stride = 1;
        while (n > 1) {
            int radix = n % 4 == 0 ? 4 : n % 2 == 0 ? 2 : n % 3 == 0 ? 3 : 5;
            int m = n / radix;
            pass(from, to, radix, m, stride);
            Halves swap = from;
            from = to;
            to = swap;
            n = m;
            stride *= radix;
        }
        return from;
    }

    /** One step of decimation in frequency: y[q + s (r p + j)] = w^(pj) Σ_i x[q + s (p + m i)] exp(-j2π ij/r). */
    private void pass(Halves x, Halves y, int radix, int m, int stride) {
        int turn = length / (radix * m);
        int part = stride * m;
        for (int p = 0; p < m; p++) {
            double c = cosine[turn * p];
            double s = sine[turn * p];
            int from = stride * p;
            int to = radix * stride * p;
            if (radix == 4) {
                four(x.re, x.im, y.re, y.im, from, part, to, stride, c, s);
            } else if (radix == 2) {
                two(x.re, x.im, y.re, y.im, from, part, to, stride, c, s);
            } else if (radix == 3) {
                three(x.re, x.im, y.re, y.im, from, part, to, stride, c, s);
            } else {
                five(x.re, x.im, y.re, y.im, from, part, to, stride, c, s);
            }
        }
    }

    /**
     * So many sums of four values each, turned by multiples of an angle, of which c and s are cosine and sine; likewise of two, three and
     * five.
     */
    private static void four(double[] re, double[] im, double[] outRe, double[] outIm, int from, int part, int to, int count, double c,
            double s) {
        double c2 = c * c - s * s;
        double s2 = 2 * c * s;
        double c3 = c * c2 - s * s2;
        double s3 = s * c2 + c * s2;
        for (int q = 0; q < count; q++) {
            int a = from + q;
            int b = to + q;
            double apcRe = re[a] + re[a + 2 * part];
            double apcIm = im[a] + im[a + 2 * part];
            double amcRe = re[a] - re[a + 2 * part];
            double amcIm = im[a] - im[a + 2 * part];
            double bpdRe = re[a + part] + re[a + 3 * part];
            double bpdIm = im[a + part] + im[a + 3 * part];
            double bmdRe = re[a + part] - re[a + 3 * part];
            double bmdIm = im[a + part] - im[a + 3 * part];
            outRe[b] = apcRe + bpdRe;
            outIm[b] = apcIm + bpdIm;
            turned(outRe, outIm, b + count, amcRe + bmdIm, amcIm - bmdRe, c, s);
            turned(outRe, outIm, b + 2 * count, apcRe - bpdRe, apcIm - bpdIm, c2, s2);
            turned(outRe, outIm, b + 3 * count, amcRe - bmdIm, amcIm + bmdRe, c3, s3);
        }
    }

    private static void two(double[] re, double[] im, double[] outRe, double[] outIm, int from, int part, int to, int count, double c,
            double s) {
        for (int q = 0; q < count; q++) {
            int a = from + q;
            int b = to + q;
            outRe[b] = re[a] + re[a + part];
            outIm[b] = im[a] + im[a + part];
            turned(outRe, outIm, b + count, re[a] - re[a + part], im[a] - im[a + part], c, s);
        }
    }

    private static void three(double[] re, double[] im, double[] outRe, double[] outIm, int from, int part, int to, int count, double c,
            double s) {
        double h = Math.sqrt(3) / 2;
        double c2 = c * c - s * s;
        double s2 = 2 * c * s;
        for (int q = 0; q < count; q++) {
            int a = from + q;
            int b = to + q;
            double sumRe = re[a + part] + re[a + 2 * part];
            double sumIm = im[a + part] + im[a + 2 * part];
            double difRe = h * (re[a + part] - re[a + 2 * part]);
            double difIm = h * (im[a + part] - im[a + 2 * part]);
            double midRe = re[a] - sumRe / 2;
            double midIm = im[a] - sumIm / 2;
            outRe[b] = re[a] + sumRe;
            outIm[b] = im[a] + sumIm;
            turned(outRe, outIm, b + count, midRe + difIm, midIm - difRe, c, s);
            turned(outRe, outIm, b + 2 * count, midRe - difIm, midIm + difRe, c2, s2);
        }
    }

    private static void five(double[] re, double[] im, double[] outRe, double[] outIm, int from, int part, int to, int count, double c,
            double s) {
        double a1 = Math.cos(2 * Math.PI / 5);
        double a2 = Math.cos(4 * Math.PI / 5);
        double b1 = Math.sin(2 * Math.PI / 5);
        double b2 = Math.sin(4 * Math.PI / 5);
        double c2 = c * c - s * s;
        double s2 = 2 * c * s;
        double c3 = c * c2 - s * s2;
        double s3 = s * c2 + c * s2;
        double c4 = c2 * c2 - s2 * s2;
        double s4 = 2 * c2 * s2;
        for (int q = 0; q < count; q++) {
            int a = from + q;
            int b = to + q;
            double p1Re = re[a + part] + re[a + 4 * part];
            double p1Im = im[a + part] + im[a + 4 * part];
            double m1Re = re[a + part] - re[a + 4 * part];
            double m1Im = im[a + part] - im[a + 4 * part];
            double p2Re = re[a + 2 * part] + re[a + 3 * part];
            double p2Im = im[a + 2 * part] + im[a + 3 * part];
            double m2Re = re[a + 2 * part] - re[a + 3 * part];
            double m2Im = im[a + 2 * part] - im[a + 3 * part];
            double oneRe = re[a] + a1 * p1Re + a2 * p2Re;
            double oneIm = im[a] + a1 * p1Im + a2 * p2Im;
            double twoRe = re[a] + a2 * p1Re + a1 * p2Re;
            double twoIm = im[a] + a2 * p1Im + a1 * p2Im;
            double threeRe = b1 * m1Re + b2 * m2Re;
            double threeIm = b1 * m1Im + b2 * m2Im;
            double fourRe = b2 * m1Re - b1 * m2Re;
            double fourIm = b2 * m1Im - b1 * m2Im;
            outRe[b] = re[a] + p1Re + p2Re;
            outIm[b] = im[a] + p1Im + p2Im;
            turned(outRe, outIm, b + count, oneRe + threeIm, oneIm - threeRe, c, s);
            turned(outRe, outIm, b + 2 * count, twoRe + fourIm, twoIm - fourRe, c2, s2);
            turned(outRe, outIm, b + 3 * count, twoRe - fourIm, twoIm + fourRe, c3, s3);
            turned(outRe, outIm, b + 4 * count, oneRe - threeIm, oneIm + threeRe, c4, s4);
        }
    }

    /** (u + jv) exp(-jφ), of which c and s are cosine and sine. */
    private static void turned(double[] re, double[] im, int at, double u, double v, double c, double s) {
        re[at] = u * c + v * s;
        im[at] = v * c - u * s;
    }
}
