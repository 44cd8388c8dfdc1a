package wbv.control.trial;

import org.apache.commons.math3.analysis.MultivariateFunction;
import org.apache.commons.math3.optim.InitialGuess;
import org.apache.commons.math3.optim.MaxEval;
import org.apache.commons.math3.optim.PointValuePair;
import org.apache.commons.math3.optim.nonlinear.scalar.GoalType;
import org.apache.commons.math3.optim.nonlinear.scalar.ObjectiveFunction;
import org.apache.commons.math3.optim.nonlinear.scalar.noderiv.NelderMeadSimplex;
import org.apache.commons.math3.optim.nonlinear.scalar.noderiv.SimplexOptimizer;
import wbv.control.ApparentSitter;
import wbv.control.FollowedSitter;
import wbv.control.SeatHardware;
import wbv.control.SitterPrior;
import wbv.control.SitterSource;
import wbv.control.ToldSitter;
import wbv.rig.CarriedPerson;
import wbv.rig.Posture;
import wbv.rig.Subject;

/**
 * What the maker of a seat for one floor knows: the seat, and the middle sitter, whom he has had on it. Controllers are tuned and fixed
 * for that sitter.
 */
public final class Maker {

    /** The population's middle: 79.4 kg, 1.76 m. */
    public static final Subject MIDDLE = new Subject("1", 79.4, 1.76, 1, 1, Posture.NORMAL);

    private static final double LOWEST = 0.5;
    private static final double FINEST = 0.5;
    private static final int LINES = 32;

    private final SeatHardware hardware;
    private final Floor floor;
    private final SitterPrior prior;

    /** Calibrates the estimator by one ride of the middle sitter on a passive seat. */
    public Maker(SeatHardware hardware, Floor floor, long seed) {
        this.hardware = hardware;
        this.floor = floor;
        ApparentSitter middle = apparent(MIDDLE);
        FollowedSitter reading = new FollowedSitter(hardware, SitterPrior.wide(middle, middle.frequency(), middle.damping()));
        SeatTrial calibration = new SeatTrial(hardware, new Ride(MIDDLE, floor, 0, 60, seed));
        double softness = calibration.calibrate(reading);
        this.prior = SitterPrior.wide(middle.times(1, Math.sqrt(softness), 1), reading.track().frequency(), reading.track().damping());
    }

    /** What is made. */
    public SeatHardware hardware() {
        return hardware;
    }

    /** What it is made for. */
    public Floor floor() {
        return floor;
    }

    /** What is known before anybody sits down. */
    public SitterPrior prior() {
        return prior;
    }

    /** What a controller is to believe of the sitter. */
    SitterSource source(Knowledge knowledge, Subject subject) {
        return switch (knowledge) {
            case FIXED -> new ToldSitter(prior.middle());
            case SCHEDULED -> new FollowedSitter(hardware, prior);
            case ORACLE -> new ToldSitter(apparent(subject));
        };
    }

    /**
     * The one mass on a spring that has a person's apparent mass, as nearly as one can in the least squares of 0.5 to 16 Hz, at the
     * softening's reference magnitude.
     */
    public static ApparentSitter apparent(Subject subject) {
        CarriedPerson person = new CarriedPerson(subject, SuspendedPerson.STEP);
        double[][] measured = new double[LINES][4];
        for (int i = 0; i < LINES; i++) {
            person.respond(LOWEST + i * FINEST, measured[i]);
        }
        double mass = person.carriedMass();
        double[] response = new double[2];
        MultivariateFunction misfit = p -> {
            ApparentSitter sitter = sitter(p, mass);
            double sum = 0;
            for (int i = 0; i < LINES; i++) {
                sitter.apparentMass(LOWEST + i * FINEST, response);
                double re = response[0] - measured[i][0];
                double im = response[1] - measured[i][1];
                sum += re * re + im * im;
            }
            return sum;
        };
        PointValuePair best = new SimplexOptimizer(1e-10, 1e-10).optimize(new MaxEval(5000), new ObjectiveFunction(misfit),
                GoalType.MINIMIZE,
                new InitialGuess(new double[] {Math.log(0.2), Math.log(5), Math.log(0.4)}), new NelderMeadSimplex(3, 0.2));
        return sitter(best.getPoint(), mass);
    }

    /** @param p ln of rigid over moving mass, of the natural frequency and of the damping ratio */
    private static ApparentSitter sitter(double[] p, double mass) {
        double ratio = Math.exp(p[0]);
        return new ApparentSitter(mass * ratio / (1 + ratio), mass / (1 + ratio), Math.exp(p[1]), Math.exp(p[2]));
    }
}
