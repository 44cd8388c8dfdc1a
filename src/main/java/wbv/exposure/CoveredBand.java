package wbv.exposure;

/**
 * How much of a weighting's band a sampling rate covers. Instruments that conform to ISO 8041-1 cover all of it; what lies above
 * half the rate is lost, so that a value from a low rate is a lower bound.
 *
 * @param from    lower end [Hz]
 * @param to      upper end [Hz]: that of the weighting, or rate / 2.56
 * @param nominal upper end that the standard asks for [Hz]
 */
public record CoveredBand(double from, double to, double nominal) {

    /** Samples per period at the highest frequency that counts as measured, as is usual for anti-aliasing filters. */
    private static final double SAMPLES_PER_PERIOD = 2.56;

    public CoveredBand {
        if (!(from > 0 && from < to && to <= nominal)) {
            throw new IllegalArgumentException("a band must rise and end within the nominal one: " + from + " to " + to
                    + ", " + nominal + " Hz");
        }
    }

    /**
     * The band of a weighting that a rate covers.
     *
     * @param rate sampling rate [Hz]
     * @throws IllegalArgumentException if it covers none
     */
    public static CoveredBand of(Weighting weighting, double rate) {
        return new CoveredBand(weighting.nominalFrom(), Math.min(weighting.nominalTo(), rate / SAMPLES_PER_PERIOD),
                weighting.nominalTo());
    }

    /** True if what is above the band is missing from the value. */
    public boolean lowerBound() {
        return to < nominal;
    }

    /** The band in words, and what it means where it ends early. */
    public String words() {
        String band = RoundedNumber.text(from, 3) + " to " + RoundedNumber.text(to, 3) + " Hz";
        return lowerBound() ? band + ": a lower bound, not ISO 8041-1 conformant above " + RoundedNumber.text(to, 3) + " Hz" : band;
    }
}
