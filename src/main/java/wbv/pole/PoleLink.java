package wbv.pole;

import java.io.Serializable;
import java.util.Comparator;
import java.util.List;
import wbv.filter.model.Bounds.Attribute;
import wbv.identify.Pole;
import wbv.recording.Channel;

/**
 * What a measured pole says of an absent one: a polygon for every pair of attributes.
 *
 * @param absent          channel without a sensor
 * @param kind            what its pole is: {@value #BODY}, of the one-degree body that best simulates it, or {@code cluster N}
 *         of ARMAX poles
 * @param measuredCluster cluster of the measured place's poles
 * @param polygons        one for each pair of attributes
 */
public record PoleLink(Channel absent, String kind, int measuredCluster, List<ConstraintPolygon> polygons) implements Serializable {

    public static final String BODY = "body";

    public PoleLink {
        polygons = List.copyOf(polygons);
        if (polygons.isEmpty()) {
            throw new IllegalArgumentException("a link needs a polygon: " + absent + ", " + kind);
        }
    }

    /**
     * Bounds of an attribute of the absent pole: those of the polygon that says most of it. The polygons from a pole's frequency,
     * damping ratio and parts are the same two numbers seen four ways, not four witnesses: what they have in common holds less
     * often than any of them.
     *
     * @param measured the pole seen now
     */
    public Chord chord(Pole measured, Attribute attribute) {
        ConstraintPolygon best = polygons.stream().filter(polygon -> polygon.absent() == attribute)
                .min(Comparator.comparingDouble(ConstraintPolygon::width))
                .orElseThrow(() -> new IllegalArgumentException("no polygon leads to " + attribute + " of " + absent));
        return best.at(Attributes.of(measured, best.measured()));
    }
}
