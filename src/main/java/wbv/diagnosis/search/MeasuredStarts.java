package wbv.diagnosis.search;

import java.util.Arrays;
import java.util.Comparator;
import java.util.Optional;
import java.util.stream.IntStream;
import wbv.body.Spectra;
import wbv.body.Structure;
import wbv.diagnosis.algebra.DampedEquations;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Knob;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Projection;
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
 * model's numbers beside it follow from one linear problem, as near as the motion is known. The sensors' errors follow too: those that were
 * found beside a model that lacks a law make up for what they can of it.
 */
final class MeasuredStarts {

    private final Screening screening;
    private final Fitter.State base;
    private final Structure structure;
    private final Projection errors;
    /** What each of the model's numbers does along the motion by all that it is, by coordinate; to first order what is no factor. */
    private final Followed[] carried;
    /** Their products. */
    private final double[][] products;
    /** What is left along the motion. */
    private final Followed left;

    /**
     * Along the motion at a fit.
     *
     * @param screening at that fit
     */
    MeasuredStarts(Screening screening, Fitter.State base, Motion motion) {
        this.screening = screening;
        this.base = base;
        this.structure = base.candidate().at(base.x()).structure();
        this.errors = Projection.ofAll(base);
        // What is driven has no masses, and moves as it was measured.
        double[][] accelerations = structure.held() ? new double[0][] : motion.accelerations();
        this.carried = IntStream.range(0, base.x().length).mapToObj(i -> followed(carried(i, motion, accelerations)))
                .toArray(Followed[]::new);
        this.products = Arrays.stream(carried).map(one -> Arrays.stream(carried).mapToDouble(one::product).toArray())
                .toArray(double[][]::new);
        this.left = followed(screening.along());
    }

    private double[] carried(int i, Motion motion, double[][] accelerations) {
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
     * A change of the residual that the sensors' errors follow.
     *
     * @param vector whitened, as long as the residual
     * @param own    its products with the errors [1]
     * @param follow how the errors follow it [1]
     */
    private record Followed(double[] vector, double[] own, double[] follow) {

        double product(Followed other) {
            return ScalarProduct.of(vector, other.vector) - ScalarProduct.of(own, other.follow);
        }
    }

    private Followed followed(double[] vector) {
        double[] own = errors.products(vector);
        return new Followed(vector, own, errors.errors(own));
    }

    /**
     * A law, and the model's numbers beside it as the measured motion has them.
     *
     * @param values of the law's numbers, each in its unit
     * @param law    its force by sample [N]
     * @param x      coordinates of the candidate with the hypothesis [1], one a knob
     * @param left   sum of squares that it would leave, priors included [1]
     */
    private record Solved(double[] values, double[] law, double[] x, double left) {}

    /**
     * Coordinates of a candidate with a hypothesis to start from [1], one a knob; empty where no law has a size, or none that it may have.
     *
     * @param with base and hypothesis
     */
    Optional<double[]> of(Candidate with, Hypothesis hypothesis) {
        if (!LinkLaws.isInLink(hypothesis)) {
            return Optional.empty();
        }
        return hypothesis.starts().stream().flatMap(start -> sized(hypothesis, start).stream())
                .map(values -> solved(with, hypothesis, values)).min(Comparator.comparingDouble(Solved::left))
                .map(first -> shaped(with, hypothesis, first).x());
    }

    /** Values of a start with its amplitudes as the measured motion has them; empty where it may not have them. */
    private Optional<double[]> sized(Hypothesis hypothesis, Start start) {
        if (start.columns().isEmpty()) {
            return Optional.of(start.values());
        }
        int columns = start.columns().size();
        Followed[] all = Arrays.copyOf(carried, carried.length + columns);
        for (int c = 0; c < columns; c++) {
            double[] only = new double[columns];
            only[c] = 1;
            all[carried.length + c] = direction(hypothesis,
                    screening.laws().force(hypothesis, Screening.sized(hypothesis, start, only)));
        }
        double[] strengths = strengths(all, left);
        double[] values = Screening.sized(hypothesis, start, Arrays.copyOfRange(strengths, carried.length, all.length));
        return IntStream.range(0, values.length).allMatch(i -> {
            Hypothesis.Number number = hypothesis.numbers().get(i);
            return values[i] >= number.low() && values[i] <= number.high();
        }) ? Optional.of(values) : Optional.empty();
    }

    private Followed direction(Hypothesis hypothesis, double[] force) {
        return followed(screening.direction(LinkLaws.link(hypothesis), force));
    }

    /**
     * The law of the shape with which least is left, the model's numbers moving beside it: steps of Gauss and Newton from the best of its
     * starts, which lie far apart.
     */
    private Solved shaped(Candidate with, Hypothesis hypothesis, Solved first) {
        int[] free = IntStream.range(0, first.values().length).filter(i -> hypothesis.numbers().get(i).isFree()).toArray();
        Solved best = first;
        for (int turn = 0; turn < Effort.HEAT_STEPS; turn++) {
            Solved from = best;
            double[] step = step(hypothesis, from, free);
            best = IntStream.range(0, Effort.TRIES)
                    .mapToObj(half -> solved(with, hypothesis, moved(hypothesis, from.values(), free, step, Math.pow(0.5, half))))
                    .filter(next -> next.left() < from.left()).findFirst().orElse(from);
            if (best.left() > (1 - Effort.ROUGH) * from.left()) {
                break;
            }
        }
        return best;
    }

    /** How far the law's free numbers go beside the model's, those that are factors by logarithms. */
    private double[] step(Hypothesis hypothesis, Solved from, int[] free) {
        Followed[] all = Arrays.copyOf(beside(hypothesis, from.values(), from.law()), carried.length + free.length);
        for (int i = 0; i < free.length; i++) {
            double[] moved = moved(hypothesis, from.values(), new int[] {free[i]}, new double[] {Effort.DIFFERENCE}, 1);
            all[carried.length + i] = direction(hypothesis, slope(from.law(), screening.laws().force(hypothesis, moved)));
        }
        double[] strengths = strengths(all, followed(sum(left.vector(), direction(hypothesis, from.law()).vector())));
        return Arrays.copyOfRange(strengths, carried.length, all.length);
    }

    /** Values of a law with some of its numbers moved, within their bounds. */
    private static double[] moved(Hypothesis hypothesis, double[] values, int[] which, double[] step, double part) {
        double[] out = values.clone();
        for (int i = 0; i < which.length; i++) {
            Hypothesis.Number number = hypothesis.numbers().get(which[i]);
            double value = number.unit() == 0 ? out[which[i]] * Math.exp(part * step[i]) : out[which[i]] + part * step[i] * number.unit();
            out[which[i]] = Math.max(number.low(), Math.min(number.high(), value));
        }
        return out;
    }

    /** How one force turns into another by a little. A new array. */
    private static double[] slope(double[] from, double[] to) {
        double[] out = new double[from.length];
        Arrays.setAll(out, j -> (to[j] - from[j]) / Effort.DIFFERENCE);
        return out;
    }

    /** What the model's numbers do beside a law, which goes with those of its own link. */
    private Followed[] beside(Hypothesis hypothesis, double[] values, double[] law) {
        int link = LinkLaws.link(hypothesis);
        double stiffness = structure.stiffness()[link];
        double damping = structure.damping()[link];
        Followed[] all = carried.clone();
        for (int i = 0; i < all.length; i++) {
            Knob knob = base.candidate().knobs().get(i);
            if (knob.isOfLink() && knob.slot().at() == link) {
                boolean spring = knob.slot().kind() == Slot.Kind.STIFFNESS;
                double[] more = slope(law, screening.laws().force(hypothesis, values,
                        spring ? (1 + Effort.DIFFERENCE) * stiffness : stiffness, spring ? damping : (1 + Effort.DIFFERENCE) * damping));
                all[i] = Arrays.stream(more).allMatch(force -> force == 0) ? all[i]
                        : followed(sum(all[i].vector(), screening.direction(link, more)));
            }
        }
        return all;
    }

    /** The model's numbers beside a law. */
    private Solved solved(Candidate with, Hypothesis hypothesis, double[] values) {
        double[] law = screening.laws().force(hypothesis, values);
        Followed[] all = beside(hypothesis, values, law);
        double[] rest = sum(left.vector(), direction(hypothesis, law).vector());
        double[] strengths = strengths(all, followed(rest));
        for (int i = 0; i < all.length; i++) {
            Spectra.add(rest, all[i].vector(), strengths[i]);
        }
        Followed beyond = followed(rest);
        double[] x = base.candidate().extended(base.x(), with, hypothesis, values);
        double cost = beyond.product(beyond);
        for (int i = 0; i < all.length; i++) {
            Knob knob = base.candidate().knobs().get(i);
            double value = knob.unit() == 0 ? knob.value(x[i]) * (1 + strengths[i]) : knob.value(x[i] + strengths[i]);
            x[i] = knob.coordinate(Math.max(knob.value(knob.low()), value));
            cost += Math.pow(x[i] / knob.deviation(), 2);
        }
        return new Solved(values, law, x, cost);
    }

    /** How strong some directions are that leave least of a residual, those of the model's numbers first, of which something is known [1]. */
    private double[] strengths(Followed[] directions, Followed residual) {
        double[][] gram = new double[directions.length][directions.length];
        double[] gradient = Arrays.stream(directions).mapToDouble(residual::product).toArray();
        for (int i = 0; i < directions.length; i++) {
            for (int j = 0; j <= i; j++) {
                boolean known = i < carried.length && directions[i] == carried[i] && directions[j] == carried[j];
                gram[i][j] = known ? products[i][j] : directions[i].product(directions[j]);
                gram[j][i] = gram[i][j];
            }
        }
        for (int i = 0; i < carried.length; i++) {
            double deviation = base.candidate().knobs().get(i).deviation();
            gram[i][i] += 1 / (deviation * deviation);
            gradient[i] += base.x()[i] / (deviation * deviation);
        }
        return Arrays.stream(DampedEquations.solve(gram, gradient)).map(s -> -s).toArray();
    }
}
