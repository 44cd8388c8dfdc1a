package wbv.state;

import java.util.Optional;
import wbv.recording.Recording;
import wbv.signal.CrossSpectrum;
import wbv.signal.Detrend;
import wbv.signal.FrequencyResponse;
import wbv.signal.Segmentation;

/**
 * What a recording says of the way from seat to head: how much later the head jerks, and the body of one degree of freedom that would
 * do that (the use that the thesis promises in section 7.2).
 *
 * <p>The lag is that of {@link HeadLag}. The body solves ω² (T - 1) + 2ζω · jw (T - 1) = w² T by least squares over the transfer
 * function T from jerks of the seat to those of the head about the samples that jerk, from 1 to 8 Hz, weighted by coherence and power.
 *
 * @param lag       of the head behind the seat; empty where too little jerks
 * @param frequency natural, undamped [Hz]; NaN where no body does that
 * @param damping ratio; NaN likewise
 * @param samples   that jerk
 */
public record SeatToHead(Optional<HeadLag.Lag> lag, double frequency, double damping, int samples) {

    private static final double AROUND = 0.25;
    private static final double SEGMENT = 2.2;

    /** From a recording, and where a track says that something jerks. */
    public static SeatToHead of(StateTrack track) {
        int n = track.length();
        double[] seat = new double[n];
        double[] head = new double[n];
        boolean[] jerks = new boolean[n];
        for (int i = 0; i < n; i++) {
            seat[i] = track.told(i) ? track.features()[i][FeatureSpec.SEAT_JERK] : 0;
            head[i] = track.told(i) ? track.features()[i][FeatureSpec.HEAD_JERK] : 0;
            jerks[i] = track.state(i).jerk();
        }
        FeatureSpec features = track.model().features();
        double[] body = body(seat, head, near(jerks, features.rate()), features.rate());
        int samples = 0;
        for (boolean jerk : jerks) {
            samples += jerk ? 1 : 0;
        }
        return new SeatToHead(lag(track.recording(), features, track.model().thresholds()), body[0], body[1], samples);
    }

    private static Optional<HeadLag.Lag> lag(Recording recording, FeatureSpec features, Thresholds thresholds) {
        HeadLag lag = new HeadLag(features.rate(), thresholds.surge(), Double.POSITIVE_INFINITY);
        double[] seat = recording.values(features.seat());
        double[] head = recording.values(features.head());
        for (int i = 0; i < seat.length; i++) {
            lag.accept(seat[i], head[i]);
        }
        return lag.lag();
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
