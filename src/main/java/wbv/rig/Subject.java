package wbv.rig;

import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import wbv.rig.platform.Seeds;
import wbv.rig.platform.SpecNumbers;

/**
 * A simulated person: one of four who are always the same, or one drawn from a population, and how he sits.
 *
 * <p>Masses have the mean and the standard deviation of the thesis' four men, 79.4 ± 7.1 kg. The others are assumed: statures
 * 1.76 ± 0.07 m; first resonances ± 5 %, which takes 95 of 100 people from 4.5 to 5.5 Hz, the range that Pope and others found;
 * damping ratios ± 8 %. Nobody is farther from the mean than two and a half standard deviations.
 *
 * @param origin    the word by which he is drawn: {@code 1} to {@code 4}, or {@code random:7}
 * @param mass      body mass [kg], 30 to 200
 * @param stature   [m], 1.2 to 2.2
 * @param tautness  ratio of the natural frequencies to those of the average sitter, sitting normally
 * @param tightness damping ratios over those of the average sitter
 * @param posture   how he sits
 */
public record Subject(String origin, double mass, double stature, double tautness, double tightness, Posture posture) {

    /** Stature of the average sitter [m]. */
    static final double STATURE = 1.76;

    private static final double MASS = 79.4;
    private static final double FARTHEST = 2.5;

    /** The four, in order. */
    public static final List<Subject> ALL = List.of(
            new Subject("1", 78.37, STATURE, 1.00, 1.00, Posture.NORMAL),
            new Subject("2", 70.81, STATURE, 1.06, 0.94, Posture.NORMAL),
            new Subject("3", 88.09, STATURE, 0.95, 1.07, Posture.NORMAL),
            new Subject("4", 80.33, STATURE, 0.98, 0.97, Posture.NORMAL));

    public Subject {
        require("mass must be 30 to 200 kg", mass, 30, 200);
        require("stature must be 1.2 to 2.2 m", stature, 1.2, 2.2);
        require("tautness must be 0.5 to 2", tautness, 0.5, 2);
        require("tightness must be 0.5 to 2", tightness, 0.5, 2);
    }

    /**
     * One of the four.
     *
     * @throws IllegalArgumentException if the number is not 1 to 4
     */
    public static Subject of(int number) {
        if (number < 1 || number > ALL.size()) {
            throw new IllegalArgumentException("subject must be 1 to " + ALL.size() + ": " + number);
        }
        return ALL.get(number - 1);
    }

    /** Someone of the population; the same for the same seed. */
    public static Subject random(long seed) {
        RandomGenerator random = new Seeds(seed).source("subject");
        double mass = MASS + 7.1 * deviate(random);
        double stature = STATURE + 0.07 * deviate(random);
        double tautness = 1 + 0.05 * deviate(random);
        double tightness = 1 + 0.08 * deviate(random);
        return new Subject("random:" + seed, hundredths(mass), hundredths(stature), tautness, tightness, Posture.NORMAL);
    }

    /**
     * Reads {@code 1} to {@code 4}, or {@code random:7}.
     *
     * @throws IllegalArgumentException if the word is neither
     */
    static Subject parse(String word) {
        if (!word.startsWith("random:")) {
            return of(SpecNumbers.parseIndex("subject", word, 1, ALL.size()));
        }
        try {
            return random(Long.parseLong(word.substring("random:".length())));
        } catch (NumberFormatException notANumber) {
            throw new IllegalArgumentException("a random subject is random:SEED, a whole number: '" + word + "'", notANumber);
        }
    }

    /** The same person with another mass, his frequencies and damping ratios kept. */
    Subject withMass(double other) {
        return new Subject(origin, other, stature, tautness, tightness, posture);
    }

    /** The same person sitting otherwise. */
    Subject withPosture(Posture other) {
        return new Subject(origin, mass, stature, tautness, tightness, other);
    }

    /** Natural frequencies over those of the average sitter, as he sits. */
    double tautnessAsHeSits() {
        return tautness * posture.tautness();
    }

    /** The words of a rig's spec that {@link #parse} and its likes read back. */
    @Override
    public String toString() {
        StringBuilder words = new StringBuilder("subject=").append(origin);
        if (mass != parse(origin).mass()) {
            words.append(" mass=").append(SpecNumbers.plain(mass));
        }
        if (posture != Posture.NORMAL) {
            words.append(" posture=").append(posture);
        }
        return words.toString();
    }

    private static double deviate(RandomGenerator random) {
        double deviate = random.nextGaussian();
        while (Math.abs(deviate) > FARTHEST) {
            deviate = random.nextGaussian();
        }
        return deviate;
    }

    private static double hundredths(double value) {
        return Math.rint(100 * value) / 100;
    }

    private static void require(String what, double value, double least, double most) {
        if (!(value >= least && value <= most)) {
            throw new IllegalArgumentException(what + ": " + value);
        }
    }
}
