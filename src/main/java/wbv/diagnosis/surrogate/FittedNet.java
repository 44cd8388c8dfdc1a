package wbv.diagnosis.surrogate;

/** An arrangement of bodies and links that was fitted to a simulation: in a chain along one axis, or in a plane. */
sealed interface FittedNet permits FittedChain, FittedPlane {

    /** An arrangement that misses no greater share of any output is good enough. */
    double GOOD = 0.005;

    /** The greatest share of an output that it misses [1]. */
    double worst();
}
