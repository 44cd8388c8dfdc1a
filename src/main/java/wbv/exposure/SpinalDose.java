package wbv.exposure;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleConsumer;

/**
 * Acceleration dose of the lumbar spine from vertical shocks (ISO 2631-5:2018 clause 5):
 * {@code Dz = 1.07 (Σ A_i⁶)^(1/6)} over the positive peaks of the spine's acceleration, a peak being the greatest value between
 * two zero crossings. Takes values of the spine's acceleration; see {@link #filter}.
 */
public final class SpinalDose implements DoubleConsumer {

    private static final double AMPLITUDE = 1.07;
    /** The seat's acceleration is to be free of gravity and bias; the spine's response is 1 at 0 Hz. [Hz] */
    private static final double HIGH_PASS = 0.1;

    private double peak;
    private double sum;
    private long peaks;

    /** Seat to spine, clause 5.2 Formula 1, behind a high-pass of second order at 0.1 Hz that takes gravity out. */
    public static AnalogFilter filter() {
        List<AnalogSection> sections = new ArrayList<>(spine().sections());
        sections.add(AnalogSection.highPass(HIGH_PASS, Math.sqrt(0.5)));
        return new AnalogFilter(sections, HIGH_PASS);
    }

    /** Seat to spine alone. */
    static AnalogFilter spine() {
        return new AnalogFilter(List.of(AnalogSection.resonance(34, 0.35, 31, 0.21), pole(230, 0.88), pole(260, 0.80),
                pole(320, 0.40), pole(380, 0.75), pole(420, 0.65)), 31 / (2 * Math.PI));
    }

    private static AnalogSection pole(double w, double damping) {
        return new AnalogSection(1, 0, 0, 1, 2 * damping / w, 1 / (w * w));
    }

    /** Takes the next value [m/s²]; a missing one (NaN) ends a peak. */
    @Override
    public void accept(double value) {
        if (value > 0) {
            peak = Math.max(peak, value);
        } else if (peak > 0) {
            sum += Math.pow(peak, 6);
            peaks++;
            peak = 0;
        }
    }

    /** Dose Dz up to now [m/s²], a peak that goes on included. */
    public double dose() {
        return AMPLITUDE * Math.pow(sum + Math.pow(peak, 6), 1.0 / 6);
    }

    /** Peaks counted. */
    public long peaks() {
        return peaks + (peak > 0 ? 1 : 0);
    }

    /**
     * Dose of a day of one task, {@code Dz (td/tm)^(1/6)} [m/s²].
     *
     * @param dose Dz [m/s²]
     * @param daily td, in the unit of tm
     * @param measured tm, in the same unit
     */
    public static double daily(double dose, double daily, double measured) {
        return dose * Math.pow(daily / measured, 1.0 / 6);
    }

    /**
     * Dose of a day of several tasks, {@code (Σ Dzd_j⁶)^(1/6)} [m/s²].
     *
     * @param doses of the tasks in a day [m/s²]
     */
    public static double together(double... doses) {
        double all = 0;
        for (double each : doses) {
            all += Math.pow(each, 6);
        }
        return Math.pow(all, 1.0 / 6);
    }
}
