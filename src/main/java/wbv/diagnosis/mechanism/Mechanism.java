package wbv.diagnosis.mechanism;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.DoubleSupplier;
import java.util.stream.IntStream;

/**
 * Something that a model may lack: what it is called, what it adds and where, from which sizes a search for it starts, and what has to be
 * known of it to judge it and to tell people.
 */
public sealed interface Mechanism
        permits Softening, Hardening, Asymmetry, SpeedDamping, DryFriction, Hysteresis, Separation, EndStop, Clearance,
        AbruptChange, GradualChange, Viscoelasticity, StretchReflex, RotationalCoupling, CrossAxisCoupling, HiddenMass, UnmeasuredForce,
        SensorMount,
        SensorDelay, SensorAcCoupling, SensorGain, SensorMisalignment, SensorRectifying, SensorClipping, SensorBias, SensorDropouts,
        SensorQuantised, Scheduled, ParameterError, LearnedForce, Mechanism.Custom {

    /** One that somebody adds to a {@link Library} of his own. */
    non-sealed interface Custom extends Mechanism {}

    /** How it stands in a library. */
    Entry entry();

    /** What it may add in a link. Asked only of a link that has a measure, but for what couples other motion into it. */
    default List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        return List.of();
    }

    /** What it may add to a body, by the model's order of bodies; nothing for most. */
    default List<Hypothesis> onBody(Scene scene, int body) {
        return List.of();
    }

    /** What may be wrong with the sensor of an output; nothing for most. */
    default List<Hypothesis> atSensor(Scene scene, int output) {
        return List.of();
    }

    /**
     * Its numbers as a reader expects them.
     *
     * @param numbers those of a hypothesis of its
     */
    default List<Told> told(List<Hypothesis.Number> numbers) {
        return IntStream.range(0, numbers.size()).filter(i -> numbers.get(i).isFree()).mapToObj(i -> Told.plain(numbers.get(i).key(), i))
                .toList();
    }

    /** The same of a hypothesis whose numbers need more than their keys. */
    default List<Told> told(Hypothesis hypothesis) {
        return told(hypothesis.numbers());
    }

    /**
     * What is open of a number beside what a fit knows.
     *
     * @param key of the number as it is told
     */
    default Doubt doubt(String key) {
        return Doubt.SHARE;
    }

    /** What settles it against another, where this one knows better than the families of the two. */
    default Optional<String> against(Mechanism rival) {
        return Optional.empty();
    }

    /**
     * What it may be with a number more, to be begun where its plain form was found; empty where it has no such form.
     *
     * @param plain hypothesis of its
     * @param found values, as many as the plain one has numbers, each in its unit. Not modified.
     */
    default Optional<Hypothesis> further(Hypothesis plain, double[] found) {
        return Optional.empty();
    }

    /**
     * Another form of it, begun where its plain form was found; empty where that is no better place than its own starts.
     *
     * @param form hypothesis of its at the place
     * @param found values, as many as the plain one has numbers, each in its unit. Not modified.
     */
    default Optional<Hypothesis> begunAt(Hypothesis form, double[] found) {
        return Optional.empty();
    }

    /** What two forces of a kind in one link are together: one of that kind, of which the second is the form. */
    enum Together {
        /** Of a force over deflection alone. */
        CURVE,
        /** Of what sticks and slides, whatever the rate: friction is one slider, a spring that yields some (Iwan 1966). */
        LOOP,
        /** Two. */
        TWO
    }

    /** What it is with another of its kind in the same link. */
    default Together together() {
        return family() == Family.SPRING || family() == Family.CONTACT ? Together.CURVE : Together.TWO;
    }

    /** Whether another hypothesis is simpler where both act at one place, see {@link Hypothesis#yieldsTo}. */
    default boolean yieldsTo(Hypothesis rival) {
        return false;
    }

    /** Whether it is refitted whatever the look to first order promises, which may miss what it does. */
    default boolean isAlwaysRefitted() {
        return false;
    }

    /** Whether springs and dashpots of other values make up for nearly all of it: then only a comparison shows that it is missing. */
    default boolean isImitatedByNumbers() {
        return false;
    }

    /**
     * Whether it is another thing that is imitated where one of its numbers stands at a bound.
     *
     * @param key of the number
     * @param low which bound
     */
    default boolean imitatesAt(String key, boolean low) {
        return false;
    }

    /** Whether a recording shows it without any fit. */
    default boolean showsWithoutFit() {
        return false;
    }

    /**
     * What is said of one that was found, with {@code %s} for its place.
     *
     * @param keys of the numbers that were found, which tell its form
     */
    default String sentence(Set<String> keys) {
        return entry().sentence();
    }

    /**
     * The same of one in a form that no number tells.
     *
     * @param form as {@link #form} says it
     */
    default String sentence(Set<String> keys, Map<String, String> form) {
        return sentence(keys);
    }

    /**
     * What one that was found is of several things that go by the same word, where none of its numbers says so by itself: words by what
     * they tell, such as that friction has no time to stick, or the side of a stop. What its law chooses beside its numbers, for most
     * nothing.
     *
     * @param numbers as they are told, by key
     * @param speed   of its link, root mean square, as it moves with it [m/s], of a joint [rad/s]; NaN where it is in no link
     */
    default Map<String, String> form(Hypothesis found, Map<String, Double> numbers, DoubleSupplier speed) {
        return found.choices();
    }

    /** The word of the vocabulary. */
    default String word() {
        return entry().word();
    }

    /** What kind it is. */
    default Family family() {
        return entry().family();
    }

    /**
     * How a mechanism stands in a library.
     *
     * @param word       of the vocabulary, such as {@code stiffness.softening}
     * @param family     what kind it is
     * @param sentence   what it is, in the words of someone who sits in the seat: a clause with {@code %s} for the place
     * @param experiment what it calls for to be settled by itself
     */
    record Entry(String word, Family family, String sentence, String experiment) {

        /** Settled as most of its family are. */
        public Entry(String word, Family family, String sentence) {
            this(word, family, sentence, family.experiment());
        }
    }
}
