package wbv.diagnosis.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import wbv.body.ModelFile;
import wbv.recording.format.RecordingFile;
import wbv.signal.ScalarProduct;

/** Normal equations carried from state to state are those of the corrected derivatives worked out in full. */
class NormalTest {

    private static final Path CASE = Path.of("data/arff/concealed/001");

    @Test
    void carriedOverIsAsGoodAsNew() throws Exception {
        isAsGoodAsNew(0.02, true);
    }

    /** What errors take is another where one has come to stand at its bound; their products with the derivatives are not. */
    @Test
    void otherErrorsMayStandAtTheirBounds() throws Exception {
        isAsGoodAsNew(0.4, false);
    }

    /** @param suits whether the same errors are free where the model has moved so far */
    private static void isAsGoodAsNew(double far, boolean suits) throws Exception {
        Evidence evidence = new Evidence(ModelFile.read(CASE.resolve("model.json")),
                new RecordingFile(CASE.resolve("recording.csv.gz")).load());
        Fitter fitter = new Fitter(evidence);
        Candidate candidate = Baseline.of(evidence);
        double[] x = candidate.start();
        Fitter.Frame frame = fitter.frame(candidate, x, evidence.fit());
        Fitter.State here = fitter.lookWithSlopes(candidate, x, frame);
        double[] moved = x.clone();
        for (int i = 0; i < moved.length; i++) {
            moved[i] += far * Math.sin(1 + 3 * i);
        }
        Fitter.State there = fitter.look(candidate, moved, frame);
        assertEquals(suits, new Projection(here).suits(there));
        Normal carried = new Normal(here).followed(there);
        Normal whole = new Normal(there.withSlopes(corrected(here, there)));
        for (int i = 0; i < x.length; i++) {
            assertEquals(whole.gradient()[i], carried.gradient()[i], 1e-8 * (1 + Math.abs(whole.gradient()[i])));
            for (int j = 0; j < x.length; j++) {
                double size = Math.sqrt(whole.curvature()[i][i] * whole.curvature()[j][j]);
                assertEquals(whole.curvature()[i][j], carried.curvature()[i][j], 1e-9 * size);
            }
        }
    }

    /** Broyden's correction in the metric of the derivatives' sizes: it makes them tell the change that was seen. */
    private static double[][] corrected(Fitter.State here, Fitter.State there) {
        int n = here.x().length;
        double[][] out = new double[n][];
        double length = 0;
        for (int i = 0; i < n; i++) {
            double step = there.x()[i] - here.x()[i];
            length += step * step * ScalarProduct.of(here.slopes()[i], here.slopes()[i]);
        }
        for (int i = 0; i < n; i++) {
            double step = there.x()[i] - here.x()[i];
            double weight = step * ScalarProduct.of(here.slopes()[i], here.slopes()[i]) / length;
            out[i] = here.slopes()[i].clone();
            for (int k = 0; k < out[i].length; k++) {
                double missed = there.raw()[k] - here.raw()[k];
                for (int j = 0; j < n; j++) {
                    missed -= here.slopes()[j][k] * (there.x()[j] - here.x()[j]);
                }
                out[i][k] += weight * missed;
            }
        }
        return out;
    }
}
