package wbv.identify;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** ARMAX against statsmodels, against known systems, and its own laws. */
class ArmaxTest {

    private static final Orders ORDERS = new Orders(2, 3, 2, 0);

    @Test
    void agreesWithStatsmodelsOnStoredData() throws IOException {
        List<String> lines;
        try (InputStream in = ArmaxTest.class.getResourceAsStream("armax.csv")) {
            lines = new String(in.readAllBytes(), StandardCharsets.UTF_8).lines().toList();
        }
        double[] estimate = numbers(lines.get(2));
        double[] deviation = numbers(lines.get(3));
        double[][] rows = lines.subList(5, lines.size()).stream()
                .map(line -> Arrays.stream(line.split(",")).mapToDouble(Double::parseDouble).toArray()).toArray(double[][]::new);
        Samples samples = Samples.of(60, Arrays.stream(rows).mapToDouble(r -> r[0]).toArray(),
                Arrays.stream(rows).mapToDouble(r -> r[1]).toArray());
        ArmaxFit fit = new PredictionError(ORDERS).fit(samples);
        double[] ours = coefficients(fit.model());
        assertTrue(fit.converged());
        for (int i = 0; i < ours.length; i++) {
            // The two treat the first samples differently, which is worth a fraction of a deviation.
            assertEquals(estimate[i], ours[i], 0.1 * deviation[i], "coefficient " + i);
            assertEquals(deviation[i], fit.deviations()[i], 0.1 * deviation[i], "deviation " + i);
        }
        assertEquals(estimate[7], fit.model().variance(), 0.01 * estimate[7]);
    }

    @Test
    void exactDataGiveExactCoefficientsAndTheInitialState() {
        double[] initial = {0.7, -0.4};
        Armax truth = new Armax(60, KnownSystem.A, new double[][] {KnownSystem.B}, 0, new double[0], 0);
        double[] u = KnownSystem.input(400, new Well19937c(3));
        double[] y = truth.simulate(new double[][] {u}, initial);
        ArmaxFit fit = new PredictionError(new Orders(2, 3, 0, 0)).fit(Samples.of(60, u, y));
        assertArrayEquals(KnownSystem.A, fit.model().a(), 1e-7);
        assertArrayEquals(KnownSystem.B, fit.model().b()[0], 1e-7);
        assertArrayEquals(initial, fit.initial(), 1e-6);
        Pole pole = fit.model().poles().modes().get(0);
        // Closed form of a pair: σ = ln(a2)/(2T), ωd = arccos(-a1/(2√a2))/T. It is the body of 5 Hz and 0.35.
        assertEquals(30 * Math.log(0.693143), pole.re(), 1e-4);
        assertEquals(60 * Math.acos(1.468799 / (2 * Math.sqrt(0.693143))), pole.im(), 1e-4);
        assertEquals(5, pole.frequency(), 1e-4);
        assertEquals(0.35, pole.damping(), 1e-4);
    }

    @ParameterizedTest
    @ValueSource(doubles = {20, 10})
    void estimatesScatterAboutTheTruthAsTheyClaim(double decibel) {
        Scatter scatter = Scatter.of(8, seed -> new PredictionError(ORDERS).fit(KnownSystem.armax(decibel, 1800, seed)));
        scatter.requireUnbiasedAndHonest(4);
    }

    @Test
    void twoInputsAndADelayAreToldApart() {
        Armax truth = new Armax(60, KnownSystem.A, new double[][] {{0.3, 0.1}, {-0.2, 0.05}}, 2, new double[] {0.4}, 1);
        double[][] u = {KnownSystem.input(1500, new Well19937c(1)), KnownSystem.input(1500, new Well19937c(2))};
        double[] y = truth.simulate(u, new double[3]);
        Well19937c random = new Well19937c(4);
        for (int k = 0; k < y.length; k++) {
            y[k] += 1e-4 * random.nextGaussian();
        }
        ArmaxFit fit = new PredictionError(new Orders(2, 2, 2, 2)).fit(new Samples(60, u, y));
        assertArrayEquals(truth.b()[0], fit.model().b()[0], 1e-3);
        assertArrayEquals(truth.b()[1], fit.model().b()[1], 1e-3);
    }

    @Test
    void predictionUsesTheOutputAndSimulationDoesNot() {
        Samples samples = KnownSystem.armax(10, 1800, 5);
        ArmaxFit fit = new PredictionError(ORDERS).fit(samples);
        double[] predicted = fit.model().predict(samples, fit.initial());
        double[] simulated = fit.model().simulate(samples.u(), fit.initial());
        double[] disturbed = samples.y().clone();
        disturbed[900] += 100;
        Samples other = Samples.of(60, samples.u()[0], disturbed);
        assertTrue(Math.abs(fit.model().predict(other, fit.initial())[901] - predicted[901]) > 10);
        assertTrue(error(samples.y(), predicted) < 0.5 * error(samples.y(), simulated));
        assertEquals(fit.model().variance(), error(samples.y(), predicted), 0.02 * fit.model().variance());
    }

    @Test
    void schwarzChoosesTheOrdersThatMadeTheData() {
        Samples samples = KnownSystem.armax(20, 3000, 9);
        OrderSelection selection = OrderSelection.among(List.of(new Orders(1, 2, 1, 0), ORDERS, new Orders(3, 4, 3, 0),
                new Orders(4, 5, 4, 0)), samples);
        assertEquals(ORDERS, selection.best().orders());
    }

    @Test
    void theEquationIsWrittenOut() {
        Armax model = new Armax(60, new double[] {-1.5}, new double[][] {{0.5}}, 1, new double[] {0.25}, 4);
        assertEquals("y[k] = + 1.50000 y[k-1] + 0.500000 u[k-1] + e[k] + 0.250000 e[k-1], sd(e) = 2.000, 60.0000 Hz",
                model.toString());
    }

    @Test
    void modulusIsThatOfTheBody() {
        // ZOH of (2ζω s + ω²)/(s² + 2ζω s + ω²) has gain 1 at rest.
        double gain = (1 - 1.468799 + 0.693143);
        Armax model = new Armax(60, KnownSystem.A, new double[][] {{gain}}, 1, new double[0], 0);
        assertEquals(1, model.modulus(0, 0), 1e-12);
    }

    @Test
    void badSamplesAreRefusedWithTheirPlace() {
        double[] y = new double[100];
        y[17] = Double.NaN;
        IllegalArgumentException fault = assertThrows(IllegalArgumentException.class, () -> Samples.of(60, new double[100], y));
        assertTrue(fault.getMessage().contains("sample 17"), fault.getMessage());
        assertThrows(IllegalArgumentException.class, () -> new PredictionError(ORDERS).fit(Samples.of(60, new double[9],
                new double[9])));
    }

    @Test
    void silenceGivesNoModeAndNoCrash() {
        ArmaxFit fit = new PredictionError(ORDERS).fit(Samples.of(60, new double[300], new double[300]));
        assertTrue(fit.model().poles().modes().isEmpty());
    }

    static double[] coefficients(Armax model) {
        return java.util.stream.DoubleStream.concat(Arrays.stream(model.a()), java.util.stream.DoubleStream.concat(
                Arrays.stream(model.b()).flatMapToDouble(Arrays::stream), Arrays.stream(model.c()))).toArray();
    }

    private static double error(double[] y, double[] model) {
        double sum = 0;
        for (int k = 10; k < y.length; k++) {
            sum += (y[k] - model[k]) * (y[k] - model[k]);
        }
        return sum / (y.length - 10);
    }

    private static double[] numbers(String line) {
        return Arrays.stream(line.substring(line.indexOf(':') + 1).strip().split(",")).mapToDouble(Double::parseDouble).toArray();
    }
}
