package wbv.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.InputStream;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

class DiscreteRiccatiTest {

    /** SciPy 1.17.1; see the README beside the file. */
    @TestFactory
    Stream<DynamicTest> solutionsAreThoseOfSciPy() throws IOException {
        try (InputStream in = DiscreteRiccatiTest.class.getResourceAsStream("riccati.json")) {
            return StreamSupport.stream(new ObjectMapper().readTree(in).get("cases").spliterator(), false)
                    .map(each -> DynamicTest.dynamicTest(each.get("a").size() + " states, " + each.get("r").size() + " inputs",
                            () -> check(each)));
        }
    }

    private static void check(JsonNode each) {
        DMatrixRMaj a = matrix(each.get("a"));
        DMatrixRMaj b = matrix(each.get("b"));
        DMatrixRMaj expected = matrix(each.get("x"));
        DMatrixRMaj h = matrix(each.get("q"));
        DMatrixRMaj g = gram(b, matrix(each.get("r")));
        DMatrixRMaj x = solve(a, g, h);
        double size = CommonOps_DDRM.elementMaxAbs(expected);
        for (int i = 0; i < expected.data.length; i++) {
            assertEquals(expected.data[i], x.data[i], 1e-9 * size, "element " + i);
        }
        assertTrue(DiscreteRiccati.residual(a, g, h, x) < 1e-11);
    }

    /** x = a² x / (1 + g x) + h of one state is a quadratic equation. */
    @Test
    void oneStateIsAQuadraticEquation() {
        DMatrixRMaj x = solve(new DMatrixRMaj(new double[][] {{2}}), new DMatrixRMaj(new double[][] {{3}}),
                new DMatrixRMaj(new double[][] {{5}}));
        double p = 3 * 5 + 4 - 1; // g x² + (1 - a² - g h) x - h = 0
        assertEquals((p + Math.sqrt(p * p + 4 * 3 * 5)) / 6, x.get(0, 0), 1e-12);
    }

    @Test
    void whatNoInputReachesAndGrowsHasNoSolution() {
        DiscreteRiccati riccati = new DiscreteRiccati(2);
        riccati.begin(CommonOps_DDRM.diag(1.1, 0.5), CommonOps_DDRM.diag(0, 1), CommonOps_DDRM.identity(2));
        while (!riccati.advance()) {
            assertThrows(IllegalStateException.class, riccati::solution);
        }
        assertFalse(riccati.solved());
        assertThrows(IllegalStateException.class, riccati::solution);
    }

    private static DMatrixRMaj solve(DMatrixRMaj a, DMatrixRMaj g, DMatrixRMaj h) {
        DiscreteRiccati riccati = new DiscreteRiccati(a.numRows);
        riccati.begin(a, g, h);
        int doublings = 1;
        while (!riccati.advance()) {
            doublings++;
        }
        assertTrue(doublings < 25, doublings + " doublings");
        return riccati.solution();
    }

    private static DMatrixRMaj gram(DMatrixRMaj b, DMatrixRMaj r) {
        DMatrixRMaj inverse = r.copy();
        CommonOps_DDRM.invert(inverse);
        DMatrixRMaj left = new DMatrixRMaj(b.numRows, b.numCols);
        CommonOps_DDRM.mult(b, inverse, left);
        DMatrixRMaj g = new DMatrixRMaj(b.numRows, b.numRows);
        CommonOps_DDRM.multTransB(left, b, g);
        return g;
    }

    private static DMatrixRMaj matrix(JsonNode rows) {
        DMatrixRMaj m = new DMatrixRMaj(rows.size(), rows.get(0).size());
        for (int i = 0; i < m.numRows; i++) {
            for (int j = 0; j < m.numCols; j++) {
                m.set(i, j, rows.get(i).get(j).asDouble());
            }
        }
        return m;
    }
}
