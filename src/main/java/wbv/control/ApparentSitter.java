package wbv.control;

/**
 * A sitter as a seat feels him: a mass that moves with it and one on a spring and damper (Wei and Griffin 1998, model 1b).
 *
 * @param rigid     mass that moves with the seat, the seat pan's with it [kg], &gt; 0
 * @param moving    mass on the spring [kg], &gt; 0
 * @param frequency undamped natural frequency of the moving mass [Hz], &gt; 0
 * @param damping   its damping ratio [1], &gt; 0
 */
public record ApparentSitter(double rigid, double moving, double frequency, double damping) {

    public ApparentSitter {
        if (!(rigid > 0 && moving > 0 && frequency > 0 && damping > 0)) {
            throw new IllegalArgumentException(
                    "masses, natural frequency and damping ratio of a sitter must be > 0: " + rigid + " kg, " + moving + " kg, "
                            + frequency + " Hz, " + damping);
        }
    }

    /** All that the seat carries [kg]. */
    public double mass() {
        return rigid + moving;
    }

    /** The same sitter with all masses, the natural frequency and the damping ratio times factors &gt; 0. */
    public ApparentSitter times(double masses, double frequencies, double dampings) {
        return new ApparentSitter(masses * rigid, masses * moving, frequencies * frequency, dampings * damping);
    }

    /**
     * Force over acceleration of the seat.
     *
     * @param f [Hz]
     * @param response real and imaginary part [kg], two long. Modified.
     */
    public void apparentMass(double f, double[] response) {
        double r = f / frequency;
        double numeratorIm = 2 * damping * r;
        double re = 1 - r * r;
        double size = re * re + numeratorIm * numeratorIm;
        response[0] = rigid + moving * (re + numeratorIm * numeratorIm) / size;
        response[1] = moving * (numeratorIm * re - numeratorIm) / size;
    }
}
