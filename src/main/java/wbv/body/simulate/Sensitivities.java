package wbv.body.simulate;

/** Which derivatives a simulation works out beside its outputs. */
public enum Sensitivities {
    /** None. */
    NONE,
    /** Those to the numbers of laws, drives and faults: a fraction of the work where the structure has many. */
    OWN,
    /** Those to every parameter. */
    ALL;

    /** All or none. */
    public static Sensitivities all(boolean asked) {
        return asked ? ALL : NONE;
    }

    boolean any() {
        return this != NONE;
    }

    /**
     * The first parameter to which there is a derivative.
     *
     * @param structure parameters of the structure, which come first
     */
    int from(int structure) {
        return this == OWN ? structure : 0;
    }
}
