package wbv.diagnosis;

import java.util.Arrays;
import java.util.Optional;
import wbv.diagnosis.algebra.DampedEquations;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Knob;
import wbv.diagnosis.fit.Normal;
import wbv.diagnosis.fit.Slot;
import wbv.diagnosis.measured.SmallError;
import wbv.diagnosis.search.MassScale;
import wbv.signal.ScalarProduct;

/**
 * How sure the numbers of the user's own model are in a fit: by the curvature of its cost, and by how much more the stretches of the
 * recording differ than the white noise that the fit took what is left for. The small errors of sensors are in that cost; on top comes what
 * no data tell: the scale of the masses where motion alone is measured, and the gains of force and motion where forces are.
 */
public final class NumberIntervals {

    private final Fitter.State state;
    private final double[][] curvature;
    private final BlockScores scores;
    private final MassScale scale;
    private final double gains;

    private NumberIntervals(Evidence evidence, Fitter.State state, double[][] curvature) {
        this.state = state;
        this.curvature = curvature;
        this.scores = new BlockScores(state, evidence.recording().clock().rate());
        this.scale = MassScale.of(evidence, state);
        this.gains = evidence.measuresForces() ? Math.sqrt(2) * SmallError.Kind.GAIN.deviation() : 0;
    }

    /**
     * Of a fit at its least cost; empty where that has no slopes.
     *
     * @param fit not modified
     */
    public static Optional<NumberIntervals> of(Evidence evidence, Fitter.State fit) {
        Fitter.State sloped = new Fitter(evidence).lookWithSlopes(fit.candidate(), fit.x(), fit.frame());
        if (sloped.failed()) {
            return Optional.empty();
        }
        double[][] curvature = new Normal(sloped).curvature();
        return Arrays.stream(curvature).flatMapToDouble(Arrays::stream).allMatch(Double::isFinite)
                ? Optional.of(new NumberIntervals(evidence, sloped, curvature))
                : Optional.empty();
    }

    /** Where a number lies, in the unit of its key; empty where the fit holds it, or cannot tell. */
    public Optional<Interval> of(int i) {
        Knob knob = state.candidate().knobs().get(i);
        double half = Interval.quantile(scores.count()) * deviation(i);
        if (state.held()[i] || Double.isNaN(half)) {
            return Optional.empty();
        }
        double x = state.x()[i];
        if (knob.unit() == 0) {
            double share = Math.hypot(half, Interval.Z * open(knob, scale));
            return Optional.of(ordered(knob.value(x) * Math.exp(-share), knob.value(x) * Math.exp(share)));
        }
        return Optional.of(ordered(knob.value(x) - half * knob.unit(), knob.value(x) + half * knob.unit()));
    }

    /** Where a mass lies that the fit holds [kg]; empty where that sets the scale of all, or a force does. */
    public Optional<Interval> ofHeld(double mass) {
        double share = Interval.Z * scale.deviation();
        return share > 0 ? Optional.of(ordered(mass * Math.exp(-share), mass * Math.exp(share))) : Optional.empty();
    }

    private static Interval ordered(double one, double other) {
        return new Interval(Math.min(one, other), Math.max(one, other), Interval.Source.CURVATURE);
    }

    /**
     * By how many standard deviations a number is off what was given [1]; 0 of one that the fit holds.
     *
     * @param masses the scale of all
     */
    double sureness(int i, MassScale masses) {
        double shift = state.x()[i] + Math.log(masses.factor());
        return state.held()[i] ? 0 : Math.abs(shift) / Math.hypot(deviation(i), open(state.candidate().knobs().get(i), masses));
    }

    /**
     * The same where one mass is taken as it was given and sets the scale of all.
     *
     * @param i a number that is a factor of what was given
     * @param held the mass, likewise
     */
    double surenessBeside(int i, int held) {
        double[] less = new double[curvature.length];
        less[i] = 1;
        less[held] = -1;
        return state.held()[i] || i == held ? 0 : Math.abs(state.x()[i] - state.x()[held]) / deviation(less);
    }

    /** The same of the heaviest mass, which a fit holds. */
    double surenessOfHeaviest(int held) {
        return Math.abs(state.x()[held]) / deviation(held);
    }

    /** What no cost shows of a number that is found as a factor [1]: the scale of the masses, or what force and motion are measured by. */
    private double open(Knob knob, MassScale masses) {
        return isOfModel(knob) ? Math.hypot(masses.deviation(), gains) : 0;
    }

    /** Whether it is a stiffness, a damping or a mass that the model gives, found as a factor of that. */
    static boolean isOfModel(Knob knob) {
        return knob.unit() == 0 && (knob.isOfLink() || knob.slot().kind() == Slot.Kind.MASS);
    }

    /** Standard deviation of a coordinate of the fit [1]. */
    private double deviation(int i) {
        double[] unit = new double[curvature.length];
        unit[i] = 1;
        return deviation(unit);
    }

    /** The same of a sum of coordinates, each so many times. */
    private double deviation(double[] unit) {
        double[] solved = DampedEquations.solve(curvature, unit, state.held(), 0);
        double white = ScalarProduct.of(unit, solved);
        return Math.sqrt(Math.max(0, white) * Math.max(Math.max(1, state.reduced()), scores.ratio(solved, white)));
    }
}
