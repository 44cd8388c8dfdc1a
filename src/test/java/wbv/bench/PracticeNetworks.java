package wbv.bench;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import org.ejml.data.Complex_F64;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.interfaces.decomposition.EigenDecomposition_F64;
import wbv.network.Estimate;
import wbv.network.Peers;
import wbv.network.Reader;
import wbv.network.Reading;
import wbv.network.TrainedNetwork;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;

/**
 * The networks that ship on ten recordings of another physics engine, {@code ../shared/practice}, platform to torso. Truth are
 * the two slowest modes of the linear chain that the key gives, which has three or four; its table stands in docs/thesis.md.
 */
public final class PracticeNetworks {

    private static final double TAU = 2 * Math.PI;
    private static final Path PRACTICE = Path.of("../shared/practice");
    private static final int LENGTH = 219;
    private static final int HOP = 60;

    private PracticeNetworks() {}

    public static void main(String[] arguments) throws IOException {
        Path folder = arguments.length > 0 ? Path.of(arguments[0]) : PRACTICE;
        if (!Files.isDirectory(folder)) {
            System.out.println("No recordings at " + folder + "; name their folder");
            return;
        }
        Map<String, double[][]> errors = new LinkedHashMap<>();
        System.out.println("| case | concealed | truth ζ1, f1, ζ2, f2 | network | fitted | fit in frequency alone "
                + "| unlike, of two modes | unlike, of one |");
        System.out.println("|---|---|---|---|---|---|---|---|");
        for (int i = 1; i <= 10; i++) {
            Path place = folder.resolve(String.format("%03d", i));
            JsonNode key = new ObjectMapper().readTree(place.resolve("key.json").toFile());
            double[] truth = modes(key.get("true_linear_model"), 2);
            List<double[][]> motions = windows(new RecordingFile(place.resolve("recording.csv.gz")).load());
            List<Reading> two = read(2, motions);
            List<Reading> one = read(1, motions);
            double[] network = median(two, reading -> reading.network().value());
            double[] fitted = median(two, reading -> reading.fitted().value());
            double[] alone = median(motions, motion -> Peers.fit(motion, 2).value());
            System.out.printf("| %03d | %s | %s | %s | %s | %s | %s | %s |%n", i,
                    key.get("mechanisms").get(0).get("mechanism").asText(),
                    words(truth), words(network), words(fitted), words(alone), unlike(two), unlike(one));
            gather(errors, "network", truth, network, i);
            gather(errors, "fitted", truth, fitted, i);
            gather(errors, "fit in frequency alone", truth, alone, i);
            gather(errors, "90 % intervals of the network that hold", covered(two, truth, Reading::network), i);
            gather(errors, "90 % intervals of the fit that hold", covered(two, truth, Reading::fitted), i);
        }
        System.out.println("\nRoot mean square of the ten errors of ζ1, f1 [Hz], ζ2, f2 [Hz]; of intervals the mean share:");
        errors.forEach((name, rows) -> {
            double[] sum = new double[4];
            for (double[] row : rows) {
                for (int j = 0; j < 4; j++) {
                    sum[j] += (name.contains("%") ? row[j] : row[j] * row[j]) / rows.length;
                }
            }
            System.out.println(name + ": " + Arrays.toString(Arrays.stream(sum).map(s -> name.contains("%") ? s : Math.sqrt(s))
                    .mapToObj(s -> String.format(Locale.ROOT, "%.3f", s)).toArray()));
        });
    }

    private static void gather(Map<String, double[][]> errors, String name, double[] truth, double[] said, int number) {
        double[] error = new double[4];
        Arrays.setAll(error, j -> (said[j] - truth[j]) / (j % 2 == 0 ? 1 : TAU));
        gather(errors, name, error, number);
    }

    private static void gather(Map<String, double[][]> errors, String name, double[] row, int number) {
        errors.computeIfAbsent(name, each -> new double[10][])[number - 1] = row;
    }

    private static double[] covered(List<Reading> readings, double[] truth, Function<Reading, Estimate> what) {
        double[] share = new double[4];
        for (Reading reading : readings) {
            Estimate each = what.apply(reading);
            for (int j = 0; j < 4; j++) {
                boolean held = Math.abs(each.value()[j] - truth[j]) <= Estimate.NINETY * each.deviation()[j];
                share[j] += held ? 1.0 / readings.size() : 0;
            }
        }
        return share;
    }

    private static List<Reading> read(int modes, List<double[][]> motions) {
        try (Reader reader = new Reader(TrainedNetwork.shipped(modes))) {
            return reader.readAll(motions);
        }
    }

    /** Whole windows, one a second, in which the platform shakes with 0.2 m/s² or more. */
    private static List<double[][]> windows(Recording recording) {
        double[] u = recording.values(Channel.parse("platform.acc.z"));
        double[] y = recording.values(Channel.parse("sternum.acc.z"));
        List<double[][]> windows = new ArrayList<>();
        for (int from = 0; from + LENGTH <= u.length; from += HOP) {
            double[][] motion = {Arrays.copyOfRange(u, from, from + LENGTH), Arrays.copyOfRange(y, from, from + LENGTH)};
            if (Arrays.stream(motion[0]).map(x -> x * x).average().orElse(0) > 0.04
                    && Arrays.stream(motion[1]).allMatch(Double::isFinite)) {
                windows.add(motion);
            }
        }
        return windows;
    }

    private static <T> double[] median(List<T> all, Function<T, double[]> what) {
        double[] median = new double[4];
        for (int j = 0; j < 4; j++) {
            int target = j;
            median[j] = all.stream().mapToDouble(each -> what.apply(each)[target]).sorted().toArray()[all.size() / 2];
        }
        return median;
    }

    private static String words(double[] values) {
        return String.format(Locale.ROOT, "%.2f, %.2f Hz, %.2f, %.2f Hz", values[0], values[1] / TAU, values[2], values[3] / TAU);
    }

    private static String unlike(List<Reading> readings) {
        return Math.round(100.0 * readings.stream().filter(Reading::unlike).count() / readings.size()) + " %";
    }

    /** ζ and ω of the slowest modes of a chain on its base. */
    private static double[] modes(JsonNode model, int count) {
        Map<String, Integer> number = new LinkedHashMap<>();
        model.get("bodies").forEach(body -> number.put(body.get("name").asText(), number.size()));
        int n = number.size();
        DMatrixRMaj a = new DMatrixRMaj(2 * n, 2 * n);
        for (int i = 0; i < n; i++) {
            a.set(i, n + i, 1);
        }
        for (JsonNode link : model.get("links")) {
            int from = number.getOrDefault(link.get("from").asText(), -1);
            int to = number.getOrDefault(link.get("to").asText(), -1);
            for (int[] pair : new int[][] {{from, to}, {to, from}}) {
                if (pair[0] >= 0) {
                    double mass = model.get("bodies").get(pair[0]).get("mass_kg").asDouble();
                    double k = link.get("stiffness_N_per_m").asDouble() / mass;
                    double c = link.get("damping_Ns_per_m").asDouble() / mass;
                    a.add(n + pair[0], pair[0], -k);
                    a.add(n + pair[0], n + pair[0], -c);
                    if (pair[1] >= 0) {
                        a.add(n + pair[0], pair[1], k);
                        a.add(n + pair[0], n + pair[1], c);
                    }
                }
            }
        }
        EigenDecomposition_F64<DMatrixRMaj> decomposition = DecompositionFactory_DDRM.eig(2 * n, false);
        decomposition.decompose(a);
        List<double[]> modes = new ArrayList<>();
        for (int i = 0; i < 2 * n; i++) {
            Complex_F64 pole = decomposition.getEigenvalue(i);
            if (pole.imaginary > 0) {
                double omega = Math.hypot(pole.real, pole.imaginary);
                modes.add(new double[] {-pole.real / omega, omega});
            }
        }
        modes.sort(Comparator.comparingDouble(mode -> mode[1]));
        return modes.stream().limit(count).flatMapToDouble(Arrays::stream).toArray();
    }
}
