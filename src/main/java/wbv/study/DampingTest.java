package wbv.study;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import wbv.exposure.Meter;
import wbv.exposure.Weighting;
import wbv.identify.EquivalentBodies;
import wbv.identify.EquivalentBody;
import wbv.identify.MotionWindow;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.recording.inspect.RowSource;
import wbv.result.OutputFolder;
import wbv.result.ResultsJson;
import wbv.signal.Peak;
import wbv.signal.Segmentation;

/**
 * A passive seat on a shaker, as a recording of floor and seat shows it: resonance, transmissibility there, damping ratio, SEAT value.
 * ISO 10326-1 is remembered to ask for an inert mass of 75 kg on the seat and a sinusoidal floor that passes through the resonance,
 * and ISO 7096 for a transmissibility at resonance below {@link #LOW_LIMIT} (EM1 to EM4, EM6) or {@link #HIGH_LIMIT} (EM5, EM7 to
 * EM9); neither was at hand, so both are assumed.
 *
 * <p>The transmissibility is measured (H1), and that of the mass on spring and damper which moves as the seat does, simulated from the
 * floor over the whole recording. Friction damps the more, the less the seat moves: numbers hold for the level that was ridden.
 *
 * @param format     always {@code wbv-seat-test}
 * @param version of the form, 1
 * @param provenance what made it
 * @param floor      channel
 * @param seat channel
 * @param seconds of the recording
 * @param seat_value SEAT by r.m.s., Wk both [1]
 * @param measured   highest transmissibility within the band that was shaken; empty where it stands at its end
 * @param fitted     the mass on spring and damper; empty where the seat does not move as one
 * @param curve      by frequency, where the floor was shaken
 */
public record DampingTest(String format, int version, Map<String, String> provenance, String floor, String seat, double seconds,
        double seat_value, Optional<Measured> measured, Optional<Fitted> fitted, Curve curve) {

    /** Greatest transmissibility at resonance of seats for EM1 to EM4 and EM6; assumed. */
    public static final double LOW_LIMIT = 1.5;
    /** The same for EM5 and EM7 to EM9; assumed. */
    public static final double HIGH_LIMIT = 2.0;

    /** Where the search for the response's resolution begins: a soft seat, hardly damped. */
    private static final double SOFTEST = 1;
    private static final double LEAST_DAMPING = 0.1;
    /** By how much a peak may be lowered by the length of the segments. */
    private static final double BIAS = 0.02;
    private static final double LEVEL = 0.95;

    /**
     * The peak.
     *
     * @param resonance_hz where
     * @param transmissibility there [1]
     * @param margin half the band [1] that holds it with 95 %
     */
    public record Measured(double resonance_hz, double transmissibility, double margin) {}

    /**
     * A mass on spring and damper. Deviations are standard ones; they count what the seat does otherwise.
     *
     * @param natural_frequency_hz undamped
     * @param damping_ratio to the critical one
     * @param resonance_hz where its transmissibility is highest
     * @param damping_ratio_deviation of that ratio
     * @param transmissibility there [1]
     * @param transmissibility_deviation of that [1]
     * @param explained share of the seat's motion
     */
    public record Fitted(double natural_frequency_hz, double natural_frequency_deviation_hz, double damping_ratio,
            double damping_ratio_deviation, double resonance_hz, double transmissibility, double transmissibility_deviation,
            double explained) {

        static Fitted of(EquivalentBody body) {
            EquivalentBody.Mode mode = body.modes().get(0);
            double slope = (highest(mode.damping() + 1e-4) - highest(mode.damping() - 1e-4)) / 2e-4;
            return new Fitted(mode.frequency(), mode.frequencyDeviation(), mode.damping(), mode.dampingDeviation(),
                    mode.frequency() * place(mode.damping()),
                    highest(mode.damping()), Math.abs(slope) * mode.dampingDeviation(), body.explained());
        }

        /** Frequency of the peak over the natural one. */
        private static double place(double damping) {
            return Math.sqrt(Math.sqrt(1 + 8 * damping * damping) - 1) / (2 * damping);
        }

        private static double highest(double damping) {
            return modulus(place(damping), damping);
        }

        private static double modulus(double r, double damping) {
            double damper = 2 * damping * r;
            return Math.sqrt((1 + damper * damper) / ((1 - r * r) * (1 - r * r) + damper * damper));
        }

        double modulus(double frequency) {
            return modulus(frequency / natural_frequency_hz, damping_ratio);
        }
    }

    /**
     * Arrays of one length. Not copied.
     *
     * @param frequency_hz by line, rising
     * @param transmissibility |H1| by line [1]
     * @param margin half its band, by line [1]
     * @param fitted |H| of what was fitted, by line [1]; NaN if none
     */
    public record Curve(double[] frequency_hz, double[] transmissibility, double[] margin, double[] fitted) {}

    /**
     * Reads a recording and writes {@code seat.json}.
     *
     * @throws DataFault if floor or seat were not recorded along z, or for too short a time
     */
    public static DampingTest run(RowSource source, String title, Map<String, String> provenance, OutputFolder out) throws IOException {
        DampingTest test = of(source, title, provenance);
        ResultsJson.write(test, out.file("seat.json"));
        return test;
    }

    static DampingTest of(RowSource source, String title, Map<String, String> provenance) throws IOException {
        Recording recording = source.load();
        Channel floor = new AnalysisRequest(source, title, Optional.empty(), List.of(), List.of(), 5, 0.4, provenance)
                .chooseInput(recording.channels(), title);
        Channel seat = recording.channels().stream().filter(each -> each.location().equals("seat") && !each.equals(floor)
                && each.quantity() == floor.quantity() && each.axis() == floor.axis()).findFirst()
                .orElseThrow(() -> DataFault.in(title,
                        "a test of a seat needs its sensor beside " + floor + ": there is no seat." + floor.quantity()
                                + " along the same axis among " + recording.channels()));
        Optional<Fitted> fitted = fit(recording, floor, seat);
        ResponseRequest request = new ResponseRequest(source, title, Map.of(), List.of(floor), List.of(seat),
                OptionalDouble.of(segment(recording, fitted)),
                LEVEL, Optional.empty(), 0, false, Map.of(), Optional.empty(), provenance);
        MeasuredResponse measured = new MeasuredResponse(source, request, (step, share) -> {});
        ResponseCurve curve = new ResponseCurve(floor, seat, 0, measured.response(0), measured.h2(0, 0), Optional.empty(), 0, LEVEL);
        Optional<Peak> peak = curve.peak();
        return new DampingTest("wbv-seat-test", 1, provenance, floor.toString(), seat.toString(), recording.duration(),
                weighted(recording, seat) / weighted(recording, floor),
                peak.map(highest -> new Measured(highest.frequency(), highest.height(), curve.highestMargin())), fitted,
                drawn(curve, fitted));
    }

    private static Optional<Fitted> fit(Recording recording, Channel floor, Channel seat) {
        MotionWindow window = new MotionWindow(recording.clock().rate(), 2, recording.length());
        double[] u = recording.values(floor);
        double[] y = recording.values(seat);
        for (int i = 0; i < u.length; i++) {
            window.accept(new double[] {u[i], y[i]});
        }
        return new EquivalentBodies(window, 0).of(y, 1).filter(body -> body.carries() && body.modes().get(0).damping() > 2e-4)
                .map(Fitted::of);
    }

    /** Long enough for the seat's own peak, short enough for four of them. */
    private static double segment(Recording recording, Optional<Fitted> fitted) {
        double rate = recording.clock().rate();
        double wanted = Segmentation
                .resolving(rate, fitted.map(Fitted::natural_frequency_hz).orElse(SOFTEST), fitted.map(Fitted::damping_ratio)
                        .orElse(LEAST_DAMPING), BIAS)
                .length() / rate;
        return Math.min(wanted, recording.duration() / 4);
    }

    /** Weighted r.m.s., as {@code wbv exposure} has it. */
    private static double weighted(Recording recording, Channel channel) {
        double[] values = recording.values(channel);
        double mean = Arrays.stream(values).filter(Double::isFinite).average().orElse(0);
        Meter meter = Meter.exact(Weighting.WK.filter(), recording.clock().rate(), mean, false);
        Arrays.stream(values).forEach(meter::accept);
        meter.finish();
        return meter.vibration().rms();
    }

    private static Curve drawn(ResponseCurve curve, Optional<Fitted> fitted) {
        double[] frequency = curve.frequency();
        int[] usable = IntStream.range(0, frequency.length).filter(k -> curve.usable()[k]).toArray();
        return new Curve(pick(frequency, usable), pick(curve.h1().magnitudes(), usable), pick(curve.margin(), usable), Arrays.stream(usable)
                .mapToDouble(k -> fitted.map(body -> body.modulus(frequency[k])).orElse(Double.NaN)).toArray());
    }

    private static double[] pick(double[] from, int[] places) {
        return Arrays.stream(places).mapToDouble(k -> from[k]).toArray();
    }

    /** One sentence. */
    public String sentence() {
        return measured
                .map(peak -> String.format(Locale.ROOT,
                        "At its resonance of %.2f Hz the seat moves %.2f ± %.2f times as much as the floor.",
                        peak.resonance_hz(), peak.transmissibility(), peak.margin()))
                .orElse("The seat shows no resonance within the band that the floor shakes.");
    }

    /** A few lines for the terminal. */
    public String summary() {
        StringBuilder text = new StringBuilder(
                String.format(Locale.ROOT, "%s to %s, %.1f s: SEAT %.3f by r.m.s., Wk%n", floor, seat, seconds, seat_value));
        text.append(measured
                .map(peak -> String.format(Locale.ROOT, "  measured   transmissibility %.2f ± %.2f at %.2f Hz%n", peak.transmissibility(),
                        peak.margin(), peak.resonance_hz()))
                .orElse(String.format("  measured   no peak within the band that the floor shakes%n")));
        text.append(fitted.map(body -> String.format(Locale.ROOT,
                "  fitted     transmissibility %.2f ± %.2f at %.2f Hz: natural frequency %.3f ± %.3f Hz, damping ratio %.3f ± %.3f (2σ), "
                        + "explains %.1f %%%n",
                body.transmissibility(), 2 * body.transmissibility_deviation(), body.resonance_hz(), body.natural_frequency_hz(),
                2 * body.natural_frequency_deviation_hz(), body.damping_ratio(), 2 * body.damping_ratio_deviation(),
                100 * body.explained()))
                .orElse(String.format("  fitted     the seat does not move as a mass on a spring and a damper%n")));
        text.append(String.format(Locale.ROOT,
                "  allowed    %.1f (EM1 to EM4, EM6) or %.1f (EM5, EM7 to EM9) with an inert mass of 75 kg on the seat (assumed)%n",
                LOW_LIMIT, HIGH_LIMIT));
        return text.toString().replace(System.lineSeparator(), "\n");
    }
}
