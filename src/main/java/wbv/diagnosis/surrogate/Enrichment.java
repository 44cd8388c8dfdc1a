package wbv.diagnosis.surrogate;

import java.util.function.BiConsumer;
import java.util.function.BiPredicate;
import java.util.function.UnaryOperator;

/** Bodies and links that nobody measured, added one at a time as long as each pays for itself. */
final class Enrichment {

    /** What progress is told of as. */
    static final String STEP = "identifying the simulation";
    /** Mass of a body that is added, over all that is known, where fits start; a link that is added carries as much. */
    static final double LIGHT = 0.1;
    /** Natural frequencies of what is added [Hz], where fits start. */
    static final double[] FREQUENCIES = {5, 12};
    /** Bodies or links that nobody measured: each brings so many places for a law that more would hide where it is. */
    private static final int MOST = 2;

    private Enrichment() {}

    /**
     * An arrangement with as much more as it takes to do what a simulation did.
     *
     * @param richer the best with one body or link more
     * @param pays whether that, the second, is worth its numbers beside the first
     * @param progress told the step and the share of it that is done, 0 to 1
     */
    static <F extends FittedNet> F of(F plain, UnaryOperator<F> richer, BiPredicate<F, F> pays,
            BiConsumer<String, Double> progress) {
        F best = plain;
        boolean paid = true;
        for (int added = 0; added < MOST && paid && best.worst() > FittedNet.GOOD; added++) {
            progress.accept(STEP, (1.0 + added) / (1 + MOST));
            F more = richer.apply(best);
            paid = pays.test(best, more);
            best = paid ? more : best;
        }
        return best;
    }
}
