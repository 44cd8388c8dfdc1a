package wbv.rig;

import java.util.List;

/** A sitter in motion: stepped by the platform, looked at by sensors. */
interface Plant {

    /**
     * One inner step.
     *
     * @param platform the platform's motion at the end of the step. Not modified, and not kept.
     */
    void step(PlaceMotion platform);

    /** The motion of a place of {@link Sitter#places} now. The object is the plant's and changes with the next step. */
    PlaceMotion motion(int place);

    /**
     * What the seat pushes the sitter with now, along x, y, z [N], less his weight: a force plate between them, tared. Longer
     * arrays hold the moments behind. The array is the plant's and changes with the next step.
     */
    double[] seatForce();

    /** Names of the true parameters, such as {@code zeta} and {@code omega}. */
    List<String> parameters();

    /**
     * Writes the true parameters of this instant.
     *
     * @param into as long as {@link #parameters}. Modified.
     */
    void parameters(double[] into);

    /** Names of the states of the equations of motion, with their units. */
    List<String> states();

    /**
     * Writes the states of this instant.
     *
     * @param into as long as {@link #states}. Modified.
     */
    void states(double[] into);

    /**
     * The running plant of a sitter.
     *
     * @param h inner step [s]
     * @param start time of the first step's end [s]
     */
    static Plant of(Sitter sitter, Effects effects, double h, double start) {
        if (sitter instanceof Sitter.OneDof one) {
            return LinearPlant.of(one, h, start);
        } else if (sitter instanceof Sitter.TwoDof two) {
            return LinearPlant.of(two, h, start);
        }
        Sitter.Person person = (Sitter.Person) sitter;
        Skeleton skeleton = new Skeleton(person.subject(), new Anatomy(person.subject().stature()), effects);
        return new PersonPlant(skeleton, new AmplitudeSoftening(effects.has(Effect.SOFTENING), h), h);
    }
}
