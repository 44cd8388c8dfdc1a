package wbv.control.trial;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import wbv.rig.Posture;
import wbv.rig.Subject;

/** Who is let ride: drivers unlike the middle one first, then the rig's population, which is narrow (79.4 ± 7.1 kg). */
public final class Sitters {

    /** Mass [kg], stature [m], and natural frequencies over the average; assumed. */
    private static final double[][] UNLIKE = {
        {55, 1.60, 1.00}, {98, 1.85, 1.00}, {55, 1.60, 0.80}, {98, 1.85, 1.20}, {65, 1.70, 1.20}, {110, 1.90, 0.80}, {75, 1.75, 0.75},
        {75, 1.75, 1.25}};

    private Sitters() {}

    /** How many are unlike the middle one. */
    public static int unlike() {
        return UNLIKE.length;
    }

    /**
     * The first so many.
     *
     * @param count &gt;= 1
     */
    public static List<Subject> first(int count) {
        List<Subject> sitters = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            sitters.add(
                    i < UNLIKE.length ? new Subject("1", UNLIKE[i][0], UNLIKE[i][1], UNLIKE[i][2], 1, Posture.NORMAL) : Subject.random(i));
        }
        return sitters;
    }

    /**
     * A sitter of this mass, average in all else.
     *
     * @param mass [kg]
     * @throws IllegalArgumentException if nobody has such a mass
     */
    public static Subject ofMass(double mass) {
        return new Subject("1", mass, Maker.MIDDLE.stature(), 1, 1, Posture.NORMAL);
    }

    /** Mass and stiffness in a few words. */
    static String words(Subject subject) {
        return String.format(Locale.ROOT, "%.0f kg, natural frequencies × %.2f, damping ratios × %.2f", subject.mass(), subject.tautness(),
                subject.tightness());
    }
}
