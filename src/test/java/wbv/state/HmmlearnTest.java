package wbv.state;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.state.markov.BaumWelch;
import wbv.state.markov.HiddenMarkov;
import wbv.state.markov.Trellis;
import wbv.state.mixture.CovarianceShape;
import wbv.state.mixture.Gaussian;
import wbv.state.mixture.Mixture;

/** The stored results of hmmlearn 0.3.3 on the same sequences ({@code hmm.py} beside them made them). */
class HmmlearnTest {

    private static final double EXACT = 1e-6;

    private static JsonNode stored;

    @BeforeAll
    static void read() throws IOException {
        try (InputStream in = HmmlearnTest.class.getResourceAsStream("hmm.json")) {
            stored = new ObjectMapper().readTree(in);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"full", "diag", "mixture"})
    void likelihoodAndPosteriors(String kind) {
        JsonNode oracle = stored.get(kind);
        HiddenMarkov model = model(kind, oracle.get("start"));
        double likelihood = 0;
        int at = 0;
        for (double[][] sequence : sequences()) {
            Trellis trellis = new Trellis(model, sequence);
            likelihood += trellis.logLikelihood();
            for (double[] row : trellis.posterior()) {
                assertArrayEquals(vector(oracle.get("posteriors").get(at++)), row, EXACT);
            }
        }
        assertEquals(oracle.get("log_likelihood").asDouble(), likelihood, EXACT);
    }

    @ParameterizedTest
    @ValueSource(strings = {"full", "diag"})
    void likeliestPath(String kind) {
        JsonNode oracle = stored.get(kind);
        HiddenMarkov model = model(kind, oracle.get("start"));
        int at = 0;
        for (double[][] sequence : sequences()) {
            for (int state : new Trellis(model, sequence).path()) {
                assertEquals(oracle.get("path").get(at).asInt(), state, "row " + at++);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"full, 0", "full, 1", "diag, 0", "diag, 1", "mixture, 0"})
    void fittedParameters(String kind, int index) {
        JsonNode oracle = stored.get(kind);
        JsonNode fitted = oracle.get("fitted").get(index);
        BaumWelch.Result result = new BaumWelch(fitted.get("rounds").asInt(), 0, 0, shape(kind), 1e-12)
                .fit(model(kind, oracle.get("start")), sequences(), share -> {});
        HiddenMarkov expected = model(kind, fitted);
        HiddenMarkov found = result.model();
        assertEquals(fitted.get("log_likelihood").asDouble(), result.history().get(result.history().size() - 1), EXACT);
        assertArrayEquals(expected.initial(), found.initial(), EXACT);
        for (int i = 0; i < expected.states(); i++) {
            assertArrayEquals(expected.transition()[i], found.transition()[i], EXACT);
            assertArrayEquals(expected.emissions().get(i).weights(), found.emissions().get(i).weights(), EXACT);
            for (int m = 0; m < expected.emissions().get(i).size(); m++) {
                Gaussian wanted = expected.emissions().get(i).components().get(m);
                Gaussian got = found.emissions().get(i).components().get(m);
                assertArrayEquals(wanted.mean(), got.mean(), EXACT);
                assertArrayEquals(wanted.covariance(), got.covariance(), EXACT);
            }
        }
    }

    @Test
    void sequencesOfOneRowCountOnceForTheStart() {
        HiddenMarkov model = model("full", stored.get("full").get("start"));
        double[][] one = sequences().get(1);
        assertEquals(1, one.length);
        double expected = 0;
        for (int k = 0; k < model.states(); k++) {
            expected += model.initial()[k] * Math.exp(model.emissions().get(k).logDensity(one[0], new double[1], new double[2]));
        }
        assertEquals(Math.log(expected), new Trellis(model, one).logLikelihood(), 1e-12);
    }

    private static CovarianceShape shape(String kind) {
        return kind.equals("diag") ? CovarianceShape.DIAGONAL : CovarianceShape.FULL;
    }

    private static List<double[][]> sequences() {
        List<double[][]> sequences = new ArrayList<>();
        stored.get("sequences").forEach(sequence -> sequences.add(matrix(sequence)));
        return sequences;
    }

    private static HiddenMarkov model(String kind, JsonNode node) {
        List<Mixture> emissions = new ArrayList<>();
        for (int k = 0; k < node.get("initial").size(); k++) {
            if (kind.equals("mixture")) {
                List<Gaussian> components = new ArrayList<>();
                for (int m = 0; m < node.get("weights").get(k).size(); m++) {
                    components.add(gaussian(kind, node.get("means").get(k).get(m), node.get("covariances").get(k).get(m)));
                }
                emissions.add(new Mixture(vector(node.get("weights").get(k)), components));
            } else {
                emissions.add(Mixture.of(gaussian(kind, node.get("means").get(k), node.get("covariances").get(k))));
            }
        }
        return new HiddenMarkov(vector(node.get("initial")), matrix(node.get("transition")), emissions);
    }

    private static Gaussian gaussian(String kind, JsonNode mean, JsonNode covariance) {
        double[] centre = vector(mean);
        double[] flat = new double[centre.length * centre.length];
        for (int i = 0; i < centre.length; i++) {
            System.arraycopy(vector(covariance.get(i)), 0, flat, i * centre.length, centre.length);
        }
        return Gaussian.exact(shape(kind), centre, flat);
    }

    private static double[] vector(JsonNode node) {
        double[] values = new double[node.size()];
        for (int i = 0; i < values.length; i++) {
            values[i] = node.get(i).asDouble();
        }
        return values;
    }

    private static double[][] matrix(JsonNode node) {
        double[][] rows = new double[node.size()][];
        for (int i = 0; i < rows.length; i++) {
            rows[i] = vector(node.get(i));
        }
        return rows;
    }
}
