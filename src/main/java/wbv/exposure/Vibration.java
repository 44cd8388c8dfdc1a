package wbv.exposure;

/**
 * What one weighted acceleration amounts to over a measurement, the multiplying factor k not applied.
 * Thesis: Eq. 2-1.
 *
 * @param seconds         time measured T [s]
 * @param missing         time that is missing from it [s]
 * @param rms             weighted r.m.s. acceleration a_w [m/s²]
 * @param deviation       relative standard deviation of a_w by the scatter between blocks of 10 s; NaN for fewer than six
 * @param peak            greatest modulus [m/s²]
 * @param vdv             vibration dose value of the time measured, {@code (∫ a_w⁴ dt)^¼} [m/s^1.75]
 * @param mtvv            greatest running r.m.s., linear over 1 s [m/s²]
 * @param mtvvTime        where that second ends [s from the beginning]
 * @param mtvvExponential greatest running r.m.s., exponential with τ = 1 s [m/s²]
 */
public record Vibration(double seconds, double missing, double rms, double deviation, double peak, double vdv, double mtvv,
        double mtvvTime, double mtvvExponential) {

    /** Crest factor up to which r.m.s. is enough (ISO 2631-1 6.2.2). */
    public static final double GREATEST_CREST = 9;
    /** MTVV / a_w above which shocks need more than r.m.s. (ISO 2631-1 6.3.3). */
    public static final double GREATEST_MTVV_RATIO = 1.5;
    /** VDV / (a_w T^¼) above which shocks need more than r.m.s. (ISO 2631-1 6.3.3). */
    public static final double GREATEST_VDV_RATIO = 1.75;

    /** Greatest modulus over a_w [1]; 0 where nothing moves. */
    public double crestFactor() {
        return ratio(peak, rms);
    }

    /** MTVV over a_w [1]; 0 where nothing moves. */
    public double mtvvRatio() {
        return ratio(mtvv, rms);
    }

    /** VDV over a_w T^¼ [1]; 0 where nothing moves. */
    public double vdvRatio() {
        return ratio(vdv, rms * Math.sqrt(Math.sqrt(seconds)));
    }

    private static double ratio(double value, double to) {
        return to > 0 ? value / to : 0;
    }

    /** True if the r.m.s. alone would belittle shocks: the dose decides beside it. */
    public boolean shocks() {
        return crestFactor() > GREATEST_CREST || mtvvRatio() > GREATEST_MTVV_RATIO || vdvRatio() > GREATEST_VDV_RATIO;
    }

    /**
     * Dose value of a steady vibration of this r.m.s., {@code 1.4 a_w T^¼} [m/s^1.75]. Thesis: Eq. 2-3.
     *
     * @param time T [s]
     */
    public double estimatedDose(double time) {
        return estimatedDose(rms, time);
    }

    /**
     * {@code 1.4 a_w T^¼} [m/s^1.75].
     *
     * @param rms a_w [m/s²]
     * @param time T [s]
     */
    public static double estimatedDose(double rms, double time) {
        return 1.4 * rms * Math.sqrt(Math.sqrt(time));
    }

    /** Motion sickness dose value of the time measured, {@code (∫ a_w² dt)^½} [m/s^1.5]; for Wf. */
    public double motionSicknessDose() {
        return rms * Math.sqrt(seconds);
    }

    /** The part that daily exposure rests on. */
    public Level level() {
        return new Level(rms, deviation, vdv, seconds);
    }

    /**
     * Level of a vibration.
     *
     * @param rms       a_w [m/s²], &gt;= 0
     * @param deviation relative standard deviation of it, NaN where unknown
     * @param vdv       dose value of the time measured [m/s^1.75], NaN where unknown
     * @param seconds   time measured [s], &gt; 0
     */
    public record Level(double rms, double deviation, double vdv, double seconds) {

        public Level {
            if (!(rms >= 0) || Double.isInfinite(rms)) {
                throw new IllegalArgumentException("weighted acceleration must be >= 0 m/s²: " + rms);
            }
            if (!(seconds > 0) || vdv < 0) {
                throw new IllegalArgumentException("time measured must be > 0 s and dose >= 0: " + seconds + " s, " + vdv);
            }
        }

        /** A level of which only the r.m.s. is known [m/s²]. */
        public Level(double rms) {
            this(rms, Double.NaN, Double.NaN, 1);
        }

        /**
         * Dose value of another duration of the same vibration [m/s^1.75].
         *
         * @param time [s]
         */
        public double dose(double time) {
            return vdv * Math.sqrt(Math.sqrt(time / seconds));
        }
    }
}
