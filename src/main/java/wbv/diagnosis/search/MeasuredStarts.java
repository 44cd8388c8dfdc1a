package wbv.diagnosis.search;

import java.util.Arrays;
import java.util.Comparator;
import java.util.Optional;
import java.util.stream.IntStream;
import wbv.body.Spectra;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Knob;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Start;
import wbv.diagnosis.search.AlongMeasured.Followed;

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

    private final Directions directions;
    private final Fitter.State base;
    private final AlongMeasured along;

    /**
     * Along the motion at a fit.
     *
     * @param directions at that fit
     */
    MeasuredStarts(Directions directions, Fitter.State base, AlongMeasured along) {
        this.directions = directions;
        this.base = base;
        this.along = along;
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
        if (!Directions.isInLink(hypothesis)) {
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
        Followed[] own = along.carried();
        Followed[] all = Arrays.copyOf(own, own.length + columns);
        for (int c = 0; c < columns; c++) {
            all[own.length + c] = direction(hypothesis, directions.force(hypothesis, Screening.alone(hypothesis, start, c)));
        }
        double[] strengths = along.strengths(all, along.left());
        double[] values = Screening.sized(hypothesis, start, Arrays.copyOfRange(strengths, own.length, all.length));
        return IntStream.range(0, values.length).allMatch(i -> hypothesis.numbers().get(i).mayBe(values[i])) ? Optional.of(values)
                : Optional.empty();
    }

    /** What is left beside a law. A new array. */
    private double[] beyond(Hypothesis hypothesis, double[] law) {
        return AlongMeasured.sum(along.left().vector(), directions.of(Directions.link(hypothesis), law));
    }

    private Followed direction(Hypothesis hypothesis, double[] force) {
        return along.followed(directions.of(Directions.link(hypothesis), force));
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
        Followed[] own = beside(hypothesis, from.values(), from.law());
        Followed[] all = Arrays.copyOf(own, own.length + free.length);
        for (int i = 0; i < free.length; i++) {
            double[] moved = moved(hypothesis, from.values(), new int[] {free[i]}, new double[] {Effort.DIFFERENCE}, 1);
            all[own.length + i] = direction(hypothesis, slope(from.law(), directions.force(hypothesis, moved)));
        }
        double[] strengths = along.strengths(all, along.followed(beyond(hypothesis, from.law())));
        return Arrays.copyOfRange(strengths, own.length, all.length);
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
        int link = Directions.link(hypothesis);
        Followed[] all = along.carried();
        for (int i = 0; i < all.length; i++) {
            Knob knob = base.candidate().knobs().get(i);
            if (knob.isOfLink() && knob.slot().at() == link) {
                double[] more = slope(law, directions.force(hypothesis, values, knob, 1 + Effort.DIFFERENCE));
                all[i] = Arrays.stream(more).allMatch(force -> force == 0) ? all[i]
                        : along.followed(AlongMeasured.sum(all[i].vector(), directions.of(link, more)));
            }
        }
        return all;
    }

    /** The model's numbers beside a law. */
    private Solved solved(Candidate with, Hypothesis hypothesis, double[] values) {
        double[] law = directions.force(hypothesis, values);
        Followed[] all = beside(hypothesis, values, law);
        double[] rest = beyond(hypothesis, law);
        double[] strengths = along.strengths(all, along.followed(rest));
        for (int i = 0; i < all.length; i++) {
            Spectra.add(rest, all[i].vector(), strengths[i]);
        }
        Followed still = along.followed(rest);
        double[] x = base.candidate().extended(base.x(), with, hypothesis, values);
        double cost = still.product(still);
        along.move(x, strengths);
        for (int i = 0; i < all.length; i++) {
            cost += Math.pow(x[i] / base.candidate().knobs().get(i).deviation(), 2);
        }
        return new Solved(values, law, x, cost);
    }
}
