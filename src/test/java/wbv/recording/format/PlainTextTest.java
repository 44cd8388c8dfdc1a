package wbv.recording.format;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.recording.DataFault;
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
        "sep=;\r\nt;head.acc.z\r\n0;1,5\r\n0,5;-2\r\n",
        "# made by hand\n\n \"t\" , \"head.acc.z\" ,\n 0 , 1.5 ,\n\"0.5\",\"-2\",\n# end\n",
        "head.acc.z,t\n+1.5,0.0\n-2e0,5E-1\n",
        "@RELATION x\r\n@ATTRIBUTE t REAL\r\n@ATTRIBUTE \"head.acc.z\" NUMERIC\r\n@DATA\r\n0,1.5\r\n\r\n0.5,-2\r\n"})
    void theyAllReadTheSame(String text) throws IOException {
        List<double[]> rows = Samples.rows(Samples.recording(folder, "r.csv", text).open());
        assertEquals(2, rows.size());
        assertArrayEquals(new double[] {0, 1.5}, rows.get(0));
        assertArrayEquals(new double[] {0.5, -2}, rows.get(1));
    }

    /** As Excel saves a CSV on Windows, where m/s² is no UTF-8. */
    @Test
    void whatIsNoUtf8IsReadAsWindowsWritesIt() throws IOException {
        byte[] text = "# Gerät: 3\nt;head.acc.z\ns;mm/s²\n0;1500\n0,5;-2000\n".getBytes(Charset.forName("windows-1252"));
        Path file = Files.write(folder.resolve("r.csv"), text);
        try (RowReader reader = new RecordingFile(file).open()) {
            assertEquals("3", reader.metadata().notes().get("Gerät"));
            assertArrayEquals(new double[] {0, 1.5}, Samples.rows(reader).get(0), 1e-15);
        }
    }

    /** What is wrong is told of the column that is wrong, and what would be right. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "2025-03-04T10:15:00;#DIV/0!|r.csv:2: column head.acc.z must be a finite number, or empty where it is missing: '#DIV/0!'",
        "2025-03-04T10:15:00;1.838,001|r.csv:2: column head.acc.z must be a finite number without marks between thousands",
        "04.03.2025 10:15:00,000;1|r.csv:2: column t must be a number, or a date and time of ISO 8601, such as 2025-03-04T10:15:00.005",
        "10 s;1|r.csv:2: column t must be a finite number"})
    void aCellThatIsNoNumberIsToldWithItsColumn(String row, String told) throws IOException {
        RecordingFile file = Samples.recording(folder, "r.csv", "t;head.acc.z\n" + row + "\n");
        String message = assertThrows(DataFault.class, () -> Samples.rows(file.open())).getMessage();
        assertTrue(message.contains(told), message);
    }

    @Test
    void decimalCommasBetweenCommasAreToldAsThat() throws IOException {
        RecordingFile file = Samples.recording(folder, "r.csv", "t,head.acc.z,seat.acc.z\n0,00,1,5,2,5\n");
        String message = assertThrows(DataFault.class, () -> Samples.rows(file.open())).getMessage();
        assertTrue(message.contains("the row has 6 cells where the header names 3; where commas are decimal, part the cells by semicolons"),
                message);
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
