package wbv.exposure;

/** The basicentric axes of a seat, with weighting and multiplying factor for health (ISO 2631-1 7.2.3; 2002/44/EC Annex B). */
public enum SeatAxis {
    /** Fore and aft. */
    X('x', Weighting.WD, 1.4),
    /** Sideways. */
    Y('y', Weighting.WD, 1.4),
    /** Vertical. */
    Z('z', Weighting.WK, 1);

    private final char letter;
    private final Weighting weighting;
    private final double factor;

    SeatAxis(char letter, Weighting weighting, double factor) {
        this.letter = letter;
        this.weighting = weighting;
        this.factor = factor;
    }

    /** {@code x}, {@code y} or {@code z}. */
    public char letter() {
        return letter;
    }

    /** For health, Wd or Wk. */
    public Weighting weighting() {
        return weighting;
    }

    /** Multiplying factor k for health [1]. */
    public double factor() {
        return factor;
    }
}
