package wbv.pole;

import elki.clustering.dbscan.DBSCAN;
import elki.clustering.optics.ClusterOrder;
import elki.clustering.optics.OPTICSHeap;
import elki.data.Cluster;
import elki.data.Clustering;
import elki.data.NumberVector;
import elki.data.model.Model;
import elki.data.type.TypeUtil;
import elki.database.StaticArrayDatabase;
import elki.database.ids.DBIDArrayIter;
import elki.database.ids.DBIDIter;
import elki.database.ids.DBIDRange;
import elki.database.relation.Relation;
import elki.datasource.ArrayAdapterDatabaseConnection;
import elki.distance.minkowski.EuclideanDistance;
import java.util.Arrays;

/**
 * ELKI's density clusters of points, as a label for each: 0, 1, … in the order of first appearance, {@value #NOISE} for noise.
 *
 * <p>A point is core if at least {@code least} points, itself counted, lie within epsilon of it.
 */
public final class Density {

    /** Label of a point in no cluster. */
    public static final int NOISE = -1;

    private Density() {}

    /**
     * DBSCAN (Ester, Kriegel, Sander and Xu 1996).
     *
     * @param points by row, all coordinates of one unit. Not modified.
     * @param epsilon in that unit, &gt; 0
     * @param least &gt;= 1
     */
    public static int[] dbscan(double[][] points, double epsilon, int least) {
        check(epsilon, least);
        if (points.length == 0) {
            return new int[0];
        }
        Relation<NumberVector> relation = relation(points);
        DBIDRange ids = (DBIDRange) relation.getDBIDs();
        Clustering<Model> found = new DBSCAN<NumberVector>(EuclideanDistance.STATIC, epsilon, least).run(relation);
        int[] labels = new int[points.length];
        Arrays.fill(labels, NOISE);
        int next = 0;
        for (Cluster<Model> cluster : found.getAllClusters()) {
            if (!cluster.isNoise()) {
                for (DBIDIter it = cluster.getIDs().iter(); it.valid(); it.advance()) {
                    labels[ids.getOffset(it)] = next;
                }
                next++;
            }
        }
        return inOrder(labels);
    }

    /**
     * OPTICS (Ankerst, Breunig, Kriegel and Sander 1999), its reachability cut at epsilon: a point reachable from the one before
     * it goes with it, another that is core begins a cluster, and the rest is noise.
     *
     * @param points by row, all coordinates of one unit. Not modified.
     * @param epsilon in that unit, &gt; 0
     * @param least &gt;= 1
     */
    public static int[] optics(double[][] points, double epsilon, int least) {
        check(epsilon, least);
        if (points.length == 0) {
            return new int[0];
        }
        Relation<NumberVector> relation = relation(points);
        DBIDRange ids = (DBIDRange) relation.getDBIDs();
        // A search a little wider than the cut keeps the cut exact and the run fast.
        ClusterOrder order = new OPTICSHeap<NumberVector>(EuclideanDistance.STATIC, 2 * epsilon, least).run(relation);
        double[] core = KDistance.core(points, least);
        int[] labels = new int[points.length];
        int current = NOISE;
        int next = 0;
        for (DBIDArrayIter it = order.iter(); it.valid(); it.advance()) {
            int point = ids.getOffset(it);
            if (order.getReachability(it) > epsilon) {
                current = core[point] <= epsilon ? next++ : NOISE;
            }
            labels[point] = current;
        }
        return inOrder(labels);
    }

    private static void check(double epsilon, int least) {
        if (!(epsilon > 0) || least < 1) {
            throw new IllegalArgumentException("epsilon must be > 0 and the least number of points >= 1: " + epsilon
                    + ", " + least);
        }
    }

    private static Relation<NumberVector> relation(double[][] points) {
        StaticArrayDatabase database = new StaticArrayDatabase(new ArrayAdapterDatabaseConnection(points));
        database.initialize();
        return database.getRelation(TypeUtil.NUMBER_VECTOR_FIELD);
    }

    /** The same partition with labels in the order of first appearance. */
    static int[] inOrder(int[] labels) {
        int[] renamed = new int[labels.length + 1];
        Arrays.fill(renamed, NOISE);
        int next = 0;
        int[] out = labels.clone();
        for (int i = 0; i < labels.length; i++) {
            if (labels[i] != NOISE) {
                if (renamed[labels[i]] == NOISE) {
                    renamed[labels[i]] = next++;
                }
                out[i] = renamed[labels[i]];
            }
        }
        return out;
    }
}
