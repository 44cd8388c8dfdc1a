package wbv.diagnosis.fit;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import wbv.body.Assembly;
import wbv.body.law.LearnedTerm;
import wbv.body.number.Modulator;
import wbv.body.number.Shape;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.learn.LawLearnerTest;

class MotionTest {

    private static final Modulator LOAD = Modulator.parse("negative part of the load of link 2");

    /** Two accelerometers of 0.02 m/s² noise, twice integrated, tell the slow part of a stiff link's motion badly. */
    @Test
    void whatSensorsShowAboveTheirNoiseBringsAModelNearerToTheTruth() {
        Evidence evidence = new Evidence(LawLearnerTest.model(List.of()), LawLearnerTest.recording(law(2500)));
        double[] truth = evidence.excitation()
                .fineSeries(new Simulator(evidence.excitation()).run(assembly(law(2500)), false).stretch()[0]);
        Assembly given = LawLearnerTest.model(List.of()).assembly();
        double measured = apart(truth, Motion.measured(evidence, given).displacement(0));
        double modelled = apart(truth, Motion.simulated(evidence, given).displacement(0));
        double whole = apart(truth, Motion.simulated(evidence, assembly(law(2500))).displacement(0));
        assertTrue(measured < 0.7 * modelled && whole < 1e-9, measured + " measured, " + modelled + " of the model, " + whole);
    }

    @Test
    void aLoadIsWhatSpringDashpotAndLawsCarry() {
        Evidence evidence = new Evidence(LawLearnerTest.model(List.of()), LawLearnerTest.recording(law(2500)));
        Motion motion = Motion.simulated(evidence, assembly(new LearnedTerm(Shape.parse("v^3"), Modulator.NONE, 40)));
        double[] load = motion.load(0);
        for (int j = 1; j < load.length; j += 97) {
            double r = motion.displacement(0)[j];
            double v = motion.velocity(0)[j];
            assertTrue(Math.abs(load[j] - 50000 * r - 900 * v - 40 * v * v * v) < 1e-9 * 50000, "at " + j);
        }
    }

    /** Root mean square by which a motion is off, in parts of the truth. */
    private static double apart(double[] truth, double[] motion) {
        double off = 0;
        double size = 0;
        for (int i = 0; i < truth.length; i++) {
            off += (motion[i] - truth[i]) * (motion[i] - truth[i]);
            size += truth[i] * truth[i];
        }
        return Math.sqrt(off / size);
    }

    private static LearnedTerm law(double coefficient) {
        return new LearnedTerm(Shape.DEFLECTION, LOAD, coefficient);
    }

    private static Assembly assembly(LearnedTerm law) {
        return LawLearnerTest.model(List.of(law)).assembly();
    }
}
