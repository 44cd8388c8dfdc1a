package wbv.diagnosis.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.DiagonalMatrix;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Knob;
import wbv.diagnosis.fit.Normal;
import wbv.diagnosis.fit.Slot;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;

/** Numbers of a model on a recording of another engine in which nothing is missing. */
class OwnNumbersTest {

    private static final Path NULL_CASE = Path.of("data/arff/concealed/001");
    private static final int LINK = 1;

    private final Model right = ModelFile.read(NULL_CASE.resolve("model.json"));
    private final Recording recording = new RecordingFile(NULL_CASE.resolve("recording.csv.gz")).load();

    OwnNumbersTest() throws IOException {}

    private Model with(double stiffness) {
        List<Model.Link> links = new ArrayList<>(right.links());
        Model.Link link = links.get(LINK);
        links.set(LINK, new Model.Link(link.from(), link.to(), stiffness * link.stiffness(), link.damping(), link.sensor(), link.laws(),
                link.drives(), link.faults()));
        return new Model(right.name(), right.source(), right.axis(), right.base(), right.bodies(), links, right.inputs());
    }

    private double logPrior(Model model) {
        Evidence evidence = new Evidence(model, recording);
        Candidate baseline = Baseline.of(evidence);
        Fitter fitter = new Fitter(evidence);
        Fitter.State fit = fitter.fit(baseline, baseline.start(), fitter.frame(baseline, baseline.start(), evidence.fit()), 30, 1e-6);
        return OwnNumbers.logPrior(fitter, fit, 1);
    }

    @Test
    void numbersAsGivenCostNothing() {
        Evidence evidence = new Evidence(right, recording);
        Candidate baseline = Baseline.of(evidence);
        Fitter fitter = new Fitter(evidence);
        assertEquals(0, OwnNumbers.logPrior(fitter, fitter.look(baseline, new double[baseline.knobs().size()], evidence.fit()), 1));
    }

    /** The fit finds the same body: what it costs that one stiffness was given three times too small is that number's alone. */
    @Test
    void oneThatIsPlainlyWrongCostsItsOwnAndNoMore() {
        double scale = Priors.NUMBER;
        double costs = Math.log1p(Math.pow(Math.log(3) / scale, 2));
        double given = logPrior(right);
        double wrong = logPrior(with(1 / 3.0));
        assertTrue(given < 0 && given > -costs, "" + given);
        assertEquals(costs, given - wrong, 0.15 * costs);
    }

    /**
     * By the definition, knob by knob, with variances by the inverse of the curvature: the data's part, as far as they are believed, with
     * what is known before of all but the links.
     */
    @ParameterizedTest
    @ValueSource(doubles = {1, 0.1, 0.001})
    void whatTheDataLeaveOpenCountsAsScatter(double sharpness) {
        Evidence evidence = new Evidence(right, recording);
        Candidate baseline = Baseline.of(evidence);
        Fitter fitter = new Fitter(evidence);
        double[] x = new double[baseline.knobs().size()];
        int[] links = IntStream.range(0, x.length).filter(i -> baseline.knobs().get(i).isOfLink()).toArray();
        for (int at : links) {
            double[] moved = x.clone();
            moved[at] = 1;
            Fitter.State look = fitter.look(baseline, moved, evidence.fit());
            RealMatrix curvature = new Array2DRowRealMatrix(
                    new Normal(fitter.lookWithSlopes(baseline, moved, look.frame())).curvature());
            RealMatrix before = new DiagonalMatrix(baseline.knobs().stream().mapToDouble(knob -> Math.pow(knob.deviation(), -2)).toArray());
            RealMatrix others = new DiagonalMatrix(baseline.knobs().stream()
                    .mapToDouble(knob -> knob.isOfLink() ? 0 : Math.pow(knob.deviation(), -2)).toArray());
            RealMatrix told = curvature.subtract(before).scalarMultiply(sharpness).add(others);
            double variance = new LUDecomposition(told).getSolver().getInverse().getEntry(at, at);
            double scale = Priors.NUMBER;
            assertEquals(-Math.log(1 + 1 / (scale * scale + variance)), OwnNumbers.logPrior(fitter, look, sharpness), 1e-6);
        }
    }

    /** A stop may be so stiff that derivatives of a run overflow where the run does not. */
    @Test
    void whatHasNoDerivativesIsNotLeftOpen() {
        assertEquals(0, OwnNumbers.variance(new double[][] {{Double.NaN, 0}, {0, 1}}, 1));
        assertEquals(0, OwnNumbers.variance(new double[][] {{1, 0}, {0, Double.POSITIVE_INFINITY}}, 0));
        assertEquals(0, OwnNumbers.variance(new double[0][], 3));
        assertEquals(0.25, OwnNumbers.variance(new double[][] {{4, 0}, {0, 1}}, 0), 1e-12);
    }

    @Test
    void onlyWhatALinkWasGivenIsAsked() {
        Slot stiffness = Slot.of(Slot.Kind.STIFFNESS, 0);
        assertTrue(new Knob("k", stiffness, 1e4, 0, -3, 3, 2).isOfLink());
        assertTrue(new Knob("c", Slot.of(Slot.Kind.DAMPING, 0), 100, 0, -3, 3, 2).isOfLink());
        assertTrue(!new Knob("m", Slot.of(Slot.Kind.MASS, 0), 7, 0, -3, 3, 2).isOfLink());
        assertTrue(!new Knob("k", stiffness, 0, 1, -3, 3, 2).isOfLink(), "not a factor of what was given");
    }
}
