package wbv.rig;

import org.apache.commons.math3.random.RandomGenerator;

/**
 * An offset that walks slowly and comes back: a Gauss-Markov process of first order, b' = -b/τ + w, with a given standard
 * deviation. Its time constant of 100 s is assumed.
 */
final class SlowWalk {

    private static final double TIME = 100;

    private final double keep;
    private final double kick;
    private final RandomGenerator random;
    private double value;

    /**
     * @param deviation standard deviation, &gt;= 0
     * @param interval time between two calls of {@link #next} [s]
     */
    SlowWalk(double deviation, double interval, RandomGenerator random) {
        this.random = random;
        keep = StrictMath.exp(-interval / TIME);
        kick = deviation * Math.sqrt(1 - keep * keep);
        value = deviation * random.nextGaussian();
    }

    /** The offset now; every call goes one interval on. */
    double next() {
        value = keep * value + kick * random.nextGaussian();
        return value;
    }
}
