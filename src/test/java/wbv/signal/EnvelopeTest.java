package wbv.signal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class EnvelopeTest {

    @ParameterizedTest
    @ValueSource(ints = {1, 9, 10, 11, 79, 80, 81, 12_345})
    void bucketsAreTheExtremesOfTheirStretch(int samples) {
        double[] signal = new Random(samples).doubles(samples, -5, 5).toArray();
        Envelope envelope = new Envelope(10);
        DoubleStream.of(signal).forEach(envelope::accept);
        assertTrue(envelope.size() <= 10);
        assertEquals((samples + envelope.width() - 1) / envelope.width(), envelope.size());
        for (int i = 0; i < envelope.size(); i++) {
            int from = i * envelope.width();
            int to = Math.min(samples, from + envelope.width());
            double[] stretch = Arrays.copyOfRange(signal, from, to);
            assertEquals(DoubleStream.of(stretch).min().orElseThrow(), envelope.smallest(i));
            assertEquals(DoubleStream.of(stretch).max().orElseThrow(), envelope.largest(i));
            assertEquals(DoubleStream.of(stretch).average().orElseThrow(), envelope.mean(i), 1e-12);
            assertEquals((from + to - 1) / 2.0, envelope.centre(i));
        }
    }

    @Test
    void missingSamplesAreLeftOut() {
        Envelope envelope = new Envelope(2);
        for (double value : new double[] {Double.NaN, Double.NaN, 3, Double.NaN}) {
            envelope.accept(value);
        }
        assertEquals(Double.NaN, envelope.smallest(0));
        assertEquals(Double.NaN, envelope.mean(0));
        assertEquals(3, envelope.mean(1));
    }
}
