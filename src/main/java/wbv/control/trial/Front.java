package wbv.control.trial;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * What one controller makes of one ride, tuned from daring to careful: comfort over stroke.
 *
 * @param family    of the controller
 * @param knowledge what it knows of the sitter
 * @param points by rising tuning, one at least
 */
public record Front(ControllerFamily family, Knowledge knowledge, List<Point> points) {

    /**
     * A ride with one tuning.
     *
     * @param tuning what was tuned to, in the unit of the family
     * @param result what came of it
     */
    public record Point(double tuning, TrialResult result) {}

    /**
     * At a given stroke.
     *
     * @param seat SEAT [1]
     * @param head likewise, of the head
     * @param strokeRms [m]
     * @param strokeMost [m]
     * @param stopHits mean number of hits
     * @param power [W]
     * @param force of the actuator, r.m.s. [N]
     */
    public record AtStroke(double seat, double head, double strokeRms, double strokeMost, double stopHits, double power, double force) {

        private static AtStroke of(TrialResult r) {
            return new AtStroke(r.seat(), r.head(), r.strokeRms(), r.strokeMost(), r.stopHits(), r.power(), r.forceRms());
        }

        private static AtStroke between(TrialResult a, TrialResult b, double stroke) {
            double share = Math.log(stroke / a.strokeRms()) / Math.log(b.strokeRms() / a.strokeRms());
            return new AtStroke(mix(a.seat(), b.seat(), share), mix(a.head(), b.head(), share), stroke,
                    mix(a.strokeMost(), b.strokeMost(), share),
                    mix(a.stopHits(), b.stopHits(), share), mix(a.power(), b.power(), share), mix(a.forceRms(), b.forceRms(), share));
        }

        private static double mix(double a, double b, double share) {
            return a + share * (b - a);
        }
    }

    public Front {
        points = List.copyOf(points);
        if (points.isEmpty()) {
            throw new IllegalArgumentException("a front needs a point at least");
        }
    }

    /**
     * The least SEAT with at most so much stroke, on straight lines between the points over the logarithm of the stroke.
     *
     * @param strokeRms [m]
     * @return empty if no point has so little stroke
     */
    public Optional<AtStroke> at(double strokeRms) {
        List<TrialResult> sorted = points.stream().map(Point::result).sorted(Comparator.comparingDouble(TrialResult::strokeRms)).toList();
        List<AtStroke> within = new ArrayList<>();
        for (int i = 0; i < sorted.size() && sorted.get(i).strokeRms() <= strokeRms; i++) {
            within.add(AtStroke.of(sorted.get(i)));
            if (i + 1 < sorted.size() && sorted.get(i + 1).strokeRms() > strokeRms) {
                within.add(AtStroke.between(sorted.get(i), sorted.get(i + 1), strokeRms));
            }
        }
        return within.stream().min(Comparator.comparingDouble(AtStroke::seat));
    }

    /** The point with the least SEAT among those that leave the stops alone, else of all. */
    public Point best() {
        Comparator<Point> byHits = Comparator.comparing(point -> point.result().stopHits() > 0);
        return points.stream().min(byHits.thenComparing(point -> point.result().seat())).orElseThrow();
    }
}
