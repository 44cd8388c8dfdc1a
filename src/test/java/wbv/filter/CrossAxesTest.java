package wbv.filter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Random;
import org.junit.jupiter.api.Test;
import wbv.filter.SimulatedSitter.Motion;
import wbv.filter.model.Spec;

/** A body that answers two motions of its base, each by a closed form: {@code y = H u + 0.9 G w}. */
class CrossAxesTest {

    private static final double NOISE = Spec.noise(SimulatedSitter.RATE);
    private static final int SAMPLES = 3600;
    private static final double SHARE = 0.9;
    private static final SimulatedSitter BODY = new SimulatedSitter(4.6, 0.33);
    private static final SimulatedSitter OTHER = new SimulatedSitter(2.2, 0.5);

    private final Motion own = BODY.steady(0.8, SAMPLES, 1);
    private final Motion across = OTHER.steady(0.8, SAMPLES, 2);
    private final Motion measured = new Motion(own.u(), whole()).measured(NOISE, 1);
    private final double[] w = new Motion(across.u(), across.y()).measured(NOISE, 3).u();

    private double[] whole() {
        double[] y = new double[SAMPLES];
        for (int i = 0; i < SAMPLES; i++) {
            y[i] = own.y()[i] + SHARE * across.y()[i];
        }
        return y;
    }

    private static AccompaniedEstimator estimator(int others) {
        return new AccompaniedEstimator(EstimatorDesign.of(Method.EKF_ADWIN).estimator(Spec.at(SimulatedSitter.RATE), Silent::new), others);
    }

    /** Mean square of output less prediction over the output's, in the last half. */
    private double error(AccompaniedEstimator estimator, boolean crossed) {
        double errors = 0;
        double power = 0;
        double[] others = new double[crossed ? 1 : 0];
        for (int i = 0; i < SAMPLES; i++) {
            if (crossed) {
                others[0] = w[i];
            }
            double foreseen = estimator.predict(measured.u()[i], others);
            double said = estimator.step(measured.u()[i], others, measured.y()[i]).prediction();
            assertEquals(foreseen, said, 0, "predicting is what the step says");
            if (i >= SAMPLES / 2) {
                errors += (measured.y()[i] - said) * (measured.y()[i] - said);
                power += measured.y()[i] * measured.y()[i];
            }
        }
        return errors / power;
    }

    @Test
    void theBodyIsFoundBesideAnotherMotion() {
        AccompaniedEstimator alone = estimator(0);
        AccompaniedEstimator crossed = estimator(1);
        double errorAlone = error(alone, false);
        double errorCrossed = error(crossed, true);
        assertTrue(errorAlone > 0.2, "one input leaves what the other does: " + errorAlone);
        assertTrue(errorCrossed < 0.01, "two inputs leave little: " + errorCrossed);
        BodyEstimate track = crossed.estimator().track();
        assertEquals(1, track.frequency() / BODY.frequency(), 0.01);
        assertEquals(1, track.damping() / BODY.damping(), 0.03);
        assertTrue(track.frequencyDeviation() < alone.estimator().track().frequencyDeviation());
    }

    @Test
    void thePartOfTheOtherIsWhatItsClosedFormSays() {
        CrossAxes cross = new CrossAxes(Spec.at(SimulatedSitter.RATE), 1);
        double errors = 0;
        double power = 0;
        for (int i = 0; i < SAMPLES; i++) {
            double[] others = {w[i]};
            double part = cross.foresee(others);
            cross.learn(measured.u()[i], others, measured.y()[i]);
            if (i >= SAMPLES / 2) {
                double truth = SHARE * across.y()[i];
                errors += (part - truth) * (part - truth);
                power += truth * truth;
            }
        }
        assertTrue(errors < 0.01 * power, errors / power + " of it is missed");
    }

    /** An hour of one frequency tells about two numbers of 24: nothing winds up, and no other motion shakes loose after. */
    @Test
    void anHourOfOneFrequencyDoesNoHarm() {
        CrossAxes cross = new CrossAxes(Spec.at(SimulatedSitter.RATE), 1);
        Random random = new Random(5);
        double[] others = new double[1];
        for (int i = 0; i < 60 * 60 * 60; i++) {
            double phase = 2 * Math.PI * 3 * i / SimulatedSitter.RATE;
            others[0] = Math.sin(1.1 * phase) + NOISE * random.nextGaussian();
            assertTrue(Math.abs(cross.foresee(others)) < 3, "at " + i);
            cross.learn(Math.sin(phase), others, Math.sin(phase + 1) + 0.5 * Math.sin(1.1 * phase - 1)
                    + NOISE * random.nextGaussian());
        }
        for (int i = 0; i < 600; i++) {
            others[0] = random.nextGaussian();
            double part = cross.foresee(others);
            assertTrue(Math.abs(part) < 20, part + " at " + i);
            cross.learn(random.nextGaussian(), others, random.nextGaussian());
        }
    }

    @Test
    void missingSamplesAreTolerated() {
        AccompaniedEstimator estimator = estimator(1);
        Random random = new Random(6);
        double[] others = new double[1];
        for (int i = 0; i < SAMPLES; i++) {
            boolean base = random.nextInt(300) == 0;
            others[0] = base ? Double.NaN : w[i];
            BodyEstimate track = estimator.step(base ? Double.NaN : measured.u()[i], others, random.nextInt(50) == 0 ? Double.NaN
                    : measured.y()[i]);
            assertTrue(Double.isFinite(track.frequency()));
        }
        assertEquals(1, estimator.estimator().track().frequency() / BODY.frequency(), 0.02);
    }

    @Test
    void resetReplaysAndNothingIsAllocated() {
        AccompaniedEstimator estimator = estimator(1);
        double first = error(estimator, true);
        estimator.reset();
        assertEquals(first, error(estimator, true), 0);
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long id = Thread.currentThread().getId();
        double[] others = new double[1];
        long before = threads.getThreadAllocatedBytes(id);
        for (int i = 0; i < SAMPLES; i++) {
            others[0] = w[i];
            estimator.step(measured.u()[i], others, measured.y()[i]);
        }
        double bytes = (threads.getThreadAllocatedBytes(id) - before) / (double) SAMPLES;
        assertTrue(bytes < 4, bytes + " bytes a sample");
    }

    @Test
    void withoutOthersItIsTheEstimatorAlone() {
        AccompaniedEstimator accompanied = estimator(0);
        Estimator alone = EstimatorDesign.of(Method.EKF_ADWIN).estimator(Spec.at(SimulatedSitter.RATE), Silent::new);
        for (int i = 0; i < 600; i++) {
            assertEquals(alone.step(measured.u()[i], measured.y()[i]).prediction(),
                    accompanied.step(measured.u()[i], new double[0], measured.y()[i]).prediction(), 0);
        }
        assertThrows(IllegalArgumentException.class, () -> new CrossAxes(Spec.at(60), -1));
    }
}
