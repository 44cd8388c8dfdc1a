package wbv.report.analysis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.util.Base64;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import wbv.report.page.ChartAxis;
import wbv.report.page.ChartJson;
import wbv.report.page.LineChart;
import wbv.report.page.Series;
import wbv.study.Waveform;

/** Long signals: what is kept of them, and what the page holds. */
class WaveformTest {

    private static final int SHOCK = 54_321;

    /** A ride with one sample of a shock and some that are lost. */
    private static double[] ride() {
        Random random = new Random(3);
        double[] ride = new double[100_000];
        for (int i = 0; i < ride.length; i++) {
            ride[i] = i % 700 == 5 ? Double.NaN : random.nextGaussian();
        }
        ride[SHOCK] = 60;
        return ride;
    }

    private static Waveform waveform(int most, double[] signal) {
        Waveform waveform = new Waveform(most);
        for (double value : signal) {
            waveform.accept(value);
        }
        return waveform;
    }

    @Test
    void everySampleIsThereWhileThereIsRoom() {
        double[] ride = ride();
        Series series = WaveformSeries.of("a", waveform(100_000, ride), 12, 1 / 60.0);
        assertEquals(0, series.band().lower().length);
        for (int i = 0; i < ride.length; i++) {
            assertEquals(ride[i], series.y()[i], 0.0);
            assertEquals(12 + i / 60.0, series.x()[i], 1e-9);
        }
    }

    @Test
    void beyondItsRoomItKeepsTheRange() {
        double[] ride = ride();
        Waveform waveform = waveform(3000, ride);
        Series series = WaveformSeries.of("a", waveform, 0, 1);
        int width = waveform.width();
        assertEquals(64, width);
        for (int k = 0; k < series.x().length; k++) {
            double least = Double.NaN;
            double most = Double.NaN;
            for (int i = k * width; i < Math.min(ride.length, (k + 1) * width); i++) {
                least = Double.isNaN(least) || ride[i] < least ? ride[i] : least;
                most = Double.isNaN(most) || ride[i] > most ? ride[i] : most;
            }
            assertEquals(least, series.band().lower()[k]);
            assertEquals(most, series.band().upper()[k]);
        }
        assertEquals(60, series.band().upper()[SHOCK / width], "a shock of one sample is not lost");
    }

    @Test
    void aGapLongerThanAPointStaysAGap() {
        Waveform waveform = new Waveform(4);
        for (int i = 0; i < 16; i++) {
            waveform.accept(i >= 4 && i < 8 ? Double.NaN : i);
        }
        Series series = WaveformSeries.of("a", waveform, 0, 1);
        assertEquals(4, waveform.width());
        assertTrue(Double.isNaN(series.y()[1]) && Double.isNaN(series.band().lower()[1]) && Double.isNaN(series.band().upper()[1]));
        assertEquals(0, series.band().lower()[0]);
        assertEquals(15, series.band().upper()[3]);
    }

    /** Two bytes a sample: each is read back within half a step, a lost one as lost, the shock at its very sample. */
    @Test
    void thePageHoldsEverySampleWithinHalfAStep() throws IOException {
        double[] ride = ride();
        LineChart chart = new LineChart("c", ChartAxis.linear("Time", "s"), ChartAxis.linear("a", "m/s²"),
                List.of(WaveformSeries.of("a", waveform(100_000, ride), 0, 1 / 60.0)));
        String json = ChartJson.of(chart);
        assertTrue(json.length() < 3 * ride.length, json.length() + " letters for " + ride.length + " samples");
        JsonNode y = new ObjectMapper().readTree(json).get("series").get(0).get("y");
        byte[] bytes = Base64.getDecoder().decode(y.get("codes").asText());
        assertEquals(2 * ride.length, bytes.length);
        double low = y.get("low").asDouble();
        double step = y.get("step").asDouble();
        int highest = 0;
        for (int i = 0; i < ride.length; i++) {
            int code = (short) (bytes[2 * i] & 0xff | bytes[2 * i + 1] << 8);
            double value = code == Short.MIN_VALUE ? Double.NaN : low + (code + 32767) * step;
            assertEquals(ride[i], value, 0.5 * step * (1 + 1e-9));
            highest = code > (short) (bytes[2 * highest] & 0xff | bytes[2 * highest + 1] << 8) ? i : highest;
        }
        assertEquals(SHOCK, highest);
    }

    @Test
    void aCurveWithoutAnyValueIsWrittenToo() throws IOException {
        double[] x = new double[ChartJson.LONG];
        double[] nothing = new double[x.length];
        double[] constant = new double[x.length];
        for (int i = 0; i < x.length; i++) {
            x[i] = i;
            nothing[i] = Double.NaN;
            constant[i] = 9.81;
        }
        JsonNode series = new ObjectMapper().readTree(ChartJson.of(new LineChart("c", ChartAxis.linear("t", "s"), ChartAxis.linear("a", ""),
                List.of(Series.line("nothing", x, nothing), Series.line("constant", x, constant))))).get("series");
        byte[] lost = Base64.getDecoder().decode(series.get(0).get("y").get("codes").asText());
        assertEquals(0, lost[0]);
        assertEquals((byte) 0x80, lost[1]);
        assertEquals(9.81, series.get(1).get("y").get("low").asDouble());
        assertEquals(-32767, (short) (Base64.getDecoder().decode(series.get(1).get("y").get("codes").asText())[1] << 8 | 1));
    }
}
