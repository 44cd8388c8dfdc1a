package wbv.rig.platform;

import org.apache.commons.math3.random.RandomGenerator;

/**
 * Motion within a band whose level holds: sine lines of equal amplitude, one in each cell of the band, whose frequencies run to
 * and fro between the edges of their cells at random paces.
 *
 * <p>The spectrum is flat in the band and continuous, without gaps or period. One line alone is a sweep: its mean square is
 * exact over any few seconds, and its values are far from normal. Many lines are nearly normal, and the root mean square of
 * two minutes from 0.5 to 12 Hz scatters by half a percent, a third of what filtered noise does.
 */
final class WanderingLines {

    private static final double SHORTEST_LEG = 2;
    private static final double LONGEST_LEG = 6;

    private final RandomGenerator random;
    private final double h;
    private final double amplitude;
    private final double cell;
    private final double low;
    private final double[] from;
    private final double[] to;
    private final double[] phase;
    private final int[] leg;
    private final int[] left;
    private final double[] re;
    private final double[] im;
    private final double[] turnRe;
    private final double[] turnIm;
    private final double[] bendRe;
    private final double[] bendIm;

    /**
     * @param lines  number of lines
     * @param low    lower edge of the band [Hz]
     * @param high   upper edge [Hz]
     * @param rms    root mean square in the unit of the output
     * @param h      step [s]
     * @param random phases and paces. Modified.
     */
    WanderingLines(int lines, double low, double high, double rms, double h, RandomGenerator random) {
        int n = lines;
        this.random = random;
        this.h = h;
        this.low = low;
        this.cell = (high - low) / n;
        this.amplitude = rms * Math.sqrt(2.0 / n);
        from = new double[n];
        to = new double[n];
        phase = new double[n];
        leg = new int[n];
        left = new int[n];
        re = new double[n];
        im = new double[n];
        turnRe = new double[n];
        turnIm = new double[n];
        bendRe = new double[n];
        bendIm = new double[n];
        for (int k = 0; k < n; k++) {
            phase[k] = 2 * Math.PI * random.nextDouble();
            boolean up = random.nextBoolean();
            double share = random.nextDouble();
            double start = edge(k, !up) + (edge(k, up) - edge(k, !up)) * share;
            begin(k, start, edge(k, up), 1 - share);
        }
    }

    /** The next value. */
    double next() {
        double sum = 0;
        for (int k = 0; k < re.length; k++) {
            sum += im[k];
            if (--left[k] == 0) {
                phase[k] = (phase[k] + Math.PI * h * (from[k] + to[k]) * leg[k]) % (2 * Math.PI);
                double edge = to[k];
                double other = edge == edge(k, true) ? edge(k, false) : edge(k, true);
                begin(k, edge, other, 1);
            } else {
                double r = re[k] * turnRe[k] - im[k] * turnIm[k];
                im[k] = re[k] * turnIm[k] + im[k] * turnRe[k];
                re[k] = r;
                double t = turnRe[k] * bendRe[k] - turnIm[k] * bendIm[k];
                turnIm[k] = turnRe[k] * bendIm[k] + turnIm[k] * bendRe[k];
                turnRe[k] = t;
            }
        }
        return amplitude * sum;
    }

    private double edge(int k, boolean upper) {
        return low + cell * (upper ? k + 1 : k);
    }

    /** Starts a leg: frequency linear in time from one value to another, phase exact at its start. */
    private void begin(int k, double start, double end, double share) {
        double seconds = (SHORTEST_LEG + (LONGEST_LEG - SHORTEST_LEG) * random.nextDouble()) * share;
        from[k] = start;
        to[k] = end;
        leg[k] = Math.max(1, (int) Math.round(seconds / h));
        left[k] = leg[k];
        double bend = 2 * Math.PI * h * (end - start) / leg[k];
        double turn = 2 * Math.PI * h * start + bend / 2;
        re[k] = StrictMath.cos(phase[k]);
        im[k] = StrictMath.sin(phase[k]);
        turnRe[k] = StrictMath.cos(turn);
        turnIm[k] = StrictMath.sin(turn);
        bendRe[k] = StrictMath.cos(bend);
        bendIm[k] = StrictMath.sin(bend);
    }
}
