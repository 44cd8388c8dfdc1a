package wbv.recording.format;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.recording.RowReader;

/** The ways in which programs and places write the same table. */
class PlainTextTest {

    @TempDir
    Path folder;

    @ParameterizedTest
    @ValueSource(strings = {
        "t,head.acc.z\n0,1.5\n0.5,-2\n",
        "\uFEFFt,head.acc.z\r\n0,1.5\r\n0.5,-2\r\n",
        "t;head.acc.z\n0;1,5\n0,5;-2",
        "t\thead.acc.z\n0\t1.5\n0.5\t-2\n\n\n",
        "# made by hand\n\n \"t\" , \"head.acc.z\" ,\n 0 , 1.5 ,\n\"0.5\",\"-2\",\n# end\n",
        "head.acc.z,t\n+1.5,0.0\n-2e0,5E-1\n",
        "@RELATION x\r\n@ATTRIBUTE t REAL\r\n@ATTRIBUTE \"head.acc.z\" NUMERIC\r\n@DATA\r\n0,1.5\r\n\r\n0.5,-2\r\n"})
    void theyAllReadTheSame(String text) throws IOException {
        List<double[]> rows = Samples.rows(Samples.recording(folder, "r.csv", text).open());
        assertEquals(2, rows.size());
        assertArrayEquals(new double[] {0, 1.5}, rows.get(0));
        assertArrayEquals(new double[] {0.5, -2}, rows.get(1));
    }

    @Test
    void rowsLongerThanTheBufferAreRead() throws IOException {
        int channels = 20_000;
        StringBuilder text = new StringBuilder("t");
        for (int i = 0; i < channels; i++) {
            text.append(",place_").append(i).append(".acc.z");
        }
        for (int row = 0; row < 3; row++) {
            text.append('\n').append(row);
            for (int i = 0; i < channels; i++) {
                text.append(',').append(row * 0.5 + i);
            }
        }
        List<double[]> rows = Samples.rows(Samples.recording(folder, "wide.csv", text.toString()).open());
        assertEquals(3, rows.size());
        assertEquals(1.0 + channels - 1, rows.get(2)[channels]);
    }

    @Test
    void howFarAReaderIsGrowsToOne() throws IOException {
        StringBuilder text = new StringBuilder("t,head.acc.z\n");
        for (int i = 0; i < 100_000; i++) {
            text.append(i).append(",0.25\n");
        }
        try (RowReader reader = Samples.recording(folder, "r.csv", text.toString()).open()) {
            double[] row = new double[2];
            double last = reader.fractionRead();
            assertTrue(last > 0 && last < 0.2, "at first " + last);
            for (int i = 0; reader.read(row); i++) {
                assertTrue(reader.fractionRead() >= last && reader.fractionRead() >= i / 100_000.0 - 0.05);
                last = reader.fractionRead();
            }
            assertEquals(1, last);
        }
    }
}
