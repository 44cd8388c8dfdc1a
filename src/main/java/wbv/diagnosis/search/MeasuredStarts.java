package wbv.diagnosis.search;

import java.util.Arrays;
import java.util.Comparator;
import java.util.Optional;
import java.util.stream.IntStream;
import wbv.body.Spectra;
import wbv.body.Structure;
import wbv.diagnosis.algebra.Columns;
import wbv.diagnosis.algebra.DampedEquations;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Knob;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Slot;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Start;
import wbv.signal.ScalarProduct;

/**
 * Laws as strong as what was measured says, to start from. Screening sees a law as it would be if it were weak, beside a model that has
 * bent itself to make up for it: of a strong one that tells neither the size nor, at times, the sign.
 *
 * <p>What a model lacks is, however strong, in proportion to the forces that it lacks along the motion that there was (Lippmann and
 * Schwinger, Physical Review 1950): {@code r + H (Δk x + Δc v - Δm a + φ(x, v)) = noise}, r being what a fit leaves, H the way of a
 * force to the outputs of the model as fitted, x and v the motion of a link and a that of a body as measured. So the law's size and the
 * model's numbers beside it follow from one linear problem, as near as the motion is known.
 */
final class MeasuredStarts {

    private final Screening screening;
    private final Fitter.State base;
    private final Motion motion;
    private final Structure structure;
    /** What each of the model's numbers does along the motion by all that it is, by coordinate; to first order what is no factor. */
    private final double[][] carried;
    /** What is left along the motion. */
    private final double[] left;

    /**
     * Along the motion at a fit.
     *
     * @param screening at that fit
     */
    MeasuredStarts(Screening screening, Fitter.State base, Motion motion) {
        this.screening = screening;
        this.base = base;
        this.motion = motion;
        this.structure = base.candidate().at(base.x()).structure();
        // What is driven has no masses, and moves as it was measured.
        double[][] accelerations = structure.held() ? new double[0][] : motion.accelerations();
        this.carried = IntStream.range(0, base.x().length).mapToObj(i -> carried(i, accelerations)).toArray(double[][]::new);
        this.left = screening.along();
    }

    private double[] carried(int i, double[][] accelerations) {
        Knob knob = base.candidate().knobs().get(i);
        int at = knob.slot().at();
        return knob.unit() != 0 || !knob.tied().isEmpty() ? base.slopes()[i] : switch (knob.slot().kind()) {
            case STIFFNESS -> screening.direction(at, times(structure.stiffness()[at], motion.displacement(at)));
            case DAMPING -> screening.direction(at, times(structure.damping()[at], motion.velocity(at)));
            case MASS -> Arrays.stream(structure.sharing(at))
                    .mapToObj(body -> screening.directionOn(body, times(-structure.mass()[at], accelerations[body])))
                    .reduce(new double[base.slopes()[i].length], MeasuredStarts::sum);
            default -> base.slopes()[i];
        };
    }

    private static double[] times(double factor, double[] x) {
        return Arrays.stream(x).map(value -> factor * value).toArray();
    }

    private static double[] sum(double[] x, double[] y) {
        double[] out = x.clone();
        Spectra.add(out, y, 1);
        return out;
    }

    /**
     * A solved start.
     *
     * @param x    coordinates of the candidate with the hypothesis [1], one a knob
     * @param left sum of squares that it would leave, priors included [1]
     */
    private record Solved(double[] x, double left) {}

    /**
     * Coordinates of a candidate with a hypothesis to start from [1], one a knob; empty where no law has a size, or none that it may have.
     *
     * @param with base and hypothesis
     */
    Optional<double[]> of(Candidate with, Hypothesis hypothesis) {
        if (!LinkLaws.isInLink(hypothesis)) {
            return Optional.empty();
        }
        int link = LinkLaws.link(hypothesis);
        return hypothesis.starts().stream().flatMap(start -> sized(hypothesis, link, start).stream())
                .map(values -> solved(with, hypothesis, link, values)).min(Comparator.comparingDouble(Solved::left)).map(Solved::x);
    }

    /** Values of a start with its amplitudes as the measured motion has them; empty where it may not have them. */
    private Optional<double[]> sized(Hypothesis hypothesis, int link, Start start) {
        if (start.columns().isEmpty()) {
            return Optional.of(start.values());
        }
        int columns = start.columns().size();
        double[][] all = Arrays.copyOf(carried, carried.length + columns);
        for (int c = 0; c < columns; c++) {
            double[] only = new double[columns];
            only[c] = 1;
            all[carried.length + c] = screening.direction(link,
                    screening.laws().force(hypothesis, Screening.sized(hypothesis, start, only)));
        }
        double[] strengths = strengths(new Columns(all), left);
        double[] values = Screening.sized(hypothesis, start, Arrays.copyOfRange(strengths, carried.length, all.length));
        return IntStream.range(0, values.length).allMatch(i -> {
            Hypothesis.Number number = hypothesis.numbers().get(i);
            return values[i] >= number.low() && values[i] <= number.high();
        }) ? Optional.of(values) : Optional.empty();
    }

    /** The model's numbers beside a law, which goes with those of its own link. */
    private Solved solved(Candidate with, Hypothesis hypothesis, int link, double[] values) {
        double stiffness = structure.stiffness()[link];
        double damping = structure.damping()[link];
        double[] law = screening.laws().force(hypothesis, values);
        double[][] all = carried.clone();
        for (int i = 0; i < all.length; i++) {
            Knob knob = base.candidate().knobs().get(i);
            if (knob.isOfLink() && knob.slot().at() == link) {
                boolean spring = knob.slot().kind() == Slot.Kind.STIFFNESS;
                double[] more = screening.laws().force(hypothesis, values, spring ? (1 + Effort.DIFFERENCE) * stiffness : stiffness,
                        spring ? damping : (1 + Effort.DIFFERENCE) * damping);
                Arrays.setAll(more, j -> (more[j] - law[j]) / Effort.DIFFERENCE);
                all[i] = sum(all[i], screening.direction(link, more));
            }
        }
        double[] beside = sum(left, screening.direction(link, law));
        Columns columns = new Columns(all);
        double[] strengths = strengths(columns, beside);
        columns.subtract(Arrays.stream(strengths).map(s -> -s).toArray(), beside);
        double[] x = base.candidate().extended(base.x(), with, hypothesis, values);
        double cost = ScalarProduct.of(beside, beside);
        for (int i = 0; i < all.length; i++) {
            Knob knob = base.candidate().knobs().get(i);
            double value = knob.unit() == 0 ? knob.value(x[i]) * (1 + strengths[i]) : knob.value(x[i] + strengths[i]);
            x[i] = knob.coordinate(Math.max(knob.value(knob.low()), value));
            cost += Math.pow(x[i] / knob.deviation(), 2);
        }
        return new Solved(x, cost);
    }

    /**
     * How strong some directions are that leave least of a residual, those of the model's numbers first, of which something is known [1].
     *
     * @param residual Not modified.
     */
    private double[] strengths(Columns directions, double[] residual) {
        double[][] products = directions.gram();
        double[] gradient = directions.products(residual);
        for (int i = 0; i < carried.length; i++) {
            double deviation = base.candidate().knobs().get(i).deviation();
            products[i][i] += 1 / (deviation * deviation);
            gradient[i] += base.x()[i] / (deviation * deviation);
        }
        return Arrays.stream(DampedEquations.solve(products, gradient)).map(s -> -s).toArray();
    }
}
