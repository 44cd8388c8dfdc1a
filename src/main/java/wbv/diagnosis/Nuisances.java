package wbv.diagnosis;

import java.util.ArrayList;
import java.util.List;
import wbv.body.SensorFault;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/**
 * The small errors that every sensor has (gain, clock, tilt, place), each with what is known of it beforehand. Being small they act
 * linearly, and what they act on was measured, so they are not simulated: for any residual their best values follow from a small
 * quadratic problem, within three standard deviations. What is larger has to be named.
 */
final class Nuisances {

    /** Standard deviation of a sensor's gain [1]. */
    static final double GAIN = 0.01;
    /** Standard deviation of a sensor's delay, in samples. */
    static final double DELAY = 0.15;
    /** Standard deviation of a sensor's tilt [rad]: one degree. */
    static final double TILT = Math.toRadians(1);
    /** Standard deviation of a sensor's place [m]. */
    static final double ARM = 0.005;
    /** Standard deviation of the part that a sensor's sway plays [1]: none to all of tilt times acceleration across. */
    static final double SWAY = 1;

    /** Standard deviation of a sensor's height above the axis about which its place turns [m]. */
    static final double HEIGHT = 0.3;

    private static final double MOST = 3;
    private static final int SWEEPS = 200;

    private final List<String> names;
    private final List<Integer> owners;
    /** What one standard deviation of each error adds to the whitened residual. */
    private final double[][] columns;
    private final double[][] gram;

    /** The errors of all acceleration sensors of the outputs, in a window. */
    static Nuisances of(Evidence evidence, Whitening whitening) {
        List<String> names = new ArrayList<>();
        List<Integer> owners = new ArrayList<>();
        List<double[]> columns = new ArrayList<>();
        double step = evidence.recording().clock().step();
        for (int o = 0; o < evidence.outputs().size(); o++) {
            Channel channel = evidence.outputs().get(o);
            if (channel.quantity() != Quantity.ACCELERATION) {
                continue;
            }
            double[] y = evidence.measured(o);
            add(evidence, whitening, names, owners, columns, o, "gain", y, GAIN);
            add(evidence, whitening, names, owners, columns, o, "delay", slope(y, step), -DELAY * step);
            for (Channel across : evidence.companions(channel.location(), Quantity.ACCELERATION)) {
                add(evidence, whitening, names, owners, columns, o, "tilt to " + across.axis(), evidence.series(across), TILT);
                addSway(evidence, whitening, names, owners, columns, o, across, step);
            }
            addCentripetal(evidence, whitening, names, owners, columns, o, channel);
            for (Channel rate : evidence.companions(channel.location(), Quantity.ANGULAR_RATE)) {
                add(evidence, whitening, names, owners, columns, o, "arm on " + rate.axis(), slope(evidence.series(rate), step), ARM);
            }
        }
        return new Nuisances(names, owners, columns.toArray(double[][]::new));
    }

    /** A sensor that sways tilts, and sees the acceleration across times its angle: pitch for the fore-aft axis, roll for the lateral. */
    private static void addSway(Evidence evidence, Whitening whitening, List<String> names, List<Integer> owners,
                            List<double[]> columns, int output,
                                Channel across, double step) {
        char axis = across.axis() == 'x' ? 'y' : 'x';
        for (Channel rate : evidence.companions(across.location(), Quantity.ANGULAR_RATE)) {
            if (rate.axis() == axis) {
                double[] angle = integrated(evidence.series(rate), step);
                double[] a = evidence.series(across);
                for (int i = 0; i < angle.length; i++) {
                    angle[i] *= a[i];
                }
                add(evidence, whitening, names, owners, columns, output, "sway to " + across.axis(), angle, SWAY);
            }
        }
    }

    /** A sensor above the axis about which its place turns is pulled inwards: height times the square of the rate. */
    private static void addCentripetal(Evidence evidence, Whitening whitening, List<String> names, List<Integer> owners,
                            List<double[]> columns, int output,
                                       Channel channel) {
        List<Channel> rates = evidence.companions(channel.location(), Quantity.ANGULAR_RATE);
        if (!rates.isEmpty()) {
            double[] square = new double[evidence.measured(output).length];
            for (Channel rate : rates) {
                double[] w = evidence.series(rate);
                for (int i = 0; i < square.length; i++) {
                    square[i] -= w[i] * w[i];
                }
            }
            add(evidence, whitening, names, owners, columns, output, "height", square, HEIGHT);
        }
    }

    /** Angle from rate, what is slower than a tenth of a hertz left out. */
    private static double[] integrated(double[] rate, double step) {
        double[] out = new double[rate.length];
        double decay = Math.exp(-2 * Math.PI * 0.1 * step);
        for (int i = 1; i < out.length; i++) {
            out[i] = decay * (out[i - 1] + step * (rate[i] + rate[i - 1]) / 2);
        }
        return out;
    }

    private static void add(Evidence evidence, Whitening whitening, List<String> names, List<Integer> owners,
                            List<double[]> columns, int output, String name,
                            double[] series, double deviation) {
        double[][] spectra = new double[evidence.outputs().size()][0];
        double[] scaled = new double[series.length];
        for (int i = 0; i < scaled.length; i++) {
            scaled[i] = deviation * series[i];
        }
        spectra[output] = whitening.window().spectrum(scaled, evidence.valid(output));
        names.add(evidence.outputs().get(output) + " " + name);
        owners.add(output);
        columns.add(whitening.whiten(spectra));
    }

    /** Time derivative by central differences, raised to be right to third order. */
    private static double[] slope(double[] x, double step) {
        double[] out = new double[x.length];
        for (int i = 2; i + 2 < x.length; i++) {
            out[i] = (8 * (x[i + 1] - x[i - 1]) - (x[i + 2] - x[i - 2])) / (12 * step);
        }
        return out;
    }

    private Nuisances(List<String> names, List<Integer> owners, double[][] columns) {
        this.names = names;
        this.owners = owners;
        this.columns = columns;
        gram = new double[columns.length][columns.length];
        for (int i = 0; i < columns.length; i++) {
            for (int j = 0; j <= i; j++) {
                gram[i][j] = Fitter.dot(columns[i], columns[j]);
                gram[j][i] = gram[i][j];
            }
        }
    }

    /** The errors of sensors that a candidate holds at fault in the same way: there the fault says it all. */
    boolean[] off(Candidate candidate) {
        boolean[] out = new boolean[columns.length];
        for (Hypothesis hypothesis : candidate.added()) {
            for (Hypothesis.Addition addition : hypothesis.additions()) {
                for (int i = 0; i < out.length && addition instanceof Hypothesis.Addition.AtSensor; i++) {
                    Hypothesis.Addition.AtSensor at = (Hypothesis.Addition.AtSensor) addition;
                    out[i] |= at.output() == owners.get(i) && names.get(i).contains(like(at.fault()));
                }
            }
        }
        return out;
    }

    /** What the small error is called that a fault is a large one of; a fault of another kind leaves all small ones as they are. */
    private static String like(SensorFault fault) {
        return fault instanceof SensorFault.Gain ? " gain" : fault instanceof SensorFault.Delay ? " delay"
                : fault instanceof SensorFault.Misalignment ? " tilt" : fault instanceof SensorFault.LeverArm ? " arm" : "none";
    }

    int count() {
        return names.size();
    }

    String name(int i) {
        return names.get(i);
    }

    double[] column(int i) {
        return columns[i];
    }

    /** Products of a whitened vector with all columns. */
    double[] products(double[] vector) {
        double[] out = new double[columns.length];
        for (int i = 0; i < out.length; i++) {
            out[i] = Fitter.dot(columns[i], vector);
        }
        return out;
    }

    /** What the errors make of a residual. @param errors in standard deviations @param square what is left, as a sum of squares */
    record Explained(double[] errors, double square) { }

    /**
     * The errors that explain a residual best: least |r - D n|² + |n|² within the bounds, by coordinate descent.
     *
     * @param off errors that are not asked, see {@link #off}
     */
    Explained explain(double[] residual, boolean[] off) {
        double[] n = new double[columns.length];
        double[] products = products(residual);
        double[] g = products.clone();   // Dᵀ(r - D n) at n = 0
        for (int sweep = 0; sweep < SWEEPS; sweep++) {
            double moved = 0;
            for (int i = 0; i < n.length; i++) {
                if (off[i]) {
                    continue;
                }
                double next = Math.max(-MOST, Math.min(MOST, (g[i] + gram[i][i] * n[i]) / (gram[i][i] + 1)));
                double change = next - n[i];
                if (change != 0) {
                    for (int j = 0; j < n.length; j++) {
                        g[j] -= gram[i][j] * change;
                    }
                    n[i] = next;
                    moved = Math.max(moved, Math.abs(change));
                }
            }
            if (moved < 1e-6) {
                break;
            }
        }
        // |r - D n|² = |r|² - n·(Dᵀr + Dᵀ(r - D n))
        return new Explained(n, Math.max(0, Fitter.dot(residual, residual) - Fitter.dot(n, products) - Fitter.dot(n, g)));
    }

    /** The residual without what errors explain. A new array. */
    double[] removed(double[] residual, double[] n) {
        double[] out = residual.clone();
        for (int i = 0; i < n.length; i++) {
            for (int k = 0; k < out.length && n[i] != 0; k++) {
                out[k] -= columns[i][k] * n[i];
            }
        }
        return out;
    }

    /** Whether an error stands at its bound and so takes no part in small changes. */
    static boolean held(double value) {
        return Math.abs(value) >= MOST - 1e-9;
    }

    double gram(int i, int j) {
        return gram[i][j];
    }
}
