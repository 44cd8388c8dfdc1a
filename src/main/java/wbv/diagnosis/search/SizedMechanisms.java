package wbv.diagnosis.search;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;
import wbv.diagnosis.algebra.DirectionProducts;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Start;
import wbv.signal.ScalarProduct;

/**
 * One mechanism or two from one start each, as strong as leaves least of a residual.
 *
 * @param together directions of their amplitudes in the order of the mechanisms, and what follows them
 * @param grown    by amplitude, how many times as much it carries because the model's numbers follow [1]: a spring that loses four fifths
 *                 of itself loses more newtons the stiffer it was
 */
record SizedMechanisms(List<Looked> each, DirectionProducts.Together together, double[] grown) {

    /**
     * A mechanism from one of its starts.
     *
     * @param own the directions of its amplitudes, or the one of what has none
     * @param growth by amplitude, how much of its force goes by each of the model's numbers [1], one a knob; none where none does
     */
    record Looked(Hypothesis hypothesis, Start start, int[] own, Place place, List<double[]> growth) {

        /** @param from its first direction's index */
        static Looked of(Hypothesis hypothesis, Start start, int from, Candidate base, Directions directions) {
            int[] own = IntStream.range(from, from + Math.max(1, start.columns().size())).toArray();
            Looked one = new Looked(hypothesis, start, own, Place.plain(hypothesis, base), List.of());
            return Directions.isInLink(hypothesis) && !start.columns().isEmpty() ? one.growing(base, directions) : one;
        }

        private Looked growing(Candidate base, Directions directions) {
            List<double[]> by = IntStream.range(0, own.length).mapToObj(c -> growth(base, directions, only(c))).toList();
            boolean any = by.stream().flatMapToDouble(Arrays::stream).anyMatch(part -> part != 0);
            return any ? new Looked(hypothesis, start, own, place, by) : this;
        }

        /** By what part its force is larger where each of the model's numbers is twice as large. */
        private double[] growth(Candidate base, Directions directions, double[] values) {
            double[] force = directions.force(hypothesis, values);
            double square = ScalarProduct.of(force, force);
            return base.knobs().stream()
                    .mapToDouble(knob -> square > 0 && knob.isOfLink() && knob.slot().at() == Directions.link(hypothesis)
                            ? ScalarProduct.of(force, directions.force(hypothesis, values, knob, 2)) / square - 1 : 0)
                    .toArray();
        }

        /** @param times how many times as large each of the model's numbers is [1], one a knob */
        private double grown(int amplitude, double[] times) {
            double[] by = growth.get(amplitude);
            return 1 + IntStream.range(0, by.length).mapToDouble(k -> by[k] == 0 ? 0 : by[k] * (times[k] - 1)).sum();
        }

        /** Its numbers with amplitudes so many times what they are looked at with. */
        double[] values(double[] strengths) {
            return Screening.sized(hypothesis, start, strengths);
        }

        /** The same with one of them alone. */
        double[] only(int amplitude) {
            return Screening.alone(hypothesis, start, amplitude);
        }

        private boolean mayBe(int amplitude, double strength) {
            if (start.columns().isEmpty()) {
                return strength * Effort.NEAR_ONE > 1 && strength < Effort.NEAR_ONE;
            }
            for (int i : start.columns().get(amplitude)) {
                Hypothesis.Number number = hypothesis.numbers().get(i);
                if (!number.mayBe(number.nothing() + strength * start.sizes()[i])) {
                    return false;
                }
            }
            return true;
        }
    }

    /**
     * Amplitudes that would not be what they may are left out; empty where one has none that it may have, or does what the other does.
     *
     * @param products of all directions
     * @param times    how many times as large each of the model's numbers is beside some directions [1], one a knob
     */
    static Optional<SizedMechanisms> of(DirectionProducts products, List<Looked> each,
            Function<DirectionProducts.Together, double[]> times) {
        int[] which = each.stream().flatMapToInt(one -> Arrays.stream(one.own())).toArray();
        boolean[] none = new boolean[which.length];
        SizedMechanisms sized = of(each, products.together(which, none), times);
        while (sized.leavesOut(none)) {
            sized = of(each, products.together(which, none), times);
        }
        return sized.isEach() ? Optional.of(sized) : Optional.empty();
    }

    private static SizedMechanisms of(List<Looked> each, DirectionProducts.Together together,
            Function<DirectionProducts.Together, double[]> times) {
        double[] grown = new double[each.stream().mapToInt(one -> one.own().length).sum()];
        Arrays.fill(grown, 1);
        if (each.stream().anyMatch(one -> !one.growth().isEmpty())) {
            double[] larger = times.apply(together);
            int at = 0;
            for (Looked one : each) {
                for (int c = 0; c < one.growth().size(); c++) {
                    grown[at + c] = one.grown(c, larger);
                }
                at += one.own().length;
            }
        }
        return new SizedMechanisms(each, together, grown);
    }

    /** How strong an amplitude is in a model with the numbers that follow [1]. */
    private double strength(int at) {
        return together.joint().strengths()[at] / grown[at];
    }

    /**
     * Whether an amplitude is not what it may be, so that it is left out.
     *
     * @param none which are. Modified.
     */
    private boolean leavesOut(boolean[] none) {
        boolean any = false;
        int at = 0;
        for (Looked one : each) {
            for (int c = 0; c < one.own().length; c++) {
                boolean out = !none[at] && !one.mayBe(c, strength(at));
                none[at++] |= out;
                any |= out;
            }
        }
        return any;
    }

    /** Whether each of them does something. */
    private boolean isEach() {
        int at = 0;
        boolean all = true;
        for (Looked one : each) {
            boolean any = false;
            for (int c = 0; c < one.own().length; c++) {
                any |= together.joint().strengths()[at++] != 0;
            }
            all &= any;
        }
        return all;
    }

    /** What they take of the sum of squares [1]. */
    double gain() {
        return together.joint().gain();
    }

    /** A candidate with all of them. */
    Candidate on(Candidate base) {
        return each.stream().map(Looked::hypothesis).reduce(base, Candidate::with, (a, b) -> b);
    }

    /**
     * Its coordinates [1], one a knob.
     *
     * @param own those of the candidate without them. Not modified.
     */
    double[] on(Candidate base, double[] own) {
        Candidate with = base;
        double[] x = own;
        int from = 0;
        for (Looked one : each) {
            Candidate next = with.with(one.hypothesis());
            int to = from + one.own().length;
            x = with.extended(x, next, one.hypothesis(), one.values(IntStream.range(from, to).mapToDouble(this::strength).toArray()));
            with = next;
            from = to;
        }
        return x;
    }
}
