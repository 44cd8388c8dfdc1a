package wbv.filter.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.lang.reflect.RecordComponent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.apache.commons.math3.analysis.integration.SimpsonIntegrator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.filter.EstimatorDesign;
import wbv.filter.Method;
import wbv.filter.drift.Adwin;

class AdaptationTest {

    @Test
    void usualNumbersAreAccepted() {
        assertEquals(10, Adaptation.USUAL.wandering().ratio());
    }

    @Test
    void onePartIsReplaced() {
        Adaptation.Scatter longer = new Adaptation.Scatter(12, 20);
        Adaptation other = Adaptation.USUAL.with(longer);
        assertEquals(longer, other.scatter());
        assertEquals(Adaptation.USUAL, other.with(Adaptation.USUAL.scatter()));
    }

    @Test
    void everyPartIsPutWhereItBelongs() throws ReflectiveOperationException {
        for (RecordComponent group : Adaptation.class.getRecordComponents()) {
            Adaptation.Part part = (Adaptation.Part) group.getAccessor().invoke(Adaptation.USUAL);
            assertEquals(Adaptation.USUAL, Adaptation.USUAL.with(part), group.getName());
        }
    }

    /** Estimators are made of the numbers that they are given: with a wide prior the deviation starts wide. */
    @Test
    void anEstimatorAdaptsByWhatItIsGiven() {
        Adaptation.Prior usual = Adaptation.USUAL.prior();
        Adaptation wide = Adaptation.USUAL
                .with(new Adaptation.Prior(1, usual.motion(), usual.offset(), usual.apart(), usual.firstsShare()));
        for (Method method : Method.values()) {
            double ratio = deviation(Spec.at(60).adapting(wide), method) / deviation(Spec.at(60), method);
            assertTrue(ratio > 1.1, method + ": " + ratio);
        }
    }

    private static double deviation(Spec spec, Method method) {
        return EstimatorDesign.of(method).estimator(spec, Adwin::new).step(0, 0).frequencyDeviation();
    }

    @Test
    void theDocumentHasEveryNumberAsItIs() throws ReflectiveOperationException, IOException {
        List<String> rows = Files.readAllLines(Path.of("docs/adaptation.md")).stream().filter(line -> line.startsWith("| "))
                .map(line -> line.split(" \\| ")).filter(cells -> cells[0].contains("."))
                .map(cells -> cells[0].substring(2) + " " + cells[1])
                .toList();
        List<String> numbers = new ArrayList<>();
        for (RecordComponent group : Adaptation.class.getRecordComponents()) {
            Object part = group.getAccessor().invoke(Adaptation.USUAL);
            for (RecordComponent each : group.getType().getRecordComponents()) {
                numbers.add(group.getName() + "." + each.getName() + " " + each.getAccessor().invoke(part));
            }
        }
        assertEquals(numbers, rows);
    }

    @Test
    void whatCannotBeIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> new Adaptation.Scatter(0, 20));
        assertThrows(IllegalArgumentException.class, () -> new Adaptation.Scatter(3, Double.NaN));
        assertThrows(IllegalArgumentException.class, () -> new Adaptation.Prior(0.5, 1, 1, 0.9, 0.8), "the second mode below the first");
        assertThrows(IllegalArgumentException.class, () -> new Adaptation.Particles(1.1, 40, 0.25, 0.5, 0.5, 20, 0.03, 1.5));
        assertThrows(IllegalArgumentException.class, () -> new Adaptation.Particles(0.98, 40, 0.25, 0.5, 30, 20, 0.03, 1.5));
    }

    /** E[min(z², m)] of a standard normal z, by quadrature. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 2, 4, 8})
    void surpriseThatIsExpectedIsTheMeanOfALimitedSquare(double most) {
        double mean = 2 * new SimpsonIntegrator().integrate(10_000_000,
                z -> Math.min(z * z, most) * Math.exp(-z * z / 2) / Math.sqrt(2 * Math.PI), 0, 9);
        assertEquals(mean, new Adaptation.Wandering(0.5, 0.1, 60, 0.25, 10, 300, 3, 2, most).expectedSurprise(), 6e-5);
    }
}
