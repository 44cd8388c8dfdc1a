package wbv.study.seat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import wbv.control.SeatHardware;
import wbv.control.trial.Comparison;
import wbv.control.trial.ControllerFamily;
import wbv.control.trial.EarthMover;
import wbv.control.trial.Floor;
import wbv.control.trial.Front;

/**
 * A comparison of controlled seats for machines; {@code wbv seat} writes it as {@code seat.json}.
 *
 * @param format     always {@code wbv-seat}
 * @param version of the form, 1
 * @param simulated  true: nobody was shaken for it
 * @param provenance what made it
 * @param seat the hardware
 * @param settle_s ridden but not judged
 * @param seconds judged of each ride
 * @param gains      by family, what knowing the sitter is worth at equal stroke
 */
public record SeatResults(String format, int version, boolean simulated, Map<String, String> provenance, SeatHardware seat, double settle_s,
        double seconds, double jolt_m_s2, long seed, List<Surface> floors, Map<String, Comparison.Gain> gains) {

    /**
     * What came of it on one floor.
     *
     * @param limit of SEAT, assumed; empty for roads
     * @param skyhook_Ns_per_m whose stroke all are given
     * @param damper which controller a damper does best with, under the middle sitter
     */
    public record Surface(String floor, String description, double rms_m_s2, Optional<Double> limit, double skyhook_Ns_per_m,
            String damper, List<Summary> at_equal_stroke, List<Rider> sitters) {}

    /** Mean over sitters; the greatest stroke is the greatest of all. */
    public record Summary(String controller, String knowledge, Front.AtStroke mean) {}

    /**
     * What came of it under one sitter.
     *
     * @param stroke_rms_m that all are given
     */
    public record Rider(String sitter, double mass_kg, double stroke_rms_m, List<Front> fronts) {}

    static SeatResults of(Comparison comparison, Map<String, String> provenance) {
        Comparison.Request asked = comparison.request();
        Map<String, Comparison.Gain> gains = new TreeMap<>();
        for (ControllerFamily family : ControllerFamily.values()) {
            comparison.gain(family).ifPresent(gain -> gains.put(family.word(), gain));
        }
        return new SeatResults("wbv-seat", 1, true, provenance, asked.hardware(), asked.settle(), asked.seconds(), asked.jolt(),
                asked.seed(), comparison.floors().stream().map(floor -> surface(comparison, floor)).toList(), gains);
    }

    private static Surface surface(Comparison comparison, Comparison.OnFloor on) {
        List<Summary> summaries = comparison.entrants().stream().flatMap(entrant -> on.mean(entrant)
                .map(mean -> new Summary(entrant.family().word(), entrant.knowledge().word(), mean)).stream()).toList();
        return new Surface(on.floor().word(), on.floor().description(), on.floor().rms(), limit(on.floor()), on.skyhook(),
                on.damper().word(), summaries,
                on.sitters().stream().map(one -> new Rider(one.words(), one.mass(), one.stroke(), one.fronts())).toList());
    }

    private static Optional<Double> limit(Floor floor) {
        return floor instanceof EarthMover mover ? Optional.of(mover.limit()) : Optional.empty();
    }
}
