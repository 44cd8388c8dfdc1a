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
    private static final double CHANCE = 0.1;
    private static final double WITHOUT = 100;

    @Test
    void whatWasDrawnByACalibrationGivesItBack() {
        List<Double> forms = new ArrayList<>();
        List<Double> chance = new ArrayList<>();
        for (int seed = 0; seed < 5; seed++) {
            Calibration found = Calibrating.of(drawn(new Random(seed), 2000), "", "").orElseThrow();
            forms.add(found.forms());
            chance.add(Math.log(found.chance()));
        }
        assertEquals(FORMS, mean(forms), 0.4, "" + forms);
        assertEquals(Math.log(CHANCE), mean(chance), 0.2, "" + chance);
    }

    private static double mean(List<Double> values) {
        return values.stream().mapToDouble(Double::doubleValue).average().orElseThrow();
    }

    /** A force that nobody measured is named without a fit: what it leaves says nothing of forms. */
    @Test
    void whatNoFitFoundDoesNotTell() {
        assertTrue(Calibrating.of(List.of(marking(WITHOUT, 0, WITHOUT, 0, true)), "", "").isEmpty());
    }

    @Test
    void aLapseIsOneMoreThanWasSeen() {
        List<Marking> sure = new ArrayList<>();
        for (int i = 0; i < 98; i++) {
            sure.add(marking(0.2, 0, 50, 0, true));
        }
        assertEquals(0.01, Calibrating.of(sure, "", "").orElseThrow().lapse(), 1e-12);
    }

    @Test
    void whereNothingWasNamedNothingIsKnown() {
        assertTrue(Calibrating.of(List.of(), "", "").isEmpty());
    }

    /** Names and rivals that leave as much by chance, and move the model's numbers so; which is right is drawn by the calibration. */
    private static List<Marking> drawn(Random random, int count) {
        Calibration truth = new Calibration(FORMS, CHANCE, 0.01, 1, 0, 0, "", "");
        List<Marking> out = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double left = 0.005 * Math.pow(200, random.nextDouble());
            double rival = left + Math.max(left, CHANCE) * 1.5 * random.nextDouble();
            double numbers = -2 * random.nextDouble();
            double others = -2 * random.nextDouble();
            double least = 1 + left;
            double[] all = {truth.evidence(least, least) + numbers, truth.evidence(1 + rival, least) + others,
                truth.evidence(1 + WITHOUT, least) + numbers, truth.evidence(1 + Calibration.unlisted(WITHOUT), least) + numbers};
            double p = 1 / Arrays.stream(all).map(each -> Math.exp(each - all[0])).sum();
            out.add(marking(left, numbers, rival, others, random.nextDouble() < p));
        }
        return out;
    }

    private static Marking marking(double left, double numbers, double rival, double others, boolean right) {
        ProofAnswer answer = new ProofAnswer("missing-physics", "", List.of(name("hysteresis", left, numbers)),
                List.of(name("friction.coulomb", rival, others)), List.of(), 1 + WITHOUT, 1 + left, 1 + WITHOUT, 1 + left, 1);
        return MarkingTest.marked(right ? "hysteresis" : "friction.coulomb", answer);
    }

    private static ProofAnswer.Name name(String mechanism, double left, double numbers) {
        return new ProofAnswer.Name(mechanism, "seat-torso", 0.9, Map.of(), Map.of(), Map.of(), 1 + left, numbers);
    }
}
