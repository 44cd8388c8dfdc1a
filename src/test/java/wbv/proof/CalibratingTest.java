package wbv.proof;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import wbv.diagnosis.search.Calibration;

/** Answers that were drawn as a calibration says give it back, and its probabilities are then as often right. */
class CalibratingTest {

    private static final double FORMS = 8;
    private static final double WITHOUT = 100;

    @Test
    void whatWasDrawnByACalibrationGivesItBack() {
        List<Double> found = new ArrayList<>();
        for (int seed = 0; seed < 5; seed++) {
            found.add(Calibrating.of(drawn(new Random(seed), 2000), 0.1, "", "").orElseThrow().forms());
        }
        double mean = found.stream().mapToDouble(Double::doubleValue).average().orElseThrow();
        assertEquals(FORMS, mean, 0.4, "" + found);
    }

    @Test
    void aLapseIsOneMoreThanWasSeen() {
        List<Marking> sure = new ArrayList<>();
        for (int i = 0; i < 98; i++) {
            sure.add(marking(0.2, 50, true));
        }
        assertEquals(0.01, Calibrating.of(sure, 0.1, "", "").orElseThrow().lapse(), 1e-12);
    }

    @Test
    void whereNothingWasNamedNothingIsKnown() {
        assertTrue(Calibrating.of(List.of(), 0.1, "", "").isEmpty());
    }

    /** Names and rivals that leave as much by chance; which is right is drawn by the calibration. */
    private static List<Marking> drawn(Random random, int count) {
        Calibration truth = new Calibration(FORMS, 0.1, 0.01, 0, 0, "", "");
        List<Marking> out = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double left = 1 + random.nextDouble();
            double rival = left * (1 + 1.5 * random.nextDouble());
            double[] evidence = truth.evidence(1 + left, 1 + rival, 1 + WITHOUT, 1 + Calibration.unlisted(WITHOUT));
            double p = 1 / Arrays.stream(evidence).map(each -> Math.exp(each - evidence[0])).sum();
            out.add(marking(left, rival, random.nextDouble() < p));
        }
        return out;
    }

    private static Marking marking(double left, double rival, boolean right) {
        ProofAnswer answer = new ProofAnswer("missing-physics", "", List.of(name("hysteresis", left)),
                List.of(name("friction.coulomb", rival)), List.of(), 1 + WITHOUT, 1 + left, 1 + WITHOUT, 1 + left, 1);
        return MarkingTest.marked(right ? "hysteresis" : "friction.coulomb", answer);
    }

    private static ProofAnswer.Name name(String mechanism, double left) {
        return new ProofAnswer.Name(mechanism, "seat-torso", 0.9, Map.of(), Map.of(), Map.of(), 1 + left);
    }
}
