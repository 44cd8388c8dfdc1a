package wbv.exposure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** ISO 2631-5:2018 against its worked example (through phonometry) and moduli computed with NumPy. */
class SpinalTest {

    private static SpinalDose fivePeaks() {
        SpinalDose dose = new SpinalDose();
        for (int i = 0; i < 5; i++) {
            for (double value : new double[] {-3, 12, 40, 39, 7, 0, -60, Double.NaN}) {
                dose.accept(value);
            }
        }
        return dose;
    }

    @Test
    void theWorkedExample() {
        double dose = fivePeaks().dose();
        assertEquals(5, fivePeaks().peaks());
        assertEquals(55.968, dose, 5e-4);
        SpinalRisk man = new SpinalRisk(SpinalRisk.Sex.MALE, 20, 20, 120);
        assertEquals(1.623, man.stress(dose), 5e-4);
        assertEquals(1.220, man.variable(dose), 5e-4);
        assertEquals(0.367, man.probability(dose), 5e-4);
        SpinalRisk woman = new SpinalRisk(SpinalRisk.Sex.FEMALE, 20, 20, 120);
        assertEquals(1.399, woman.stress(dose), 5e-4);
        assertEquals(0.962, woman.variable(dose), 5e-4);
    }

    /** R for 10, 50 and 90 % of risk as Table C.2 prints them, and P of those R. */
    @ParameterizedTest
    @CsvSource({"MALE,0.72,0.1", "MALE,1.42,0.5", "MALE,2.17,0.9", "FEMALE,0.52,0.1", "FEMALE,0.87,0.5", "FEMALE,1.20,0.9"})
    void risksAreThoseOfTableC2(SpinalRisk.Sex sex, double variable, double risk) {
        SpinalRisk one = new SpinalRisk(sex, 30, 10, 200);
        double dose = variable / one.variable(1);
        assertEquals(variable, one.variable(dose), 1e-9);
        assertEquals(risk, one.probability(dose), 0.015);
    }

    @ParameterizedTest
    @CsvSource({"0.5,1.003", "2,1.056", "4,1.417", "4.71,1.586", "6,1.143", "8,0.873", "10,0.822", "20,0.705", "40,0.328",
        "80,0.0056"})
    void theSpineFollowsTheSeat(double frequency, double modulus) {
        assertEquals(modulus, SpinalDose.spine().modulus(frequency), 6e-4);
        assertEquals(modulus, SpinalDose.filter().modulus(frequency), 6e-4 + 0.001 * modulus);
    }

    /** A sine through the whole chain: N periods of amplitude a |H| give 1.07 a |H| N^(1/6), whatever gravity is added. */
    @Test
    void aSineGivesItsPeaks() {
        SpinalDose dose = new SpinalDose();
        Weigher weigher = new ExactWeigher(SpinalDose.filter(), 100, 9.81, false, dose);
        for (int i = 0; i < 60000; i++) {
            weigher.accept(9.81 + 2 * Math.sin(2 * Math.PI * 4 * i / 100.0));
        }
        weigher.finish();
        assertEquals(2400, dose.peaks(), 1);
        double expected = 1.07 * 2 * SpinalDose.filter().modulus(4) * Math.pow(2400, 1 / 6.0);
        assertEquals(expected, dose.dose(), 0.005 * expected);
    }

    @Test
    void dosesOfADay() {
        assertEquals(2, SpinalDose.daily(1, 64, 1), 1e-12);
        assertEquals(Math.pow(65, 1 / 6.0), SpinalDose.together(1, 2), 1e-12);
    }

    @Test
    void aSpineWithoutStrengthIsCertainToBreak() {
        SpinalRisk old = new SpinalRisk(SpinalRisk.Sex.MALE, 100, 80, 240);
        assertTrue(Double.isInfinite(old.variable(1)));
        assertEquals(1, old.probability(1));
        assertThrows(IllegalArgumentException.class, () -> new SpinalRisk(SpinalRisk.Sex.MALE, 20, 0, 240));
    }
}
