package wbv.filter;

import java.util.Arrays;
import wbv.filter.model.InputWindow;
import wbv.filter.model.OneDegree;
import wbv.filter.model.Spec;

/**
 * The asymptotic correction function of an extended Kalman filter on one degree of freedom (Ljung, IEEE Trans. Automatic
 * Control 1979, eq. 3.10): {@code f(θ) = E[ψ(θ) ν(θ) / S(θ)]}, the mean of the direction in which corrections push parameters
 * that are held at θ. The filter's parameters follow {@code dθ/dτ = G⁻¹ f(θ)}, {@code G = E[ψψᵀ/S]}, in the long run: it can
 * converge only where f is zero and falls.
 *
 * <p>ψ is what the filter takes for ∂ŷ/∂θ: {@code ψ = H W + ∂h/∂θ}, {@code W ← E W + ∂g/∂θ}, {@code W ← W - K ψ}. It leaves
 * out that the gain depends on θ, which is why a filter with wrong noise may converge to wrong parameters. θ is [ln ω, ln ζ].
 *
 * <p>With noise that adapts, R is learned at each θ as {@link OutputNoise} learns it, and with it the gain; without, R is the
 * sensor's.
 */
public final class CorrectionFunction {

    /** The first seconds, which the motion's start still moves, do not count. */
    private static final double WARM_UP = 3;
    /** Largest move of a parameter in one step of the search (ln), and steps of it. */
    private static final double LONGEST_MOVE = 0.2;
    private static final int STEPS = 200;
    private static final double ARRIVED = 1e-6;

    private final Spec spec;
    private final double[] u;
    private final double[] y;
    private final boolean adapts;
    private final OneDegree model;
    private final HighPassPair baseline;
    private final InputWindow window;
    private final double[] c = new double[InputWindow.POINTS];
    private final double[] xi = new double[5];
    private final double[] p = new double[4];
    private final double[] w = new double[4];
    private final double[] forced = new double[4];

    /**
     * For the motion that a filter shall be held against, of which f is a mean.
     *
     * @param u motion of the base by sample [m/s² or rad/s]; NaN if missing. Not modified.
     * @param y motion of the body, as long, in the same unit. Not modified.
     * @param adapts whether the noise adapts, as in the adapted filter, or is the sensor's, as in the textbook's
     */
    public CorrectionFunction(Spec spec, double[] u, double[] y, boolean adapts) {
        if (u.length != y.length || u.length < 2 * WARM_UP * spec.rate()) {
            throw new IllegalArgumentException("input and output must be as long as each other, and " + 2 * WARM_UP
                    + " s at least: " + u.length + ", " + y.length + " samples");
        }
        this.spec = spec;
        this.u = u.clone();
        this.y = y.clone();
        this.adapts = adapts;
        this.model = new OneDegree(spec, true);
        this.baseline = new HighPassPair(spec);
        this.window = new InputWindow(spec);
    }

    /**
     * The function at one place.
     *
     * @param frequency  where: natural frequency [Hz]
     * @param damping    where: damping ratio
     * @param correction f for ln ω and ln ζ [1 a sample], two long
     * @param move       G⁻¹ f, the way the parameters go: ln ω and ln ζ [1], two long
     * @param stable     whether they return when moved away from a zero: judged by {@link #converge} alone, false elsewhere
     * @param meanSquare of the innovations, in the square of their unit
     */
    public record Value(double frequency, double damping, double[] correction, double[] move, boolean stable, double meanSquare) {

        public Value {
            correction = correction.clone();
            move = move.clone();
        }
    }

    /** f at a natural frequency [Hz] and a damping ratio. */
    public Value at(double frequency, double damping) {
        xi[2] = Math.log(2 * Math.PI * frequency);
        xi[3] = Math.log(damping);
        restart();
        OutputNoise noise = new OutputNoise(spec);
        double[] delayed = new double[InputWindow.LATENCY + 1];
        Arrays.fill(delayed, Double.NaN);
        double[] f = new double[2];
        double[] g = new double[3];
        double squares = 0;
        double offset = 0;
        long count = 0;
        for (int i = 0; i < u.length; i++) {
            boolean present = Double.isFinite(u[i]) && Double.isFinite(y[i]);
            if (present && !baseline.started()) {
                baseline.start(u[i], y[i]);
            }
            if (!baseline.started()) {
                continue;
            }
            window.push(present ? baseline.input(u[i]) : 0, present);
            System.arraycopy(delayed, 1, delayed, 0, InputWindow.LATENCY);
            delayed[InputWindow.LATENCY] = present ? baseline.output(y[i]) : Double.NaN;
            if (present) {
                baseline.advance(u[i], y[i]);
            }
            advance();
            if (!Double.isFinite(delayed[0])) {
                continue;
            }
            // offsets between the sensors are no part of the body
            double residual = delayed[0] - model.output(xi);
            offset += (1 - baseline.decay()) * (residual - offset);
            double r = adapts ? noise.variance() : spec.outputNoise() * spec.outputNoise();
            double innovation = residual - offset;
            double[] psi = correct(innovation, r);
            double s = psi[2];
            noise.hear(delayed[0] - offset);
            noise.learn(innovation, s - r);
            if (i > WARM_UP * spec.rate()) {
                f[0] += psi[0] * innovation / s;
                f[1] += psi[1] * innovation / s;
                g[0] += psi[0] * psi[0] / s;
                g[1] += psi[0] * psi[1] / s;
                g[2] += psi[1] * psi[1] / s;
                squares += innovation * innovation;
                count++;
            }
        }
        double determinant = g[0] * g[2] - g[1] * g[1];
        double[] move = {(g[2] * f[0] - g[1] * f[1]) / determinant, (g[0] * f[1] - g[1] * f[0]) / determinant};
        return new Value(frequency, damping, new double[] {f[0] / count, f[1] / count}, move, false, squares / count);
    }

    private void restart() {
        xi[0] = 0;
        xi[1] = 0;
        model.set(xi);
        baseline.reset();
        window.reset();
        Arrays.fill(p, 0);
        Arrays.fill(w, 0);
        double motion = spec.adaptation().prior().motion() / (2 * Math.PI * spec.frequency());
        p[0] = motion * motion;
        p[3] = motion * motion;
    }

    /** x⁻ = E x + g, P⁻ = E P Eᵀ + Q, W⁻ = E W + ∂g/∂θ. */
    private void advance() {
        window.coefficients(c);
        double[] e = model.step(0).transition();
        double[] gain = model.step(0).gains();
        model.forced(c, xi, forced);
        for (int k = 0; k < 2; k++) {
            double v = e[0] * w[k] + e[1] * w[2 + k] + forced[k];
            w[2 + k] = e[2] * w[k] + e[3] * w[2 + k] + forced[2 + k];
            w[k] = v;
        }
        model.advance(c, c.length, xi);
        double q = spec.inputNoise() * spec.inputNoise() + window.varianceOfMissing();
        double a = e[0] * p[0] + e[1] * p[2];
        double b = e[0] * p[1] + e[1] * p[3];
        double d = e[2] * p[0] + e[3] * p[2];
        double h = e[2] * p[1] + e[3] * p[3];
        p[0] = a * e[0] + b * e[1] + gain[0] * gain[0] * q;
        p[1] = a * e[2] + b * e[3] + gain[0] * gain[1] * q;
        p[2] = p[1];
        p[3] = d * e[2] + h * e[3] + gain[1] * gain[1] * q;
    }

    /** Corrects the motion alone. Returns ψ and S. */
    private double[] correct(double innovation, double r) {
        double h0 = model.damper();
        double h1 = model.spring();
        double ph0 = p[0] * h0 + p[1] * h1;
        double ph1 = p[2] * h0 + p[3] * h1;
        double s = h0 * ph0 + h1 * ph1 + r;
        double[] psi = new double[3];
        for (int k = 0; k < 2; k++) {
            psi[k] = h0 * w[k] + h1 * w[2 + k] + model.outputSlope(k, xi);
        }
        psi[2] = s;
        double k0 = ph0 / s;
        double k1 = ph1 / s;
        for (int k = 0; k < 2; k++) {
            w[k] -= k0 * psi[k];
            w[2 + k] -= k1 * psi[k];
        }
        xi[0] += k0 * innovation;
        xi[1] += k1 * innovation;
        p[0] -= k0 * ph0;
        p[1] -= k0 * ph1;
        p[2] = p[1];
        p[3] -= k1 * ph1;
        return psi;
    }

    /**
     * Where the parameters go from a start: {@code θ ← θ + G⁻¹ f(θ)} until they rest, or leave the bounds of {@link Spec}.
     *
     * @param frequency natural frequency of the start [Hz]
     * @param damping   damping ratio of the start
     * @return the last place; stable if it is a rest to which they return from all four sides
     */
    public Value converge(double frequency, double damping) {
        double logF = Math.log(frequency);
        double logZ = Math.log(damping);
        for (int i = 0; i < STEPS; i++) {
            Value value = at(Math.exp(logF), Math.exp(logZ));
            double shortened = Math.min(1, LONGEST_MOVE / Math.max(Math.abs(value.move[0]), Math.abs(value.move[1])));
            double df = shortened * value.move[0];
            double dz = shortened * value.move[1];
            if (!(Math.abs(df) + Math.abs(dz) > ARRIVED)) {
                return new Value(value.frequency, value.damping, value.correction, value.move, returns(logF, logZ),
                        value.meanSquare);
            }
            logF += df;
            logZ += dz;
            boolean inside = logF > Math.log(Spec.LEAST_FREQUENCY) && logF < Math.log(Spec.MOST_FREQUENCY)
                    && logZ > Math.log(Spec.LEAST_DAMPING) && logZ < Math.log(Spec.MOST_DAMPING);
            if (!inside) {
                return value;
            }
        }
        return at(Math.exp(logF), Math.exp(logZ));
    }

    private boolean returns(double logF, double logZ) {
        double away = 0.02;
        return at(Math.exp(logF + away), Math.exp(logZ)).move[0] < 0 && at(Math.exp(logF - away), Math.exp(logZ)).move[0] > 0
                && at(Math.exp(logF), Math.exp(logZ + away)).move[1] < 0 && at(Math.exp(logF), Math.exp(logZ - away)).move[1] > 0;
    }
}
