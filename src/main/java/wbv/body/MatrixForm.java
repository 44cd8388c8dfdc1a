package wbv.body;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.EigenDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import wbv.recording.Channel;

/**
 * A model as other tools export it: {@code M q'' + C q' + K q = -M R a}, with q against the base, a the base's accelerations and R how each
 * of them carries q; sensors read combinations of q. It becomes a {@link Model} whose bodies are the coordinates, where M is diagonal, or
 * else the modes of M and K, and whose links are what K and C join.
 *
 * <p>An entry of K between two coordinates is a spring between them, which their difference stretches where it is negative and their sum
 * where it is positive; what is then left on the diagonal is a spring to the base. Where less than nothing is left, K is taken apart as
 * L D Lᵀ instead: a spring for each column.
 */
final class MatrixForm {

    /** Part of the largest entry of a matrix below which another is rounding. */
    private static final double ROUNDING = 1e-9;
    /** The same for two entries that should be one: files print six digits at least. */
    private static final double SYMMETRY = 1e-6;

    private final JsonPlace at;
    private final List<String> names;
    private final List<Channel> axes;
    /** How coordinates are made of bodies: coordinate by body. */
    private final RealMatrix shape;
    private final double[] mass;
    private final RealMatrix stiffness;
    private final RealMatrix damping;
    private final RealMatrix carried;

    private MatrixForm(JsonPlace at) {
        this.at = at;
        at.allow(Set.of("name", "source", "subject", "axis", "base", "matrices", "inputs"));
        JsonPlace matrices = at.child("matrices");
        matrices.allow(Set.of("coordinates", "M", "C", "K", "R", "sensors", "places"));
        JsonPlace base = at.child("base");
        base.allow(Set.of("name", "sensors", ModelFile.FILTER));
        axes = base.texts("sensors").stream().map(name -> base.guard(() -> Channel.parse(name))).toList();
        List<String> coordinates = matrices.texts("coordinates");
        int n = coordinates.size();
        if (n == 0 || coordinates.stream().distinct().count() < n) {
            throw matrices.fault("'coordinates' must name each coordinate once");
        }
        RealMatrix m = symmetric(matrices, "M", n);
        RealMatrix k = symmetric(matrices, "K", n);
        RealMatrix c = symmetric(matrices, "C", n);
        RealMatrix r = axes.isEmpty() ? new Array2DRowRealMatrix(n, 1) : matrix(matrices, "R", n, axes.size());
        boolean lumped = IntStream.range(0, n).allMatch(i -> IntStream.range(0, n).allMatch(j -> i == j || m.getEntry(i, j) == 0));
        shape = lumped ? diagonal(IntStream.range(0, n).mapToDouble(i -> 1).toArray()) : modes(matrices, m, k);
        names = lumped ? coordinates : IntStream.rangeClosed(1, n).mapToObj(i -> "mode" + i).toList();
        RealMatrix turned = shape.transpose();
        mass = IntStream.range(0, n).mapToDouble(i -> turned.multiply(m).multiply(shape).getEntry(i, i)).toArray();
        stiffness = turned.multiply(k).multiply(shape);
        damping = turned.multiply(c).multiply(shape);
        // q = shape η, and M R a moves η as shape⁻¹ R: of modes of unit mass shapeᵀ M is that inverse.
        carried = lumped ? r : turned.multiply(m).multiply(r);
        for (int i = 0; i < n; i++) {
            if (!(mass[i] > 0)) {
                throw matrices.fault("'M' must be positive: its entry for " + coordinates.get(i) + " is " + mass[i]);
            }
        }
    }

    static boolean is(JsonPlace at) {
        return at.has("matrices");
    }

    static Model read(JsonPlace at) {
        MatrixForm form = new MatrixForm(at);
        JsonPlace base = at.child("base");
        Model.Base ground = base.guard(() -> new Model.Base(base.text("name"), form.axes.stream().findFirst(), 0,
                form.axes.isEmpty() ? form.axes : form.axes.subList(1, form.axes.size()), Optional.empty(),
                ModelFile.filter(base)));
        return ModelFile.model(at, ground, form.bodies(), form.links(ground.name()), form.sensors());
    }

    private List<Model.Body> bodies() {
        List<Model.Body> out = new ArrayList<>();
        for (int i = 0; i < names.size(); i++) {
            Map<Channel, Double> by = new LinkedHashMap<>();
            for (int axis = 0; axis < axes.size(); axis++) {
                by.put(axes.get(axis), carried.getEntry(i, axis));
            }
            int own = i;
            out.add(at.guard(
                    () -> new Model.Body(names.get(own), mass[own], Optional.empty(), List.of(), Optional.empty(), List.of(), false, by,
                            Optional.empty(), false, Optional.empty())));
        }
        return out;
    }

    /** Where a spring or a dashpot acts. */
    private record Joint(String from, String to, Map<String, Double> arms) {}

    private List<Model.Link> links(String ground) {
        Map<Joint, double[]> joints = new LinkedHashMap<>();
        join(ground, stiffness, 0, joints);
        join(ground, damping, 1, joints);
        List<Model.Link> out = new ArrayList<>();
        joints.forEach((joint, values) -> out
                .add(at.guard(() -> new Model.Link(joint.from(), joint.to(), values[0], values[1], Optional.empty(), List.of(),
                        List.of(), List.of(), joint.arms(), Optional.empty()))));
        for (JsonPlace place : at.child("matrices").optionalList("places")) {
            place.allow(Set.of("from", "to", "laws"));
            out.add(ModelFile.link(place, place.text("from"), place.text("to"), 0, 0, Map.of(), Optional.empty()));
        }
        return out;
    }

    /**
     * Adds what a matrix joins.
     *
     * @param which 0 for springs, 1 for dashpots
     * @param joints Modified.
     */
    private void join(String ground, RealMatrix matrix, int which, Map<Joint, double[]> joints) {
        Map<Joint, Double> found = between(ground, matrix);
        double least = -ROUNDING * largest(matrix);
        if (found.values().stream().anyMatch(value -> value < least)) {
            found = throughout(ground, matrix);
        }
        found.forEach((joint, value) -> {
            if (value > -least) {
                joints.computeIfAbsent(joint, each -> new double[2])[which] = value;
            }
        });
    }

    /** Each entry off the diagonal joins two bodies; what is left on the diagonal, of either sign, joins one to the base. */
    private Map<Joint, Double> between(String ground, RealMatrix matrix) {
        Map<Joint, Double> out = new LinkedHashMap<>();
        for (int j = 0; j < names.size(); j++) {
            double rest = matrix.getEntry(j, j);
            for (int i = 0; i < names.size(); i++) {
                double entry = i == j ? 0 : matrix.getEntry(i, j);
                rest -= Math.abs(entry);
                if (i < j && entry != 0) {
                    out.put(entry < 0 ? new Joint(names.get(i), names.get(j), Map.of())
                            : new Joint(ground, names.get(j), Map.of(names.get(i), 1.0)), Math.abs(entry));
                }
            }
            out.put(new Joint(ground, names.get(j), Map.of()), rest);
        }
        return out;
    }

    /** As L D Lᵀ, L with ones on its diagonal: one joint to the base for each column, which all bodies behind it stretch too. */
    private Map<Joint, Double> throughout(String ground, RealMatrix matrix) {
        int n = names.size();
        double[][] left = matrix.getData();
        Map<Joint, Double> out = new LinkedHashMap<>();
        for (int i = 0; i < n; i++) {
            double pivot = left[i][i];
            if (pivot < ROUNDING * largest(matrix)) {
                if (pivot < -ROUNDING * largest(matrix)) {
                    throw at.fault(String.format(Locale.ROOT, "K and C must not give energy: %s would (%.3g is left of its entry)",
                            names.get(i), pivot));
                }
                continue;
            }
            Map<String, Double> arms = new LinkedHashMap<>();
            for (int j = i + 1; j < n; j++) {
                double part = left[j][i] / pivot;
                if (part != 0) {
                    arms.put(names.get(j), part);
                }
                for (int k = i + 1; k < n; k++) {
                    left[j][k] -= part * left[i][k];
                }
            }
            out.put(new Joint(ground, names.get(i), arms), pivot);
        }
        return out;
    }

    private List<Model.Sensor> sensors() {
        List<Model.Sensor> out = new ArrayList<>();
        for (JsonPlace sensor : at.child("matrices").optionalList("sensors")) {
            sensor.allow(Set.of("sensor", "reads", "faults"));
            Channel channel = sensor.channel("sensor").orElseThrow(() -> sensor.fault("'sensor' names no channel"));
            double[] reads = sensor.numbers("reads");
            if (reads.length != names.size()) {
                throw sensor.fault("'reads' must have a number for each of " + names.size() + " coordinates: it has " + reads.length);
            }
            double[] by = shape.preMultiply(reads);
            Map<String, Double> named = new LinkedHashMap<>();
            IntStream.range(0, by.length).filter(i -> by[i] != 0).forEach(i -> named.put(names.get(i), by[i]));
            out.add(sensor.guard(() -> new Model.Sensor(channel, named, ModelFile.faults(sensor), Optional.empty())));
        }
        return out;
    }

    /** The modes of M and K, of unit mass, by column. */
    private static RealMatrix modes(JsonPlace matrices, RealMatrix m, RealMatrix k) {
        EigenDecomposition masses = new EigenDecomposition(m);
        double[] lightest = masses.getRealEigenvalues();
        if (Arrays.stream(lightest).min().orElse(0) <= ROUNDING * Arrays.stream(lightest).max().orElse(0)) {
            throw matrices.fault("'M' must be positive: its least eigenvalue is " + Arrays.stream(lightest).min().orElse(0));
        }
        RealMatrix scaling = masses.getV().multiply(diagonal(Arrays.stream(lightest).map(value -> 1 / Math.sqrt(value)).toArray()))
                .multiply(masses.getVT());
        RealMatrix scaled = scaling.multiply(k).multiply(scaling);
        EigenDecomposition modes = new EigenDecomposition(scaled.add(scaled.transpose()).scalarMultiply(0.5));
        return scaling.multiply(modes.getV());
    }

    private static RealMatrix symmetric(JsonPlace matrices, String key, int n) {
        RealMatrix read = matrix(matrices, key, n, n);
        double most = largest(read);
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < i; j++) {
                if (Math.abs(read.getEntry(i, j) - read.getEntry(j, i)) > SYMMETRY * most) {
                    throw matrices
                            .fault("'" + key + "' must be symmetric: entries " + i + ", " + j + " are " + read.getEntry(i, j) + " and "
                                    + read.getEntry(j, i) + ". Cross gains that are not go into 'reads'");
                }
            }
        }
        return read.add(read.transpose()).scalarMultiply(0.5);
    }

    private static RealMatrix matrix(JsonPlace matrices, String key, int rows, int columns) {
        double[][] read = matrices.table(key);
        if (read.length != rows || Arrays.stream(read).anyMatch(row -> row.length != columns)) {
            throw matrices.fault("'" + key + "' must have " + rows + " rows of " + columns + " numbers");
        }
        return new Array2DRowRealMatrix(read);
    }

    private static double largest(RealMatrix matrix) {
        return Arrays.stream(matrix.getData()).flatMapToDouble(Arrays::stream).map(Math::abs).max().orElse(0);
    }

    private static RealMatrix diagonal(double[] entries) {
        RealMatrix out = new Array2DRowRealMatrix(entries.length, entries.length);
        IntStream.range(0, entries.length).forEach(i -> out.setEntry(i, i, entries[i]));
        return out;
    }
}
