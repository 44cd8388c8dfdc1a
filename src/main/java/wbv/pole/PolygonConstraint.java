package wbv.pole;

import wbv.filter.Bounds;
import wbv.filter.Constraint;

/**
 * Bounds of an absent body over a recording, as the constrained estimator takes them: from a sample on, those that the pole
 * measured then set; nothing is bounded before the first.
 */
public final class PolygonConstraint implements Constraint {

    private static final long serialVersionUID = 1;

    private final long[] from;
    private final double[][] lower;
    private final double[][] upper;
    private int current;

    /** @param from rising sample numbers @param chords of each, in the order of {@link Attributes#OF_A_POLE} */
    PolygonConstraint(long[] from, Chord[][] chords) {
        this.from = from.clone();
        int attributes = Attributes.OF_A_POLE.size();
        lower = new double[from.length][attributes];
        upper = new double[from.length][attributes];
        for (int i = 0; i < from.length; i++) {
            for (int j = 0; j < attributes; j++) {
                lower[i][j] = chords[i][j].lower();
                upper[i][j] = chords[i][j].upper();
            }
        }
    }

    @Override
    public void at(long sample, Bounds bounds) {
        while (current + 1 < from.length && from[current + 1] <= sample) {
            current++;
        }
        if (from.length == 0 || from[current] > sample) {
            return;
        }
        // Frequency and damping alone: the other two follow from them, and their chords may contradict in the last digits.
        bounds.set(Bounds.Attribute.FREQUENCY, lower[current][0], upper[current][0]);
        bounds.set(Bounds.Attribute.DAMPING, lower[current][1], upper[current][1]);
    }

    @Override
    public void reset() {
        current = 0;
    }
}
