package wbv.exposure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.recording.format.RecordingFile;

/** That a level speaks for g, where nothing else says in what an acceleration is. */
class AssumedUnitTest {

    private static final SeatMeter.Setup USUAL = new SeatMeter.Setup(Optional.empty(), Optional.empty(), false);

    @TempDir
    Path folder;

    /** A seat that is shaken at random, so that its weighted acceleration is about two thirds of this [the column's unit]. */
    private SeatMeasurement measured(String column, double rms, double standing) throws IOException {
        Random random = new Random(8);
        StringBuilder text = new StringBuilder("t," + column + "\n");
        double slow = 0;
        for (int i = 0; i < 6000; i++) {
            slow = 0.7 * slow + random.nextGaussian();
            text.append(String.format(Locale.ROOT, "%.2f,%.7f%n", i / 100.0, standing + rms * slow / 1.4));
        }
        Path file = folder.resolve("ride.csv");
        Files.writeString(file, text);
        return SeatMeter.measure(new RecordingFile(file), USUAL, share -> {});
    }

    @Test
    void aQuietSeatMayBeInG() throws IOException {
        SeatMeasurement quiet = measured("seat.acc.z", 0.08, 0);
        double level = quiet.axes().get(SeatAxis.Z).rms();
        String message = quiet.unit().orElseThrow().message();
        assertTrue(message.contains("nothing states the unit of seat.acc and no gravity shows it: m/s² is assumed"), message);
        assertTrue(message.contains("A(8) " + RoundedNumber.text(9.80665 * level, 2) + " m/s²"), message);
        assertTrue(quiet.remarks().contains(quiet.unit().get()));
        assertTrue(quiet.unit().get().advice().contains("seat.acc.z [g]"), quiet.unit().get().advice());
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.006, 0.5, 2})
    void nothingIsSaidOfWhatMovesAsSeatsDoOrHardlyMoves(double rms) throws IOException {
        assertEquals(Optional.empty(), measured("seat.acc.z", rms, 0).unit());
    }

    @Test
    void whatStatesItsUnitIsBelieved() throws IOException {
        assertEquals(Optional.empty(), measured("seat.acc.z [m/s2]", 0.08, 0).unit());
        SeatMeasurement inG = measured("seat.acc.z_g", 0.08, 0);
        assertEquals(Optional.empty(), inG.unit());
        assertEquals(9.80665 * measured("seat.acc.z", 0.08, 0).axes().get(SeatAxis.Z).rms(), inG.axes().get(SeatAxis.Z).rms(), 1e-6);
    }

    @Test
    void gravityShowsTheUnit() throws IOException {
        for (String column : List.of("seat.acc.z", "seat.accg.z")) {
            assertEquals(Optional.empty(), measured(column, 0.08, 9.8).unit(), column);
        }
    }
}
