package wbv.diagnosis;

import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;

/**
 * What Laplace's integral misses along one coordinate of which the likelihood has kinks or several hills, such as a moment, a gap or a delay: the
 * sum of what is really there, at points at which all other coordinates follow, over what the curvature at the fit promises.
 */
final class ProfileSum {

    private static final double STEP = 0.5;
    private static final int STEPS = 7;

    private final Fitter fitter;

    ProfileSum(Fitter fitter) {
        this.fitter = fitter;
    }

    /** Whether a knob is one that slopes tell little of. */
    static boolean isAsked(Knob knob) {
        String key = knob.key();
        return key.endsWith("time_s") || key.endsWith("gap_m") || key.endsWith("delay_s") || key.endsWith("_hz");
    }

    /** Logarithms to be added for all knobs that are asked. @param normal equations at the fit */
    double correction(Fitter.State fit, Normal normal) {
        return IntStream.range(0, fit.x().length).filter(i -> isAsked(fit.candidate().knobs().get(i))).mapToDouble(i -> along(i, fit, normal)).sum();
    }

    private double along(int i, Fitter.State fit, Normal normal) {
        int n = fit.x().length;
        double[] unit = new double[n];
        unit[i] = 1;
        double[] way = factor(normal, n).solve(unit);
        double deviation = Math.sqrt(way[i]);
        double[] logs = new double[2 * STEPS + 1];
        double[] promised = new double[logs.length];
        for (int step = -STEPS; step <= STEPS; step++) {
            double[] x = fit.x().clone();
            boolean inside = true;
            for (int j = 0; j < n; j++) {
                Knob knob = fit.candidate().knobs().get(j);
                double moved = x[j] + step * STEP * way[j] / deviation;
                x[j] = Math.max(knob.low(), Math.min(knob.high(), moved));
                inside &= j != i || x[j] == moved;
            }
            double z = step * STEP;
            // What lies outside is cut from both, as the integral cuts it.
            boolean counts = inside && deviation < fit.candidate().knobs().get(i).high() - fit.candidate().knobs().get(i).low();
            promised[step + STEPS] = counts ? -z * z / 2 : Double.NEGATIVE_INFINITY;
            logs[step + STEPS] = step == 0 ? 0 : counts ? (fit.cost() - fitter.look(fit.candidate(), x, fit.frame()).cost()) / 2 : Double.NEGATIVE_INFINITY;
        }
        return LogSum.of(promised) == Double.NEGATIVE_INFINITY ? 0 : LogSum.of(logs) - LogSum.of(promised);
    }

    private static SymmetricFactor factor(Normal normal, int n) {
        DMatrixRMaj h = new DMatrixRMaj(n, n);
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                h.set(i, j, normal.curvature()[i][j] * (i == j ? 1 + 1e-9 : 1));
            }
        }
        return SymmetricFactor.of(h).orElseThrow();
    }
}
