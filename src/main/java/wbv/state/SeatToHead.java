package wbv.state;

import wbv.signal.CrossSpectrum;
import wbv.signal.Detrend;
import wbv.signal.FrequencyResponse;
import wbv.signal.Segmentation;

/**
 * What the states say of the way from seat to head: how much later the head jerks, and the body of one degree of freedom that
 * would
 * do that (the use that the thesis promises in section 7.2).
 *
 * <p>The states are turned back into jerks, the mean jerk of every state weighted by its probability. The lag is where the
 * correlation of the two, over the samples that jerk, is greatest (a parabola through the three samples about it). The body
 * solves
 * ω² (T - 1) + 2ζω · jw (T - 1) = w² T by least squares over the transfer function T from seat to head, from 1 to 8 Hz,
 * weighted by
 * coherence and power.
 *
 * @param lag       of the head behind the seat [s] @param frequency natural, undamped [Hz]; NaN where no body does that
 * @param damping   ratio; NaN likewise @param samples that jerk
 */
public record SeatToHead(double lag, double frequency, double damping, int samples) {

    private static final double LONGEST = 0.25;
    private static final double AROUND = 0.25;
    private static final double SEGMENT = 2.2;

    /** From what a track says. */
    public static SeatToHead of(StateTrack track) {
        int n = track.length();
        double[] seat = new double[n];
        double[] head = new double[n];
        double[] seatSign = new double[n];
        double[] headSign = new double[n];
        HiddenMarkov chain = track.model().chain();
        for (int i = 0; i < n; i++) {
            for (int k = 0; k < chain.states(); k++) {
                Gaussian gaussian = chain.emissions().get(k).components().get(0);
                seat[i] += track.chain()[i][k] * gaussian.mean(FeatureSpec.SEAT_JERK);
                head[i] += track.chain()[i][k] * gaussian.mean(FeatureSpec.HEAD_JERK);
            }
        }
        boolean[] jerks = new boolean[n];
        for (int i = 0; i < n; i++) {
            jerks[i] = track.state(i).jerk();
            for (MotionState state : track.model().known()) {
                seatSign[i] += track.probability(i, state) * state.seatSign();
                headSign[i] += track.probability(i, state) * state.headSign();
            }
        }
        double rate = track.model().features().rate();
        SeatToHead means = of(seat, head, jerks, rate);
        return new SeatToHead(lag(seatSign, headSign, near(jerks, rate), rate), means.frequency, means.damping, means.samples);
    }

    /**
     * From two signals.
     *
     * @param seat jerk @param head jerk @param jerks which samples count @param rate [Hz]
     */
    public static SeatToHead of(double[] seat, double[] head, boolean[] jerks, double rate) {
        int samples = 0;
        for (boolean jerk : jerks) {
            samples += jerk ? 1 : 0;
        }
        boolean[] near = near(jerks, rate);
        double[] body = body(seat, head, near, rate);
        return new SeatToHead(lag(seat, head, near, rate), body[0], body[1], samples);
    }

    /** Samples that jerk, and a quarter of a second about them. */
    private static boolean[] near(boolean[] jerks, double rate) {
        boolean[] near = new boolean[jerks.length];
        int around = (int) Math.round(AROUND * rate);
        for (int i = 0; i < jerks.length; i++) {
            for (int j = Math.max(0, i - around); jerks[i] && j <= Math.min(near.length - 1, i + around); j++) {
                near[j] = true;
            }
        }
        return near;
    }

    private static double lag(double[] seat, double[] head, boolean[] near, double rate) {
        int longest = (int) Math.round(LONGEST * rate);
        double[] products = new double[2 * longest + 1];
        for (int i = longest; i < seat.length - longest; i++) {
            for (int lag = -longest; near[i] && lag <= longest; lag++) {
                double product = seat[i] * head[i + lag];
                products[longest + lag] += Double.isFinite(product) ? product : 0;
            }
        }
        int best = 1;
        for (int j = 1; j < products.length - 1; j++) {
            best = products[j] > products[best] ? j : best;
        }
        double a = products[best - 1];
        double b = products[best];
        double c = products[best + 1];
        double vertex = a - 2 * b + c < 0 ? 0.5 * (a - c) / (a - 2 * b + c) : 0;
        return b > 0 ? (best - longest + vertex) / rate : Double.NaN;
    }

    private static double[] body(double[] seat, double[] head, boolean[] near, double rate) {
        double[] none = {Double.NaN, Double.NaN};
        CrossSpectrum spectrum = new CrossSpectrum(new Segmentation(rate,
                Integer.highestOneBit((int) Math.round(SEGMENT * rate)), 0.5),
                Detrend.MEAN, 1);
        for (int i = 0; i < seat.length; i++) {
            spectrum.accept(near[i] ? seat[i] : 0, near[i] ? head[i] : 0);
        }
        if (spectrum.averaged(0) < 4) {
            return none;
        }
        FrequencyResponse response = spectrum.response(0, FrequencyResponse.Excited.USUAL);
        double aa = 0;
        double ab = 0;
        double bb = 0;
        double ay = 0;
        double by = 0;
        for (int i = 0; i < response.frequency().length; i++) {
            double f = response.frequency()[i];
            double coherence = response.coherence()[i];
            if (f < 1 || f > 8 || !(coherence > 0.3)) {
                continue;
            }
            double w = 2 * Math.PI * f;
            double re = response.h1().re()[i];
            double im = response.h1().im()[i];
            // Rows of real and imaginary part: ω² (T - 1) + 2ζω · jw (T - 1) = w² T, over w² so that no frequency rules.
            double weight = response.inputDensity()[i] * coherence / (w * w * w * w);
            double[][] rows = {{re - 1, -w * im, w * w * re}, {im, w * (re - 1), w * w * im}};
            for (double[] row : rows) {
                aa += weight * row[0] * row[0];
                ab += weight * row[0] * row[1];
                bb += weight * row[1] * row[1];
                ay += weight * row[0] * row[2];
                by += weight * row[1] * row[2];
            }
        }
        double determinant = aa * bb - ab * ab;
        double square = (ay * bb - by * ab) / determinant;
        double twice = (by * aa - ay * ab) / determinant;
        if (!(determinant > 0 && square > 0 && twice > 0)) {
            return none;
        }
        double omega = Math.sqrt(square);
        return new double[] {omega / (2 * Math.PI), twice / (2 * omega)};
    }
}
