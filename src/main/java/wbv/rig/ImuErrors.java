package wbv.rig;

/**
 * What the sensors at a place do to what they measure.
 *
 * @param acceleration in m/s²
 * @param rate in rad/s
 * @param field in units of the local field of the earth
 * @param force        of the force plate on the seat, in N
 * @param tilt         standard deviation of the error of attitude about x and about y [rad]
 * @param lossShare    share of packets lost where losses are on, 0 to less than 1; the force plate is wired
 * @param lossBurst    mean number of packets lost in a row, &gt;= 1
 */
public record ImuErrors(Part acceleration, Part rate, Part field, Part force, double tilt, double lossShare, double lossBurst) {

    /** Standard gravity [m/s²]. */
    public static final double GRAVITY = 9.80665;

    private static final double DEGREE = Math.PI / 180;

    /** The local field of the earth [gauss] (assumed: south-eastern Australia). */
    private static final double GAUSS = 0.57;

    /**
     * What one kind of sensor does, in its unit.
     *
     * @param noise     density of its white noise [unit/√Hz]
     * @param bias      standard deviation of its constant offset from sensor to sensor, in its unit
     * @param drift     standard deviation of the offset that walks, in its unit
     * @param range     it clips beyond this, in its unit
     * @param step      resolution in which it sends, in its unit, &gt;= 0; 0 is exact
     * @param bandwidth corner of the single-pole low-pass inside [Hz]
     */
    public record Part(double noise, double bias, double drift, double range, double step, double bandwidth) {
        public Part {
            if (!(noise >= 0 && bias >= 0 && drift >= 0 && step >= 0)) {
                throw new IllegalArgumentException("noise, bias, drift and resolution must be >= 0");
            }
            if (!(range > 0 && bandwidth > 0)) {
                throw new IllegalArgumentException("range and bandwidth must be > 0: " + range + ", " + bandwidth);
            }
        }

        private Part withNoise(double factor) {
            return new Part(factor * noise, bias, drift, range, step, bandwidth);
        }
    }

    /**
     * The sensors of the thesis, Table 3-2: 200 µg/√Hz, 0.1 mg, ±160 m/s²; 0.01 °/s/√Hz, 10 °/h, ±2000 °/s; 184 Hz; 0.2 mG/√Hz,
     * ±1.9 G, 60 Hz. Its bias stability is taken twice: as the scatter of constant offsets and as that of their walk. The force
     * plate, the field's distortion by the platform's motors (2 %), resolutions, tilt of half a degree, and loss of one packet
     * in a hundred, in threes, are assumed.
     */
    public static final ImuErrors TABLE_3_2 = new ImuErrors(
            new Part(200e-6 * GRAVITY, 0.1e-3 * GRAVITY, 0.1e-3 * GRAVITY, 160, 1e-4, 184),
            new Part(0.01 * DEGREE, 10 * DEGREE / 3600, 10 * DEGREE / 3600, 2000 * DEGREE, 1e-5, 184),
            new Part(0.2e-3 / GAUSS, 0.02, 0, 1.9 / GAUSS, 1e-4, 60),
            new Part(0.02, 0.5, 0.5, 5000, 0.01, 184),
            0.5 * DEGREE, 0.01, 3);

    public ImuErrors {
        if (!(tilt >= 0)) {
            throw new IllegalArgumentException("tilt must be >= 0: " + tilt);
        }
        if (!(lossShare >= 0 && lossShare < 1)) {
            throw new IllegalArgumentException("share of lost packets must be 0 to less than 1: " + lossShare);
        }
        if (!(lossBurst >= 1)) {
            throw new IllegalArgumentException("mean burst of lost packets must be >= 1: " + lossBurst);
        }
    }

    /** The same sensors with all noise densities multiplied. */
    public ImuErrors withNoise(double factor) {
        return new ImuErrors(acceleration.withNoise(factor), rate.withNoise(factor), field.withNoise(factor),
                force.withNoise(factor), tilt, lossShare, lossBurst);
    }
}
