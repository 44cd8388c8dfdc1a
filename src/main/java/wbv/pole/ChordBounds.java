package wbv.pole;

import java.util.List;
import wbv.filter.Constraint;
import wbv.filter.model.Bounds;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * Bounds of an absent body as the constrained estimator takes them: those that the pole measured last sets.
 *
 * <p>With new bounds the estimate begins in their middle. Nothing is measured of the body, so the edge nearest to where the
 * estimate came from says where it came from, and not where the body is.
 * Thesis: Eq. 6-7.
 */
final class ChordBounds implements Constraint {

    private static final long serialVersionUID = 1;

    private final double[] lower = new double[Attributes.OF_A_BODY.size()];
    private final double[] upper = new double[lower.length];
    private boolean fresh;

    /** @param chords in the order of {@link Attributes#OF_A_BODY} */
    ChordBounds(List<Chord> chords) {
        see(chords);
    }

    /** A new pole was measured. */
    void see(List<Chord> chords) {
        for (int i = 0; i < lower.length; i++) {
            lower[i] = chords.get(i).lower();
            upper[i] = chords.get(i).upper();
        }
        fresh = true;
    }

    @Override
    public void at(long sample, Bounds bounds) {
        for (int i = 0; i < lower.length; i++) {
            double middle = (lower[i] + upper[i]) / 2;
            bounds.set(Attributes.OF_A_BODY.get(i), fresh ? middle : lower[i], fresh ? middle : upper[i]);
        }
        fresh = false;
    }

    @Override
    public void reset() {
        fresh = true;
    }

    @Override
    public void save(StateWriter out) {
        out.put(lower);
        out.put(upper);
        out.put(fresh);
    }

    @Override
    public void load(StateReader in) {
        in.numbers(lower);
        in.numbers(upper);
        fresh = in.flag();
    }
}
