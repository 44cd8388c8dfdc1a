package wbv.recording.format;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Map;
import org.junit.jupiter.api.Test;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Recording;

class RecordingTest {

    private static final Recording WHOLE = new Recording(new Clock(2, 10), Map.of(Samples.HEAD, new double[] {5, 6, Double.NaN, 8, 9}),
            Metadata.NONE);

    @Test
    void aPartKeepsItsTimes() {
        Recording part = WHOLE.part(1, 4);
        assertArrayEquals(new double[] {6, Double.NaN, 8}, part.values(Samples.HEAD));
        assertEquals(WHOLE.clock().time(1), part.clock().time(0));
        assertEquals(WHOLE.metadata(), part.metadata());
    }

    @Test
    void aPartLiesWithinTheWhole() {
        assertThrows(IllegalArgumentException.class, () -> WHOLE.part(-1, 3));
        assertThrows(IllegalArgumentException.class, () -> WHOLE.part(2, 6));
        assertThrows(IllegalArgumentException.class, () -> WHOLE.part(3, 3));
    }
}
