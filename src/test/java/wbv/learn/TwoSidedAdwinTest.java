package wbv.learn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import moa.classifiers.core.driftdetection.ADWIN;
import moa.classifiers.core.driftdetection.ADWINChangeDetector;
import moa.classifiers.core.driftdetection.ChangeDetector;
import moa.options.ClassOption;
import moa.streams.InstanceStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.stream.RecordingStream;

class TwoSidedAdwinTest {

    private static ChangeDetector detector(String cli) throws Exception {
        ChangeDetector detector = (ChangeDetector) ClassOption.cliStringToObject(cli, ChangeDetector.class, null);
        detector.prepareForUse();
        return detector;
    }

    /** A mean that falls from 0.7 to 0.3 halfway. */
    private static double[] fall() {
        Random random = new Random(4);
        double[] values = new double[4000];
        for (int i = 0; i < values.length; i++) {
            values[i] = (i < 2000 ? 0.4 : 0) + 0.6 * random.nextDouble();
        }
        return values;
    }

    private static int alarms(ChangeDetector detector) {
        int alarms = 0;
        for (double value : fall()) {
            detector.input(value);
            alarms += detector.getChange() ? 1 : 0;
        }
        return alarms;
    }

    @Test
    void itHearsAFallWhichTheDetectorOfMoaDoesNot() throws Exception {
        assertTrue(alarms(detector("wbv.learn.TwoSidedAdwin")) > 0);
        assertEquals(0, alarms(detector(ADWINChangeDetector.class.getName())));
    }

    @Test
    void itRingsWhenMoasWindowIsCut() throws Exception {
        ChangeDetector ours = detector("wbv.learn.TwoSidedAdwin -d 0.01");
        ADWIN theirs = new ADWIN(0.01);
        for (double value : fall()) {
            ours.input(value);
            assertEquals(theirs.setInput(value), ours.getChange());
            assertEquals(theirs.getEstimation(), ours.getEstimation(), 0);
        }
    }

    @Test
    void resetForgetsAndACopyGoesOn() throws Exception {
        ChangeDetector one = detector("wbv.learn.TwoSidedAdwin");
        one.input(0.5);
        ChangeDetector copy = (ChangeDetector) one.copy();
        copy.input(0.7);
        assertEquals(0.6, copy.getEstimation(), 1e-15);
        assertEquals(0.5, one.getEstimation(), 0);
        one.resetLearning();
        one.input(0.1);
        assertEquals(0.1, one.getEstimation(), 0);
    }

    /** Every change detector of MOA's that can be copied, and ours, inside the learner; the rest is refused (DetectorsTest). */
    @Tag("slow")
    @ParameterizedTest
    @ValueSource(strings = {"ADWINChangeDetector", "CusumDM", "DDM", "EDDM", "EWMAChartDM", "EnsembleDriftDetectionMethods",
        "GeometricMovingAverageDM", "HDDM_A_Test", "HDDM_W_Test", "PageHinkleyDM", "RDDM", "STEPD", "none", "wbv.learn.TwoSidedAdwin"})
    void theLearnerTakesAnyDetector(String name) throws Exception {
        AdwinKalman learner = (AdwinKalman) ClassOption.cliStringToObject("wbv.learn.AdwinKalman -a " + name, AdwinKalman.class, null);
        RecordingStream stream = (RecordingStream) ClassOption.cliStringToObject(
                "wbv.stream.RecordingStream -f data/arff/one-dof-step.arff", InstanceStream.class, null);
        stream.prepareForUse();
        learner.setModelContext(stream.getHeader());
        learner.prepareForUse();
        while (stream.hasMoreInstances()) {
            learner.trainOnInstance(stream.nextInstance());
        }
        assertTrue(learner.explained().share() > 0.95, name + " explains " + learner.explained().share());
    }
}
