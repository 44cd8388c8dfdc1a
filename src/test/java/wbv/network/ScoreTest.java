package wbv.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class ScoreTest {

    @Test
    void errorsOfThreeTrialsByHand() {
        List<LabelledMotion> trials = List.of(trial(1), trial(2), trial(3));
        List<Estimate> said = List.of(estimate(1.5, 0.4), estimate(2.5, 0.2), estimate(Double.NaN, Double.NaN));
        Score score = Score.of(0, trials, said, 3.5, 2);
        assertEquals(0.5, score.rmse(), 1e-12);
        assertEquals(0, score.deviation(), 1e-12);
        assertEquals(0.25, score.standardised(), 1e-12);
        assertEquals(1, score.missing());
        Score stated = Score.of(0, trials.subList(0, 2), said.subList(0, 2), 0, 2);
        assertEquals(0.5, stated.covered(), "0.5 is within 1.645 times 0.4, not within 1.645 times 0.2");
        assertEquals(Math.sqrt((0.16 + 0.04) / 2), stated.stated(), 1e-12);
    }

    /** Targets that are a linear function of the pixels: ridge regression finds it where noise does not hide it. */
    @Test
    void ridgeRegressionFindsALinearTarget() {
        Imaging imaging = new Imaging(List.of(ImagePlane.of(ImagePlane.Kind.LEVEL, 0)));
        SplittableRandom random = new SplittableRandom(1);
        List<LabelledMotion> trials = new ArrayList<>();
        for (int i = 0; i < 120; i++) {
            double level = random.nextDouble(0, 3);
            double[][] motion = new double[2][Imaging.SAMPLES];
            for (int n = 0; n < Imaging.SAMPLES; n++) {
                motion[0][n] = Math.exp(level) * random.nextDouble(-1, 1);
            }
            trials.add(new LabelledMotion(motion, new double[] {level, 5 - 2 * level}, ""));
        }
        Ridge ridge = Ridge.fit(imaging, trials.subList(0, 90), trials.subList(90, 100));
        for (LabelledMotion trial : trials.subList(100, 120)) {
            double[] value = ridge.read(trial.motion()).value();
            assertEquals(trial.truth()[0], value[0], 0.2);
            assertEquals(5 - 2 * value[0], value[1], 1e-6);
        }
    }

    /** On a linear body the instruments are near the truth of the rig. */
    @Test
    void peersKnowTheBody() {
        LabelledMotion trial = RigTrials.of(Bodies.ONE_DOF, 1, 1, share -> {}).get(0);
        double[] found = Peers.instruments(trial.motion(), 1).value();
        assertEquals(trial.truth()[0], found[0], 0.05);
        assertEquals(trial.truth()[1], found[1], 0.1 * trial.truth()[1]);
        assertTrue(trial.truth()[1] > 10);
    }

    /** The likelihood of the answer's spectrum alone: half of the bodies to 0.7 Hz, where knowing nothing gives 1.75. */
    @Test
    void theAnswersSpectrumAloneTellsTheFrequencyRoughly() {
        double[] errors = RigTrials.of(Bodies.ONE_DOF, 40, 6, share -> {}).stream()
                .mapToDouble(trial -> Math.abs(Peers.spectrum(trial.motion()[1]).value()[1] - trial.truth()[1]))
                .sorted().toArray();
        assertTrue(errors[20] < 0.7 * 2 * Math.PI, "median " + errors[20] + " rad/s");
    }

    private static LabelledMotion trial(double truth) {
        return new LabelledMotion(new double[0][0], new double[] {truth}, "");
    }

    private static Estimate estimate(double value, double deviation) {
        return new Estimate(new double[] {value}, new double[] {deviation});
    }
}
