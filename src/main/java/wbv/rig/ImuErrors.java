package wbv.rig;

/**
 * What an inertial sensor does to what it measures.
 *
 * @param accelerationNoise   density of its white noise [m/s²/√Hz]
 * @param accelerationBias    standard deviation of its constant offset from sensor to sensor [m/s²]
 * @param accelerationRange   it clips beyond this [m/s²]
 * @param rateNoise           [rad/s/√Hz]
 * @param rateBias            [rad/s]
 * @param rateRange           [rad/s]
 * @param accelerationStep    resolution in which it sends [m/s²], &gt;= 0; 0 is exact
 * @param rateStep            [rad/s]
 * @param bandwidth           corner of the single-pole low-pass inside [Hz]
 * @param tilt                standard deviation of the error of attitude about x and about y [rad]
 * @param lossShare           share of packets lost where losses are on, 0 to less than 1
 * @param lossBurst           mean number of packets lost in a row, &gt;= 1
 */
public record ImuErrors(double accelerationNoise, double accelerationBias, double accelerationRange, double rateNoise,
                        double rateBias, double rateRange, double accelerationStep, double rateStep, double bandwidth,
                        double tilt, double lossShare, double lossBurst) {

    /** Standard gravity [m/s²]. */
    public static final double GRAVITY = 9.80665;

    private static final double DEGREE = Math.PI / 180;

    /**
     * The sensors of the thesis, Table 3-2: 200 µg/√Hz, 0.1 mg, ±160 m/s²; 0.01 °/s/√Hz, 10 °/h, ±2000 °/s; 184 Hz.
     * Resolution, tilt of half a
     * degree and loss of one packet in a hundred, in threes, are assumed.
     */
    public static final ImuErrors TABLE_3_2 = new ImuErrors(200e-6 * GRAVITY, 0.1e-3 * GRAVITY, 160, 0.01 * DEGREE,
            10 * DEGREE / 3600, 2000 * DEGREE, 1e-4, 1e-5, 184, 0.5 * DEGREE, 0.01, 3);

    public ImuErrors {
        if (!(accelerationNoise >= 0 && rateNoise >= 0 && accelerationBias >= 0 && rateBias >= 0)) {
            throw new IllegalArgumentException("noise and bias must be >= 0");
        }
        if (!(accelerationRange > 0 && rateRange > 0)) {
            throw new IllegalArgumentException("ranges must be > 0: " + accelerationRange + ", " + rateRange);
        }
        if (!(accelerationStep >= 0 && rateStep >= 0 && tilt >= 0)) {
            throw new IllegalArgumentException("resolution and tilt must be >= 0");
        }
        if (!(bandwidth > 0)) {
            throw new IllegalArgumentException("bandwidth must be > 0 Hz: " + bandwidth);
        }
        if (!(lossShare >= 0 && lossShare < 1)) {
            throw new IllegalArgumentException("share of lost packets must be 0 to less than 1: " + lossShare);
        }
        if (!(lossBurst >= 1)) {
            throw new IllegalArgumentException("mean burst of lost packets must be >= 1: " + lossBurst);
        }
    }

    /** The same sensor with both noise densities multiplied. */
    public ImuErrors withNoise(double factor) {
        return new ImuErrors(factor * accelerationNoise, accelerationBias, accelerationRange, factor * rateNoise, rateBias,
                rateRange, accelerationStep, rateStep, bandwidth, tilt, lossShare, lossBurst);
    }
}
