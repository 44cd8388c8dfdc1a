package wbv.identify;

/**
 * Transfer function of a body of one or two modes on a shaken base, and its slopes: {@code H = H₁}, or {@code H = g H₁ + (1 - g) H₂
 * + h (C₁ - C₂)}, with {@code H_m = (d s + k)/(s² + d s + k)}, {@code C_m = k s/(s² + d s + k)/ω₀},
 * {@code d = 2ζω}, {@code k = ω²}. It is 1 + O(s²): the body follows its base at rest and in slow motion. Any output of a chain or fork of
 * two masses has the second form.
 *
 * <p>Parameters: ln ω, ln ζ of the first mode; then of the second, g and h. A body of one mode of whose damping a share κ acts
 * against the base and the rest against rest, {@code (κ d s + k)/(s² + d s + k)}, has ln ω, ln ζ, κ.
 */
final class ModalBody {

    static final int ONE = 2;
    static final int TWO = 6;
    static final int SKYHOOK = 3;
    /** ω₀, by which h has no unit [rad/s]: that of a seated body. */
    private static final double REFERENCE = 2 * Math.PI * 5;
    private static final double LEAST_FREQUENCY = 0.05;
    private static final double LEAST_DAMPING = 1e-4;
    private static final double MOST_DAMPING = 100;
    private static final double MOST_SHARE = 100;
    private static final int SHARE = 4;
    private static final int CROSS = 5;

    private final int modes;
    private final boolean skyhook;
    private final double[] re;
    private final double[] im;

    /** @param modes 1 or 2 */
    ModalBody(int modes) {
        this(modes, false);
    }

    private ModalBody(int modes, boolean skyhook) {
        this.modes = modes;
        this.skyhook = skyhook;
        this.re = new double[1 + parameters()];
        this.im = new double[1 + parameters()];
    }

    /** One mode, part of whose damping acts against rest. */
    static ModalBody withSkyhook() {
        return new ModalBody(1, true);
    }

    int modes() {
        return modes;
    }

    int parameters() {
        return skyhook ? SKYHOOK : modes == 1 ? ONE : TWO;
    }

    /** Natural frequency of a mode [Hz]. */
    static double frequency(double[] theta, int mode) {
        return Math.exp(theta[2 * mode]) / (2 * Math.PI);
    }

    /** Damping ratio of a mode [1]. */
    static double damping(double[] theta, int mode) {
        return Math.exp(theta[2 * mode + 1]);
    }

    /**
     * Whether a fit may go there: nowhere near overflow, and not beyond what samples can show.
     *
     * @param rate [Hz]
     */
    boolean within(double[] theta, double rate) {
        for (int m = 0; m < modes; m++) {
            double f = frequency(theta, m);
            double zeta = damping(theta, m);
            if (!(f > LEAST_FREQUENCY && f < rate && zeta > LEAST_DAMPING && zeta < MOST_DAMPING)) {
                return false;
            }
        }
        return skyhook ? Math.abs(theta[2]) < MOST_SHARE
                : modes == 1 || Math.abs(theta[SHARE]) < MOST_SHARE && Math.abs(theta[CROSS]) < MOST_SHARE;
    }

    /** Real part of H (at 0) and of its slopes to the parameters (from 1 on), after {@link #at}. */
    double[] re() {
        return re;
    }

    /** Imaginary parts likewise. */
    double[] im() {
        return im;
    }

    /**
     * Evaluates H and its slopes.
     *
     * @param theta parameters
     * @param omega [rad/s]
     */
    void at(double[] theta, double omega) {
        if (skyhook) {
            skyhook(theta, omega);
            return;
        }
        if (modes == 1) {
            mode(theta, 0, omega, 1, 0, 0);
            return;
        }
        double g = theta[SHARE];
        double h = theta[CROSS];
        mode(theta, 0, omega, g, h, 0);
        double firstRe = re[0];
        double firstIm = im[0];
        double shareRe = re[1 + SHARE];
        double shareIm = im[1 + SHARE];
        double crossRe = re[1 + CROSS];
        double crossIm = im[1 + CROSS];
        mode(theta, 1, omega, 1 - g, -h, 2);
        re[0] += firstRe;
        im[0] += firstIm;
        re[1 + SHARE] = shareRe - re[1 + SHARE];
        im[1 + SHARE] = shareIm - im[1 + SHARE];
        re[1 + CROSS] = crossRe - re[1 + CROSS];
        im[1 + CROSS] = crossIm - im[1 + CROSS];
    }

    /**
     * share × H_m + cross × C_m, its slopes to ln ω and ln ζ, and, of two modes, H_m and C_m themselves.
     *
     * @param at of ln ω
     */
    private void mode(double[] theta, int m, double omega, double share, double cross, int at) {
        double w = Math.exp(theta[2 * m]);
        double k = w * w;
        double d = 2 * Math.exp(theta[2 * m + 1]) * w * omega;
        double c = k * omega / REFERENCE;
        // numerator n = share (k + j d) + cross j c over the denominator (k - ω²) + j d
        double nRe = share * k;
        double nIm = share * d + cross * c;
        double dRe = k - omega * omega;
        double size = dRe * dRe + d * d;
        double hRe = (nRe * dRe + nIm * d) / size;
        double hIm = (nIm * dRe - nRe * d) / size;
        re[0] = hRe;
        im[0] = hIm;
        // to ln ω: n' = share (2k + j d) + cross 2 j c, D' = 2k + j d; to ln ζ: n' = share j d, D' = j d
        quotient(1 + at, share * 2 * k - (hRe * 2 * k - hIm * d), share * d + cross * 2 * c - (hRe * d + hIm * 2 * k), dRe, d, size);
        quotient(2 + at, hIm * d, share * d - hRe * d, dRe, d, size);
        if (modes == 2) {
            quotient(1 + SHARE, k, d, dRe, d, size);
            quotient(1 + CROSS, 0, c, dRe, d, size);
        }
    }

    private void skyhook(double[] theta, double omega) {
        double w = Math.exp(theta[0]);
        double k = w * w;
        double d = 2 * Math.exp(theta[1]) * w * omega;
        double share = theta[2];
        double dRe = k - omega * omega;
        double size = dRe * dRe + d * d;
        double hRe = (k * dRe + share * d * d) / size;
        double hIm = (share * d * dRe - k * d) / size;
        re[0] = hRe;
        im[0] = hIm;
        quotient(1, 2 * k - (hRe * 2 * k - hIm * d), share * d - (hRe * d + hIm * 2 * k), dRe, d, size);
        quotient(2, hIm * d, share * d - hRe * d, dRe, d, size);
        quotient(3, 0, d, dRe, d, size);
    }

    private void quotient(int at, double nRe, double nIm, double dRe, double dIm, double size) {
        re[at] = (nRe * dRe + nIm * dIm) / size;
        im[at] = (nIm * dRe - nRe * dIm) / size;
    }
}
