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

    /** Takes the next sample, of any unit, and gives what comes out, in that unit times the gain. */
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

    /**
     * The same for two samples.
     *
     * @param pair in time order; what comes out takes their place. Modified.
     */
    void step(double[] pair) {
        double x0 = pair[0];
        double x1 = pair[1];
        for (int s = 0, c = 0; s < state.length; s += 2, c += COEFFICIENTS) {
            double b0 = coefficients[c];
            double b1 = coefficients[c + 1];
            double b2 = coefficients[c + 2];
            double a1 = coefficients[c + 3];
            double a2 = coefficients[c + 4];
            double s1 = state[s];
            double s2 = state[s + 1];
            double y0 = b0 * x0 + s1;
            s1 = b1 * x0 - a1 * y0 + s2;
            s2 = b2 * x0 - a2 * y0;
            double y1 = b0 * x1 + s1;
            state[s] = b1 * x1 - a1 * y1 + s2;
            state[s + 1] = b2 * x1 - a2 * y1;
            x0 = y0;
            x1 = y1;
        }
        pair[0] = x0;
        pair[1] = x1;
    }

    /**
     * Goes to the state in which a constant input has always been there.
     *
     * @param value of any unit
     */
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

    /**
     * The complex response.
     *
     * @param frequency as a part of the rate
     * @param response real and imaginary part. Modified.
     */
    void response(double frequency, double[] response) {
        double cos = Math.cos(2 * Math.PI * frequency);
        double sin = -Math.sin(2 * Math.PI * frequency);
        double cos2 = Math.cos(4 * Math.PI * frequency);
        double sin2 = -Math.sin(4 * Math.PI * frequency);
        double re = 1;
        double im = 0;
        for (int c = 0; c < coefficients.length; c += COEFFICIENTS) {
            double upRe = coefficients[c] + coefficients[c + 1] * cos + coefficients[c + 2] * cos2;
            double upIm = coefficients[c + 1] * sin + coefficients[c + 2] * sin2;
            double downRe = 1 + coefficients[c + 3] * cos + coefficients[c + 4] * cos2;
            double downIm = coefficients[c + 3] * sin + coefficients[c + 4] * sin2;
            double size = downRe * downRe + downIm * downIm;
            double ownRe = (upRe * downRe + upIm * downIm) / size;
            double ownIm = (upIm * downRe - upRe * downIm) / size;
            double next = re * ownRe - im * ownIm;
            im = re * ownIm + im * ownRe;
            re = next;
        }
        response[0] = re;
        response[1] = im;
    }

    /**
     * Takes the memory of another of the same biquads.
     *
     * @param memory two for each. Not modified.
     */
    void become(double[] memory) {
        System.arraycopy(memory, 0, state, 0, state.length);
    }

    /** The coefficients b0 b1 b2 a1 a2 [1] of each biquad in turn, as long as five times their number. A copy. */
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
