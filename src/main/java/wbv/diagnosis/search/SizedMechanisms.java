package wbv.diagnosis.search;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import wbv.diagnosis.algebra.DirectionProducts;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Start;

/**
 * One mechanism or two from one start each, as strong as leaves least of a residual.
 *
 * @param together directions of their amplitudes in the order of the mechanisms, and what follows them
 */
record SizedMechanisms(List<Looked> each, DirectionProducts.Together together) {

    /**
     * A mechanism from one of its starts.
     *
     * @param own the directions of its amplitudes, or the one of what has none
     */
    record Looked(Hypothesis hypothesis, Start start, int[] own, Place place) {

        /** @param from its first direction's index */
        static Looked of(Hypothesis hypothesis, Start start, int from, Candidate base) {
            int[] own = IntStream.range(from, from + Math.max(1, start.columns().size())).toArray();
            return new Looked(hypothesis, start, own, Place.plain(hypothesis, base));
        }

        /** Its numbers with amplitudes so many times what they are looked at with. */
        double[] values(double[] strengths) {
            return Screening.sized(hypothesis, start, strengths);
        }

        /** The same with one of them alone. */
        double[] only(int amplitude) {
            double[] strengths = new double[own.length];
            strengths[amplitude] = 1;
            return values(strengths);
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
     */
    static Optional<SizedMechanisms> of(DirectionProducts products, List<Looked> each) {
        int[] which = each.stream().flatMapToInt(one -> Arrays.stream(one.own())).toArray();
        boolean[] none = new boolean[which.length];
        SizedMechanisms sized = new SizedMechanisms(each, products.together(which, none));
        while (sized.leavesOut(none)) {
            sized = new SizedMechanisms(each, products.together(which, none));
        }
        return sized.isEach() ? Optional.of(sized) : Optional.empty();
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
                boolean out = !none[at] && !one.mayBe(c, together.joint().strengths()[at]);
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
            x = with.extended(x, next, one.hypothesis(), one.values(Arrays.copyOfRange(together.joint().strengths(), from, to)));
            with = next;
            from = to;
        }
        return x;
    }
}
