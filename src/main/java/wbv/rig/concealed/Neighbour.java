package wbv.rig.concealed;

/**
 * Another link of the chain, read from the states of the whole.
 *
 * @param upper its upper body
 * @param lower its lower body, -1 for the platform
 * @param bodies of the whole, unseen ones too
 * @param stiffness [N/m]
 * @param damping [N s/m] of its linear part
 */
record Neighbour(int upper, int lower, int bodies, double stiffness, double damping) {

    static Neighbour of(Chain chain, int link, int bodies) {
        return new Neighbour(link, chain.parent()[link], bodies, chain.stiffness()[link], chain.damping()[link]);
    }

    /**
     * How far it is stretched [m].
     *
     * @param y all states
     */
    double deflection(double[] y) {
        return lower < 0 ? y[upper] : y[upper] - y[lower];
    }

    /**
     * What its spring and dashpot carry, positive in tension [N].
     *
     * @param y all states
     */
    double load(double[] y) {
        double v = lower < 0 ? y[bodies + upper] : y[bodies + upper] - y[bodies + lower];
        return stiffness * deflection(y) + damping * v;
    }
}
