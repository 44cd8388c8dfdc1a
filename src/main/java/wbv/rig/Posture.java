package wbv.rig;

import java.util.Locale;

/**
 * How a person sits. Sitting erect stiffens: from slouched to erect the resonance rises from 4.4 to 5.2 Hz (ascribed to
 * Kitazaki and Griffin 1998; assumed, for it was not checked against the original), by the same ratio on either side of normal.
 */
public enum Posture {
    SLOUCHED(Math.sqrt(4.4 / 5.2)), NORMAL(1), ERECT(Math.sqrt(5.2 / 4.4));

    private final double tautness;

    Posture(double tautness) {
        this.tautness = tautness;
    }

    /** Natural frequencies over those of the same person sitting normally. */
    double tautness() {
        return tautness;
    }

    /** The word of this posture, such as {@code erect}. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** @throws IllegalArgumentException if no posture has this name */
    static Posture parse(String word) {
        for (Posture posture : values()) {
            if (posture.toString().equals(word)) {
                return posture;
            }
        }
        throw new IllegalArgumentException("a posture is slouched, normal or erect: '" + word + "'");
    }
}
