package wbv.report.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.report.page.Figures.Figure;

/** Numbers for people, and what records refuse. */
class FiguresTest {

    @ParameterizedTest
    @CsvSource({"3.14159, 3.142", "0, 0", "-0.5, −0.5", "12345.6, 12350", "0.00012345, 0.0001234", "99.999, 100",
        "0.1, 0.1", "300, 300", "1.5e-7, 1.5 · 10⁻⁷", "-2.5e9, −2.5 · 10⁹", "NaN, –", "Infinity, –"})
    void atMostFourSignificantDigitsAreShown(double value, String shown) {
        assertEquals(shown, Figure.of("x", value, "").value());
    }

    @ParameterizedTest
    @CsvSource({"4.4123, 0.0211, 4.412, ± 0.042", "1234.5, 123, 1230, ± 250", "0.35, 0.00496, 0.3500, ± 0.0099",
        "0.35, 0.004999, 0.350, ± 0.010", "-5, 0.5, −5.0, ± 1.0", "7.25, 0, 7.25, ''", "7.25, NaN, 7.25, ''"})
    void uncertaintyIsTwoDeviationsAndSetsTheDigits(double value, double deviation, String shown, String uncertainty) {
        Figure figure = Figure.measured("x", value, deviation, "Hz");
        assertEquals(shown, figure.value());
        assertEquals(uncertainty, figure.uncertainty());
    }

    @Test
    void recordsRefuseWhatCannotBeDrawn() {
        double[] two = {1, 2};
        assertThrows(IllegalArgumentException.class, () -> Series.line("a", two, new double[3]));
        assertThrows(IllegalArgumentException.class, () -> Series.line("a", new double[] {2, 1}, two));
        assertThrows(IllegalArgumentException.class, () -> Series.line("a", new double[] {1, Double.NaN}, two));
        assertThrows(IllegalArgumentException.class, () -> ChartAxis.log("f", "Hz").within(0, 10));
        assertThrows(IllegalArgumentException.class, () -> ChartAxis.linear("t", "s").within(2, 1));
        assertThrows(IllegalArgumentException.class,
                () -> new Table("", List.of(Table.Column.words("a")), List.of(List.of("1", "2"))));
        assertThrows(IllegalArgumentException.class, () -> new Heatmap("m", ChartAxis.linear("t", "s"), ChartAxis.linear("f", "Hz"),
                ChartAxis.linear("PSD", "dB"), two, two, new double[2][3]));
    }
}
