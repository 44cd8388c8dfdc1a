package wbv.signal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Random;
import org.apache.commons.math3.complex.Complex;
import org.apache.commons.math3.transform.DftNormalization;
import org.apache.commons.math3.transform.FastFourierTransformer;
import org.apache.commons.math3.transform.TransformType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class FftTest {

    @ParameterizedTest
    @ValueSource(ints = {4, 8, 16, 256, 4096})
    void spectrumIsThatOfCommonsMath(int length) {
        double[] data = noise(length);
        Complex[] expected = new FastFourierTransformer(DftNormalization.STANDARD).transform(data, TransformType.FORWARD);
        new Fft(length).forward(data);
        double tolerance = 1e-13 * length;
        assertEquals(expected[0].getReal(), data[0], tolerance);
        assertEquals(expected[length / 2].getReal(), data[1], tolerance);
        for (int k = 1; k < length / 2; k++) {
            assertEquals(expected[k].getReal(), data[2 * k], tolerance, "real part of bin " + k);
            assertEquals(expected[k].getImaginary(), data[2 * k + 1], tolerance, "imaginary part of bin " + k);
        }
    }

    @Test
    void spectrumIsTheDefiningSum() {
        double[] data = noise(32);
        double[] x = data.clone();
        new Fft(32).forward(data);
        for (int k = 1; k < 16; k++) {
            double re = 0;
            double im = 0;
            for (int n = 0; n < 32; n++) {
                re += x[n] * Math.cos(2 * Math.PI * k * n / 32);
                im -= x[n] * Math.sin(2 * Math.PI * k * n / 32);
            }
            assertEquals(re, data[2 * k], 1e-12);
            assertEquals(im, data[2 * k + 1], 1e-12);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {4, 8, 1024})
    void inverseRestoresTheSequence(int length) {
        double[] data = noise(length);
        double[] x = data.clone();
        Fft fft = new Fft(length);
        fft.forward(data);
        fft.inverse(data);
        assertArrayEquals(x, data, 1e-13);
    }

    @ParameterizedTest
    @ValueSource(ints = {-8, 0, 2, 12, 1000})
    void lengthMustBeAPowerOfTwo(int length) {
        assertThrows(IllegalArgumentException.class, () -> new Fft(length));
    }

    private static double[] noise(int length) {
        return new Random(length).doubles(length, -1, 1).toArray();
    }
}
