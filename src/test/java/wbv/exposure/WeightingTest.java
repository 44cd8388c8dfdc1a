package wbv.exposure;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The weightings against the numbers that the standards print. */
class WeightingTest {

    static List<String[]> table(String name) throws IOException {
        try (InputStream in = WeightingTest.class.getResourceAsStream(name)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8).lines().filter(line -> !line.startsWith("#"))
                    .map(line -> line.split(",")).toList();
        }
    }

    private static Weighting named(String symbol) {
        return Arrays.stream(Weighting.values()).filter(w -> w.symbol().startsWith(symbol)).findFirst().orElseThrow();
    }

    /** Factors at true third-octave centres, four digits each: 333 values within 0.1 %. */
    @Test
    void designGoalsAreReachedWithinATenthOfAPercent() throws IOException {
        List<String[]> rows = table("weighting-factors.csv");
        int compared = 0;
        for (String[] row : rows.subList(1, rows.size())) {
            double frequency = Math.pow(10, Integer.parseInt(row[0]) / 10.0);
            for (int i = 1; i < row.length; i++) {
                double goal = Double.parseDouble(row[i]);
                assertEquals(goal, named(rows.get(0)[i]).factor(frequency), 1e-3 * goal, rows.get(0)[i] + " at " + frequency
                        + " Hz");
                compared++;
            }
        }
        assertEquals(333, compared);
    }

    /** ISO 8041-1 Table 1: factors at 100 rad/s, for Wf at 2.5 rad/s, to the four digits printed. */
    @ParameterizedTest
    @CsvSource({"WK,0.7718", "WD,0.1261", "WC,0.5145", "WE,0.06287", "WJ,1.019", "WB,0.8126", "WM,0.3362", "WF,0.3888"})
    void factorsAtTheReferenceFrequency(Weighting weighting, double factor) {
        double reference = (weighting == Weighting.WF ? 2.5 : 100) / (2 * Math.PI);
        assertEquals(factor, weighting.factor(reference), 6e-4 * factor);
    }

    /** The table of 1997 is at nominal frequencies, and misprints Wd at 10 Hz. */
    @Test
    void thePrintedTableOf1997HoldsButForItsMisprint() throws IOException {
        List<String[]> rows = table("iso2631-1-table3.csv");
        int off = 0;
        for (String[] row : rows.subList(1, rows.size())) {
            double frequency = Double.parseDouble(row[0]);
            for (int i = 1; i <= 2; i++) {
                double printed = Double.parseDouble(row[i]);
                double factor = named(rows.get(0)[i]).factor(frequency);
                if (Math.abs(factor / printed - 1) > 0.005) {
                    assertEquals("Wd at 10", rows.get(0)[i] + " at " + row[0]);
                    assertEquals(0.2017, factor, 1e-4);
                    off++;
                }
            }
        }
        assertEquals(23, rows.size() - 1);
        assertEquals(1, off);
    }

    /** Biquads of Wk at 480 and 240 Hz computed with SciPy's bilinear from the same sections, to ten decimals. */
    @Test
    void biquadsAreThoseOfTheBilinearTransform() {
        double[] at480 = {0.9963044514, -1.9926089028, 0.9963044514, -1.9925952457, 0.9926225599,
            0.1819770236, 0.3639540472, 0.1819770236, -0.4856748647, 0.2135829591,
            0.0778718457, 0.0117781531, -0.0660936927, -1.7479269662, 0.7714832724,
            0.9928862486, -1.9515593822, 0.9596124896, -1.9510906490, 0.9529674713};
        double[] at240 = {0.9926226099, -1.9852452198, 0.9926226099, -1.9851907932, 0.9852996465,
            0.3753768412, 0.7507536824, 0.3753768412, 0.3126063125, 0.1889010524,
            0.1479972231, 0.0416216512, -0.1063755718, -1.5129903564, 0.5962336589,
            0.9856611441, -1.9027270065, 0.9207319143, -1.9008976681, 0.9082223967};
        assertArrayEquals(at240, gainsSpreadAs(Weighting.WK.filter().cascade(240).coefficients(), at240), 2e-10);
        assertArrayEquals(at480, gainsSpreadAs(Weighting.WK.filter().cascade(480).coefficients(), at480), 2e-10);
    }

    /** The gain (ω5/ω6)² may stand in any section; it is moved to where the reference has it. */
    private static double[] gainsSpreadAs(double[] ours, double[] reference) {
        double[] moved = ours.clone();
        for (int section = 0; section < ours.length; section += 5) {
            double by = reference[section] / ours[section];
            for (int i = 0; i < 3; i++) {
                moved[section + i] *= by;
            }
        }
        double whole = 1;
        for (int section = 0; section < ours.length; section += 5) {
            whole *= reference[section] / ours[section];
        }
        double step = 2.37 / 3.35;
        assertTrue(Math.abs(whole - 1) < 1e-8 || Math.abs(whole * step * step - 1) < 1e-8, "gain differs by " + whole);
        return moved;
    }

    @Test
    void tolerancesAreThoseOfTable5() {
        assertEquals(new Weighting.Tolerance(0.11, 0.12), Weighting.WK.tolerance(8));
        assertEquals(new Weighting.Tolerance(0.21, 0.26), Weighting.WK.tolerance(0.4));
        assertEquals(new Weighting.Tolerance(0.21, 0.26), Weighting.WD.tolerance(80));
        assertEquals(new Weighting.Tolerance(1, 0.26), Weighting.WD.tolerance(Math.pow(10, 2.2)));
        assertEquals(new Weighting.Tolerance(0.11, 0.12), Weighting.WF.tolerance(0.2));
        assertEquals(new Weighting.Tolerance(1, 0.26), Weighting.WF.tolerance(2));
    }

    /** The weighting of an angular rate is that of its derivative: jω times the rate. */
    @Test
    void aRateIsDifferentiatedOnTheWay() {
        for (double frequency : new double[] {0.5, 1, 4, 25}) {
            assertEquals(2 * Math.PI * frequency * Weighting.WE.factor(frequency),
                    ComfortAxis.PITCH.filter().modulus(frequency), 1e-9, frequency + " Hz");
        }
    }

    @Test
    void aLowRateIsALowerBound() {
        CoveredBand slow = CoveredBand.of(Weighting.WK, 60);
        assertTrue(slow.lowerBound());
        assertEquals("0.5 to 23.4 Hz: a lower bound, not ISO 8041-1 conformant above 23.4 Hz", slow.words());
        assertEquals("0.5 to 80 Hz", CoveredBand.of(Weighting.WD, 256).words());
        assertEquals("0.1 to 0.5 Hz", CoveredBand.of(Weighting.WF, 60).words());
    }
}
