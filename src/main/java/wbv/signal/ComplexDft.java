package wbv.signal;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * Discrete Fourier transform of complex sequences of length 2^a 3^b 5^c.
 *
 * <p>The sequence is a matrix, as square as its length allows. Its columns are transformed, its values turned, rows become columns, and
 * these are transformed (Gentleman and Sande 1966; radices 4, 2, 3, 5). All work is done on two whole rows at a time, which is what a
 * processor does best. Immutable: one object may serve many threads.
 */
final class ComplexDft {

    private final int points;
    /** Of the divisors of the length the greatest that is not above its square root. */
    private final int rows;
    private final double[] cosine;
    private final double[] sine;
    /** By row and column, as values are turned between both. */
    private final double[][] turnCosine;
    private final double[][] turnSine;

    /** @param points of a sequence, at least 1, with no prime factor above 5 */
    ComplexDft(int points) {
        this.points = points;
        rows = IntStream.rangeClosed(1, (int) Math.sqrt(points)).filter(n -> points % n == 0).max().orElseThrow();
        cosine = IntStream.range(0, points).mapToDouble(k -> Math.cos(2 * Math.PI * k / points)).toArray();
        sine = IntStream.range(0, points).mapToDouble(k -> Math.sin(2 * Math.PI * k / points)).toArray();
        turnCosine = byRow(cosine);
        turnSine = byRow(sine);
    }

    private double[][] byRow(double[] turn) {
        return IntStream.range(0, rows).mapToObj(row -> IntStream.range(0, points / rows).mapToDouble(i -> turn[row * i]).toArray())
                .toArray(double[][]::new);
    }

    /**
     * Complex numbers, real and imaginary parts.
     *
     * @param re of any unit, by row and column. Not copied
     * @param im likewise
     */
    record Rows(double[][] re, double[][] im) {

        private static Rows of(int rows, int columns) {
            return new Rows(new double[rows][columns], new double[rows][columns]);
        }

        private Rows part(int from, int to) {
            return new Rows(Arrays.copyOfRange(re, from, to), Arrays.copyOfRange(im, from, to));
        }
    }

    /** Room for a sequence, row after row. */
    Rows room() {
        return Rows.of(rows, points / rows);
    }

    /** Room for its spectrum. */
    Rows turnedRoom() {
        return Rows.of(points / rows, rows);
    }

    /**
     * The spectrum {@code X_k = Σ x_n exp(-j2πkn/N)}, row after row, in the unit of the sequence.
     *
     * @param x sequence, of {@link #room}. Lost
     * @param room of {@link #turnedRoom}. Its rows are the result's
     */
    Rows of(Rows x, Rows room) {
        turnOver(down(x), room);
        return down(room);
    }

    /** Transforms each column, in place; the same rows in the order of their frequencies. */
    private Rows down(Rows x) {
        int n = x.re.length;
        if (n == 1) {
            return x;
        }
        int radix = n % 4 == 0 ? 4 : n % 2 == 0 ? 2 : n % 3 == 0 ? 3 : 5;
        int m = n / radix;
        double[][] re = new double[radix][];
        double[][] im = new double[radix][];
        for (int p = 0; p < m; p++) {
            for (int j = 0; j < radix; j++) {
                re[j] = x.re[p + m * j];
                im[j] = x.im[p + m * j];
            }
            switch (radix) {
                case 2 -> two(re, im);
                case 3 -> three(re, im);
                case 4 -> four(re, im);
                default -> five(re, im);
            }
            for (int j = 0; j < radix; j++) {
                x.re[p + m * j] = re[j];
                x.im[p + m * j] = im[j];
                if (p * j > 0) {
                    double c = cosine[points / n * p * j];
                    double s = sine[points / n * p * j];
                    mix(re[j], im[j], c, s, -s, c);
                }
            }
        }
        Rows out = new Rows(new double[n][], new double[n][]);
        for (int j = 0; j < radix; j++) {
            Rows part = down(x.part(j * m, (j + 1) * m));
            for (int k = 0; k < m; k++) {
                out.re[radix * k + j] = part.re[k];
                out.im[radix * k + j] = part.im[k];
            }
        }
        return out;
    }

    /** Rows become columns, each value turned by its row times its column. */
    private void turnOver(Rows x, Rows out) {
        for (int row = 0; row < rows; row++) {
            double[] re = x.re[row];
            double[] im = x.im[row];
            double[] c = turnCosine[row];
            double[] s = turnSine[row];
            for (int i = 0; i < re.length; i++) {
                out.re[i][row] = re[i] * c[i] + im[i] * s[i];
                out.im[i][row] = im[i] * c[i] - re[i] * s[i];
            }
        }
    }

    /** The transforms of two rows: element by element, in place, in the order of their frequencies; likewise of three, four and five. */
    private static void two(double[][] re, double[][] im) {
        addAndSubtract(re[0], re[1]);
        addAndSubtract(im[0], im[1]);
    }

    private static void three(double[][] re, double[][] im) {
        double h = Math.sqrt(3) / 2;
        addAndSubtract(re[1], re[2]);
        addAndSubtract(im[1], im[2]);
        mix(re[0], re[1], 1, 1, 1, -0.5);
        mix(im[0], im[1], 1, 1, 1, -0.5);
        mix(re[1], im[2], 1, h, 1, -h);
        mix(im[1], re[2], 1, -h, 1, h);
        swap(re, 2, im, 2);
    }

    private static void four(double[][] re, double[][] im) {
        for (double[][] part : new double[][][] {re, im}) {
            addAndSubtract(part[0], part[2]);
            addAndSubtract(part[1], part[3]);
            addAndSubtract(part[0], part[1]);
            swap(part, 1, part, 2);
        }
        addAndSubtract(re[1], im[3]);
        addAndSubtract(im[1], re[3]);
        swap(im, 1, re, 3);
        swap(re, 3, im, 3);
    }

    private static void five(double[][] re, double[][] im) {
        double apart = Math.sqrt(5) / 4;
        double b1 = Math.sin(2 * Math.PI / 5);
        double b2 = Math.sin(4 * Math.PI / 5);
        for (double[][] part : new double[][][] {re, im}) {
            addAndSubtract(part[1], part[4]);
            addAndSubtract(part[2], part[3]);
            addAndSubtract(part[1], part[2]);
            mix(part[0], part[1], 1, 1, 1, -0.25);
            mix(part[1], part[2], 1, apart, 1, -apart);
            mix(part[4], part[3], b1, b2, b2, -b1);
        }
        addAndSubtract(re[1], im[4]);
        mix(im[1], re[4], 1, -1, 1, 1);
        swap(re, 4, im, 4);
        addAndSubtract(re[2], im[3]);
        mix(im[2], re[3], 1, -1, 1, 1);
        swap(re, 3, im, 3);
    }

    private static void swap(double[][] a, int i, double[][] b, int j) {
        double[] row = a[i];
        a[i] = b[j];
        b[j] = row;
    }

    private static void addAndSubtract(double[] a, double[] b) {
        for (int i = 0; i < a.length; i++) {
            double x = a[i];
            double y = b[i];
            a[i] = x + y;
            b[i] = x - y;
        }
    }

    /** Each a becomes {@code aa a + ab b}, each b {@code ba a + bb b}. */
    private static void mix(double[] a, double[] b, double aa, double ab, double ba, double bb) {
        for (int i = 0; i < a.length; i++) {
            double x = a[i];
            double y = b[i];
            a[i] = aa * x + ab * y;
            b[i] = ba * x + bb * y;
        }
    }
}
