package wbv.identify;

import java.io.Serializable;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import wbv.signal.RealDft;

/**
 * A body of one mode of whose damping a share acts against its base and the rest against rest:
 * {@code H = (2κζω s + ω²)/(s² + 2ζω s + ω²)}. The slowest mode of a chain seen from its base, where the others are stiff.
 *
 * @param frequency natural frequency [Hz], &gt; 0
 * @param damping   damping ratio ζ [1], &gt; 0
 * @param baseShare κ [1]
 */
public record SkyhookBody(double frequency, double damping, double baseShare) implements Serializable {

    /** Motion of before the stretch that a fit leaves aside [s]. */
    private static final double SETTLING = 2;
    /** Where fits begin: natural frequencies [Hz], damping ratio, share. */
    private static final double[] FREQUENCIES = {2.5, 4, 6, 9};
    private static final double DAMPING = 0.35;
    private static final double SHARE = 0.7;

    public SkyhookBody {
        if (!(frequency > 0 && damping > 0) || !Double.isFinite(frequency + damping + baseShare)) {
            throw new IllegalArgumentException("a body needs a natural frequency > 0 Hz, a damping ratio > 0 and a finite share: "
                    + frequency + ", " + damping + ", " + baseShare);
        }
    }

    /**
     * The body that simulates a stretch best, after what other motions of the base can explain is taken out of both. The input is
     * taken for band-limited, as sensors give it.
     *
     * @param rate   samples per second [Hz]
     * @param u      input by sample, in its own unit, without offset and gaps. Not modified.
     * @param others other motions, likewise. Not modified.
     * @param y      output, likewise. Not modified.
     * @return empty if nothing moves, or the motions cannot be told apart
     */
    public static Optional<SkyhookBody> of(double rate, double[] u, double[][] others, double[] y) {
        RealDft dft = new RealDft(RealDft.covering(u.length + (int) Math.ceil(2 * SETTLING * rate)));
        double[] weight = new double[y.length];
        Arrays.fill(weight, Math.min(weight.length, (int) (SETTLING * rate)), weight.length, 1);
        CrossMotions.Explaining taken = new CrossMotions(rate, others, y.length).on(weight)
                .by(IntStream.range(0, others.length).boxed().toList());
        if (!taken.sound()) {
            return others.length == 0 ? Optional.empty() : of(rate, u, new double[0][], y);
        }
        EquivalentBodyFit fit = new EquivalentBodyFit(rate, dft, dft.forward(Arrays.copyOf(u, dft.length())), y, weight, taken,
                ModalBody.withSkyhook());
        double[] best = new double[0];
        double least = Double.POSITIVE_INFINITY;
        for (double f : FREQUENCIES) {
            double[] theta = {Math.log(2 * Math.PI * f), Math.log(DAMPING), SHARE};
            double cost = fit.cost(theta);
            if (cost < least) {
                least = cost;
                best = theta;
            }
        }
        if (best.length == 0 || !(least > 0)) {
            return Optional.empty();
        }
        fit.minimise(best);
        return Optional.of(new SkyhookBody(ModalBody.frequency(best, 0), ModalBody.damping(best, 0), best[2]));
    }

    /** The mean of bodies, at least one. */
    public static SkyhookBody mean(List<SkyhookBody> bodies) {
        return new SkyhookBody(bodies.stream().mapToDouble(SkyhookBody::frequency).average().orElseThrow(),
                bodies.stream().mapToDouble(SkyhookBody::damping).average().orElseThrow(),
                bodies.stream().mapToDouble(SkyhookBody::baseShare).average().orElseThrow());
    }

    /**
     * Output by sample from a band-limited input, in its unit, at rest before it.
     *
     * @param u by sample, in its own unit, without gaps. Not modified.
     * @param rate [Hz]
     */
    public double[] simulate(double[] u, double rate) {
        RealDft dft = new RealDft(RealDft.covering(u.length + (int) Math.ceil(2 * SETTLING * rate)));
        double[] spectrum = dft.forward(Arrays.copyOf(u, dft.length()));
        ModalBody body = ModalBody.withSkyhook();
        double[] theta = {Math.log(2 * Math.PI * frequency), Math.log(damping), baseShare};
        for (int k = 0; k <= dft.length() / 2; k++) {
            body.at(theta, 2 * Math.PI * rate * k / dft.length());
            double re = spectrum[2 * k];
            double im = spectrum[2 * k + 1];
            spectrum[2 * k] = body.re()[0] * re - body.im()[0] * im;
            spectrum[2 * k + 1] = k == 0 || 2 * k == dft.length() ? 0 : body.re()[0] * im + body.im()[0] * re;
        }
        return dft.inverse(spectrum, u.length);
    }
}
