package wbv.filter;

import java.util.random.RandomGenerator;
import wbv.filter.model.Adaptation;

/** Where particles begin: some about a start, the others anywhere, so that a wrong start does no harm. */
record ParticlePrior(Adaptation adaptation) {

    /**
     * Draws the parameters of one particle.
     *
     * @param centre   an estimate with the parameters of the start. Not modified.
     * @param states   numbers of an estimate that are motion; as many parameters are frequencies and damping ratios
     * @param particle motion, then parameters. Modified.
     */
    void draw(double[] centre, int states, RandomGenerator random, double[] particle) {
        boolean anywhere = random.nextDouble() < adaptation.particles().anywhere();
        for (int i = states; i < particle.length; i++) {
            particle[i] = anywhere && i < 2 * states ? anywhere((i - states) % 2, random)
                    : centre[i] + adaptation.prior().parameters() * random.nextGaussian();
        }
    }

    /** Where particles begin: uniform damping ratio and frequency, in their logarithms. Thesis: Eq. 5-11. */
    private double anywhere(int parameter, RandomGenerator random) {
        Adaptation.Particles range = adaptation.particles();
        double low = parameter == 0 ? 2 * Math.PI * range.lowest() : range.lightest();
        double high = parameter == 0 ? 2 * Math.PI * range.highest() : range.heaviest();
        return Math.log(low) + random.nextDouble() * Math.log(high / low);
    }
}
