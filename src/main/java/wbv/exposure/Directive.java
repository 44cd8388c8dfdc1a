package wbv.exposure;

/** Daily exposure values of Directive 2002/44/EC Article 3 (not of ISO 2631 or AS 2670, which have none). */
public enum Directive {
    /** Exposure action value: from here on the employer has to act. */
    ACTION(0.5, 9.1),
    /** Exposure limit value: nobody may be exposed to more. */
    LIMIT(1.15, 21);

    private final double a8;
    private final double vdv;

    Directive(double a8, double vdv) {
        this.a8 = a8;
        this.vdv = vdv;
    }

    /** Daily exposure A(8) [m/s²]. */
    public double a8() {
        return a8;
    }

    /** Daily vibration dose value [m/s^1.75]. */
    public double vdv() {
        return vdv;
    }

    /** Points by the HSE's count [1], in which the action value is 100. */
    public double points() {
        return points(a8);
    }

    /** Points [1] of a daily exposure A(8) [m/s²]: {@code 100 (A/0.5)²}. Points of tasks add up to those of the day. */
    public static double points(double a8) {
        double ratio = a8 / ACTION.a8;
        return 100 * ratio * ratio;
    }

    /** Which values an exposure reaches. */
    public enum Verdict {
        BELOW_ACTION("below the action value"), ABOVE_ACTION("above the action value"), ABOVE_LIMIT("above the limit value"),
        UNKNOWN("not known");

        private final String words;

        Verdict(String words) {
            this.words = words;
        }

        /** As a sentence says it: "above the action value". */
        public String words() {
            return words;
        }

        /** On A(8) [m/s²]; a value that is reached counts as exceeded. */
        public static Verdict ofA8(double a8) {
            return of(a8, ACTION.a8, LIMIT.a8);
        }

        /** On a daily dose value [m/s^1.75]. */
        public static Verdict ofVdv(double vdv) {
            return of(vdv, ACTION.vdv, LIMIT.vdv);
        }

        private static Verdict of(double value, double action, double limit) {
            if (Double.isNaN(value)) {
                return UNKNOWN;
            }
            return value >= limit ? ABOVE_LIMIT : value >= action ? ABOVE_ACTION : BELOW_ACTION;
        }
    }
}
