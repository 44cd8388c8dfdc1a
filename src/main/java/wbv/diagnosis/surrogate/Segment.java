package wbv.diagnosis.surrogate;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * What is usual of a place on a seat or on who sits on it. Masses are those of a man of 73 kg, as much of him as rests on the seat (de Leva
 * 1996: head and neck 6.9 %, chest and abdomen 32 %, arms 10 %, pelvis 11 %, thighs 28 %, of which the seat carries half), of which only
 * the ratios count; places and radii of gyration those of a man of 1.75 m who sits (likewise, by segment). Those of seat and cushion are
 * assumed. Fits move all of it; only what a simulation does not tell stays.
 *
 * @param name     as sensors' locations have it
 * @param mass     [kg]
 * @param x        forward of the base's sensor [m]
 * @param z        above it, where that is below the cushion [m]
 * @param gyration radius of, about the axis of pitch [m]
 */
record Segment(String name, double mass, double x, double z, double gyration) {

    /** Names of what carries a trunk, all of them alike, and of what a backrest hangs on. */
    static final Set<String> TRUNK = Set.of("torso", "trunk", "chest", "sternum");
    static final Set<String> FRAME = Set.of("seat");
    /** What has no segments below it. */
    private static final List<String> GROUND = List.of("platform", "floor");
    /** From below upwards. */
    private static final List<Segment> KNOWN = List.of(new Segment("seat", 10, 0, 0.05, 0.2), new Segment("cushion", 3, 0, 0.05, 0.15),
            new Segment("pelvis", 19, 0, 0.12, 0.15), new Segment("abdomen", 12, 0, 0.25, 0.13),
            new Segment("lumbar", 12, -0.05, 0.25, 0.13), new Segment("torso", 31, 0, 0.42, 0.18),
            new Segment("trunk", 31, 0, 0.42, 0.18), new Segment("chest", 31, 0, 0.42, 0.18),
            new Segment("sternum", 31, 0, 0.42, 0.18), new Segment("shoulders", 7, 0, 0.55, 0.15),
            new Segment("neck", 1.5, 0, 0.65, 0.06), new Segment("head", 5, 0.02, 0.8, 0.08));

    Segment {
        if (!(mass > 0 && gyration > 0 && Double.isFinite(x + z))) {
            throw new IllegalArgumentException("a segment needs a mass and a radius of gyration above 0, and a place: " + name);
        }
    }

    /** The one of a location, if that is a place on a seat or a sitter. */
    static Optional<Segment> at(String location) {
        return KNOWN.stream().filter(segment -> segment.name.equals(location)).findFirst();
    }

    /** Which one a location is, from the base upwards; those that are none of these come last. */
    static int order(String location) {
        List<String> names = KNOWN.stream().map(Segment::name).toList();
        int ground = GROUND.indexOf(location);
        int above = names.indexOf(location);
        return ground >= 0 ? ground : GROUND.size() + (above < 0 ? names.size() : above);
    }
}
