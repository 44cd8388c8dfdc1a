package wbv.diagnosis;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import wbv.body.ModelFile;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.algebra.DampedEquations;
import wbv.diagnosis.fit.Entering;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Knob;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Normal;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.measured.SmallError;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.search.MassScale;
import wbv.signal.ScalarProduct;

/**
 * The numbers of the mechanisms in a fit, and how sure they are. What the fit knows comes from the cost: its curvature where it
 * is a parabola as far as the interval reaches, its profile where it is not. The cost counts as if what is left were white; by
 * how much it is not, the stretches of the recording tell. On top comes what no cost shows: the scale of the masses, what a law's
 * formula leaves undone at its place, and the small errors that every sensor has.
 */
final class Values {

    /**
     * How sharp a moment is, in the unit of its number [1]: in that what changes has changed, and the cost has a kink there, no parabola.
     */
    private static final double MOMENT = 0.5;
    /** How much more one muscle's twitch may lag than another's that passes as much (assumed) [s]. */
    private static final double TWITCH = 0.05;
    private static final int STEPS = 4;
    private static final double SETTLED = 1e-6;

    private final Evidence evidence;
    private final Fitter fitter;
    private final Fitter.State state;
    private final double[][] curvature;
    private final BlockScores scores;
    private final MassScale scale;

    /** @param chosen the fit that holds what was found */
    Values(Evidence evidence, Fitter.State chosen) {
        this.evidence = evidence;
        this.fitter = new Fitter(evidence);
        Fitter.State settled = fitter.fit(chosen.candidate(), chosen.x(), chosen.frame(), STEPS, SETTLED);
        this.state = fitter.lookWithSlopes(settled.candidate(), settled.x(), settled.frame());
        this.curvature = new Normal(state).curvature();
        this.scores = new BlockScores(state, evidence.recording().clock().rate());
        this.scale = MassScale.of(evidence, state);
    }

    /** The fit at its least cost, with the heaviest mass as given. */
    Fitter.State fit() {
        return state;
    }

    /** The fit at its least cost, at the scale that all masses tell. */
    Fitter.State state() {
        return scale.applied(state);
    }

    MassScale scale() {
        return scale;
    }

    /** A hypothesis of the fit with its numbers. */
    Diagnosis.Named named(Hypothesis hypothesis, double probability) {
        List<Estimand> plain = Estimand.of(hypothesis, state.candidate());
        List<Estimand> scaled = Estimand.of(hypothesis, state().candidate());
        List<Interval> found = Parallel.map(IntStream.range(0, plain.size()).boxed().toList(),
                i -> interval(hypothesis, plain.get(i), scaled.get(i)));
        boolean about = evidence.model().links().stream()
                .anyMatch(link -> link.name().equals(hypothesis.where()) && evidence.model().about(link));
        Map<String, Double> plainly = new LinkedHashMap<>();
        Map<String, Double> values = new LinkedHashMap<>();
        Map<String, Interval> intervals = new LinkedHashMap<>();
        for (int i = 0; i < scaled.size(); i++) {
            double value = scaled.get(i).value(scaled.get(i).u(state.x()));
            String key = about ? ModelFile.keyAbout(scaled.get(i).key()) : scaled.get(i).key();
            plainly.put(scaled.get(i).key(), value);
            values.put(key, value);
            intervals.put(key, found.get(i));
        }
        return new Diagnosis.Named(hypothesis.mechanism(), hypothesis.where(), probability, values, intervals, state.reduced())
                .in(hypothesis.kind().form(hypothesis, plainly, () -> speed(hypothesis)));
    }

    /** Of the link of a hypothesis as it moves with all that was found, root mean square [m/s]; NaN where it is in no link. */
    private double speed(Hypothesis hypothesis) {
        return hypothesis.additions().stream().filter(Addition.OfLink.class::isInstance).mapToInt(of -> ((Addition.OfLink) of).link())
                .mapToDouble(link -> {
                    double[] velocity = Motion.measured(evidence, state.candidate().at(state.x())).velocity(link);
                    return Motion.rms(velocity, velocity.length);
                }).findFirst().orElse(Double.NaN);
    }

    private Interval interval(Hypothesis hypothesis, Estimand plain, Estimand scaled) {
        double[] b = plain.slope(state.x());
        boolean moment = scaled.key().equals("time_s");
        boolean[] moments = new boolean[b.length];
        boolean[] held = state.held();
        for (int i = 0; i < held.length; i++) {
            moments[i] = !moment && state.candidate().knobs().get(i).isMoment();
            held[i] = b[i] == 0 && (held[i] || moments[i]);
        }
        double[] solved = DampedEquations.solve(curvature, b, held, 0);
        double white = ScalarProduct.of(b, solved);
        double ratio = Math.max(Math.max(1, state.reduced()), moment ? 1 : scores.ratio(solved, white));
        double quantile = Interval.quantile(scores.count());
        Profile profile = new Profile(fitter, state, curvature, plain, solved, moments, quantile * quantile * ratio);
        List<Profile.End> ends = Parallel.map(List.of(-1, 1), moment ? profile::parabola : profile::end);
        double u = plain.u(state.x());
        double value = scaled.value(u);
        double low = value;
        double high = value;
        Interval.Source source = Interval.Source.CURVATURE;
        double relative = relative(hypothesis, scaled, b, white, u);
        double absolute = scatter(hypothesis, scaled.key()).orElse(0);
        for (Profile.End end : ends) {
            source = end.from() == Interval.Source.PROFILE ? end.from() : source;
            double found = Double.isInfinite(end.u()) ? Math.signum(end.u() * scaled.rate(u)) * Double.POSITIVE_INFINITY
                    : widened(value, scaled.value(end.u()), absolute, relative);
            low = Math.min(low, found);
            high = Math.max(high, found);
        }
        if (!plain.isPlain()) {
            return new Interval(low, high, source);
        }
        Knob knob = state.candidate().knobs().get(plain.at()[0]);
        double[] bounds = {scaled.value(knob.low()), scaled.value(knob.high())};
        Arrays.sort(bounds);
        return new Interval(low <= bounds[0] ? limit(knob, bounds[0], -1) : low,
                high >= bounds[1] ? limit(knob, bounds[1], 1) : high, source);
    }

    /** What an interval ends at that reaches a bound: there where physics ends, nowhere where only the search did. */
    private static double limit(Knob knob, double bound, int side) {
        return knob.unit() != 0 && (bound == 0 || bound == 1) ? bound : side * Double.POSITIVE_INFINITY;
    }

    /**
     * The end of an interval that counts what the cost does not show.
     *
     * @param end      as the cost has it
     * @param absolute standard deviation of the rest
     * @param relative the same, as a part of the number
     */
    private static double widened(double value, double end, double absolute, double relative) {
        double known = Math.hypot(end - value, Interval.Z * absolute);
        double half = Math.hypot(known, Interval.Z * relative * value);
        if (known < Math.abs(value) && (end < value) == (value > 0)) {
            // what is not 0 and is known to a part of itself is not 0 there either
            return value * Math.exp(-half / Math.abs(value));
        }
        return end < value ? value - half : value + half;
    }

    /** Standard deviation, as a part of the number, of what the cost does not show. */
    private double relative(Hypothesis hypothesis, Estimand scaled, double[] slope, double white, double u) {
        double masses = MassScale.scales(scaled.key()) ? scale.deviation() : 0;
        double sensors = scatter(hypothesis, scaled.key()).isPresent() ? 0 : SmallError.Kind.GAIN.deviation();
        double form = scaled.key().equals("time_s") ? 0 : form(hypothesis, slope, white)
                * Math.abs(scaled.rate(u) / Math.max(Math.abs(scaled.value(u)), 1e-300));
        return Math.hypot(Math.hypot(masses, sensors), form);
    }

    /**
     * What the formula of a law leaves open of a number of its, in u: physics is not obliged to follow the formula that stands for
     * it. Were what is left where the law acts due to this number, the number would be off by so much if it alone moved, by more if
     * everything else gave way; what another formula does lies between, and the geometric mean of the two is taken. On the rig's
     * laws, of which none has the library's formula, errors come out 1.2 times what this gives, root mean square.
     *
     * @param slope of the number to each coordinate. Not modified.
     * @param white variance of u as the curvature has it
     */
    private double form(Hypothesis hypothesis, double[] slope, double white) {
        if (!(hypothesis.additions().get(0) instanceof Addition.InLink in)) {
            return 0;
        }
        double[] effect = new double[state.raw().length];
        double size = ScalarProduct.of(slope, slope);
        for (int i = 0; i < slope.length; i++) {
            for (int k = 0; slope[i] != 0 && k < effect.length; k++) {
                effect[k] += state.slopes()[i][k] * slope[i] / size;
            }
        }
        double[][] way = new Simulator(evidence.excitation()).linearised(state.candidate().at(state.x())).ofLinkForce(in.link());
        double left = Entering.beyondNoise(evidence, state, way);
        double alone = left / Math.max(ScalarProduct.of(effect, effect), 1e-300);
        return Math.pow(alone * left * white, 0.25);
    }

    /**
     * What is open of a number beside what the fit knows, where it is not a part of the number itself: a sensor's fault comes on
     * top of the small errors that every sensor has; a moment is as sharp as what happened at it.
     */
    private OptionalDouble scatter(Hypothesis hypothesis, String key) {
        return switch (hypothesis.kind().doubt(key)) {
            case SHARE -> OptionalDouble.empty();
            case NONE -> OptionalDouble.of(0);
            case MOMENT -> hypothesis.numbers().stream().filter(number -> number.key().equals(key))
                    .mapToDouble(number -> MOMENT * number.unit()).findFirst();
            case LEAD -> Estimand.of(hypothesis, state().candidate()).stream().filter(other -> other.key().equals("reflex_N_per_m"))
                    .mapToDouble(stretch -> TWITCH * Math.abs(stretch.value(stretch.u(state.x())))).findFirst();
            // The input's sensor has its own small error, against which this one is seen.
            case GAIN -> OptionalDouble.of(Math.sqrt(2) * SmallError.Kind.GAIN.deviation());
            case DELAY -> OptionalDouble.of(Math.sqrt(2) * SmallError.Kind.DELAY.deviation() * evidence.measured().sample());
            case TILT -> OptionalDouble.of(SmallError.Kind.TILT.deviation());
            case ARM -> OptionalDouble.of(SmallError.Kind.ARM.deviation());
        };
    }
}
