package wbv.network;

import java.io.Serializable;
import java.util.List;
import wbv.signal.Fft;
import wbv.signal.Taper;

/**
 * Short-time Fourier images of {@value #BINS} frequencies by {@value #FRAMES} moments from {@value #SAMPLES} samples (3.65 s) at
 * {@value #RATE} Hz.
 *
 * <p>The thesis says "32-point" and "32 by 32", which a one-sided transform of 32 points (17 bins) does not give. Here: segments
 * of
 * {@value #SEGMENT} samples, each less its mean, under Hann's window, every {@value #HOP} samples; bins 1 to 32 of 0.94 Hz to
 * 30 Hz, the constant left out. {@link ImagePlane.Kind#TWO_SIDED} is the other way to read it: segments of 32 samples, two-sided, every
 * 6.
 *
 * @param planes what of which channel, in order
 */
public record Imaging(List<ImagePlane> planes) implements Serializable {

    /** Samples per second of what is looked at [Hz]. */
    public static final double RATE = 60;
    /** Samples in a segment. */
    public static final int SEGMENT = 64;
    /** Samples from one segment to the next. */
    public static final int HOP = 5;
    /** Moments in an image. */
    public static final int FRAMES = 32;
    /** Frequencies in an image. */
    public static final int BINS = SEGMENT / 2;
    /** Samples that an image is made of. */
    public static final int SAMPLES = SEGMENT + (FRAMES - 1) * HOP;
    /** Points of a segment of the thesis' own images: two-sided, they give as many rows. */
    private static final int SHORT = BINS;
    /** From one of them to the next: the most that {@value #FRAMES} of them in {@value #SAMPLES} samples leave. */
    private static final int SHORT_HOP = (SAMPLES - SHORT) / (FRAMES - 1);
    /** Values of a plane: frequency by frequency, each moment by moment. */
    public static final int PLANE = BINS * FRAMES;

    /** Square of a magnitude that no sensor of today resolves [(m/s²)²]: keeps logarithms finite where a channel stands still. */
    private static final double FLOOR = 1e-8;

    public Imaging {
        planes = List.copyOf(planes);
        if (planes.isEmpty()) {
            throw new IllegalArgumentException("an image needs a plane");
        }
    }

    /** Values of an image. */
    public int size() {
        return planes.size() * PLANE;
    }

    /** Channels that are needed, counted from 0. */
    public int channels() {
        return 1 + planes.stream().mapToInt(plane -> Math.max(plane.first(), plane.second())).max().orElseThrow();
    }

    /**
     * The image of a stretch of motion.
     *
     * @param motion channel by channel, {@value #SAMPLES} finite samples each, each in its own unit. Not modified.
     * @return plane by plane, not yet standardised
     */
    public float[] image(double[][] motion) {
        double[][][] spectra = new double[channels()][][];
        float[] image = new float[size()];
        for (int p = 0; p < planes.size(); p++) {
            ImagePlane plane = planes.get(p);
            if (plane.kind() == ImagePlane.Kind.TWO_SIDED) {
                drawTwoSided(motion[plane.first()], image, p * PLANE);
                continue;
            }
            for (int c : new int[] {plane.first(), plane.second()}) {
                spectra[c] = spectra[c] == null ? transform(motion[c]) : spectra[c];
            }
            draw(plane.kind(), spectra[plane.first()], spectra[plane.second()], image, p * PLANE);
        }
        return image;
    }

    /**
     * The transform, {@code X_k = Σ_n w_n x_n exp(-j2πkn/64)} of every segment less its mean.
     *
     * @param samples series of any unit, of {@value #SAMPLES} or more. Not modified.
     * @return for every moment, in the samples' unit, real and imaginary part of bins 1 to 32 in turn
     */
    public static double[][] transform(double[] samples) {
        if (samples.length < SAMPLES) {
            throw new IllegalArgumentException("an image needs " + SAMPLES + " samples: " + samples.length);
        }
        Fft fft = new Fft(SEGMENT);
        Taper window = Taper.hann(SEGMENT);
        double[] segment = new double[SEGMENT];
        double[][] frames = new double[FRAMES][2 * BINS];
        for (int t = 0; t < FRAMES; t++) {
            System.arraycopy(samples, t * HOP, segment, 0, SEGMENT);
            double mean = 0;
            for (double value : segment) {
                mean += value / SEGMENT;
            }
            for (int n = 0; n < SEGMENT; n++) {
                segment[n] -= mean;
            }
            window.apply(segment);
            fft.forward(segment);
            System.arraycopy(segment, 2, frames[t], 0, SEGMENT - 2);
            frames[t][2 * BINS - 2] = segment[1];
        }
        return frames;
    }

    /** Rows from the least frequency, -28.1 Hz, over the constant, row 15, to 30 Hz. */
    private static void drawTwoSided(double[] samples, float[] image, int offset) {
        Fft fft = new Fft(SHORT);
        Taper window = Taper.hann(SHORT);
        double[] segment = new double[SHORT];
        for (int t = 0; t < FRAMES; t++) {
            System.arraycopy(samples, t * SHORT_HOP, segment, 0, SHORT);
            window.apply(segment);
            fft.forward(segment);
            for (int row = 0; row < SHORT; row++) {
                int k = Math.abs(row - (SHORT / 2 - 1));
                double power = k == 0 ? segment[0] * segment[0] : k == SHORT / 2 ? segment[1] * segment[1]
                        : segment[2 * k] * segment[2 * k] + segment[2 * k + 1] * segment[2 * k + 1];
                image[offset + row * FRAMES + t] = (float) (0.5 * Math.log(power + FLOOR));
            }
        }
    }

    private static void draw(ImagePlane.Kind kind, double[][] first, double[][] second, float[] image, int offset) {
        double sum = 0;
        for (int k = 0; k < BINS; k++) {
            for (int t = 0; t < FRAMES; t++) {
                double value = value(kind, first[t], second[t], 2 * k);
                sum += value;
                image[offset + k * FRAMES + t] = (float) value;
            }
        }
        if (kind == ImagePlane.Kind.RELATIVE) {
            float mean = (float) (sum / PLANE);
            for (int i = offset; i < offset + PLANE; i++) {
                image[i] -= mean;
            }
        }
    }

    private static double value(ImagePlane.Kind kind, double[] x, double[] y, int at) {
        double xx = x[at] * x[at] + x[at + 1] * x[at + 1] + FLOOR;
        double yy = y[at] * y[at] + y[at + 1] * y[at + 1] + FLOOR;
        return switch (kind) {
            case LEVEL, RELATIVE, TWO_SIDED -> 0.5 * Math.log(xx);
            case GAIN -> 0.5 * Math.log(yy / xx);
            case COSINE -> (y[at] * x[at] + y[at + 1] * x[at + 1]) / Math.sqrt(xx * yy);
            case SINE -> (y[at + 1] * x[at] - y[at] * x[at + 1]) / Math.sqrt(xx * yy);
        };
    }
}
