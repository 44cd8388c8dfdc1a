package wbv.body;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * How the coordinates of a structure go together: what stretches each link, how the base carries each coordinate, and which of them
 * are of one mass.
 *
 * <p>Small motions about where everything rests; {@link Plane} knows more. A link between points of bodies that turn is stretched by its
 * two ends and, by their lever arms, by the angles.
 *
 * @param stretch by link
 * @param carried what a coordinate moves by with a unit of each of the base's axes [1], or [m] about an axis, by coordinate and axis. Not
 *                copied
 * @param massOf  coordinate whose mass each has: its own index where it has its own. Not copied
 * @param plane   where bodies that turn are, for what goes beyond small motions; empty where that is not known
 */
public record Kinematics(List<Row> stretch, double[][] carried, int[] massOf, Optional<Plane> plane) {

    public Kinematics {
        stretch = List.copyOf(stretch);
        int bodies = carried.length;
        if (massOf.length != bodies
                || bodies > 0 && Arrays.stream(carried).anyMatch(row -> row.length != carried[0].length || row.length == 0)) {
            throw new IllegalArgumentException(
                    "kinematics need as many axes for each of " + bodies + " coordinates, at least one, and whose mass each has");
        }
        for (int i = 0; i < bodies; i++) {
            if (massOf[i] < 0 || massOf[i] >= bodies || massOf[massOf[i]] != massOf[i]) {
                throw new IllegalArgumentException("coordinate " + i + " has the mass of " + massOf[i] + ", which has none of its own");
            }
        }
        for (Row row : stretch) {
            if (Arrays.stream(row.at()).anyMatch(i -> i >= bodies)) {
                throw new IllegalArgumentException(
                        "a link is stretched by coordinates of which there are " + bodies + ": " + Arrays.toString(row.at()));
            }
        }
    }

    /**
     * Bodies along the base's one axis, each link between its two ends.
     *
     * @param from -1 for the base. Not modified.
     * @param to Not modified.
     */
    static Kinematics along(int[] from, int[] to, int bodies) {
        double[][] carried = new double[bodies][1];
        Arrays.stream(carried).forEach(row -> row[0] = 1);
        return new Kinematics(IntStream.range(0, Math.min(from.length, to.length)).mapToObj(l -> Row.between(from[l], to[l])).toList(),
                carried, IntStream.range(0, bodies).toArray(), Optional.empty());
    }

    /** Axes along which the base moves. */
    int axes() {
        return carried.length == 0 ? 1 : carried[0].length;
    }

    /** What a combination of motions moves by with a unit of one of the base's axes [1], or [m] about an axis. */
    public double carried(Row row, int axis) {
        double part = 0;
        for (int i = 0; i < row.at().length; i++) {
            part += row.by()[i] * carried[row.at()[i]][axis];
        }
        return part;
    }

    /** These, and one coordinate more that rides on another by a link of its own: it is carried as that is. */
    public Kinematics riding(int on) {
        int n = carried.length;
        List<Row> rows = new java.util.ArrayList<>(stretch);
        rows.add(Row.between(on, n));
        double[][] all = Arrays.copyOf(carried, n + 1);
        all[n] = carried[on].clone();
        int[] masses = Arrays.copyOf(massOf, n + 1);
        masses[n] = n;
        return new Kinematics(rows, all, masses, plane);
    }
}
