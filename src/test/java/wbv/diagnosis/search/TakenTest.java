package wbv.diagnosis.search;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TakenTest {

    /**
     * By how much the residual is more than noise without a name, and with it: a stop that leaves a twentieth of play is no push, a law
     * that half of a push happens to fit is none of it, and near the noise a process costs more than a name that leaves little.
     */
    @ParameterizedTest
    @CsvSource({"304, 12.9, true", "304, 70, true", "304, 80, false", "304, 150, false", "12, 3.4, true", "12, 5, false", "3.5, 2.2, true",
        "3.5, 2.5, false", "1.2, 1.1, true"})
    void whatANameTakesMostOfIsNoForceOfItsOwn(double without, double with, boolean taken) {
        assertEquals(taken, Refinement.isTaken(without, with));
    }
}
