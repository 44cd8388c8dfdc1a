package wbv.rig;

import org.apache.commons.math3.random.RandomGenerator;

/**
 * Band-limited random motion of a level that holds: sine lines of equal amplitude, one in each cell of a band, whose
 * frequencies run to and fro between the edges of their cells at random paces.
 *
 * <p>The spectrum is flat within the band and continuous (no gaps between lines, no period), the values are nearly
 * normal, and yet the mean square over a minute is right within a percent or two, which filtered noise is not: in a band of
 * 1 Hz its mean square over a minute scatters by 13 %. A rig that reproduces a level drives this way.
 */
final class WanderingLines {

    private static final double CELL = 0.125;
    private static final int FEWEST = 8;
    private static final double SHORTEST_LEG = 4;
    private static final double LONGEST_LEG = 12;

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
     * @param low    lower edge of the band [Hz]
     * @param high   upper edge [Hz]
     * @param rms    root mean square in the unit of the output
     * @param h      step [s]
     * @param random phases and paces. Modified.
     */
    WanderingLines(double low, double high, double rms, double h, RandomGenerator random) {
        int n = Math.max(FEWEST, (int) Math.round((high - low) / CELL));
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
