package wbv.signal;

/**
 * The algebra of a {@link ResponseMatrix}, one bin after the other. All channels are scaled by their root mean square at the
 * bin.
 */
final class ResponseAlgebra {

    private static final double SINGULAR = 1e-10;

    private final ResponseMatrix to;
    private final int inputs;
    private final int outputs;
    private final int n;
    private final ComplexSeries[][] cross;
    private final double[] size;
    private final Hermitian own;
    private final Hermitian composite;
    private final Hermitian square;
    private final double[] vector;

    /** @param to whose arrays are filled */
    ResponseAlgebra(ResponseMatrix to, SpectralMatrix spectra) {
        this.to = to;
        inputs = to.inputs;
        outputs = to.outputs;
        n = inputs + outputs;
        cross = new ComplexSeries[n][n];
        for (int i = 0; i < n; i++) {
            for (int j = 0; j <= i; j++) {
                cross[i][j] = spectra.cross(i, j);
            }
        }
        size = new double[n];
        own = new Hermitian(inputs);
        composite = new Hermitian(inputs + 1);
        square = new Hermitian(inputs);
        vector = new double[2 * (inputs + 1)];
    }

    void run() {
        for (int k = 0; k < to.frequency.length; k++) {
            boolean alive = true;
            for (int i = 0; i < n; i++) {
                size[i] = Math.sqrt(to.densities[i][k]);
                alive &= i >= inputs || size[i] > 0;
            }
            for (int i = 0; i < inputs && alive; i++) {
                for (int j = 0; j <= i; j++) {
                    own.set(i, j, re(i, j, k), im(i, j, k));
                }
            }
            alive = alive && own.invert();
            for (int i = 0; i < inputs; i++) {
                to.among[i][k] = alive ? Math.max(0, 1 - 1 / own.inverseRe(i, i)) : 1;
                alive &= 1 - to.among[i][k] > SINGULAR;
            }
            for (int o = 0; o < outputs; o++) {
                if (alive && size[inputs + o] > 0) {
                    leastSquares(o, k);
                    totalLeastSquares(o, k);
                } else {
                    unknown(o, k);
                }
            }
            if (to.h2.length > 0) {
                fromOutputs(k, alive);
            }
        }
    }

    /** Entry (i, j) of the coherence matrix: real part. */
    private double re(int i, int j, int k) {
        return i == j ? 1 : (i > j ? cross[i][j] : cross[j][i]).re()[k] / (size[i] * size[j]);
    }

    private double im(int i, int j, int k) {
        return i == j ? 0 : (i > j ? cross[i][j].im()[k] : -cross[j][i].im()[k]) / (size[i] * size[j]);
    }

    /** H1 = G_yx G_xx⁻¹, the coherences and the scatter. Thesis: Eq. 2-16, 2-17. */
    private void leastSquares(int o, int k) {
        int y = inputs + o;
        double explained = 0;
        for (int i = 0; i < inputs; i++) {
            double a = 0;
            double b = 0;
            for (int j = 0; j < inputs; j++) {
                double p = re(y, j, k);
                double q = im(y, j, k);
                double r = own.inverseRe(j, i);
                double s = own.inverseIm(j, i);
                a += p * r - q * s;
                b += p * s + q * r;
            }
            to.h1[o][i].re()[k] = a;
            to.h1[o][i].im()[k] = b;
            explained += a * re(y, i, k) + b * im(y, i, k);   // γ² = Re Σ H_i G_iy / G_yy
            to.ordinary[o][i][k] = Math.min(1, re(y, i, k) * re(y, i, k) + im(y, i, k) * im(y, i, k));
        }
        to.multiple[o][k] = Math.max(0, Math.min(1, explained));
        double noise = 1 - to.multiple[o][k];
        for (int i = 0; i < inputs; i++) {
            double modulus = to.h1[o][i].magnitude(k);
            double variance = noise * own.inverseRe(i, i);
            // What input i explains beyond the others is |H|² / (G_xx⁻¹)_ii; with the noise it is all that they leave.
            to.partial[o][i][k] = modulus == 0 ? 0 : modulus * modulus / (modulus * modulus + variance);
            double unit = size[y] / size[i];
            to.deviation[o][i][k] = unit * Math.sqrt(variance / (2 * (to.averages - inputs)));
            to.h1[o][i].re()[k] *= unit;
            to.h1[o][i].im()[k] *= unit;
        }
    }

    /**
     * Hv: the composite matrix of the inputs and one output; [-H | 1] is the conjugate of its last eigenvector. Thesis: Eq. 2-19, 2-20,
     * 2-21, 2-22, 2-23.
     */
    private void totalLeastSquares(int o, int k) {
        int y = inputs + o;
        for (int i = 0; i <= inputs; i++) {
            for (int j = 0; j <= i; j++) {
                int a = i == inputs ? y : i;
                int b = j == inputs ? y : j;
                composite.set(i, j, re(a, b, k), im(a, b, k));
            }
        }
        boolean found = composite.smallest(vector);
        double c = vector[inputs];
        double d = vector[2 * inputs + 1];
        double square = c * c + d * d;
        for (int i = 0; i < inputs; i++) {
            double unit = size[y] / size[i];
            double a = vector[i];
            double b = vector[inputs + 1 + i];
            // H_i = -v_i* / v_y*
            boolean defined = found && square > SINGULAR;
            to.hv[o][i].re()[k] = defined ? -unit * (a * c + b * d) / square : Double.NaN;
            to.hv[o][i].im()[k] = defined ? unit * (b * c - a * d) / square : Double.NaN;
        }
    }

    /** H2 = G_yy G_yx (G_xy G_yx)⁻¹, by the pseudo-inverse of G_xy where there are more outputs than inputs. Thesis: Eq. 2-18. */
    private void fromOutputs(int k, boolean alive) {
        boolean defined = alive;
        for (int o = inputs; o < n; o++) {
            defined &= size[o] > 0;
        }
        for (int i = 0; i < inputs && defined; i++) {
            for (int j = 0; j <= i; j++) {
                double a = 0;
                double b = 0;
                for (int o = inputs; o < n; o++) {   // C_xy C_yx
                    a += re(i, o, k) * re(o, j, k) - im(i, o, k) * im(o, j, k);
                    b += re(i, o, k) * im(o, j, k) + im(i, o, k) * re(o, j, k);
                }
                square.set(i, j, a, b);
            }
        }
        defined = defined && square.invert();
        for (int o = 0; o < outputs; o++) {
            for (int i = 0; i < inputs; i++) {
                double a = 0;
                double b = 0;
                for (int j = 0; j < inputs && defined; j++) {
                    double p = 0;
                    double q = 0;
                    for (int l = inputs; l < n; l++) {   // C_yy C_yx
                        p += re(inputs + o, l, k) * re(l, j, k) - im(inputs + o, l, k) * im(l, j, k);
                        q += re(inputs + o, l, k) * im(l, j, k) + im(inputs + o, l, k) * re(l, j, k);
                    }
                    a += p * square.inverseRe(j, i) - q * square.inverseIm(j, i);
                    b += p * square.inverseIm(j, i) + q * square.inverseRe(j, i);
                }
                double unit = size[inputs + o] / size[i];
                to.h2[o][i].re()[k] = defined ? a * unit : Double.NaN;
                to.h2[o][i].im()[k] = defined ? b * unit : Double.NaN;
            }
        }
    }

    private void unknown(int o, int k) {
        for (int i = 0; i < inputs; i++) {
            for (ComplexSeries[][] h : new ComplexSeries[][][] {to.h1, to.hv}) {
                h[o][i].re()[k] = Double.NaN;
                h[o][i].im()[k] = Double.NaN;
            }
            to.deviation[o][i][k] = Double.NaN;
        }
    }
}
