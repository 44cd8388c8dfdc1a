package wbv.rig;

import java.util.List;

/**
 * A simulated person. The four masses have the mean and the standard deviation of the thesis' four men, 79.4 ± 7.1 kg;
 * all else is assumed.
 *
 * @param number    1 to 4
 * @param mass      body mass [kg]
 * @param tautness  natural frequencies over those of the average sitter
 * @param tightness damping ratios over those of the average sitter
 */
public record Subject(int number, double mass, double tautness, double tightness) {

    /** All four, in order. */
    public static final List<Subject> ALL = List.of(
            new Subject(1, 78.37, 1.00, 1.00),
            new Subject(2, 70.81, 1.06, 0.94),
            new Subject(3, 88.09, 0.95, 1.07),
            new Subject(4, 80.33, 0.98, 0.97));

    /** @throws IllegalArgumentException if the number is not 1 to 4 */
    public static Subject of(int number) {
        if (number < 1 || number > ALL.size()) {
            throw new IllegalArgumentException("subject must be 1 to " + ALL.size() + ": " + number);
        }
        return ALL.get(number - 1);
    }
}
