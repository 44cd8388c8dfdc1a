package wbv.diagnosis;

import java.util.List;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.search.MassScale;

/**
 * One way to see a mismatch.
 *
 * @param fit     what explains it, or the base
 * @param scale   of its masses
 * @param missing what it names
 * @param rivals  what else might be
 * @param where   places that could carry it, where no name is good enough
 * @param ending  of the sentence
 */
record Explanation(Diagnosis.Verdict verdict, Fitter.State fit, MassScale scale, List<Diagnosis.Named> missing,
        List<Diagnosis.Named> rivals, List<Diagnosis.Latent> where, String ending) {

    Explanation {
        missing = List.copyOf(missing);
        rivals = List.copyOf(rivals);
        where = List.copyOf(where);
        if (verdict.isQuiet() && !missing.isEmpty()) {
            throw new IllegalArgumentException("what says that nothing is missing names nothing: " + missing);
        }
    }

    /** That the user's model with fitted values is all that can be said. */
    static Explanation nameless(Diagnosis.Verdict verdict, Grounds grounds, String ending) {
        return new Explanation(verdict, grounds.base(), grounds.scale(), List.of(), List.of(), List.of(), ending);
    }
}
