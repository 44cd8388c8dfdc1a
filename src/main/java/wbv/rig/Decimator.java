package wbv.rig;

/** From the inner rate of a sensor to its output rate: fed every inner sample, asked at output instants. */
interface Decimator {

    /** Takes the next inner sample. */
    void accept(double value);

    /**
     * The output of this instant.
     *
     * @param fraction where the instant lies between the last two inner samples: more than 0, at most 1 (at the last)
     */
    double take(double fraction);
}
