package wbv.diagnosis;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.stream.DoubleStream;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Recording;
import wbv.recording.format.ColumnMap;
import wbv.recording.format.ReadOptions;
import wbv.recording.format.RecordingFile;
import wbv.signal.Differentiator;

/**
 * Recordings that others measured, with a known cause each: what wbv names, and how well the completed model predicts records
 * that it has not seen. Prints one Markdown table.
 */
final class RealRun {

    static final Path REAL = Path.of("../shared/real");
    /** Error of the given simulation by earthquake [N]. */
    private static final Map<String, Integer> LUGRE = new TreeMap<>(
            Map.of("ImperialValleyDBE", 2041, "ImperialValleyMCE", 2970, "KocaeliDBE", 3131, "KocaeliMCE", 3341));

    private RealRun() {}

    /** A row of the table. */
    record Row(String trained, String named, String verdict, String tested, double error, String unit, String toBeat) {
        @Override
        public String toString() {
            return String.format(Locale.ROOT, "| %s | %s | %s | %s | %.4g %s | %s |", trained, named, verdict, tested, error,
                    unit, toBeat);
        }
    }

    /** @param parts silverbox, friction, mr, drives; all where none is named */
    public static void main(String[] parts) throws IOException {
        List<String> chosen = parts.length == 0 ? List.of("silverbox", "friction", "mr", "drives") : List.of(parts);
        System.out.println("| trained on | named | verdict | tested on | error | to beat |");
        System.out.println("|---|---|---|---|---|---|");
        for (String part : chosen) {
            long start = System.nanoTime();
            rows(part).forEach(System.out::println);
            System.err.printf("%s took %.0f s%n", part, (System.nanoTime() - start) / 1e9);
        }
    }

    static List<Row> rows(String part) throws IOException {
        return switch (part) {
            case "silverbox" -> silverbox();
            case "friction" -> friction();
            case "mr" -> List.of(damper("0V"), damper("4p2"), damper("A1"), damper("validation"));
            case "drives" -> List.of(drives("prbs1"), drives("prbs2"), drives("prbs3"), drives("unif1"), drives("unif2"));
            default -> throw new IllegalArgumentException("no recording '" + part + "'");
        };
    }

    static List<Row> silverbox() throws IOException {
        Diagnosis d = diagnose("silverbox", read("silverbox", "silverbox/silverbox_multisine_train.csv.gz"), Optional.empty());
        Recording test = read("silverbox", "silverbox/silverbox_multisine_test.csv.gz");
        settle(d.model(), test, 50);
        return List.of(new Row("silverbox multisine_train", named(d), d.verdict().word(), "multisine_test, from sample 50",
                1000 * error(d, test, 50, test.length()), "mV", "0.36 (y³ alone 0.356, with y² 0.309)"));
    }

    static List<Row> friction() throws IOException {
        List<Row> rows = new ArrayList<>();
        for (String quake : LUGRE.keySet()) {
            rows.add(friction(quake));
        }
        double mean = rows.stream().mapToDouble(Row::error).average().orElseThrow();
        rows.add(new Row("", "", "", "mean of the four", mean, "N", "LuGre 2871"));
        return rows;
    }

    static Row friction(String quake) throws IOException {
        List<Recording> training = training(List.copyOf(LUGRE.keySet()), quake);
        Diagnosis d = diagnose("friction_damper", joined(training), Optional.of(Channel.parse("lugre.force.z")));
        Recording test = quake(quake);
        return new Row("friction damper, harmonics and the other three earthquakes, LuGre given", named(d), d.verdict().word(), quake,
                error(d, test, 0, test.length()), "N", "LuGre " + LUGRE.get(quake));
    }

    /**
     * Two harmonic records, all earthquakes but one, and at the end, where a diagnosis keeps data unseen, two more harmonic
     * ones.
     */
    static List<Recording> training(List<String> quakes, String left) throws IOException {
        List<Recording> training = new ArrayList<>(List.of(harmonic("1in_1Hz"), harmonic("1.5in_0.5Hz")));
        for (String other : quakes) {
            if (!other.equals(left)) {
                training.add(quake(other));
            }
        }
        training.addAll(List.of(harmonic("0.5in_1Hz"), harmonic("1in_0.5Hz")));
        return training;
    }

    static Row damper(String record) throws IOException {
        Recording recording = read("mr_damper", "mr_shake/mr_shake_" + record + ".csv");
        Diagnosis d = diagnose("mr_damper", recording, Optional.empty());
        int from = (int) (0.7 * recording.length());
        double[] measured = java.util.Arrays.copyOfRange(recording.values(d.model().outputs().get(0)), from, recording.length());
        return new Row("MR damper " + record + ", first 70 %", named(d), d.verdict().word(), "last 30 %",
                100 * error(d, recording, from, recording.length()) / spread(measured), "%",
                "17 (spring and dashpot 30 to 38)");
    }

    static Row drives(String record) throws IOException {
        Map<String, String> toBeat = Map.of("prbs1", "linear 1.56, rectified 0.28", "unif1", "linear 0.250, rectified 0.158");
        Recording recording = read("coupled_drives", "coupled_drives/ced_" + record + ".csv");
        Diagnosis d = diagnose("coupled_drives", recording, Optional.empty());
        return new Row("coupled drives " + record + ", first 70 %", named(d), d.verdict().word(), "samples 410 to 499",
                error(d, recording, 410, 500), "", toBeat.getOrDefault(record, ""));
    }

    private static Diagnosis diagnose(String name, Recording recording, Optional<Channel> simulation) throws IOException {
        Model model = ModelFile.read(Path.of("data/models", name + ".json"));
        Diagnosis d = Diagnoser.diagnose(new Question(model, recording, simulation, OptionalDouble.empty()),
                (step, share) -> {});
        return d;
    }

    private static String named(Diagnosis d) {
        return d.missing().isEmpty() ? "-" : String.join(" + ", d.missing().stream().map(Diagnosis.Named::mechanism).toList());
    }

    /** Root mean square error of a free run, through the sensors as they were found to be: the same ones measured the other records. */
    static double error(Diagnosis d, Recording recording, int from, int to) {
        Channel output = d.model().outputs().get(0);
        double[] y = read(run(d.model(), recording), d.fit().sensors(), output.toString(), recording.clock());
        double[] measured = recording.values(output);
        double sum = 0;
        for (int i = from; i < to; i++) {
            sum += Math.pow(measured[i] - y[i], 2);
        }
        return Math.sqrt(sum / (to - from));
    }

    /** What a sensor reads that is late by a fraction of a sample and has a small gain, by Taylor's series of the second order. */
    private static double[] read(double[] y, Map<String, Map<String, Double>> sensors, String output, Clock clock) {
        double late = number(sensors, output, "delay_s") - number(sensors, "input", "delay_s");
        double gain = 1 / (1 - number(sensors, output, "gain"));
        double[] slope = slope(y, clock);
        double[] curvature = slope(slope, clock);
        double[] out = new double[y.length];
        java.util.Arrays.setAll(out, i -> gain * (y[i] - late * slope[i] + late * late / 2 * curvature[i]));
        return out;
    }

    private static double number(Map<String, Map<String, Double>> sensors, String sensor, String key) {
        return sensors.getOrDefault(sensor, Map.of()).getOrDefault(key, 0.0);
    }

    /** Time derivative, 0 at both ends. */
    private static double[] slope(double[] x, Clock clock) {
        Differentiator differentiator = new Differentiator(clock.rate());
        double[] out = new double[x.length];
        for (int i = 0; i < x.length; i++) {
            double slope = differentiator.accept(x[i]);
            if (!Double.isNaN(slope)) {
                out[i - differentiator.delay()] = slope;
            }
        }
        return out;
    }

    /**
     * Gives a record the state in which it begins: the first two samples of the input are moved until the first unscored
     * samples of the output fit best, two numbers for the two states of one body.
     */
    static void settle(Model model, Recording recording, int unscored) {
        double[] u = recording.values(model.inputs().get(0).sensor());
        double[] measured = recording.values(model.outputs().get(0));
        for (int round = 0; round < 6; round++) {
            double[] y = run(model, recording);
            double[][] slope = new double[2][];
            for (int i = 0; i < 2; i++) {
                u[i] += 1e-3;
                slope[i] = run(model, recording);
                u[i] -= 1e-3;
            }
            double[][] a = new double[2][2];
            double[] b = new double[2];
            for (int j = 2; j < unscored; j++) {
                for (int i = 0; i < 2; i++) {
                    double s = (slope[i][j] - y[j]) / 1e-3;
                    b[i] += s * (measured[j] - y[j]);
                    for (int k = 0; k < 2; k++) {
                        a[i][k] += s * (slope[k][j] - y[j]) / 1e-3;
                    }
                }
            }
            double det = a[0][0] * a[1][1] - a[0][1] * a[1][0];
            u[0] += (b[0] * a[1][1] - b[1] * a[0][1]) / det;
            u[1] += (b[1] * a[0][0] - b[0] * a[1][0]) / det;
        }
    }

    private static double[] run(Model model, Recording recording) {
        return new Simulator(Excitation.of(model, recording, recording.length())).outputs(model.assembly())[0];
    }

    private static double spread(double[] x) {
        double mean = java.util.Arrays.stream(x).average().orElse(0);
        return Math.sqrt(java.util.Arrays.stream(x).map(v -> (v - mean) * (v - mean)).average().orElse(0));
    }

    private static Recording quake(String name) throws IOException {
        return read("friction_damper", "friction_backlash/brfd_earthquake_" + name + ".csv.gz");
    }

    private static Recording harmonic(String name) throws IOException {
        return read("friction_damper", "friction_backlash/brfd_harmonic_36lb_" + name + ".csv.gz");
    }

    static Recording read(String map, String file) throws IOException {
        ReadOptions options = new ReadOptions(Optional.of(ColumnMap.read(Path.of("data/maps", map + ".json"))),
                OptionalDouble.empty(), Map.of());
        return new RecordingFile(REAL.resolve(file), options).load();
    }

    static boolean isThere() {
        return Files.isDirectory(REAL);
    }

    /** Records end to end on one clock, with a gap between them. */
    static Recording joined(List<Recording> parts) {
        Map<Channel, double[]> all = new LinkedHashMap<>();
        Recording first = parts.get(0);
        for (Channel channel : first.channels()) {
            double[] gap = new double[20];
            java.util.Arrays.fill(gap, Double.NaN);
            all.put(channel, parts.stream().flatMapToDouble(part -> DoubleStream.concat(java.util.Arrays.stream(part.values(channel)),
                    java.util.Arrays.stream(gap))).toArray());
        }
        return new Recording(new Clock(0, first.clock().rate()), all, first.metadata());
    }
}
