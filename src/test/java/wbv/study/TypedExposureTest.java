package wbv.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.exposure.SeatAxis;
import wbv.recording.DataFault;

/**
 * Closed forms of Directive 2002/44/EC, Annex B, and the points of the HSE's calculator (v1.06: 100 at the action value, 529 at the limit
 * value).
 */
class TypedExposureTest {

    private static TypedExposure.Results of(TypedExposure.Spell... spells) {
        return TypedExposure.of(List.of(spells)).results();
    }

    private static TypedExposure.Spell spell(double x, double y, double z, double hours) {
        return new TypedExposure.Spell(Map.of(SeatAxis.X, x, SeatAxis.Y, y, SeatAxis.Z, z), hours);
    }

    @ParameterizedTest
    @CsvSource({"0.5, 100, 480, above the action value", "1.15, 529, 90.74, above the limit value",
        "0.499, 99.6, 481.93, below the action value"})
    void eightHoursAtAValueAreItsPoints(double magnitude, double points, double minutes, String verdict) {
        TypedExposure.Results found = of(new TypedExposure.Spell(Map.of(SeatAxis.Z, magnitude), 8));
        assertEquals(magnitude, found.a8(), 1e-12);
        assertEquals(points, found.points(), 0.01);
        assertEquals(minutes, found.minutesToAction(), 0.01);
        assertEquals(verdict, found.verdict());
    }

    /** A(8) = √(Σ (k a)² t / 8 h) by axis; the highest decides; sideways and fore-and-aft count 1.4 times. */
    @Test
    void spellsAddUpByAxis() {
        TypedExposure.Results found = of(spell(0.6, 0.1, 0.7, 2), spell(0.2, 0.3, 0.5, 3.5));
        assertEquals(1.4 * Math.sqrt((0.36 * 2 + 0.04 * 3.5) / 8), found.a8ByAxis().get("x"), 1e-12);
        assertEquals(1.4 * Math.sqrt((0.01 * 2 + 0.09 * 3.5) / 8), found.a8ByAxis().get("y"), 1e-12);
        assertEquals(Math.sqrt((0.49 * 2 + 0.25 * 3.5) / 8), found.a8ByAxis().get("z"), 1e-12);
        assertEquals("z", found.worstAxis());
        assertEquals(found.points(), found.spells().stream().mapToDouble(each -> each.points().get("z")).sum(), 1e-9);
        // The whole mix drawn out to the time that is told reaches the value exactly.
        double stretch = found.minutesToAction() / (60 * 5.5);
        assertEquals(0.5, of(spell(0.6, 0.1, 0.7, 2 * stretch), spell(0.2, 0.3, 0.5, 3.5 * stretch)).a8(), 1e-12);
        assertEquals(found.minutesToLimit() / found.minutesToAction(), Math.pow(1.15 / 0.5, 2), 1e-12);
    }

    /** 1.4 k (Σ a⁴ t)^¼ with t in seconds. */
    @Test
    void doseIsEstimatedFromTheMagnitudes() {
        assertEquals(1.4 * Math.pow(Math.pow(0.7, 4) * 4 * 3600 + Math.pow(1.2, 4) * 1800, 0.25),
                of(spell(0, 0, 0.7, 4), spell(0, 0, 1.2, 0.5)).estimatedDose(), 1e-12);
    }

    @Test
    void orderOfSpellsIsNothing() {
        List<TypedExposure.Spell> spells = new ArrayList<>(List.of(spell(0.1, 0.2, 0.3, 1), spell(0.5, 0.4, 0.3, 2), spell(0, 0, 1, 0.1)));
        double a8 = TypedExposure.of(spells).results().a8();
        Collections.reverse(spells);
        assertEquals(a8, TypedExposure.of(spells).results().a8(), 1e-15);
    }

    @Test
    void moreThanADayIsRefused() {
        assertTrue(assertThrows(DataFault.class, () -> of(spell(0, 0, 1, 14), spell(0, 0, 1, 11))).getMessage().contains("--hours"));
    }
}
