package wbv.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.apache.commons.math3.complex.Complex;
import org.apache.commons.math3.stat.correlation.PearsonsCorrelation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.filter.Method;
import wbv.learn.AdwinAlarm;
import wbv.rig.Effects;
import wbv.rig.RigRun;
import wbv.rig.RigSpec;
import wbv.rig.Sitter;

/** Bodies that the base's horizontal motion pushes up, beside D = s² + 2ζωs + ω² in closed form. */
class CoupledBodiesTest {

    private static final double TAU = 2 * Math.PI;
    private static final int SETTLED = 20;
    private static final int SECONDS = 24;

    /** A drawn body under a sine along one axis alone answers in z with s²/D c of x or y, and with (2ζωs + ω²)/D of z. */
    @ParameterizedTest
    @CsvSource({"x, 3", "x, 8", "y, 5", "z, 5"})
    void oneAxisAloneIsAnsweredAsTheEquationSays(String axis, int frequency) {
        RigSpec drawn = Bodies.COUPLED.draw(new SplittableRandom(12), 5);
        RigSpec spec = RigSpec.parse(drawn.withEffects(Effects.NONE).toString()
                .replaceAll("excitation=\\S+", "excitation=sine:" + axis + ":" + frequency + ":1").replaceAll("seconds=\\S+",
                        "seconds=" + SECONDS));
        Sitter.OneDof body = (Sitter.OneDof) drawn.sitter();
        assertTrue(Math.abs(body.crossX()) > 0.02 && Math.abs(body.crossY()) > 0.02, body.toString());
        Complex s = new Complex(0, TAU * frequency);
        double w = TAU * body.frequency();
        Complex still = s.multiply(2 * body.zeta() * w).add(w * w);
        Complex denominator = s.multiply(s).add(still);
        Complex expected = switch (axis) {
            case "x" -> s.multiply(s).multiply(body.crossX()).divide(denominator);
            case "y" -> s.multiply(s).multiply(body.crossY()).divide(denominator);
            default -> still.divide(denominator);
        };
        int excitation = 1 + List.of("z", "head", "x", "y").indexOf(axis);
        Complex ratio = line(spec, 2, frequency).divide(line(spec, excitation, frequency));
        assertEquals(0, ratio.subtract(expected).abs(), 2e-3 * expected.abs());
    }

    /** Without noise, over whole periods. */
    private static Complex line(RigSpec spec, int column, double frequency) {
        RigRun run = spec.run();
        double[] row = new double[1 + spec.channels().size()];
        Complex sum = Complex.ZERO;
        while (run.read(row)) {
            run.ideal(row);
            if (row[0] >= SETTLED - 1 && row[0] < SECONDS - 2) {
                sum = sum.add(new Complex(0, -TAU * frequency * row[0]).exp().multiply(row[column]));
            }
        }
        return sum;
    }

    @Test
    void everyDrawIsWrittenAndReadAgainAndItsAxesAreIndependent() {
        for (int i = 0; i < 20; i++) {
            RigSpec spec = Bodies.COUPLED.draw(new SplittableRandom(i), i);
            assertEquals(spec, RigSpec.parse(spec.toString()));
            Sitter.OneDof body = (Sitter.OneDof) spec.sitter();
            assertTrue(Math.abs(body.crossX()) <= 0.5 && Math.abs(body.crossY()) <= 0.5);
        }
        double worst = 0;
        for (LabelledMotion trial : RigTrials.of(Bodies.COUPLED, 20, 3, share -> {})) {
            worst = Math.max(worst, Math.abs(correlation(trial.motion()[0], trial.motion()[2])));
            worst = Math.max(worst, Math.abs(correlation(trial.motion()[2], trial.motion()[3])));
        }
        assertTrue(worst < 0.6, "of 219 samples " + worst);
    }

    /** The fit that sees all axes finds the body to sensors' noise; the one that sees z alone takes the rest for noise. */
    @Test
    void theFitOfThreeAxesIsManyTimesBetterThanThatOfOne() {
        List<LabelledMotion> trials = RigTrials.of(Bodies.COUPLED, 60, 8, share -> {});
        Score three = Score.of(1, trials, trials.stream().map(trial -> Peers.fit(trial.motion(), 1)).toList(), 0, 1);
        Score one = Score.of(1, trials, trials.stream().map(trial -> Peers.fit(Arrays.copyOf(trial.motion(), 2), 1))
                .toList(), 0, 1);
        assertTrue(three.rmse() < TAU * 0.05 && 5 * three.rmse() < one.rmse(), three.rmse() + " and " + one.rmse());
        assertTrue(three.covered() > 0.75, "90 % intervals hold for " + three.covered());
    }

    /** The streaming estimator measures powers for its first 3 s; over 30 s it has time to learn what x and y do. */
    @Test
    void givenTimeTheStreamingEstimatorLearnsWhatTheOtherAxesDo() {
        List<LabelledMotion> trials = IntStream.range(0, 24).mapToObj(i -> {
            RigSpec spec = Bodies.COUPLED.draw(new SplittableRandom(100 + i), i).withSeconds(30);
            Sitter.OneDof body = (Sitter.OneDof) spec.sitter();
            double[][] motion = spec.channels().stream().map(spec.recording()::values).toArray(double[][]::new);
            return new LabelledMotion(motion, new double[] {body.zeta(), TAU * body.frequency()}, spec.toString());
        }).toList();
        for (int j = 0; j < 2; j++) {
            double crossed = stream(j, trials, 4).rmse();
            double alone = stream(j, trials, 2).rmse();
            assertTrue(crossed < 0.7 * alone, "target " + j + ": " + crossed + " and " + alone);
        }
    }

    private static Score stream(int target, List<LabelledMotion> trials, int channels) {
        return Score.of(target, trials, trials.stream().map(trial -> Peers.stream(Arrays.copyOf(trial.motion(), channels), 1,
                Method.EKF_ADWIN, () -> new AdwinAlarm(0.002))).toList(), 0, 1);
    }

    @Test
    void whatDoesNotFitIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> new Sitter.OneDof(0.3, 5, Optional.empty(), 3, 0));
        assertThrows(IllegalArgumentException.class, () -> RigSpec.parse("sitter=one-dof cross=0.3"));
        assertThrows(IllegalArgumentException.class, () -> RigSpec.parse("sitter=two-dof cross=0.3,0"));
        IllegalArgumentException refused = assertThrows(IllegalArgumentException.class, () -> new TrainingOrder(Bodies.ONE_DOF, 60, 1,
                Architecture.THREE_AXES, Architecture.THREE_AXES.settings(), 1));
        assertTrue(refused.getMessage().contains("coupled"), refused.getMessage());
    }

    private static double correlation(double[] a, double[] b) {
        return new PearsonsCorrelation().correlation(a, b);
    }
}
