package wbv.control;

import org.ejml.data.DMatrixRMaj;

/** A way to a seat's observer and gain for one sitter, in pieces of some ten microseconds; nothing is allocated but by the constructors. */
sealed interface SeatDesign permits MeanDesign, WorstDesign {

    /** Begins a design for the sitter whom the source tells now. */
    void begin(SitterSource sitter);

    /**
     * A piece of the work.
     *
     * @return whether it is over, with a design or without one
     */
    boolean advance();

    /** Whether there is a design. */
    boolean ready();

    /** What the observer foresees of its states, without the force, N by N. */
    DMatrixRMaj foresight();

    /** k, 1 by N: the force is minus k times the states [N]. */
    DMatrixRMaj gain();

    /** How readings correct the states, N by {@value SeatModel#SENSORS}. */
    DMatrixRMaj correction();
}
