package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class IntervalTest {

    @Test
    void noRootMeanSquareIsBelowZero() {
        Interval doubtful = Interval.normal(4, 8.5).notBelow(0);
        assertEquals(0, doubtful.low());
        assertEquals(4 + Interval.Z * 8.5, doubtful.high(), 1e-12);
        assertEquals(Interval.normal(40, 8.5), Interval.normal(40, 8.5).notBelow(0));
    }
}
