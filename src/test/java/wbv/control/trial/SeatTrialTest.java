package wbv.control.trial;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.control.ApparentSitter;
import wbv.control.SeatHardware;
import wbv.rig.CarriedPerson;

class SeatTrialTest {

    private static final SeatHardware SEAT = SeatHardware.ASSUMED;

    /** Root mean squares from 0.89 to 11.22 Hz that the standard is remembered to state: another source than the spectra's. */
    @ParameterizedTest
    @CsvSource({"EM1, 1.71", "EM2, 2.05", "EM3, 1.73", "EM4, 0.96", "EM7, 2.25", "EM8, 1.04", "EM9, 1.60"})
    void spectraHaveTheirRootMeanSquare(EarthMover floor, double expected) {
        double square = 0;
        for (double f = 0.89; f <= 11.22; f += 0.005) {
            square += floor.density(f) * 0.005;
        }
        assertEquals(expected, Math.sqrt(square), 0.011);
    }

    @Test
    void aRideHasItsFloorsSpectrum() {
        for (Floor floor : List.of(EarthMover.EM5, new RoadFloor('C', 50))) {
            double[] ride = floor.ride(240_000, new Well19937c(3));
            double square = 0;
            for (double a : ride) {
                square += a * a / ride.length;
            }
            assertEquals(1, Math.sqrt(square) / floor.rms(), 0.05, floor.word());
        }
    }

    /** A road twice as fast shakes twice the power at n₀ v², a class up four times. */
    @Test
    void aRoadOfTheNextClassShakesTwiceAsMuch() {
        assertEquals(2, new RoadFloor('D', 40).rms() / new RoadFloor('C', 40).rms(), 1e-9);
        assertEquals(Math.sqrt(2), new RoadFloor('C', 80).rms() / new RoadFloor('C', 40).rms(), 1e-9);
    }

    @Test
    void aSeatAtRestStaysThereAndAnotherSitterIsLevelled() {
        SuspendedPerson seat = new SuspendedPerson(SEAT, Sitters.ofMass(75));
        for (int i = 0; i < 2000; i++) {
            seat.step(0, 0, 500, 0);
        }
        assertEquals(0, seat.deflection(), 1e-9);
        seat.seat(Sitters.ofMass(55));
        double most = 0;
        for (int i = 0; i < 30_000; i++) {
            seat.step(0, 0, 500, 0);
            most = Math.max(most, seat.deflection());
        }
        assertTrue(most > 0.015, "rises by what the lighter one no longer presses down: " + most);
        assertEquals(0, seat.deflection(), 0.012);
    }

    @Test
    void stopsHold() {
        SuspendedPerson seat = new SuspendedPerson(SEAT, Sitters.ofMass(75));
        double most = 0;
        for (int i = 0; i < 5000; i++) {
            double a = 6 * Math.sin(2 * Math.PI * 1.3 * i / SuspendedPerson.RATE);
            seat.step(a, a, 100, 0);
            most = Math.max(most, Math.abs(seat.deflection()));
        }
        assertTrue(seat.hits() > 3 && most < 0.065, seat.hits() + " hits, " + most + " m");
    }

    /** The fit of one mass to the rig's person: near it where he is felt, his whole mass at rest. */
    @Test
    void theApparentSitterIsNearThePerson() {
        CarriedPerson person = new CarriedPerson(Maker.MIDDLE, SuspendedPerson.STEP);
        ApparentSitter apparent = Maker.apparent(Maker.MIDDLE);
        assertEquals(person.carriedMass(), apparent.mass(), 1e-9);
        double[] measured = new double[4];
        double[] fitted = new double[2];
        for (double f = 0.5; f <= 12; f += 0.5) {
            person.respond(f, measured);
            apparent.apparentMass(f, fitted);
            assertEquals(0, Math.hypot(measured[0] - fitted[0], measured[1] - fitted[1]) / person.carriedMass(), 0.25, "at " + f + " Hz");
        }
    }

    private static Front front(double... strokesAndSeats) {
        List<Front.Point> points = new ArrayList<>();
        for (int i = 0; i < strokesAndSeats.length; i += 2) {
            points.add(new Front.Point(i, new TrialResult(strokesAndSeats[i + 1], 1, strokesAndSeats[i], 0.04, 0, 0, 0, 1, 0, 0, 0)));
        }
        return new Front(ControllerFamily.PASSIVE, Knowledge.FIXED, points);
    }

    @Test
    void atEqualStrokeNobodyIsCreditedMoreStroke() {
        Front front = front(0.004, 1.0, 0.008, 0.8, 0.016, 0.9);
        assertFalse(front.at(0.003).isPresent());
        assertEquals(1.0, front.at(0.004).orElseThrow().seat(), 1e-12);
        assertEquals(0.9, front.at(0.004 * Math.sqrt(2)).orElseThrow().seat(), 1e-12);
        assertEquals(0.8, front.at(0.016).orElseThrow().seat(), 1e-12, "less stroke may be had, if it is better");
    }

    /** An actuator that knows what it does is better than a damper with the same stroke; nothing goes to its stops. */
    @Tag("slow")
    @Test
    void theActuatorIsBetterThanTheSkyhookAtEqualStroke() {
        Comparison comparison = Comparison.run(new Comparison.Request(SEAT, List.of(EarthMover.EM3), List.of(Sitters.ofMass(80)),
                List.of(ControllerFamily.ACTIVE), 0, 4, 10, 5),
                share -> {});
        Comparison.OnSitter sitter = comparison.floors().get(0).sitters().get(0);
        Front.AtStroke skyhook = sitter.at(Comparison.SKYHOOK).orElseThrow();
        Front.AtStroke active = sitter.at(new Comparison.Entrant(ControllerFamily.ACTIVE, Knowledge.SCHEDULED)).orElseThrow();
        assertTrue(active.seat() < 0.8 * skyhook.seat(), active.seat() + " beside " + skyhook.seat());
        assertTrue(active.strokeRms() <= sitter.stroke());
    }

    @Tag("slow")
    @Test
    void aDamperIsGivenTheControllerThatServesTheMiddleSitterBest() {
        Comparison comparison = Comparison.run(new Comparison.Request(SEAT, List.of(EarthMover.EM2, EarthMover.EM5), List.of(Maker.MIDDLE),
                List.of(ControllerFamily.ON_OFF, ControllerFamily.CLIPPED), 0, 4, 10, 5), share -> {});
        for (Comparison.OnFloor on : comparison.floors()) {
            double chosen = seat(on, on.damper());
            assertTrue(chosen <= seat(on, ControllerFamily.SKYHOOK) && chosen <= seat(on, ControllerFamily.ON_OFF)
                    && chosen <= seat(on, ControllerFamily.CLIPPED), on.floor().word());
        }
        assertEquals(ControllerFamily.CLIPPED, comparison.floors().get(0).damper(), "where the floor shakes near the resonance");
        assertTrue(comparison.dampersBesideSkyhook().mean() < 1);
    }

    private static double seat(Comparison.OnFloor on, ControllerFamily family) {
        return on.sitters().get(0).at(new Comparison.Entrant(family, Knowledge.FIXED)).orElseThrow().seat();
    }

    /**
     * A controller that is believed to have a delay of 4 ms and has 14: without the guard it sings at 21 Hz with four times a passive
     * seat's SEAT.
     */
    @Test
    void moreDelayMakesNoSong() {
        Maker maker = new Maker(SEAT, EarthMover.EM3, 1);
        SeatTrial late = new SeatTrial(SEAT,
                new Ride(Sitters.ofMass(55), EarthMover.EM3, 4, 10, 2).with(new Faults(0, Optional.empty(), 0.010, Optional.empty())));
        assertTrue(late.run(maker, ControllerFamily.ACTIVE, Knowledge.SCHEDULED, 0.4).seat() < 1);
    }

    @Tag("slow")
    @Test
    void noFaultMakesASeatUnstable() {
        Endurance.run(SEAT, 200, 1000, share -> {}).cases().forEach((fault, one) -> assertEquals(0, one.unstable(), fault));
    }
}
