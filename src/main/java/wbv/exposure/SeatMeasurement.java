package wbv.exposure;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import wbv.recording.Metadata;
import wbv.recording.inspect.Inspection;
import wbv.signal.Envelope;
import wbv.signal.ThirdOctaves;

/**
 * What one recording says of the vibration that someone sits in.
 *
 * @param inspection     what was found in the recording
 * @param metadata       what is known about it
 * @param place          where the vibration was measured
 * @param boxcar         true if the droop of integrating sensors was undone
 * @param axes           by axis that was measured; at least one
 * @param base           the same below the seat, for its SEAT values; empty where that was not measured
 * @param basePlace      where that is, if anywhere
 * @param comfort        r.m.s. by axis of comfort that was measured, without k
 * @param sickness       vertical, weighted with Wf
 * @param spine          vertical dose of ISO 2631-5
 * @param histories      by axis
 * @param spectra        by axis; empty where the recording is too short for any
 * @param unit           that the seat's acceleration may be in g, where nothing says that it is in m/s²; one of the remarks
 * @param remarks        what the reader has to know, gravest first
 */
public record SeatMeasurement(Inspection inspection, Metadata metadata, String place, boolean boxcar,
        Map<SeatAxis, Vibration> axes, Map<SeatAxis, Vibration> base, Optional<String> basePlace,
        Map<ComfortAxis, Double> comfort, Optional<Vibration> sickness, Optional<Spine> spine,
        Map<SeatAxis, History> histories, Map<SeatAxis, Spectrum> spectra, Optional<Remark> unit,
        List<Remark> remarks) {

    /**
     * What ISO 2631-5 makes of vertical shocks.
     *
     * @param dose Dz of the time measured [m/s²]
     * @param peaks that make it up
     * @param seconds measured
     */
    public record Spine(double dose, long peaks, double seconds) {}

    /**
     * Weighted acceleration and its running r.m.s. over 1 s, drawn small.
     *
     * @param step between the values they hold [s]
     */
    public record History(Envelope weighted, Envelope running, double step) {}

    /** One-third-octave r.m.s. values [m/s²], as measured and weighted; the same bands. */
    public record Spectrum(ThirdOctaves measured, ThirdOctaves weighted) {}

    /**
     * The recording as one of a day's tasks.
     *
     * @param minutes daily [min]
     */
    public DailyTask task(String name, double minutes) {
        Map<SeatAxis, Vibration.Level> levels = new EnumMap<>(SeatAxis.class);
        axes.forEach((axis, vibration) -> levels.put(axis, vibration.level()));
        return new DailyTask(name, minutes, levels);
    }

    /** SEAT value by r.m.s. [1], seat over base with the seat's weighting; empty where one of them is missing. Thesis: Eq. 2-10. */
    public OptionalDouble seatFactor(SeatAxis axis) {
        return base.containsKey(axis) ? OptionalDouble.of(axes.get(axis).rms() / base.get(axis).rms()) : OptionalDouble.empty();
    }

    /** SEAT value by dose [1], for shocks; empty where one of them is missing. */
    public OptionalDouble seatFactorByDose(SeatAxis axis) {
        return base.containsKey(axis) ? OptionalDouble.of(axes.get(axis).vdv() / base.get(axis).vdv()) : OptionalDouble.empty();
    }

    /** The bands that the sampling rate covers. */
    public CoveredBand band(SeatAxis axis) {
        return CoveredBand.of(axis.weighting(), inspection.clock().rate());
    }
}
