package wbv.exposure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.RowReader;
import wbv.recording.format.RecordingFile;
import wbv.recording.inspect.Inspection;

/** What a meter says that heard little or nothing. */
class SeatMeterTest {

    private static final SeatMeter.Setup USUAL = new SeatMeter.Setup(Optional.empty(), Optional.empty(), false);

    @Test
    void whereEverySampleIsMissingThereIsNoExposure() throws IOException {
        RecordingFile file = new RecordingFile(Path.of("data/arff/states-other.arff"));
        Inspection inspection = file.inspect();
        List<Channel> channels;
        try (RowReader reader = file.open()) {
            channels = reader.channels();
        }
        SeatMeter meter = SeatMeter.of(inspection, USUAL, channels);
        double[] row = new double[1 + channels.size()];
        Arrays.fill(row, Double.NaN);
        for (int i = 0; i < 7200; i++) {
            meter.accept(row);
        }
        DataFault fault = assertThrows(DataFault.class, () -> meter.finish(Metadata.NONE));
        assertEquals("data/arff/states-other.arff: has no stretch of seat without gaps that could be weighed", fault.getMessage());
    }
}
