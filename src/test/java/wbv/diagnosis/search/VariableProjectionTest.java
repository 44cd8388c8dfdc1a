package wbv.diagnosis.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import com.fasterxml.jackson.databind.ObjectMapper;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.body.Assembly;
import wbv.body.ModelFile;
import wbv.body.Spectra;
import wbv.body.Structure;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Place;
import wbv.rig.concealed.ConcealedCase;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Concealer;
import wbv.rig.concealed.Setting;
import wbv.signal.ScalarProduct;

/** What is eliminated has the derivatives that differences show, and leaves noise where all that is missing enters. */
class VariableProjectionTest {

    @TempDir
    private static Path folder;
    private static ConcealedCase made;
    private static Evidence evidence;
    private static Candidate given;
    /** Where the spring is that softens. */
    private static Place place;

    @BeforeAll
    static void conceal() throws Exception {
        made = Concealer.make(new ConcealedSpec("soft", List.of("stiffness.softening"), 1, Setting.RIG, false, 11));
        Path file = Files.writeString(folder.resolve("model.json"), made.model(), StandardCharsets.UTF_8);
        evidence = new Evidence(ModelFile.read(file), made.recording());
        given = Baseline.of(evidence);
        place = Place.all(evidence).stream().filter(one -> made.key().contains("\"" + one.name(evidence) + "\"")).findFirst().orElseThrow();
    }

    @Test
    void aForceAtAPlaceActsOnBodiesAsItsDirectionSays() {
        Excitation whole = evidence.whole();
        Assembly assembly = evidence.model().assembly();
        double[] force = whole.series(whole.baseSpectrum());
        for (Place one : Place.all(evidence)) {
            if (!one.isSensor()) {
                double[] shares = one.onBodies(assembly.structure());
                Excitation pushed = whole;
                for (int body = 0; body < shares.length; body++) {
                    double share = shares[body];
                    pushed = share == 0 ? pushed : pushed.pushed(body, Arrays.stream(force).map(f -> share * f).toArray());
                }
                double[][] without = new Simulator(whole).run(assembly, false).outputs();
                double[][] with = new Simulator(pushed).run(assembly, false).outputs();
                double[][] direction = one.direction(whole, assembly);
                for (int o = 0; o < with.length; o++) {
                    Spectra.add(with[o], without[o], -1);
                    double[] expected = Spectra.product(direction[o], whole.spectrum(force));
                    double size = Math.sqrt(ScalarProduct.of(expected, expected));
                    Spectra.add(with[o], expected, -1);
                    assertEquals(0, Math.sqrt(ScalarProduct.of(with[o], with[o])), 1e-9 * size, one.name(evidence));
                }
            }
        }
    }

    /** The gradient of Kaufman (1975) is that of what was eliminated; without the force it is not. */
    @Test
    void itsGradientIsThatOfWhatIsLeft() {
        VariableProjection beside = new VariableProjection(evidence, List.of(place));
        double[] x = given.start();
        VariableProjection.Turn there = beside.at(given, x);
        double[] along = gradient(there.evidence(), there.fit());
        Evidence blind = evidence.ignoring(place);
        double[] still = gradient(blind, new Fitter(blind).look(given, x, blind.fit()));
        double exact = 0;
        double missed = 0;
        double without = 0;
        for (int i = 0; i < x.length; i++) {
            double step = 1e-3;
            double[] up = x.clone();
            double[] down = x.clone();
            up[i] += step;
            down[i] -= step;
            double slope = (new Fitter(blind).look(given, up, blind.fit()).cost() - new Fitter(blind).look(given, down, blind.fit()).cost())
                    / (2 * step);
            exact += slope * slope;
            missed += Math.pow(slope - along[i], 2);
            without += Math.pow(slope - still[i], 2);
        }
        assertTrue(missed < 0.15 * 0.15 * exact, Math.sqrt(missed / exact) + " of the gradient");
        assertTrue(without > 3 * 3 * missed, Math.sqrt(without / exact) + " of the gradient without the force");
    }

    @Test
    void itLeavesNoMoreThanTheTrueNumbersDo() throws Exception {
        VariableProjection beside = new VariableProjection(evidence, List.of(place));
        Fitter.State fit = beside.at(given, given.start()).on(Effort.STEPS).fit();
        double truth = beside.at(given, trueNumbers()).fit().reduced();
        assertTrue(fit.reduced() < 1.01 * truth, fit.reduced() + " beside " + truth);
        assertTrue(fit.reduced() < 0.1 * beside.at(given, given.start()).fit().reduced());
    }

    /** Accelerations tell masses, stiffness and damping but for a factor, by which the heaviest mass is as given. */
    private double[] trueNumbers() throws Exception {
        Path file = Files.writeString(folder.resolve("true.json"),
                new ObjectMapper().readTree(made.key()).path("true_linear_model").toString(),
                StandardCharsets.UTF_8);
        double[] values = ModelFile.read(file).assembly().values();
        double[] as = evidence.model().assembly().values();
        Structure structure = evidence.model().assembly().structure();
        int heaviest = IntStream.range(0, structure.bodies()).boxed().max(Comparator.comparingDouble(b -> structure.mass()[b]))
                .orElseThrow();
        int mass = 2 * structure.links() + heaviest;
        return IntStream.range(0, given.knobs().size())
                .mapToDouble(i -> given.knobs().get(i).coordinate(values[given.index(i)] * as[mass] / values[mass])).toArray();
    }

    /** Derivative of the cost, by coordinate. */
    private static double[] gradient(Evidence seen, Fitter.State at) {
        Fitter.State sloped = new Fitter(seen).lookWithSlopes(at.candidate(), at.x(), at.frame());
        double[] out = new double[at.x().length];
        for (int i = 0; i < out.length; i++) {
            double deviation = at.candidate().knobs().get(i).deviation();
            out[i] = 2 * ScalarProduct.of(sloped.slopes()[i], sloped.residual()) + 2 * at.x()[i] / (deviation * deviation);
        }
        return out;
    }
}
