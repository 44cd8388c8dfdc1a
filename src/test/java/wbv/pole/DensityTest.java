package wbv.pole;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Clusters against scikit-learn's labels on stored data. */
class DensityTest {

    private double[][] rows;
    private double[][] points;

    @BeforeEach
    void read() throws IOException {
        try (InputStream in = DensityTest.class.getResourceAsStream("clusters.csv")) {
            rows = new String(in.readAllBytes(), StandardCharsets.UTF_8).lines().skip(3)
                    .map(line -> Arrays.stream(line.split(",")).mapToDouble(Double::parseDouble).toArray())
                    .toArray(double[][]::new);
        }
        points = Arrays.stream(rows).map(row -> new double[] {row[0], row[1]}).toArray(double[][]::new);
    }

    @Test
    void dbscanLabelsAreThoseOfScikitLearn() {
        assertArrayEquals(Density.inOrder(column(2)), Density.dbscan(points, 0.3, 6));
    }

    @Test
    void opticsCutLabelsAreThoseOfScikitLearn() {
        assertArrayEquals(Density.inOrder(column(3)), Density.optics(points, 0.3, 6));
    }

    @Test
    void kDistancesAreThoseOfScikitLearn() {
        double[] expected = Arrays.stream(rows).mapToDouble(row -> row[4]).toArray();
        assertArrayEquals(expected, KDistance.of(points, 6).distance(), 1e-9);
    }

    @Test
    void theKneeOfACurveOfTwoLinesIsItsCorner() {
        // Along a line points are 1 apart; the stragglers' distances double, so the curve bends where they begin.
        double[][] line = new double[60][2];
        for (int i = 0; i < 60; i++) {
            line[i][0] = i < 50 ? i : 50 + 20.0 * (i - 49) * (i - 49);
        }
        KDistance curve = KDistance.of(line, 2);
        assertEquals(1, curve.epsilon(), 1e-12);
    }

    @Test
    void mixtureFindsRoundClustersThatLieApart() {
        Well19937c random = new Well19937c(2);
        double[][] blobs = new double[150][];
        for (int i = 0; i < blobs.length; i++) {
            blobs[i] = new double[] {10 * (i / 50) + 0.3 * random.nextGaussian(), 0.3 * random.nextGaussian()};
        }
        int[] labels = WekaMixture.labels(blobs, 6, 1);
        assertEquals(labels[10], labels[40]);
        assertTrue(labels[10] != labels[60] && labels[60] != labels[120] && labels[10] != labels[120]);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -1, Double.NaN})
    void anEpsilonThatIsNoneIsRefused(double epsilon) {
        assertThrows(IllegalArgumentException.class, () -> Density.dbscan(points, epsilon, 6));
    }

    @Test
    void fewPointsAreAllNoise() {
        assertArrayEquals(new int[] {-1, -1}, Density.dbscan(new double[][] {{0, 0}, {1, 1}}, 5, 3));
        assertArrayEquals(new int[] {-1, -1}, Density.optics(new double[][] {{0, 0}, {1, 1}}, 5, 3));
        assertEquals(0, Density.dbscan(new double[0][], 1, 3).length);
    }

    private int[] column(int i) {
        return Arrays.stream(rows).mapToInt(row -> (int) row[i]).toArray();
    }
}
