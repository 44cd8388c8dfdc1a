package wbv.body;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.apache.commons.math3.complex.Complex;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.EigenDecomposition;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.recording.DataFault;

/** The figures are those of a reference computation (numpy, from masses, stiffness and damping), rounded as they are given here. */
class PublishedModelsTest {

    private static final int LINES_PER_HZ = 256;

    @TempDir
    private Path folder;

    static Stream<String> names() {
        return PublishedModels.names().stream();
    }

    /** Seat-to-head transmissibility: greatest value and its frequency; apparent mass [kg]: greatest value, over static, frequency. */
    @ParameterizedTest
    @CsvSource({"coermann-1962-1dof, 1.18, 4.21, 66.8, 1.18, 4.21", "wei-griffin-1998-1dof, 1.42, 4.28, 68.5, 1.34, 4.15",
        "wei-griffin-1998-2dof, 1.80, 4.75, 77.4, 1.52, 4.59", "allen-1978-2dof, 1.47, 5.67, 72.3, 1.30, 4.66",
        "wan-schimmels-1995-4dof, 1.37, 3.98, 79.2, 1.31, 3.68", "boileau-rakheja-1998-4dof, 1.78, 4.67, 90.5, 1.64, 4.57",
        "iso-5982-2001-3dof, 1.35, 4.77, 75.3, 1.37, 3.78", "fairley-griffin-1989-1dof, 1.51, 4.32, 82.83, 1.51, 4.32"})
    void peaksAreThoseOfTheLiterature(String name, double head, double headAt, double mass, double ratio, double massAt)
            throws IOException {
        Model model = PublishedModels.open(name);
        double[] transmissibility = transmissibility(model);
        int top = top(transmissibility);
        assertEquals(head, transmissibility[top], 0.006);
        assertEquals(headAt, (double) top / LINES_PER_HZ, 0.01);
        double[] apparent = apparentMass(model);
        top = top(apparent);
        assertEquals(mass, apparent[top], 0.06);
        assertEquals(ratio, apparent[top] / model.mass(), 0.006);
        assertEquals(massAt, (double) top / LINES_PER_HZ, 0.01);
    }

    /** At 2, 4, 5, 6, 8, 10, 16 and 20 Hz; the computation took 5 Hz for 31.4 rad/s, hence the last digit. */
    @ParameterizedTest
    @CsvSource({"coermann-1962-1dof, 1.090/1.175/1.165/1.127/1.013/0.892/0.624/0.513",
        "wei-griffin-1998-1dof, 1.149/1.413/1.376/1.215/0.873/0.654/0.369/0.287",
        "wei-griffin-1998-2dof, 1.158/1.683/1.787/1.480/0.847/0.556/0.271/0.204",
        "allen-1978-2dof, 1.129/1.384/1.458/1.468/1.385/1.280/0.745/0.407",
        "wan-schimmels-1995-4dof, 1.182/1.371/1.324/1.226/1.040/0.933/0.861/0.739",
        "boileau-rakheja-1998-4dof, 1.179/1.696/1.759/1.500/0.951/0.670/0.375/0.308",
        "iso-5982-2001-3dof, 1.123/1.327/1.349/1.300/1.113/0.941/0.648/0.524",
        "fairley-griffin-1989-1dof, 1.160/1.494/1.452/1.240/0.835/0.604/0.329/0.254"})
    void transmissibilityIsThatOfTheLiterature(String name, String expected) throws IOException {
        double[] transmissibility = transmissibility(PublishedModels.open(name));
        int[] frequencies = {2, 4, 5, 6, 8, 10, 16, 20};
        double[] values = Arrays.stream(expected.split("/")).mapToDouble(Double::parseDouble).toArray();
        for (int i = 0; i < values.length; i++) {
            assertEquals(values[i], transmissibility[frequencies[i] * LINES_PER_HZ], 0.0011, frequencies[i] + " Hz");
        }
    }

    /** Natural frequencies [Hz] and damping ratios of the modes that swing. */
    @ParameterizedTest
    @CsvSource({"coermann-1962-1dof, 5.80/0.927", "wei-griffin-1998-1dof, 5.08/0.537",
        "wei-griffin-1998-2dof, 5.21/0.348/9.53/0.357",
        "allen-1978-2dof, 5.87/0.681/14.34/0.388", "wan-schimmels-1995-4dof, 4.65/0.691/12.31/0.722/19.04/0.388/33.26/0.251",
        "boileau-rakheja-1998-4dof, 5.13/0.394/41.1/0.186", "iso-5982-2001-3dof, 4.51/0.545/5.67/0.675/23.9/0.574",
        "fairley-griffin-1989-1dof, 5.00/0.475"})
    void modesAreThoseOfTheLiterature(String name, String expected) throws IOException {
        double[] values = Arrays.stream(expected.split("/")).mapToDouble(Double::parseDouble).toArray();
        List<Complex> poles = poles(PublishedModels.open(name).assembly().structure());
        assertEquals(values.length / 2, poles.size());
        for (int i = 0; i < poles.size(); i++) {
            assertEquals(values[2 * i], poles.get(i).abs() / (2 * Math.PI), 0.051);
            assertEquals(values[2 * i + 1], -poles.get(i).getReal() / poles.get(i).abs(), 0.0011);
        }
    }

    /** A reader of a file has to see whether its numbers were ever checked. */
    @ParameterizedTest
    @MethodSource("names")
    void everyModelSaysHowSureItIs(String name) throws IOException {
        Model model = PublishedModels.open(name);
        assertTrue(model.source().orElseThrow().matches(".*(assumed|seen in).*"), model.source().toString());
        assertTrue(model.outputs().stream().anyMatch(channel -> channel.toString().equals("head.acc.z")),
                model.outputs().toString());
        assertEquals(model, ModelFile.parse(ModelFile.text(model), name));
    }

    /** What a user says of how well a mass is known stays in what is written, of a chain and of a plane's one mass for both ways. */
    @Test
    void howWellAMassIsKnownIsKept() {
        String weighed = "{\"name\": \"bench\", \"subject\": \"rig\", \"axis\": \"z\", "
                + "\"base\": {\"name\": \"table\", \"sensor\": \"table.acc.z\"}, "
                + "\"bodies\": [{\"name\": \"seat\", \"mass_kg\": 37, \"mass_within\": %s, \"sensor\": \"seat.acc.z\"}], "
                + "\"links\": [{\"from\": \"table\", \"to\": \"seat\", \"stiffness_N_per_m\": 6e4, \"damping_Ns_per_m\": 400}]}";
        Model model = ModelFile.parse(String.format(weighed, "0.01"), "bench.json");
        assertEquals(OptionalDouble.of(0.01), model.bodies().get(0).within());
        assertEquals(model, ModelFile.parse(ModelFile.text(model), "again.json"));
        assertTrue(assertThrows(DataFault.class, () -> ModelFile.parse(String.format(weighed, "37"), "bench.json")).getMessage()
                .contains("part within which the mass of seat is known"));
    }

    @Test
    void everyFileIsListed() throws IOException {
        try (Stream<Path> files = Files.list(Path.of("src/main/resources/wbv/body/models"))) {
            assertEquals(PublishedModels.names(), files.map(file -> file.getFileName().toString().replace(".json", "")).sorted()
                    .toList());
        }
    }

    @Test
    void aFileGoesBeforeANameAndNeitherIsOneLine() throws IOException {
        Path own = folder.resolve("own.json");
        Files.writeString(own, ModelFile.text(PublishedModels.open("allen-1978-2dof")));
        assertEquals(PublishedModels.open("allen-1978-2dof"), PublishedModels.find(own.toString()));
        assertEquals(PublishedModels.open("allen-1978-2dof"), PublishedModels.find("allen-1978-2dof"));
        DataFault fault = assertThrows(DataFault.class, () -> PublishedModels.find("allen.json"));
        assertTrue(fault.getMessage().startsWith("allen.json: there is no such file")
                && fault.getMessage().contains("allen-1978-2dof"),
                fault.getMessage());
    }

    private static double[] transmissibility(Model model) {
        int head = model.outputs().size() - 1;
        return modulus(simulator().transmissibility(model.assembly())[head]);
    }

    private static double[][] accelerations(Assembly assembly) {
        List<Assembly.Output> all = IntStream.range(0, assembly.structure().bodies())
                .mapToObj(b -> new Assembly.Output(b, Assembly.Reading.ACCELERATION, List.of())).toList();
        return new Simulator(excitation().unit())
                .run(new Assembly(assembly.structure(), assembly.laws(), assembly.drives(), all), false).outputs();
    }

    /** Force under the base over its acceleration: what every mass takes of it. */
    private static double[] apparentMass(Model model) {
        double[][] accelerations = accelerations(model.assembly());
        double[] sum = new double[accelerations[0].length];
        for (int k = 0; k < sum.length; k += 2) {
            sum[k] = model.base().mass();
        }
        for (int b = 0; b < accelerations.length; b++) {
            Spectra.add(sum, accelerations[b], model.bodies().get(b).mass());
        }
        return modulus(sum);
    }

    private static Simulator simulator() {
        return new Simulator(excitation());
    }

    private static Excitation excitation() {
        return new Excitation(64, new double[64 * (LINES_PER_HZ - 4)], Map.of());
    }

    private static double[] modulus(double[] spectrum) {
        double[] out = new double[spectrum.length / 2];
        Arrays.setAll(out, k -> Math.hypot(spectrum[2 * k], spectrum[2 * k + 1]));
        return out;
    }

    private static int top(double[] x) {
        int top = 0;
        for (int k = 1; k < x.length; k++) {
            top = x[k] > x[top] ? k : top;
        }
        return top;
    }

    /** Of the companion matrix, those with a positive imaginary part, by frequency. */
    private static List<Complex> poles(Structure s) {
        int n = s.bodies();
        RealMatrix mass = new Array2DRowRealMatrix(n, n);
        RealMatrix stiffness = new Array2DRowRealMatrix(n, n);
        RealMatrix damping = new Array2DRowRealMatrix(n, n);
        for (int b = 0; b < n; b++) {
            mass.setEntry(b, b, s.mass()[b]);
        }
        for (int l = 0; l < s.links(); l++) {
            int[] ends = {s.from()[l], s.to()[l]};
            for (int i : ends) {
                for (int j : ends) {
                    if (i >= 0 && j >= 0) {
                        stiffness.addToEntry(i, j, (i == j ? 1 : -1) * s.stiffness()[l]);
                        damping.addToEntry(i, j, (i == j ? 1 : -1) * s.damping()[l]);
                    }
                }
            }
        }
        RealMatrix inverse = new LUDecomposition(mass).getSolver().getInverse();
        RealMatrix companion = new Array2DRowRealMatrix(2 * n, 2 * n);
        for (int i = 0; i < n; i++) {
            companion.setEntry(i, n + i, 1);
        }
        companion.setSubMatrix(inverse.multiply(stiffness).scalarMultiply(-1).getData(), n, 0);
        companion.setSubMatrix(inverse.multiply(damping).scalarMultiply(-1).getData(), n, n);
        EigenDecomposition eigen = new EigenDecomposition(companion);
        return java.util.stream.IntStream.range(0, 2 * n).filter(i -> eigen.getImagEigenvalue(i) > 1e-6)
                .mapToObj(i -> new Complex(eigen.getRealEigenvalue(i), eigen.getImagEigenvalue(i)))
                .sorted(java.util.Comparator.comparingDouble(Complex::abs)).toList();
    }
}
