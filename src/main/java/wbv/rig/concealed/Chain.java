package wbv.rig.concealed;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.EigenDecomposition;

/**
 * Lumped bodies on a platform, each on one spring and dashpot that stand on a body before it or on the platform. Link i carries
 * body i. Arrays are not copied: treat them as read-only.
 *
 * @param names     of the bodies
 * @param parent    body under each link, -1 for the platform
 * @param mass      [kg]
 * @param stiffness [N/m]
 * @param damping   [N s/m]
 */
record Chain(List<String> names, int[] parent, double[] mass, double[] stiffness, double[] damping) {

    static final String PLATFORM = "platform";
    /** Where the sensor of a body sits. Viscera have none. */
    private static final Map<String, String> PLACES = Map.of("seat", "seat", "pelvis", "pelvis", "torso", "sternum", "head",
            "head");

    Chain {
        names = List.copyOf(names);
        for (int i = 0; i < names.size(); i++) {
            if (parent[i] >= i) {
                throw new IllegalArgumentException("a link must stand on a body before its own: " + names.get(i));
            }
            if (!(mass[i] > 0 && stiffness[i] >= 0 && damping[i] >= 0)) {
                throw new IllegalArgumentException("mass must be > 0, stiffness and damping >= 0: " + names.get(i));
            }
        }
    }

    int size() {
        return names.size();
    }

    int body(String name) {
        return names.indexOf(name);
    }

    /** {@code from-to}. */
    String link(int i) {
        return (parent[i] < 0 ? PLATFORM : names.get(parent[i])) + "-" + names.get(i);
    }

    /** The place of a body's sensor; empty where it has none. */
    String place(int body) {
        return PLACES.getOrDefault(names.get(body), "");
    }

    /** The body on which a sensor rides, -1 for the platform: a pelvis without a body of its own rides on the torso. */
    int rider(String place) {
        for (int i = 0; i < size(); i++) {
            if (place(i).equals(place)) {
                return i;
            }
        }
        return place.equals("pelvis") ? body("torso") : -1;
    }

    /** Undamped natural frequencies, lowest first [Hz]. */
    double[] frequencies() {
        int n = size();
        double[][] k = new double[n][n];
        for (int i = 0; i < n; i++) {
            k[i][i] += stiffness[i];
            int p = parent[i];
            if (p >= 0) {
                k[p][p] += stiffness[i];
                k[p][i] -= stiffness[i];
                k[i][p] -= stiffness[i];
            }
        }
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                k[i][j] /= Math.sqrt(mass[i] * mass[j]);
            }
        }
        double[] squares = new EigenDecomposition(new Array2DRowRealMatrix(k)).getRealEigenvalues();
        return Arrays.stream(squares).map(x -> Math.sqrt(x) / (2 * Math.PI)).sorted().toArray();
    }

    /** All stiffnesses and, so that damping ratios stay, the root of it on all dampings. */
    Chain stiffer(double factor) {
        double root = Math.sqrt(factor);
        return new Chain(names, parent, mass, Arrays.stream(stiffness).map(x -> x * factor).toArray(),
                Arrays.stream(damping).map(x -> x * root).toArray());
    }

    /**
     * The chain as a user writes it.
     *
     * @param blind places whose sensor is missing
     */
    ObjectNode json(String name, List<String> blind) {
        ObjectNode root = new ObjectMapper().createObjectNode();
        root.put("name", name).put("axis", "z");
        root.putObject("base").put("name", PLATFORM).put("sensor", PLATFORM + ".acc.z");
        ArrayNode bodies = root.putArray("bodies");
        ArrayNode links = root.putArray("links");
        for (int i = 0; i < size(); i++) {
            ObjectNode body = bodies.addObject().put("name", names.get(i)).put("mass_kg", rounded(mass[i]));
            if (place(i).isEmpty() || blind.contains(place(i))) {
                body.putNull("sensor");
            } else {
                body.put("sensor", place(i) + ".acc.z");
            }
            links.addObject().put("from", parent[i] < 0 ? PLATFORM : names.get(parent[i])).put("to", names.get(i))
                    .put("stiffness_N_per_m", rounded(stiffness[i])).put("damping_Ns_per_m", rounded(damping[i]));
        }
        return root;
    }

    /** To four significant digits. */
    static double rounded(double x) {
        return x == 0 || !Double.isFinite(x) ? x : new BigDecimal(x).round(new MathContext(4)).doubleValue();
    }
}
