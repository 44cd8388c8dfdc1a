package wbv.exposure;

/**
 * The health guidance caution zone of ISO 2631-1:1997 Annex B: below it no effects are documented, within it caution is
 * indicated, above it effects are likely. Bounds of the weighted acceleration with k on the worst axis.
 */
public enum CautionZone {
    BELOW("below the caution zone"), WITHIN("within the caution zone"), ABOVE("above the caution zone");

    private static final double LOWER_AT_8_H = 0.45;
    private static final double UPPER_AT_8_H = 0.90;
    private static final double LOWER_DOSE = 8.5;
    private static final double UPPER_DOSE = 17;
    private static final double ESTIMATE = 1.4;

    private final String words;

    CautionZone(String words) {
        this.words = words;
    }

    /** As a sentence says it: "within the caution zone". */
    public String words() {
        return words;
    }

    /**
     * Lower bound by Eq. B.1, {@code a_w √T} constant [m/s²].
     *
     * @param hours daily exposure
     */
    public static double lower(double hours) {
        return LOWER_AT_8_H * Math.sqrt(8 / hours);
    }

    /**
     * Upper bound by Eq. B.1 [m/s²].
     *
     * @param hours daily exposure
     */
    public static double upper(double hours) {
        return UPPER_AT_8_H * Math.sqrt(8 / hours);
    }

    /**
     * Lower bound by Eq. B.2, {@code a_w T^¼} constant: a dose of 8.5 [m/s²].
     *
     * @param hours daily exposure
     */
    public static double lowerByDose(double hours) {
        return LOWER_DOSE / (ESTIMATE * Math.sqrt(Math.sqrt(3600 * hours)));
    }

    /**
     * Upper bound by Eq. B.2: a dose of 17 [m/s²].
     *
     * @param hours daily exposure
     */
    public static double upperByDose(double hours) {
        return UPPER_DOSE / (ESTIMATE * Math.sqrt(Math.sqrt(3600 * hours)));
    }

    /** Where an A(8) lies by Eq. B.1 [m/s²]. */
    public static CautionZone ofA8(double a8) {
        return of(a8, LOWER_AT_8_H, UPPER_AT_8_H);
    }

    /** Where a daily dose lies by Eq. B.2 [m/s^1.75], measured or estimated. */
    public static CautionZone ofDose(double vdv) {
        return of(vdv, LOWER_DOSE, UPPER_DOSE);
    }

    private static CautionZone of(double value, double lower, double upper) {
        return value < lower ? BELOW : value <= upper ? WITHIN : ABOVE;
    }
}
