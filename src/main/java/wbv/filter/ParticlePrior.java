package wbv.filter;

import java.util.random.RandomGenerator;

/** Where particles begin: half about a start, the others anywhere, so that a wrong start does no harm. */
final class ParticlePrior {

    private static final double ANYWHERE = 0.5;
    /** Frequency [Hz] and damping of those that begin anywhere, uniform in their logarithms. */
    private static final double LOW = 0.5;
    private static final double HIGH = 20;
    private static final double LIGHT = 0.03;
    private static final double HEAVY = 1.5;

    private ParticlePrior() {}

    /**
     * Draws the parameters of one particle.
     *
     * @param centre   an estimate with the parameters of the start. Not modified.
     * @param states   numbers of an estimate that are motion; as many parameters are frequencies and damping ratios
     * @param particle motion, then parameters. Modified.
     */
    static void draw(double[] centre, int states, RandomGenerator random, double[] particle) {
        boolean anywhere = random.nextDouble() < ANYWHERE;
        for (int i = states; i < particle.length; i++) {
            particle[i] = anywhere && i < 2 * states ? anywhere((i - states) % 2, random)
                    : centre[i] + JointFilter.START * random.nextGaussian();
        }
    }

    /** Where particles begin: uniform damping ratio and frequency. Thesis: Eq. 5-11. */
    private static double anywhere(int parameter, RandomGenerator random) {
        double low = parameter == 0 ? 2 * Math.PI * LOW : LIGHT;
        double high = parameter == 0 ? 2 * Math.PI * HIGH : HEAVY;
        return Math.log(low) + random.nextDouble() * Math.log(high / low);
    }
}
