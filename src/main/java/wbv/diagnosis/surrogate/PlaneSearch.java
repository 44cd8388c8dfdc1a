package wbv.diagnosis.surrogate;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.stream.IntStream;

/**
 * Looks for rigid bodies in a plane that do what was computed of places that move along x and z and pitch: the places in a chain from the
 * base upwards, a trunk against a backrest, then a joint or a body that nobody measured more as long as each halves what is missed.
 */
final class PlaneSearch {

    /** Steps from each start, after which only the best goes on: the first ten bring most of the gain. */
    private static final int TRIED = 15;

    /** Of a place that is none of a person's [kg], [m]: its height by its order up to that of a head. */
    private static final double OTHER_MASS = 10;
    private static final double OTHER_GYRATION = 0.15;
    private static final double LOWEST = 0.1;
    private static final double HIGHEST = 0.8;

    /** By what logarithm an inertia differs from the usual one, twice as far as a mass, and by what a place does [m]; assumed. */
    private static final double INERTIA_SPREAD = 0.8;
    private static final double PLACE_SPREAD = 0.1;
    /** Of stiffness and damping: hardly anything is known of them. */
    private static final double FORCE_SPREAD = 1.5;
    /** Where the base's sensor sits below what carries the sitter [m]: under the cushion, or on the floor. */
    private static final double[] BELOW = {0, 0.4};
    /**
     * Natural frequencies that what each joint carries would have on it alone, where fits start [Hz]: of the lowest joint, and of the
     * others.
     */
    private static final double[][] STARTS = {{4, 8}, {15, 10}};
    /** Part of what it carries by which a backrest holds. */
    private static final double BACKREST = 0.2;
    private static final double BACKREST_X = -0.12;
    /**
     * Where a joint holds below the lowest place [m], and at what arm joints resist turning, where fits start [m]: a cushion as wide as a
     * seat, a spine.
     */
    private static final double CUSHION_BELOW = 0.1;
    private static final double CUSHION_ARM = 0.3;
    private static final double SPINE_ARM = 0.15;
    private static final double BACKREST_ARM = 0.1;

    private final List<String> places;
    private final PlaneFit fit;
    private final BiConsumer<String, Double> progress;

    /**
     * @param places that were measured, in the order of the fit's readings, see {@link #ordered}
     * @param fit    what they are to do
     */
    PlaneSearch(List<String> places, PlaneFit fit, BiConsumer<String, Double> progress) {
        this.places = List.copyOf(places);
        this.fit = fit;
        this.progress = progress;
    }

    /** From the base upwards; places that are no part of a person come last, in the order in which they stand. */
    static List<String> ordered(List<String> places) {
        return places.stream().sorted(Comparator.comparingInt(Segment::order)).toList();
    }

    /** The measured bodies, no more. */
    FittedPlane plain() {
        return best(starts());
    }

    /** With as much more as it takes to do what was computed. */
    FittedPlane enriched(PlaneNet plain) {
        return Enrichment.of(fit.fit(plain), known -> best(richer(known.net())),
                (known, more) -> more.evidence() > known.evidence(), progress);
    }

    /** The one that a few steps bring nearest, fitted to the end. */
    private FittedPlane best(List<PlaneNet> nets) {
        return fit.fit(
                nets.stream().map(net -> fit.fit(net, TRIED)).min(Comparator.comparingDouble(FittedPlane::cost)).orElseThrow().net());
    }

    private List<PlaneNet> starts() {
        List<PlaneNet> out = new ArrayList<>();
        for (double below : BELOW) {
            for (double[] frequencies : STARTS) {
                out.add(seated(frequencies).raised(below));
            }
        }
        return out;
    }

    private Segment usual(int place) {
        double height = LOWEST + (HIGHEST - LOWEST) * place / Math.max(1, places.size() - 1);
        return Segment.at(places.get(place)).orElseGet(() -> new Segment(places.get(place), OTHER_MASS, 0, height, OTHER_GYRATION));
    }

    /** All that is at a place or above it [kg]. */
    private double carried(int from) {
        return IntStream.range(from, places.size()).mapToDouble(place -> usual(place).mass()).sum();
    }

    private int first(Set<String> names) {
        return IntStream.range(0, places.size()).filter(i -> names.contains(places.get(i))).findFirst().orElse(-1);
    }

    private PlaneNet seated(double[] frequencies) {
        List<PlaneNet.Part> parts = IntStream.range(0, places.size()).mapToObj(i -> measured(usual(i))).toList();
        PlaneNet net = new PlaneNet(parts, List.of());
        for (int i = 0; i < parts.size(); i++) {
            double z = i == 0 ? usual(0).z() - CUSHION_BELOW : (usual(i - 1).z() + usual(i).z()) / 2;
            net = net.with(joint(i - 1, i, carried(i), frequencies[i == 0 ? 0 : 1], i == 0 ? CUSHION_ARM : SPINE_ARM, 0, z));
        }
        int trunk = first(Segment.TRUNK);
        int frame = first(Segment.FRAME);
        if (trunk > frame + 1) {
            net = net.with(joint(frame, trunk, BACKREST * carried(trunk), frequencies[0], BACKREST_ARM, BACKREST_X, usual(trunk).z()));
        }
        return net;
    }

    private static PlaneNet.Part measured(Segment usual) {
        double inertia = usual.mass() * usual.gyration() * usual.gyration();
        double[] at = {Math.log(usual.mass()), usual.x(), usual.z(), Math.log(inertia), usual.x(), usual.z()};
        return new PlaneNet.Part(usual.name(), true, PlaneNet.Numbers.of(at,
                new double[] {MassPrior.USUAL_SPREAD, PLACE_SPREAD, PLACE_SPREAD, INERTIA_SPREAD, PLACE_SPREAD, PLACE_SPREAD}));
    }

    /**
     * A joint on which a mass swings at a frequency.
     *
     * @param arm at which it holds against turning [m]
     * @param x of its point
     * @param z likewise
     */
    private static PlaneNet.Joint joint(int lower, int upper, double mass, double frequency, double arm, double x, double z) {
        Suspension suspension = Suspension.of(mass, frequency);
        double stiffness = Math.log(suspension.stiffness());
        double damping = Math.log(suspension.damping());
        double about = 2 * Math.log(arm);
        double[] at = {stiffness, stiffness, damping, damping, x, z, stiffness + about, damping + about};
        return new PlaneNet.Joint(lower, upper,
                PlaneNet.Numbers.of(at, new double[] {FORCE_SPREAD, FORCE_SPREAD, FORCE_SPREAD, FORCE_SPREAD, PLACE_SPREAD,
                    PLACE_SPREAD, FORCE_SPREAD, FORCE_SPREAD}));
    }

    /** With a joint past a body, and with a body that rides on one. */
    private static List<PlaneNet> richer(PlaneNet known) {
        List<PlaneNet> out = new ArrayList<>();
        List<PlaneNet.Part> parts = known.parts();
        double mass = Enrichment.LIGHT * known.mass();
        for (int a = -1; a < parts.size(); a++) {
            for (int b = a + 1; b < parts.size(); b++) {
                if (known.between(a, b).isEmpty() && parts.get(b).measured() && (a < 0 || parts.get(a).measured())) {
                    double z = a < 0 ? parts.get(b).z() : (parts.get(a).z() + parts.get(b).z()) / 2;
                    out.add(known.with(joint(a, b, mass, Enrichment.FREQUENCIES[0], BACKREST_ARM, parts.get(b).x(), z)));
                }
            }
        }
        String name = "unmeasured" + (1 + parts.stream().filter(part -> !part.measured()).count());
        for (int i = 0; i < parts.size(); i++) {
            PlaneNet.Part on = parts.get(i);
            for (double frequency : on.measured() ? Enrichment.FREQUENCIES : new double[0]) {
                PlaneNet.Numbers rider = PlaneNet.Numbers.of(new double[] {Math.log(mass), on.x(), on.z()},
                        new double[] {2 * MassPrior.USUAL_SPREAD, PLACE_SPREAD, PLACE_SPREAD});
                Suspension suspension = Suspension.of(mass, frequency);
                double stiffness = Math.log(suspension.stiffness());
                double damping = Math.log(suspension.damping());
                out.add(known.with(new PlaneNet.Part(name, false, rider), new PlaneNet.Joint(i, parts.size(), PlaneNet.Numbers.of(
                        new double[] {stiffness, stiffness, damping, damping},
                        new double[] {FORCE_SPREAD, FORCE_SPREAD, FORCE_SPREAD, FORCE_SPREAD}))));
            }
        }
        return out;
    }
}
