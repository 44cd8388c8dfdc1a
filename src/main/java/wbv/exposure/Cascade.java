package wbv.exposure;

import java.util.List;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/** Biquads in a row, in transposed direct form II. */
public final class Cascade implements Snapshot {

    private static final int COEFFICIENTS = 5;

    private final double[] coefficients;
    private final double[] state;

    /** @param biquads b0 b1 b2 a1 a2 each, a0 = 1 */
    Cascade(List<double[]> biquads) {
        coefficients = new double[COEFFICIENTS * biquads.size()];
        for (int i = 0; i < biquads.size(); i++) {
            System.arraycopy(biquads.get(i), 0, coefficients, COEFFICIENTS * i, COEFFICIENTS);
        }
        state = new double[2 * biquads.size()];
    }

    /** Another of the same biquads, at rest. */
    Cascade fresh() {
        return new Cascade(coefficients);
    }

    private Cascade(double[] coefficients) {
        this.coefficients = coefficients;
        this.state = new double[2 * coefficients.length / COEFFICIENTS];
    }

    /** Takes the next sample and gives what comes out. */
    public double step(double value) {
        double x = value;
        for (int s = 0, c = 0; s < state.length; s += 2, c += COEFFICIENTS) {
            // y = b0 x + s1, s1 = b1 x - a1 y + s2, s2 = b2 x - a2 y
            double y = coefficients[c] * x + state[s];
            state[s] = coefficients[c + 1] * x - coefficients[c + 3] * y + state[s + 1];
            state[s + 1] = coefficients[c + 2] * x - coefficients[c + 4] * y;
            x = y;
        }
        return x;
    }

    /** Goes to the state in which a constant input has always been there. */
    public void settle(double value) {
        double x = value;
        for (int s = 0, c = 0; s < state.length; s += 2, c += COEFFICIENTS) {
            double y = x * (coefficients[c] + coefficients[c + 1] + coefficients[c + 2])
                    / (1 + coefficients[c + 3] + coefficients[c + 4]);
            state[s + 1] = coefficients[c + 2] * x - coefficients[c + 4] * y;
            state[s] = coefficients[c + 1] * x - coefficients[c + 3] * y + state[s + 1];
            x = y;
        }
    }

    /** The coefficients b0 b1 b2 a1 a2 of each biquad in turn. */
    public double[] coefficients() {
        return coefficients.clone();
    }

    @Override
    public void save(StateWriter out) {
        out.put(state);
    }

    @Override
    public void load(StateReader in) {
        in.numbers(state);
    }
}
