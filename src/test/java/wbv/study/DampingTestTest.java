package wbv.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.exposure.SeatAxis;
import wbv.exposure.SeatMeasurement;
import wbv.exposure.SeatMeter;
import wbv.recording.DataFault;
import wbv.recording.format.ReadOptions;
import wbv.recording.format.RecordingFile;

/** A seat of known numbers under an inert mass, on a floor that is swept through its resonance. */
class DampingTestTest {

    private static final double MASS = 90;
    private static final double STIFFNESS = 6000;
    private static final double NATURAL = Math.sqrt(STIFFNESS / MASS) / 2 / Math.PI;
    private static final int RATE = 200;
    private static final int FINER = 20;

    @TempDir
    private Path room;

    /** Semi-implicit steps of 0.25 ms; 0.02 m/s² of noise. @param level of the floor [m/s²] @param friction [N] */
    private DampingTest test(double damping, double friction, double level, String seat) throws IOException {
        Path file = room.resolve("shaker.csv");
        Random random = new Random(4);
        double step = 1.0 / RATE / FINER;
        try (PrintWriter out = new PrintWriter(Files.newBufferedWriter(file))) {
            out.println("t,platform.acc.z," + seat + ".acc.z");
            double deflection = 0;
            double rate = 0;
            double phase = 0;
            for (int i = 0; i < 120 * RATE * FINER; i++) {
                double floor = level * Math.sin(phase);
                double force = -STIFFNESS * deflection - damping * rate - friction * Math.tanh(rate / 1e-3);
                if (i % FINER == 0) {
                    out.printf(Locale.ROOT, "%.4f,%.5f,%.5f%n", i * step, floor + 0.02 * random.nextGaussian(),
                            force / MASS + 0.02 * random.nextGaussian());
                }
                rate += step * (force / MASS - floor);
                deflection += step * rate;
                phase += step * 2 * Math.PI * (0.5 + 2.5 * i * step / 120);
            }
        }
        return DampingTest.of(new RecordingFile(file, ReadOptions.DEFAULT), "shaker", Map.of());
    }

    private static double ratio(double damping) {
        return damping / 2 / Math.sqrt(STIFFNESS * MASS);
    }

    /** The peak of sqrt((1 + 4 ζ² r²) / ((1 - r²)² + 4 ζ² r²)), by looking at it everywhere. */
    private static double highest(double zeta) {
        double most = 0;
        for (double r = 0.3; r < 2; r += 1e-4) {
            most = Math.max(most, Math.sqrt((1 + 4 * zeta * zeta * r * r) / (Math.pow(1 - r * r, 2) + 4 * zeta * zeta * r * r)));
        }
        return most;
    }

    @Test
    void aSeatOfKnownNumbersIsFound() throws IOException {
        for (double damping : new double[] {300, 700}) {
            DampingTest test = test(damping, 0, 1, "seat");
            DampingTest.Fitted fitted = test.fitted().orElseThrow();
            assertEquals(NATURAL, fitted.natural_frequency_hz(), 0.005 * NATURAL);
            assertEquals(ratio(damping), fitted.damping_ratio(), 0.01 * ratio(damping));
            assertEquals(highest(ratio(damping)), fitted.transmissibility(), 0.01 * highest(ratio(damping)));
            DampingTest.Measured measured = test.measured().orElseThrow();
            assertEquals(highest(ratio(damping)), measured.transmissibility(), 0.05 * highest(ratio(damping)), "by H1 alone");
            assertEquals(fitted.resonance_hz(), measured.resonance_hz(), 0.1);
            assertTrue(fitted.explained() > 0.99);
        }
    }

    @Test
    void theSeatValueIsThatOfExposure() throws IOException {
        double seat = test(300, 0, 1, "seat").seat_value();
        SeatMeasurement ride = SeatMeter.measure(new RecordingFile(room.resolve("shaker.csv"), ReadOptions.DEFAULT),
                new SeatMeter.Setup(Optional.of("seat"), Optional.of("platform"), false), share -> {});
        assertEquals(ride.axes().get(SeatAxis.Z).rms() / ride.base().get(SeatAxis.Z).rms(), seat, 1e-9);
    }

    /**
     * Friction F damps as 4 F / (π V) at the rate V that the seat has at resonance: more at half the level, and the share explained says
     * so.
     */
    @Test
    void frictionDampsTheMoreTheLessItMoves() throws IOException {
        DampingTest.Fitted much = test(300, 20, 1.5, "seat").fitted().orElseThrow();
        DampingTest.Fitted little = test(300, 20, 0.75, "seat").fitted().orElseThrow();
        assertTrue(little.damping_ratio() > 1.2 * much.damping_ratio() && much.damping_ratio() > 1.2 * ratio(300), much + ", " + little);
        assertTrue(little.explained() < much.explained());
        between(1, 1.25, much.damping_ratio() / equivalent(1.5));
        between(1, 1.25, little.damping_ratio() / equivalent(0.75));
    }

    /** More than at resonance alone: before and after it the seat is slower, and friction damps more. */
    private static void between(double least, double most, double found) {
        assertTrue(found > least && found < most, "over harmonic balance: " + found);
    }

    /** By harmonic balance at the natural frequency: V = level / (2 ζ ω). */
    private static double equivalent(double level) {
        double zeta = ratio(300);
        for (int i = 0; i < 200; i++) {
            double rate = level / (2 * zeta * 2 * Math.PI * NATURAL);
            zeta = (zeta + ratio(300 + 4 * 20 / (Math.PI * rate))) / 2;
        }
        return zeta;
    }

    @Test
    void aRecordingWithoutASeatIsRefused() {
        DataFault fault = assertThrows(DataFault.class, () -> test(300, 0, 1, "head"));
        assertTrue(fault.getMessage().contains("needs its sensor beside platform.acc.z"), fault.getMessage());
    }
}
