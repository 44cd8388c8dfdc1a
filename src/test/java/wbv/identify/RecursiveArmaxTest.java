package wbv.identify;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** The recursions against known systems and against the batch. */
class RecursiveArmaxTest {

    private static final Orders ORDERS = new Orders(2, 3, 2, 0);

    @ParameterizedTest
    @CsvSource({"EXTENDED_LEAST_SQUARES,20,0.03", "EXTENDED_LEAST_SQUARES,10,0.08", "MAXIMUM_LIKELIHOOD,20,0.03",
        "MAXIMUM_LIKELIHOOD,10,0.08"})
    void findsTheBodyInNoise(RecursiveArmax.Kind kind, double decibel, double tolerance) {
        int seeds = 8;
        double frequency = 0;
        double damping = 0;
        for (int seed = 0; seed < seeds; seed++) {
            Pole pole = run(kind, KnownSystem.armax(decibel, 3600, 100 + seed), 1).model().poles().modes().get(0);
            frequency += pole.frequency() / seeds;
            damping += pole.damping() / seeds;
        }
        assertEquals(5, frequency, 5 * tolerance);
        assertEquals(0.35, damping, 0.35 * tolerance);
    }

    @Test
    void withoutForgettingMaximumLikelihoodEndsWhereTheBatchDoes() {
        Samples samples = KnownSystem.armax(20, 12000, 7);
        double[] recursive = ArmaxTest.coefficients(run(RecursiveArmax.Kind.MAXIMUM_LIKELIHOOD, samples, 1).model());
        ArmaxFit batch = new PredictionError(ORDERS).fit(samples);
        for (int i = 0; i < recursive.length; i++) {
            assertEquals(ArmaxTest.coefficients(batch.model())[i], recursive[i], 2.5 * batch.deviations()[i], "coefficient " + i);
        }
    }

    @ParameterizedTest
    @EnumSource(RecursiveArmax.Kind.class)
    void forgettingFollowsAChange(RecursiveArmax.Kind kind) {
        Samples soft = KnownSystem.body(4, 0.3, 40, 1800, 1);
        Samples stiff = KnownSystem.body(6, 0.3, 40, 1800, 2);
        RecursiveArmax filter = new RecursiveArmax(kind, ORDERS, 1, 60, 0.99);
        feed(filter, soft);
        assertEquals(4, filter.model().poles().modes().get(0).frequency(), 0.3);
        feed(filter, stiff);
        assertEquals(6, filter.model().poles().modes().get(0).frequency(), 0.4);
    }

    @ParameterizedTest
    @EnumSource(RecursiveArmax.Kind.class)
    void silenceDoesNotWindItUp(RecursiveArmax.Kind kind) {
        RecursiveArmax filter = run(kind, KnownSystem.armax(20, 1800, 3), 0.98);
        for (int k = 0; k < 60000; k++) {
            filter.step(new double[] {0}, 0);
        }
        feed(filter, KnownSystem.armax(20, 1800, 4));
        assertEquals(5, filter.model().poles().modes().get(0).frequency(), 0.5);
    }

    @ParameterizedTest
    @EnumSource(RecursiveArmax.Kind.class)
    void resetReplaysAndMissingSamplesArePassedOver(RecursiveArmax.Kind kind) {
        Samples samples = KnownSystem.armax(10, 600, 8);
        RecursiveArmax filter = run(kind, samples, 0.995);
        String once = filter.model().toString();
        filter.step(new double[] {Double.NaN}, 1);
        assertEquals(600, filter.samples());
        filter.reset();
        feed(filter, samples);
        assertEquals(once, filter.model().toString());
        assertTrue(Double.isNaN(filter.step(new double[] {1}, Double.NaN)));
    }

    private static RecursiveArmax run(RecursiveArmax.Kind kind, Samples samples, double forgetting) {
        RecursiveArmax filter = new RecursiveArmax(kind, ORDERS, 1, 60, forgetting);
        feed(filter, samples);
        return filter;
    }

    private static void feed(RecursiveArmax filter, Samples samples) {
        double[] u = new double[1];
        for (int k = 0; k < samples.length(); k++) {
            u[0] = samples.u()[0][k];
            filter.step(u, samples.y()[k]);
        }
    }
}
