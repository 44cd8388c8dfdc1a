package wbv.pole;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.signal.FrequencyResponse;

/**
 * A prediction without sensors beside what the sensors said after all. Samples before the first pole was measured do not count.
 *
 * @param name      of the recording
 * @param channel   absent channel
 * @param from      first sample that counts
 * @param error     mean square of the difference over the variance, constants left out [1]
 * @param meanError the same of the population's mean body of one degree
 * @param measured  transmissibility from the base, as the sensors say
 * @param said      as predicted
 */
public record RemovalCheck(String name, Channel channel, int from, double error, double meanError, FrequencyResponse measured,
        FrequencyResponse said) {

    /** Compares, for every absent channel that the recording has after all. */
    public static List<RemovalCheck> of(TrainedPoles trained, String name, Recording recording,
            SensorRemoval.Prediction prediction) {
        if (prediction.seen().isEmpty()) {
            throw DataFault.in(name, "no pole of " + trained.layout().measured()
                    + " was found in any window of " + trained.windows().length()
                    + " s; the check needs a longer recording, or more motion of the base");
        }
        List<RemovalCheck> checks = new ArrayList<>();
        double rate = recording.clock().rate();
        double[] u = recording.values(trained.layout().base());
        int from = (int) prediction.seen().get(0).sample();
        for (Channel channel : trained.layout().absent()) {
            if (recording.has(channel)) {
                double[] truth = recording.values(channel);
                double[] motion = prediction.motion().get(channel);
                double[] body = trained.bodies().get(channel).simulate(PoleWindows.centred(PoleWindows.quiet(u), 0, u.length), rate);
                checks.add(new RemovalCheck(name, channel, from, error(truth, motion, from), error(truth, body, from),
                        TransmissibilityPeak.response(u, truth, from, rate), TransmissibilityPeak.response(u, motion, from, rate)));
            }
        }
        return checks;
    }

    /** Predicted less measured frequency of the peak [Hz]; empty if either has none. */
    public Optional<Double> frequencyOff() {
        return TransmissibilityPeak.of(measured).flatMap(a -> TransmissibilityPeak.of(said).map(b -> b.frequency() - a.frequency()));
    }

    /** Predicted less measured magnitude of the peak; empty if either has none. */
    public Optional<Double> magnitudeOff() {
        return TransmissibilityPeak.of(measured).flatMap(a -> TransmissibilityPeak.of(said).map(b -> b.magnitude() - a.magnitude()));
    }

    /** Mean square of a difference over the variance of the truth, from a sample on; missing samples do not count. */
    static double error(double[] truth, double[] said, int from) {
        double mean = 0;
        double difference = 0;
        int n = 0;
        for (int k = from; k < truth.length; k++) {
            if (Double.isFinite(truth[k])) {
                mean += truth[k];
                difference += truth[k] - said[k];
                n++;
            }
        }
        mean /= n;
        difference /= n;
        double squares = 0;
        double power = 0;
        for (int k = from; k < truth.length; k++) {
            if (Double.isFinite(truth[k])) {
                double e = truth[k] - said[k] - difference;
                squares += e * e;
                power += (truth[k] - mean) * (truth[k] - mean);
            }
        }
        return squares / power;
    }
}
