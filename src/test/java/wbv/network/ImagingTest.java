package wbv.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import wbv.network.ImagePlane.Kind;
import wbv.signal.Taper;

class ImagingTest {

    /** The result of SciPy, stored with how it was made. */
    @Test
    void theTransformIsScipys() throws IOException {
        double[] x = new double[Imaging.SAMPLES];
        Arrays.setAll(x, n -> Math.sin(0.3 * n) + 0.5 * Math.cos(1.1 * n + 0.4) + 0.01 * n * Math.sin(0.05 * n));
        double[][] frames = Imaging.transform(x);
        assertEquals(32, frames.length);
        for (String line : Files.readAllLines(Path.of("src/test/resources/wbv/network/stft.csv"))) {
            if (!line.startsWith("#")) {
                double[] expected = Arrays.stream(line.split(",")).mapToDouble(Double::parseDouble).toArray();
                double[] frame = frames[(int) expected[0]];
                assertEquals(64, frame.length);
                for (int i = 0; i < frame.length; i++) {
                    assertEquals(expected[1 + i], frame[i], 1e-9, "frame " + expected[0] + ", value " + i);
                }
            }
        }
    }

    /** An answer of twice the excitation, a quarter of a period late at 7.5 Hz (bin 8): gain ln 2, phase -90°. */
    @Test
    void gainAndPhaseAreThoseOfTheSignals() {
        double[][] motion = new double[2][Imaging.SAMPLES];
        Arrays.setAll(motion[0], n -> Math.cos(2 * Math.PI * 7.5 * n / 60));
        Arrays.setAll(motion[1], n -> 2 * Math.cos(2 * Math.PI * 7.5 * n / 60 - Math.PI / 2));
        Imaging imaging = new Imaging(List.of(new ImagePlane(Kind.GAIN, 0, 1), new ImagePlane(Kind.COSINE, 0, 1),
                new ImagePlane(Kind.SINE, 0, 1)));
        float[] image = imaging.image(motion);
        for (int t = 0; t < Imaging.FRAMES; t++) {
            int at = 7 * Imaging.FRAMES + t;
            assertEquals(Math.log(2), image[at], 1e-5);
            assertEquals(0, image[Imaging.PLANE + at], 1e-5);
            assertEquals(-1, image[2 * Imaging.PLANE + at], 1e-5);
        }
    }

    /**
     * The thesis' image: 3.75 Hz is bin 2 of 32 points at 60 Hz, of magnitude 1/2 · ΣHann = 32/4 for a cosine of amplitude 1, and stands as
     * far below the constant as above it; the 17 rows of a one-sided transform are all there is.
     */
    @Test
    void twoSidedImagesMirrorTheirRows() {
        double[][] motion = {new double[Imaging.SAMPLES]};
        Arrays.setAll(motion[0], n -> Math.cos(2 * Math.PI * 3.75 * n / 60));
        float[] image = new Imaging(List.of(ImagePlane.of(Kind.TWO_SIDED, 0))).image(motion);
        double sum = 0;
        for (int n = 0; n < 32; n++) {
            sum += Taper.hann(32).weight(n);
        }
        for (int t = 0; t < Imaging.FRAMES; t++) {
            assertEquals(Math.log(sum / 2), image[17 * Imaging.FRAMES + t], 1e-4);
            for (int k = 1; k < 16; k++) {
                assertEquals(image[(15 + k) * Imaging.FRAMES + t], image[(15 - k) * Imaging.FRAMES + t]);
            }
            assertEquals(Math.log(1e-8) / 2, image[25 * Imaging.FRAMES + t], 1e-3, "9 Hz away there is nothing but the floor");
        }
    }

    @Test
    void theLevelOfShakingIsTakenOutOfRelativePlanes() {
        double[][] weak = new double[1][Imaging.SAMPLES];
        SplittableRandom random = new SplittableRandom(1);
        Arrays.setAll(weak[0], n -> random.nextDouble(-1, 1));
        double[][] strong = {Arrays.stream(weak[0]).map(value -> 10 * value).toArray()};
        Imaging relative = new Imaging(List.of(ImagePlane.of(Kind.RELATIVE, 0)));
        Imaging level = new Imaging(List.of(ImagePlane.of(Kind.LEVEL, 0)));
        double difference = 0;
        for (int i = 0; i < Imaging.PLANE; i++) {
            assertEquals(relative.image(weak)[i], relative.image(strong)[i], 0.01);
            difference += (level.image(strong)[i] - level.image(weak)[i]) / Imaging.PLANE;
        }
        assertEquals(Math.log(10), difference, 0.01);
    }

    @Test
    void aPlaneOfTwoChannelsNeedsTwo() {
        assertThrows(IllegalArgumentException.class, () -> new ImagePlane(Kind.GAIN, 1, 1));
        assertThrows(IllegalArgumentException.class, () -> new ImagePlane(Kind.LEVEL, 0, 1));
        assertEquals(new ImagePlane(Kind.SINE, 0, 1), ImagePlane.parse(new ImagePlane(Kind.SINE, 0, 1).toString()));
    }
}
