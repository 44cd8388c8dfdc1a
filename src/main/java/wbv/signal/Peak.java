package wbv.signal;

import java.util.Optional;

/**
 * The highest point of a curve, by the parabola through the highest sample and its neighbours.
 *
 * @param frequency where it is [Hz]
 * @param height    its value, in the curve's unit
 */
public record Peak(double frequency, double height) {

    /**
     * The peak of the usable samples; empty if none is usable, or if the highest stands at an end of its run, so that the curve
     * may
     * rise further beyond.
     *
     * @param frequency by bin, rising in equal steps [Hz]
     * @param curve as many values, of any unit
     * @param usable which of them count None is modified.
     */
    public static Optional<Peak> of(double[] frequency, double[] curve, boolean[] usable) {
        int best = -1;
        for (int k = 0; k < curve.length; k++) {
            best = usable[k] && (best < 0 || curve[k] > curve[best]) ? k : best;
        }
        if (best < 1 || best > curve.length - 2 || !usable[best - 1] || !usable[best + 1]) {
            return Optional.empty();
        }
        double left = curve[best - 1];
        double right = curve[best + 1];
        double bend = left - 2 * curve[best] + right;
        double shift = bend < 0 ? (left - right) / (2 * bend) : 0;
        return Optional.of(new Peak(frequency[best] + shift * (frequency[best + 1] - frequency[best]),
                curve[best] - (left - right) * shift / 4));
    }
}
