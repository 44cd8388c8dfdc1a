package wbv.pole;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Test;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Polygon;
import wbv.filter.model.Bounds.Attribute;

/** Polygons against JTS's own validity and intersections. */
class ConstraintPolygonTest {

    private static final GeometryFactory FACTORY = new GeometryFactory();

    @Test
    void everyOfTwoHundredSeedsGivesAValidPolygonThatHoldsItsPoints() {
        for (int seed = 0; seed < 200; seed++) {
            RandomGenerator random = new Well19937c(seed);
            int n = 1 + random.nextInt(300);
            double[] x = new double[n];
            double[] y = new double[n];
            for (int i = 0; i < n; i++) {
                double t = random.nextDouble();
                x[i] = 4 + 3 * t + 0.02 * random.nextGaussian();
                y[i] = 30 * Math.sin(4 * t) + (seed % 3 == 0 ? 0 : random.nextGaussian());
            }
            Polygon polygon = jts(ConstraintPolygon.around(Attribute.FREQUENCY, Attribute.REAL, x, y, 1));
            assertTrue(polygon.isValid(), "seed " + seed);
            assertEquals(0, polygon.getNumInteriorRing());
            for (int i = 0; i < n; i++) {
                assertTrue(polygon.covers(FACTORY.createPoint(new Coordinate(x[i], y[i]))), "seed " + seed + ", point " + i);
            }
        }
    }

    @Test
    void chordsAreJtsIntersections() {
        RandomGenerator random = new Well19937c(1);
        double[] x = new double[200];
        double[] y = new double[200];
        for (int i = 0; i < x.length; i++) {
            double t = 2 * Math.PI * random.nextDouble();
            x[i] = Math.cos(t) + 0.05 * random.nextGaussian();
            y[i] = Math.sin(t) + 0.05 * random.nextGaussian();
        }
        ConstraintPolygon polygon = ConstraintPolygon.around(Attribute.FREQUENCY, Attribute.FREQUENCY, x, y, 0.3);
        for (double at = -0.95; at < 1; at += 0.13) {
            Geometry cut = jts(polygon).intersection(FACTORY.createLineString(new Coordinate[] {new Coordinate(at, -9),
                new Coordinate(at, 9)}));
            Chord chord = polygon.at(at);
            assertTrue(chord.inside());
            assertEquals(cut.getEnvelopeInternal().getMinY(), chord.lower(), 1e-9);
            assertEquals(cut.getEnvelopeInternal().getMaxY(), chord.upper(), 1e-9);
        }
    }

    @Test
    void anAlphaShapeBendsWithAnArcAndAConvexHullDoesNot() {
        double[] x = new double[300];
        double[] y = new double[300];
        RandomGenerator random = new Well19937c(3);
        for (int i = 0; i < 300; i++) {
            double t = Math.PI * i / 299;
            x[i] = Math.cos(t) + 0.04 * random.nextGaussian();
            y[i] = Math.sin(t) + 0.04 * random.nextGaussian();
        }
        double bent = ConstraintPolygon.around(Attribute.FREQUENCY, Attribute.REAL, x, y, 0.3).at(0).lower();
        double convex = ConstraintPolygon.around(Attribute.FREQUENCY, Attribute.REAL, x, y, 100).at(0).lower();
        assertTrue(bent > 0.7, "the arc is 1 above its middle: " + bent);
        assertTrue(convex < 0.1, "the hull is not: " + convex);
    }

    @Test
    void beyondThePolygonItsNearestEndCountsAndIsFlagged() {
        ConstraintPolygon triangle = new ConstraintPolygon(Attribute.FREQUENCY, Attribute.DAMPING, 1, 3, new double[] {1, 3, 3,
            1},
                new double[] {0.2, 0.1, 0.5, 0.2});
        assertEquals(0.15, triangle.at(2).lower(), 1e-12);
        assertEquals(0.35, triangle.at(2).upper(), 1e-12);
        assertTrue(triangle.at(2).inside());
        assertEquals(new Chord(0.1, 0.5, false), triangle.at(7));
        assertEquals(new Chord(0.2, 0.2, false), triangle.at(-1));
    }

    /** A person who lies apart from the others is within the polygon, and makes it wider; one among them does not. */
    @Test
    void aPolygonWouldHaveHeldEachPersonByTheOthers() {
        RandomGenerator random = new Well19937c(8);
        int n = 90;
        double[] x = new double[n];
        double[] y = new double[n];
        java.util.List<String> who = new java.util.ArrayList<>();
        for (int i = 0; i < n; i++) {
            int person = i % 3;
            who.add("person " + person);
            x[i] = 5 + 0.3 * random.nextGaussian();
            y[i] = 0.3 + 0.02 * random.nextGaussian() + (person == 2 ? 0.12 : 0);
        }
        ConstraintPolygon plain = ConstraintPolygon.around(Attribute.FREQUENCY, Attribute.DAMPING, x, y, 1);
        ConstraintPolygon wide = ConstraintPolygon.around(Attribute.FREQUENCY, Attribute.DAMPING, x, y, 1, who);
        assertTrue(wide.width() > 1.3 * plain.width(), wide.width() + ", " + plain.width());
        ConstraintPolygon one = ConstraintPolygon.around(Attribute.FREQUENCY, Attribute.DAMPING, x, y, 1,
                java.util.Collections.nCopies(n, "one"));
        assertEquals(plain.width(), one.width(), 1e-12);
        ConstraintPolygon square = new ConstraintPolygon(Attribute.FREQUENCY, Attribute.DAMPING, 1, 4, new double[] {1, 4, 4, 1, 1},
                new double[] {2, 2, 7, 7, 2});
        assertEquals(5, square.width(), 1e-12);
    }

    @Test
    void aRingMustBeClosedAndFinite() {
        assertThrows(IllegalArgumentException.class, () -> new ConstraintPolygon(Attribute.FREQUENCY, Attribute.REAL, 1, 3,
                new double[] {0, 1, 1, 0.5}, new double[] {0, 0, 1, 0.5}));
        assertThrows(IllegalArgumentException.class, () -> ConstraintPolygon.around(Attribute.FREQUENCY, Attribute.REAL,
                new double[0],
                new double[0], 1));
    }

    private static Polygon jts(ConstraintPolygon polygon) {
        Coordinate[] ring = new Coordinate[polygon.x().length];
        for (int i = 0; i < ring.length; i++) {
            ring[i] = new Coordinate(polygon.x()[i], polygon.y()[i]);
        }
        return FACTORY.createPolygon(ring);
    }
}
