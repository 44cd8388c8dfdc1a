package wbv.fleet;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import wbv.seat.SeatResult;

/**
 * What came of a run over all seats, for people and, by its components, for machines.
 *
 * @param seats                     that were followed
 * @param samples                   of all seats, in this run and those that it went on with
 * @param resumed_behind            packets of the runs before, 0 for a run from the beginning
 * @param samples_per_second_a_core taken by one core [1/s]; NaN where that was not measured
 * @param packets                   taken
 * @param came_twice                packets that were there already
 * @param too_late                  packets behind what was waited for
 * @param lost                      packets
 * @param lost_samples              of all seats
 * @param worst                     seats by A(8), the worst first
 */
public record FleetSummary(int seats, long samples, long resumed_behind, double samples_per_second_a_core, long packets, long came_twice,
        long too_late, long lost, long lost_samples, List<Worst> worst) {

    private static final int NAMED = 10;

    public FleetSummary {
        worst = List.copyOf(worst);
    }

    /**
     * One of the seats worst off.
     *
     * @param a8_m_per_s2 daily exposure [m/s²]
     * @param vdv_m_per_s175 dose [m/s^1.75]
     * @param minutes_to_action_value [min]
     * @param minutes_to_limit_value [min]
     */
    public record Worst(String seat, double a8_m_per_s2, double vdv_m_per_s175, double minutes_to_action_value,
            double minutes_to_limit_value, long lost_samples) {}

    /** What a run came to, with the ten seats worst off. */
    public static FleetSummary of(FleetRun.Outcome outcome) {
        long packets = 0;
        long twice = 0;
        long late = 0;
        long lost = 0;
        long samples = 0;
        for (SeatResult seat : outcome.seats()) {
            packets += seat.losses().packets();
            twice += seat.losses().twice();
            late += seat.losses().late();
            lost += seat.losses().lost();
            samples += seat.losses().samples();
        }
        List<Worst> worst = outcome.seats().stream().filter(each -> each.exposure().isPresent())
                .sorted(Comparator.comparingDouble(each -> -each.exposure().get().a8())).limit(NAMED)
                .map(each -> worst(each.seat(), each.exposure().get(), each.losses().samples())).toList();
        double speed = outcome.taken() > 0 && outcome.processor() > 0 ? outcome.samplesPerCore() : Double.NaN;
        return new FleetSummary(outcome.seats().size(), outcome.samples(), outcome.resumed(), speed, packets, twice, late, lost, samples,
                worst);
    }

    private static Worst worst(String seat, SeatResult.Exposure exposure, long lost) {
        return new Worst(seat, exposure.a8(), exposure.vdv(), exposure.minutesToAction(), exposure.minutesToLimit(), lost);
    }

    /**
     * The same in lines for people.
     *
     * @param rate of the samples of one seat [Hz]
     */
    public String text(double rate) {
        StringBuilder text = new StringBuilder();
        if (resumed_behind > 0) {
            text.append("Went on behind packet ").append(resumed_behind).append(".\n");
        }
        text.append(String.format(Locale.ROOT, "%d seats, %d samples", seats, samples));
        if (!Double.isNaN(samples_per_second_a_core)) {
            text.append(String.format(Locale.ROOT, "; %.2f µs of processor time a sample: %.0f samples/s a core, which carries %.0f seats",
                    1e6 / samples_per_second_a_core, samples_per_second_a_core, samples_per_second_a_core / rate));
        }
        text.append(String.format(Locale.ROOT, "%nPackets: %d taken, %d came twice, %d too late, %d lost (%d samples)%n", packets,
                came_twice, too_late, lost, lost_samples));
        if (!worst.isEmpty()) {
            text.append(String.format(Locale.ROOT, "%-12s %10s %12s %14s %13s %12s%n", "worst seats", "A(8) m/s²", "VDV m/s^1.75",
                    "min to action", "min to limit", "lost samples"));
        }
        for (Worst each : worst) {
            text.append(String.format(Locale.ROOT, "%-12s %9.3f %12.2f %14.0f %13.0f %12d%n", each.seat(), each.a8_m_per_s2(),
                    each.vdv_m_per_s175(), each.minutes_to_action_value(), each.minutes_to_limit_value(), each.lost_samples()));
        }
        return text.toString();
    }
}
