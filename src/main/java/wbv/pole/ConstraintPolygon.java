package wbv.pole;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import org.locationtech.jts.algorithm.hull.ConcaveHull;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.simplify.PolygonHullSimplifier;
import wbv.filter.model.Bounds;

/**
 * Where an attribute of a measured place's pole and one of an absent place's were seen together: a simple polygon, without holes,
 * that holds all the points it was made from.
 *
 * <p>It is the alpha shape of the points (Edelsbrunner, Kirkpatrick and Seidel 1983; JTS's connected form), both axes scaled to
 * their spread, widened by {@link #MARGIN} of it and simplified outwards.
 *
 * @param measured attribute of the measured place, along x
 * @param absent   attribute of the absent place, along y
 * @param alpha    largest radius of an empty circle that the hull keeps [spreads]
 * @param points   number of points it was made from
 * @param x        measured attribute by point, in its own unit; a ring, closed: the first point is the last. Not copied: read-only.
 * @param y        absent attribute, as many, in its own unit. Not copied: read-only.
 */
public record ConstraintPolygon(Bounds.Attribute measured, Bounds.Attribute absent, double alpha, int points, double[] x,
        double[] y)
        implements Serializable {

    /** Radius that follows the bend of an arc of poles and bridges the gaps between trials. */
    public static final double ALPHA = 1;
    /** Widening [spreads]: the scatter of a pole's estimate, which a hull of few points understates. */
    public static final double MARGIN = 0.1;
    /** Share of a person's points that a polygon of the others, widened, holds. */
    public static final double HELD = 0.95;
    /** Area that simplifying may add, as a share. */
    private static final double SIMPLER = 0.02;
    private static final int QUADRANT_SEGMENTS = 2;

    public ConstraintPolygon {
        int n = x.length;
        if (n < 4 || y.length != n || x[0] != x[n - 1] || y[0] != y[n - 1]) {
            throw new IllegalArgumentException("a ring needs as many y as x, at least 4, and ends where it begins: " + n
                    + ", " + y.length);
        }
        for (int i = 0; i < n; i++) {
            if (!Double.isFinite(x[i]) || !Double.isFinite(y[i])) {
                throw new IllegalArgumentException("a ring's points must be finite: " + x[i] + ", " + y[i]);
            }
        }
    }

    /**
     * The polygon of points.
     *
     * @param x     values of the measured attribute by point, in its own unit, at least one. Not modified.
     * @param y     of the absent one, as many, in its own unit. Not modified.
     * @param alpha largest radius of an empty circle that the hull keeps [spreads], &gt; 0
     */
    public static ConstraintPolygon around(Bounds.Attribute measured, Bounds.Attribute absent, double[] x, double[] y,
            double alpha) {
        return around(measured, absent, x, y, alpha, MARGIN);
    }

    /**
     * The polygon of the points of several people, wide enough that it would have held each of them had the others alone been
     * known: of all but one, the hull is widened by what the one then lacks, {@value #HELD} of the points of the worst.
     *
     * @param x   values of the measured attribute by point, in its own unit, at least one. Not modified.
     * @param y   of the absent one, as many, in its own unit. Not modified.
     * @param alpha [spreads], &gt; 0
     * @param who whose each point is
     */
    public static ConstraintPolygon around(Bounds.Attribute measured, Bounds.Attribute absent, double[] x, double[] y,
            double alpha, List<String> who) {
        double margin = MARGIN;
        double spreadX = PolePlane.spread(x);
        double spreadY = PolePlane.spread(y);
        GeometryFactory factory = new GeometryFactory();
        for (String one : who.stream().distinct().toList()) {
            List<Coordinate> others = new ArrayList<>();
            List<Coordinate> own = new ArrayList<>();
            for (int i = 0; i < x.length; i++) {
                (who.get(i).equals(one) ? own : others).add(new Coordinate(x[i] / spreadX, y[i] / spreadY));
            }
            if (!others.isEmpty()) {
                Geometry hull = ConcaveHull.alphaShape(factory.createMultiPointFromCoords(others.toArray(Coordinate[]::new)), alpha,
                        false);
                double[] lacks = own.stream().mapToDouble(point -> hull.distance(factory.createPoint(point))).sorted().toArray();
                margin = Math.max(margin, lacks[(int) Math.ceil(HELD * lacks.length) - 1]);
            }
        }
        return around(measured, absent, x, y, alpha, margin);
    }

    private static ConstraintPolygon around(Bounds.Attribute measured, Bounds.Attribute absent, double[] x, double[] y,
            double alpha, double margin) {
        if (x.length == 0 || x.length != y.length) {
            throw new IllegalArgumentException("a polygon needs points, as many y as x: " + x.length + ", " + y.length);
        }
        double centreX = PolePlane.median(x);
        double centreY = PolePlane.median(y);
        double spreadX = PolePlane.spread(x);
        double spreadY = PolePlane.spread(y);
        GeometryFactory factory = new GeometryFactory();
        Coordinate[] scaled = new Coordinate[x.length];
        for (int i = 0; i < x.length; i++) {
            scaled[i] = new Coordinate((x[i] - centreX) / spreadX, (y[i] - centreY) / spreadY);
        }
        Geometry hull = ConcaveHull.alphaShape(factory.createMultiPointFromCoords(scaled), alpha, false);
        Geometry wide = hull.buffer(margin, QUADRANT_SEGMENTS);
        Polygon outer = factory.createPolygon(((Polygon) wide).getExteriorRing().getCoordinateSequence());
        Geometry simple = PolygonHullSimplifier.hullByAreaDelta(outer, true, SIMPLER);
        Coordinate[] ring = ((Polygon) simple).getExteriorRing().getCoordinates();
        double[] ringX = new double[ring.length];
        double[] ringY = new double[ring.length];
        for (int i = 0; i < ring.length; i++) {
            ringX[i] = centreX + spreadX * ring[i].x;
            ringY[i] = centreY + spreadY * ring[i].y;
        }
        return new ConstraintPolygon(measured, absent, alpha, x.length, ringX, ringY);
    }

    /** Mean length of its chords along y, in the absent attribute's unit: its area over its extent along x. */
    public double width() {
        double area = 0;
        for (int i = 0; i + 1 < x.length; i++) {
            area += (x[i] - x[0]) * (y[i + 1] - y[0]) - (x[i + 1] - x[0]) * (y[i] - y[0]);
        }
        return largest() > least() ? Math.abs(area) / 2 / (largest() - least()) : Double.POSITIVE_INFINITY;
    }

    /** Least value along x, in the measured attribute's unit. */
    public double least() {
        double least = x[0];
        for (double value : x) {
            least = Math.min(least, value);
        }
        return least;
    }

    /** Largest value along x, in the measured attribute's unit. */
    public double largest() {
        double largest = x[0];
        for (double value : x) {
            largest = Math.max(largest, value);
        }
        return largest;
    }

    /**
     * Bounds of the absent attribute where the measured one has this value, in its unit: the least and the largest y of the polygon over
     * it. Beyond the polygon those at its nearest end count, and the chord says so.
     */
    public Chord at(double value) {
        double within = Math.max(least(), Math.min(largest(), value));
        double lower = Double.POSITIVE_INFINITY;
        double upper = Double.NEGATIVE_INFINITY;
        for (int i = 0; i + 1 < x.length; i++) {
            double from = Math.min(x[i], x[i + 1]);
            double to = Math.max(x[i], x[i + 1]);
            if (within >= from && within <= to) {
                double a = y[i];
                double b = y[i + 1];
                if (to > from) {
                    a = y[i] + (y[i + 1] - y[i]) * ((within - x[i]) / (x[i + 1] - x[i]));
                    b = a;
                }
                lower = Math.min(lower, Math.min(a, b));
                upper = Math.max(upper, Math.max(a, b));
            }
        }
        return new Chord(lower, upper, within == value);
    }
}
