package wbv.pole;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import wbv.identify.Pole;
import wbv.recording.Channel;

/**
 * All poles of a place and how they gather. Arrays are not copied: treat them as read-only.
 *
 * @param place  where
 * @param poles  of all windows
 * @param window of each pole, the number of its window
 * @param plane  coordinates they were gathered in
 * @param curve  k-distances, and with them epsilon
 * @param dbscan label of each pole, {@link Density#NOISE} for noise
 */
public record PlaceClusters(Channel place, List<Pole> poles, int[] window, PolePlane plane, KDistance curve, int[] dbscan) {

    private static final int FEWEST = 6;
    private static final double SHARE = 0.01;
    private static final int MOST_COMPONENTS = 6;

    /** Gathers poles, at least {@value #FEWEST}. */
    static PlaceClusters of(Channel place, List<Pole> poles, int[] window) {
        int least = Math.max(FEWEST, (int) Math.round(SHARE * poles.size()));
        PolePlane plane = PolePlane.of(poles);
        double[][] points = plane.coordinates(poles);
        KDistance curve = KDistance.of(points, least);
        double epsilon = Math.max(curve.epsilon(), 1e-9);
        return new PlaceClusters(place, List.copyOf(poles), window, plane, curve, Density.dbscan(points, epsilon, least));
    }

    /** The same by OPTICS, cut at the same epsilon: worked out when asked for. */
    public int[] optics() {
        return Density.optics(plane.coordinates(poles), Math.max(curve.epsilon(), 1e-9), curve.k());
    }

    /** Label of each pole by Weka's EM, which knows no noise: worked out when asked for. */
    public int[] mixture() {
        return WekaMixture.labels(plane.coordinates(poles), MOST_COMPONENTS, 1);
    }

    static boolean enough(List<Pole> poles) {
        return poles.size() >= FEWEST;
    }

    /** Number of DBSCAN's clusters. */
    public int count() {
        return Arrays.stream(dbscan).max().orElse(Density.NOISE) + 1;
    }

    /**
     * Poles of a cluster.
     *
     * @param label of DBSCAN, or {@link Density#NOISE}
     */
    public List<Pole> members(int label) {
        List<Pole> members = new ArrayList<>();
        for (int i = 0; i < dbscan.length; i++) {
            if (dbscan[i] == label) {
                members.add(poles.get(i));
            }
        }
        return members;
    }

    /** The largest cluster; noise if there is none. */
    public int largest() {
        int best = Density.NOISE;
        for (int label = 0; label < count(); label++) {
            if (best == Density.NOISE || members(label).size() > members(best).size()) {
                best = label;
            }
        }
        return best;
    }
}
