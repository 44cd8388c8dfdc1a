package wbv.pole;

import java.io.Serializable;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Polygon;
import wbv.filter.model.Bounds.Attribute;
import wbv.identify.Pole;
import wbv.identify.SkyhookBody;
import wbv.identify.TunedResponse;
import wbv.recording.Channel;
import wbv.recording.DataFault;

/**
 * What recordings with all sensors taught: enough to do without some of them.
 *
 * @param layout    which channels it is about
 * @param windows   how a window is identified
 * @param plane     coordinates of the measured place's poles
 * @param epsilon   of its clusters, in the unit of those coordinates
 * @param outline   of the measured place's main cluster: imaginary over real part
 * @param typical   the main cluster's median pole
 * @param links     polygons from the measured place's poles to the absent ones'
 * @param responses of every absent channel to the inputs, its pulsation told by the measured pole
 * @param bodies    of every absent channel, the population's mean body of one mode
 * @param trials    names of the recordings it was trained on
 */
public record TrainedPoles(Layout layout, PoleWindows windows, PolePlane plane, double epsilon, ConstraintPolygon outline,
        Pole typical,
        List<PoleLink> links, Map<Channel, TunedResponse> responses, Map<Channel, SkyhookBody> bodies,
        List<String> trials) implements Serializable {

    /** Furthest that a pole may lie from the main cluster's outline to be taken for one of its [epsilons]. */
    private static final double FURTHEST = 3;

    public TrainedPoles {
        links = List.copyOf(links);
        responses = Map.copyOf(responses);
        bodies = Map.copyOf(bodies);
        trials = List.copyOf(trials);
        for (Channel absent : layout.absent()) {
            if (!responses.containsKey(absent) || !bodies.containsKey(absent)) {
                throw new DataFault("the polygons say nothing of " + absent + "; train them on recordings that have it");
            }
        }
    }

    /**
     * The same for one absent channel alone.
     *
     * @throws DataFault if nothing is said of it
     */
    public TrainedPoles forOnly(Channel absent) {
        return new TrainedPoles(new Layout(layout.inputs(), layout.measured(), List.of(absent)), windows, plane, epsilon, outline, typical,
                links, responses, bodies, trials);
    }

    /** The mode of a window that belongs to the main cluster; empty if none does. */
    Optional<Pole> mainOf(List<Pole> modes) {
        Polygon polygon = polygon();
        GeometryFactory factory = polygon.getFactory();
        record Near(Pole pole, double distance) {}
        return modes.stream().map(pole -> {
            double[] at = plane.coordinates(pole);
            return new Near(pole, polygon.distance(factory.createPoint(new Coordinate(at[0], at[1]))));
        }).filter(near -> near.distance() <= FURTHEST * epsilon).min(Comparator.comparingDouble(Near::distance)).map(Near::pole);
    }

    private Polygon polygon() {
        Coordinate[] ring = new Coordinate[outline.x().length];
        for (int i = 0; i < ring.length; i++) {
            ring[i] = new Coordinate((outline.x()[i] - plane.centreRe()) / plane.spreadRe(),
                    (outline.y()[i] - plane.centreIm()) / plane.spreadIm());
        }
        return new GeometryFactory().createPolygon(ring);
    }

    /** The link to an absent channel's body of one degree. */
    public PoleLink bodyOf(Channel absent) {
        return links.stream().filter(link -> link.absent().equals(absent) && link.kind().equals(PoleLink.BODY)).findFirst()
                .orElseThrow(() -> new DataFault("no polygon leads to the body of " + absent
                        + "; train them on recordings that have it"));
    }

    /**
     * Bounds of a body's attribute.
     *
     * @param measured pole seen now
     */
    public Chord chord(Channel absent, Pole measured, Attribute attribute) {
        return bodyOf(absent).chord(measured, attribute);
    }
}
