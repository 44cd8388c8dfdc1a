package wbv.body;

import java.util.List;
import java.util.stream.IntStream;
import wbv.body.number.Check;

/**
 * What the anti-alias filter of all sensors lets through towards half the sampling rate, the same of base and outputs: it goes with the
 * rate, whatever that is. Straight between the points given, as the nearest of them beyond.
 *
 * @param ofRate frequency over the sampling rate [1], by point, ascending within 0 to 0.5
 * @param gain amplitude that is let through [1], by point, 0 to 1
 */
public record SensorFilter(List<Double> ofRate, List<Double> gain) {

    private static final double NYQUIST = 0.5;

    public SensorFilter {
        ofRate = List.copyOf(ofRate);
        gain = List.copyOf(gain);
        if (ofRate.isEmpty() || ofRate.size() != gain.size()) {
            throw new IllegalArgumentException("an anti-alias filter has as many gains as frequencies, one at least: " + ofRate.size()
                    + " 'of_rate', " + gain.size() + " 'gain'");
        }
        ofRate.forEach(at -> Check.within("frequency of the anti-alias filter over the rate", "1", at, 0, NYQUIST));
        gain.forEach(part -> Check.within("gain of the anti-alias filter", "1", part, 0, 1));
        List<Double> at = ofRate;
        if (IntStream.range(1, at.size()).anyMatch(i -> !(at.get(i) > at.get(i - 1)))) {
            throw new IllegalArgumentException("the frequencies of an anti-alias filter ascend: " + ofRate);
        }
    }

    /** Whether everything passes. */
    public boolean isOpen() {
        return gain.stream().allMatch(part -> part == 1);
    }

    /**
     * The amplitude that it lets through [1].
     *
     * @param relative frequency over the sampling rate [1], 0 to 0.5
     */
    public double at(double relative) {
        int above = 0;
        while (above < ofRate.size() && ofRate.get(above) < relative) {
            above++;
        }
        if (above == 0 || above == ofRate.size()) {
            return gain.get(Math.min(above, ofRate.size() - 1));
        }
        double from = ofRate.get(above - 1);
        return gain.get(above - 1) + (relative - from) / (ofRate.get(above) - from) * (gain.get(above) - gain.get(above - 1));
    }
}
