package wbv.network;

import java.util.Arrays;

/**
 * What is read from a window.
 *
 * @param network what the network says, whose deviation grows where the window is unlike those it was trained on
 * @param fitted  the linear body that explains the window best, with what the network says as what is known beforehand; what the
 *                network says where it does not see the excitation
 * @param misfit  how far the window is from what the network and a linear body make of it, over how far all but one in a hundred
 *                windows like those trained on are: the greatest of three such ratios, see {@link Usual}; NaN where not known
 */
public record Reading(Estimate network, Estimate fitted, double misfit) {

    /**
     * Nothing was read.
     *
     * @param targets values that there would be
     */
    static Reading nothing(int targets) {
        double[] nothing = new double[targets];
        Arrays.fill(nothing, Double.NaN);
        Estimate none = new Estimate(nothing, nothing);
        return new Reading(none, none, Double.NaN);
    }

    /** Whether the window was read. */
    public boolean read() {
        return Double.isFinite(network.value()[0]);
    }

    /** Whether the window is unlike any that the network was trained on: its body is another kind, or its sensors are. */
    public boolean unlike() {
        return misfit > 1;
    }
}
