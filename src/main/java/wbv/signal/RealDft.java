package wbv.signal;

import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;

/**
 * Discrete Fourier transform of real sequences of any even length 2^a 3^b 5^c, for windows that no power of two fits.
 *
 * <p>The sequence is transformed as N/2 complex numbers, of each two values, and split. Immutable: one object may serve many threads.
 */
public final class RealDft {

    /** Complex points up to which room is kept for the next transform: an effort, 6 MB for each thread at most. */
    private static final int KEPT = 1 << 17;

    private final int length;
    private final int half;
    private final double[] cosine;
    private final double[] sine;
    private final ComplexDft halves;
    private final Queue<Room> idle = new ConcurrentLinkedQueue<>();

    /**
     * Works out the twiddle factors.
     *
     * @param length points N, even, with no prime factor above 5
     */
    public RealDft(int length) {
        if (!fits(length)) {
            throw new IllegalArgumentException("length of a transform must be even with factors 2, 3 and 5 only: " + length);
        }
        this.length = length;
        this.half = length / 2;
        halves = new ComplexDft(half);
        cosine = new double[half];
        sine = new double[half];
        for (int k = 0; k < half; k++) {
            cosine[k] = Math.cos(2 * Math.PI * k / length);
            sine[k] = Math.sin(2 * Math.PI * k / length);
        }
    }

    /**
     * The greatest length that fits, not above one given.
     *
     * @param most at least 2
     */
    public static int fitting(int most) {
        if (most < 2) {
            throw new IllegalArgumentException("a transform needs at least 2 points: " + most);
        }
        int n = most - most % 2;
        while (!fits(n)) {
            n -= 2;
        }
        return n;
    }

    /**
     * The least length that fits, not below one given.
     *
     * @param least at least 2
     */
    public static int covering(int least) {
        int n = least + least % 2;
        while (!fits(n)) {
            n += 2;
        }
        return n;
    }

    /** Whether a sequence of n values can be transformed. */
    public static boolean fits(int n) {
        if (n < 2 || n % 2 != 0) {
            return false;
        }
        int rest = n;
        for (int prime : new int[] {2, 3, 5}) {
            while (rest % prime == 0) {
                rest /= prime;
            }
        }
        return rest == 1;
    }

    /** Points N of the sequence. */
    public int length() {
        return length;
    }

    /**
     * The spectrum, in the unit of the sequence, {@code X_k = Σ x_n exp(-j2πkn/N)} for k = 0 to N/2: real part at 2k, imaginary part at 2k
     * + 1.
     *
     * @param x sequence of any unit, N long. Not modified.
     */
    public double[] forward(double[] x) {
        if (x.length != length) {
            throw new IllegalArgumentException("sequence must have " + length + " values: " + x.length);
        }
        return forward(x, half + 1);
    }

    /**
     * The first lines of the spectrum, in the unit of the sequence, of one after which comes silence; otherwise as
     * {@link #forward(double[])}.
     *
     * @param x sequence of any unit, at most N long. Not modified.
     * @param lines 1 to N/2 + 1
     */
    public double[] forward(double[] x, int lines) {
        if (x.length > length || lines < 1 || lines > half + 1) {
            throw new IllegalArgumentException("transforms " + length + " values to " + (half + 1) + " lines at most: " + x.length + " to "
                    + lines);
        }
        Room room = room();
        load(x, room.sequence);
        ComplexDft.Rows z = halves.of(room.sequence, room.spectrum);
        join(z.re(), room.re);
        join(z.im(), room.im);
        double[] out = split(room.re, room.im, lines);
        leave(room);
        return out;
    }

    private static void load(double[] x, ComplexDft.Rows z) {
        for (int row = 0, n = 0; row < z.re().length; row++) {
            double[] re = z.re()[row];
            double[] im = z.im()[row];
            for (int i = 0; i < re.length; i++, n += 2) {
                re[i] = at(x, n);
                im[i] = at(x, n + 1);
            }
        }
    }

    /** {@code X_k = E_k + O_k exp(-j2πk/N)} and {@code X*_m = E_k - O_k exp(-j2πk/N)}, m = N/2 - k, of even and of odd values. */
    private double[] split(double[] re, double[] im, int lines) {
        double[] out = new double[2 * lines];
        out[0] = re[0] + im[0];
        if (lines > half) {
            out[length] = re[0] - im[0];
        }
        for (int k = 1; 2 * k <= half && k < lines; k++) {
            int m = half - k;
            double evenRe = (re[k] + re[m]) / 2;
            double evenIm = (im[k] - im[m]) / 2;
            double oddRe = (im[k] + im[m]) / 2;
            double oddIm = (re[m] - re[k]) / 2;
            double turnedRe = oddRe * cosine[k] + oddIm * sine[k];
            double turnedIm = oddIm * cosine[k] - oddRe * sine[k];
            if (m < lines) {
                out[2 * m] = evenRe - turnedRe;
                out[2 * m + 1] = turnedIm - evenIm;
            }
            out[2 * k] = evenRe + turnedRe;
            out[2 * k + 1] = evenIm + turnedIm;
        }
        return out;
    }

    /**
     * The sequence, N long, of which {@link #forward} gives this spectrum, in its unit.
     *
     * @param spectrum of any unit: real part of line k at 2k, imaginary part at 2k + 1; lines beyond its end are 0. Those at 0 and N/2 are
     *                 real in the spectrum of any real sequence: their imaginary parts do not count. Not modified.
     */
    public double[] inverse(double[] spectrum) {
        return inverse(spectrum, length);
    }

    /**
     * The first values of that sequence, count long, in the unit of the spectrum.
     *
     * @param spectrum of any unit, as for {@link #inverse(double[])}. Not modified.
     * @param count 0 to N
     */
    public double[] inverse(double[] spectrum, int count) {
        if (spectrum.length > length + 2 || count > length) {
            throw new IllegalArgumentException("at most " + (length + 2) + " numbers of a spectrum give " + length + " values: "
                    + spectrum.length + " for " + count);
        }
        Room room = room();
        merge(spectrum, room.re, room.im);
        part(room.re, room.sequence.re());
        part(room.im, room.sequence.im());
        double[] out = unloaded(halves.of(room.sequence, room.spectrum), count);
        leave(room);
        return out;
    }

    /**
     * {@code Z_k = E_k + j O_k} with {@code E_k = (X_k + X*_m)/2} and {@code O_k = (X_k - X*_m)/2 exp(j2πk/N)}, m = N/2 - k; conjugated for
     * the inverse.
     */
    private void merge(double[] spectrum, double[] re, double[] im) {
        double last = at(spectrum, length);
        re[0] = (at(spectrum, 0) + last) / 2;
        im[0] = (last - at(spectrum, 0)) / 2;
        for (int k = 1; 2 * k <= half; k++) {
            int m = half - k;
            double hereRe = at(spectrum, 2 * k);
            double hereIm = at(spectrum, 2 * k + 1);
            double thereRe = at(spectrum, 2 * m);
            double thereIm = at(spectrum, 2 * m + 1);
            double evenRe = (hereRe + thereRe) / 2;
            double evenIm = (hereIm - thereIm) / 2;
            double diffRe = (hereRe - thereRe) / 2;
            double diffIm = (hereIm + thereIm) / 2;
            double oddRe = diffRe * cosine[k] - diffIm * sine[k];
            double oddIm = diffRe * sine[k] + diffIm * cosine[k];
            re[m] = evenRe + oddIm;
            im[m] = evenIm - oddRe;
            re[k] = evenRe - oddIm;
            im[k] = -(evenIm + oddRe);
        }
    }

    private double[] unloaded(ComplexDft.Rows z, int count) {
        double scale = 1.0 / half;
        double[] out = new double[count];
        for (int row = 0, n = 0; n < count; row++) {
            double[] even = z.re()[row];
            double[] odd = z.im()[row];
            int whole = Math.min(even.length, (count - n) / 2);
            for (int i = 0; i < whole; i++, n += 2) {
                out[n] = even[i] * scale;
                out[n + 1] = odd[i] * -scale;
            }
            if (whole < even.length && n < count) {
                out[n++] = even[whole] * scale;
            }
        }
        return out;
    }

    /** What comes after an end is 0. */
    private static double at(double[] of, int i) {
        return i < of.length ? of[i] : 0;
    }

    private static void join(double[][] rows, double[] joined) {
        for (int row = 0; row < rows.length; row++) {
            System.arraycopy(rows[row], 0, joined, row * rows[row].length, rows[row].length);
        }
    }

    private static void part(double[] joined, double[][] rows) {
        for (int row = 0; row < rows.length; row++) {
            System.arraycopy(joined, row * rows[row].length, rows[row], 0, rows[row].length);
        }
    }

    private Room room() {
        Room room = idle.poll();
        return room == null ? new Room() : room;
    }

    private void leave(Room room) {
        if (half <= KEPT) {
            idle.add(room);
        }
    }

    /** What one transform is worked out in. */
    private final class Room {
        final ComplexDft.Rows sequence = halves.room();
        final ComplexDft.Rows spectrum = halves.turnedRoom();
        final double[] re = new double[half];
        final double[] im = new double[half];
    }
}
