package wbv.control.trial;

import java.util.Optional;

/**
 * A sitter of 75 kg who becomes one of 55 kg in the middle of a ride, beside the same ride with the latter from its beginning.
 *
 * @param floor   on which
 * @param family of the scheduled controller
 * @param seconds after which the weighted acceleration of the seat, r.m.s. over 5 s, stays within 5 % of that beside it; infinite if it
 *                never does
 * @param later   ratio of the two from 10 s after the change on
 */
public record Recovery(Floor floor, ControllerFamily family, double seconds, double later) {

    private static final double BEFORE = 20;
    private static final double AFTER = 40;
    private static final double WINDOW = 5;
    private static final double ALIKE = 1.05;

    static Recovery of(Maker maker, ControllerFamily family, double tuning, long seed) {
        Ride changing = new Ride(Sitters.ofMass(75), maker.floor(), 6, BEFORE + AFTER, seed)
                .with(new Faults(0, Optional.empty(), 0, Optional.of(new Faults.Change(Sitters.ofMass(55), BEFORE))));
        double[] changed = squares(maker, family, tuning, changing);
        double[] always = squares(maker, family, tuning, new Ride(Sitters.ofMass(55), maker.floor(), 6, BEFORE + AFTER, seed));
        double recovered = 0;
        for (double end = WINDOW; end <= AFTER; end += 0.5) {
            if (Math.sqrt(mean(changed, end - WINDOW, end) / mean(always, end - WINDOW, end)) > ALIKE) {
                recovered = end - WINDOW + 0.5; // the change has left the window's beginning by then
            }
        }
        boolean never = recovered > AFTER - WINDOW;
        return new Recovery(maker.floor(), family, never ? Double.POSITIVE_INFINITY : recovered,
                Math.sqrt(mean(changed, 10, AFTER) / mean(always, 10, AFTER)));
    }

    /** Mean squares of hundredths of a second from the change on. */
    private static double[] squares(Maker maker, ControllerFamily family, double tuning, Ride ride) {
        double[] sums = new double[(int) (100 * AFTER)];
        new SeatTrial(maker.hardware(), ride).run(maker, family, Knowledge.SCHEDULED, tuning,
                (time, floor, seat, deflection, weightedSeat, weightedFloor) -> {
                    int place = (int) Math.floor(100 * (time - BEFORE));
                    if (place >= 0 && place < sums.length) {
                        sums[place] += weightedSeat * weightedSeat;
                    }
                });
        return sums;
    }

    private static double mean(double[] squares, double from, double to) {
        double sum = 0;
        for (int i = (int) Math.round(100 * from); i < Math.round(100 * to); i++) {
            sum += squares[i];
        }
        return sum / (100 * (to - from));
    }
}
