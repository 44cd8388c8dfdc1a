package wbv.exposure;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.recording.DataFault;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/** A meter that was saved and loaded goes on bit for bit. */
class MeterStateTest {

    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"50, WK, false", "60, WK, true", "60, WF, false", "240, WD, true", "1000, WD, false"})
    void aSavedMeterGoesOn(double rate, Weighting weighting, boolean boxcar) {
        Random random = new Random(3);
        Meter whole = Meter.stream(weighting.filter(), rate, boxcar);
        Meter resumed = Meter.stream(weighting.filter(), rate, boxcar);
        int samples = (int) (20 * rate);
        for (int i = 0; i < samples; i++) {
            // every place within the first seconds, where it waits for its level, then anywhere
            if (i < 2 * rate || random.nextInt(50) == 0) {
                byte[] state = StateWriter.of(whole);
                resumed = Meter.stream(weighting.filter(), rate, boxcar);
                StateReader.into(resumed, "meter", state);
                assertArrayEquals(state, StateWriter.of(resumed));
            }
            boolean gone = random.nextInt(30) == 0 || i > 5 * rate && i < 6.2 * rate;
            double value = gone ? Double.NaN : 9.81 + 2 * random.nextGaussian();
            whole.accept(value);
            resumed.accept(value);
            assertEquals(whole.vibration(), resumed.vibration());
            assertEquals(whole.running(), resumed.running());
        }
        whole.finish();
        resumed.finish();
        assertEquals(whole.vibration(), resumed.vibration());
        Meter other = Meter.stream(weighting.filter(), rate + 7, boxcar);
        byte[] state = StateWriter.of(whole);
        assertThrows(DataFault.class, () -> StateReader.into(other, "meter", state));
        assertThrows(IllegalStateException.class, () -> StateWriter.of(Meter.exact(weighting.filter(), rate, 0, boxcar)));
    }
}
