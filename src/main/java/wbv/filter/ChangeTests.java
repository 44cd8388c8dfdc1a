package wbv.filter;

import java.io.Serializable;
import wbv.filter.drift.ChangeTest;
import wbv.snapshot.Snapshot;

/** The tests that listen beside an {@link wbv.filter.drift.Alarm}. */
sealed interface ChangeTests extends Serializable, Snapshot permits OwnInnovations, Witness {

    /** Forgets what was heard; the body has yet to be found. */
    void restart();

    /** Forgets what was heard; something has changed. */
    void forget();

    /** Whether they listen while the body is being found, before the alarm does. */
    boolean listenEarly();

    /**
     * ν²/S that the alarm is to hear.
     *
     * @param own of the estimate
     */
    double nis(double own);

    /**
     * Hears a sample.
     *
     * @param nis        ν²/S
     * @param normalised ν/√S, S as large as correlated innovations make it
     * @param slope      how much the output depends on ln ω, over the same √S
     * @param noise      what the model leaves
     * @return the test that says that the body has changed, if one does
     */
    ChangeTest hear(double nis, double normalised, double slope, OutputNoise noise);

    /**
     * Whether it is the body that changed when the alarm rings.
     *
     * @param rose whether ν²/S has become larger
     */
    boolean isOfTheBody(boolean rose);

    /** Whether the filter must learn the body anew after a change, so that nothing can be heard meanwhile. */
    boolean deafAfterChange();
}
