package wbv.body.simulate;

import java.util.Arrays;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.signal.Detrend;
import wbv.signal.PowerSpectrum;
import wbv.signal.Segmentation;

/**
 * How a sensor's anti-alias filter rolls off, read from its own noise: white inside, the noise of the base's sensor falls above the
 * excitation as the filter does. Base and outputs pass the same filter, so it cancels in what is linear; what a law adds inside the
 * body has to pass it too.
 */
final class RollOff {

    private static final int SEGMENT = 512;
    private static final double FROM = 0.25;
    private static final double FLAT = 0.37;

    private final double[] gain;

    private RollOff(double[] gain) {
        this.gain = gain;
    }

    /** As the axes of one place show it; no filter at all where the recording is too short to tell. */
    static RollOff of(Recording recording, Channel input) {
        int bins = SEGMENT / 2 + 1;
        double[] density = new double[bins];
        for (Channel channel : recording.channels()) {
            if (!channel.location().equals(input.location()) || channel.quantity() != input.quantity()) {
                continue;
            }
            PowerSpectrum spectrum = new PowerSpectrum(new Segmentation(recording.clock().rate(), SEGMENT, 0.5), Detrend.MEAN);
            for (double value : recording.values(channel)) {
                spectrum.accept(value);
            }
            if (spectrum.averaged() > 0) {
                double[] own = spectrum.density();
                double level = mean(own, FROM, FLAT);
                for (int k = 0; k < bins; k++) {
                    density[k] += own[k] / level;
                }
            }
        }
        double level = mean(density, FROM, FLAT);
        double[] gain = new double[bins];
        Arrays.fill(gain, 1);
        for (int k = (int) (FLAT * SEGMENT); k < bins && level > 0; k++) {
            double sum = 0;
            int count = 0;
            for (int i = Math.max(0, k - 2); i <= Math.min(bins - 1, k + 2); i++) {
                sum += density[i];
                count++;
            }
            gain[k] = Math.sqrt(Math.min(1, sum / count / level));
        }
        return new RollOff(gain);
    }

    private static double mean(double[] density, double from, double to) {
        return Arrays.stream(density, (int) (from * SEGMENT), (int) (to * SEGMENT)).average().orElse(0);
    }

    /** The filter's gain at a frequency in units of the sampling rate, 0 to 0.5. */
    double at(double relative) {
        double at = Math.min(relative * SEGMENT, gain.length - 1.0);
        int k = Math.min((int) at, gain.length - 2);
        return gain[k] + (at - k) * (gain[k + 1] - gain[k]);
    }
}
