package wbv.diagnosis.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Spectra;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * A model with numbers that may move, and what was added to the user's model to make it.
 *
 * @param template the assembly whose values the knobs replace
 * @param knobs    in the order of the coordinates x; those of the baseline come first
 * @param added    hypotheses that it contains, in the order in which they were added
 * @param freeWays whether the ways from its laws' forces may differ, see {@link WrongWay}
 */
public record Candidate(Assembly template, List<Knob> knobs, List<Hypothesis> added, boolean freeWays) {

    /** One whose laws' forces go the model's way. */
    public Candidate(Assembly template, List<Knob> knobs, List<Hypothesis> added) {
        this(template, knobs, added, false);
    }

    public Candidate {
        knobs = List.copyOf(knobs);
        added = List.copyOf(added);
    }

    /**
     * The assembly at coordinates.
     *
     * @param x coordinates [1], one a knob. Not modified.
     */
    public Assembly at(double[] x) {
        double[] values = template.values();
        for (int i = 0; i < x.length; i++) {
            double value = knobs.get(i).value(x[i]);
            values[index(i)] = value;
            for (Knob.Tied tied : knobs.get(i).tied()) {
                values[tied.slot().index(template)] = tied.factor() * value;
            }
        }
        return template.with(values);
    }

    /** Where knob i stands in {@link Assembly#values}. */
    public int index(int i) {
        return knobs.get(i).slot().index(template);
    }

    /**
     * Derivative of all outputs to knob i's value, spectra by output, in the units of both.
     *
     * @param slopes spectra by number of the assembly and output, likewise. Not modified
     */
    public double[][] slope(double[][][] slopes, int i) {
        double[][] out = slopes[index(i)];
        List<Knob.Tied> tied = knobs.get(i).tied();
        if (!tied.isEmpty()) {
            out = Arrays.stream(out).map(double[]::clone).toArray(double[][]::new);
            for (Knob.Tied each : tied) {
                double[][] more = slopes[each.slot().index(template)];
                for (int o = 0; o < out.length; o++) {
                    Spectra.add(out[o], more[o], each.factor());
                }
            }
        }
        return out;
    }

    /** How many of the knobs, the first, are of the model itself and not of what was added. */
    public int given() {
        return knobs.size() - added.stream().mapToInt(hypothesis -> hypothesis.numbers().size()).sum();
    }

    /**
     * The same whose links have stiffness and damping that are known at least so well.
     *
     * @param most standard deviation of a coordinate [1]
     */
    public Candidate surer(double most) {
        return new Candidate(template, knobs.stream().map(knob -> knob.isOfLink() ? knob.surer(most) : knob).toList(), added, freeWays);
    }

    /** Whether knob i stands apart from the model's structure, as a law's numbers do and a hidden mass does not. */
    boolean isApart(int i) {
        return index(i) >= template.structure().parameters();
    }

    /** The knob of a link's stiffness; empty where the link has none. */
    public OptionalInt stiffness(int link) {
        return knob(Slot.of(Slot.Kind.STIFFNESS, link));
    }

    private OptionalInt knob(Slot slot) {
        return IntStream.range(0, knobs.size()).filter(i -> knobs.get(i).slot().equals(slot)).findFirst();
    }

    /** What a number has before it is fitted, in its unit. */
    public double given(Slot slot) {
        OptionalInt knob = knob(slot);
        return knob.isPresent() ? knobs.get(knob.getAsInt()).reference() : template.values()[slot.index(template)];
    }

    /** Coordinates [1], one a knob, at which every knob stands at its reference, or at the nearest bound. */
    public double[] start() {
        return knobs.stream().mapToDouble(knob -> knob.within(0)).toArray();
    }

    /**
     * The hypothesis that was added last.
     *
     * @throws IndexOutOfBoundsException if none was
     */
    public Hypothesis last() {
        return added.get(added.size() - 1);
    }

    /**
     * A cost [1] with what is known of the numbers beforehand: the square of each coordinate over its deviation is added.
     *
     * @param x coordinates [1], one a knob. Not modified.
     */
    double withPriors(double cost, double[] x) {
        double all = cost;
        for (int i = 0; i < x.length; i++) {
            double pull = x[i] / knobs.get(i).deviation();
            all += pull * pull;
        }
        return all;
    }

    /** This candidate with a hypothesis on top. */
    public Candidate with(Hypothesis hypothesis) {
        List<Hypothesis> all = new ArrayList<>(added);
        all.add(hypothesis);
        Extension extension = Extension.of(template, knobs, hypothesis);
        return new Candidate(extension.template(), extension.knobs(), all, freeWays);
    }

    /** The same, with forces whose ways may differ. */
    public Candidate withFreeWays() {
        return new Candidate(template, knobs, added, true);
    }

    /**
     * Coordinates [1] of {@code with(hypothesis)}, one a knob, from those of this candidate and values of the hypothesis. Arrays are not
     * modified.
     *
     * @param x coordinates [1], one a knob
     * @param values one a number of the hypothesis, in its own unit
     */
    public double[] extended(double[] x, Candidate with, Hypothesis hypothesis, double[] values) {
        double[] out = Arrays.copyOf(x, with.knobs().size());
        int[] own = with.positions(hypothesis);
        for (int i = 0; i < own.length; i++) {
            out[own[i]] = with.knobs().get(own[i]).coordinate(values[i]);
        }
        return out;
    }

    /**
     * Coordinates [1] of {@code with(hypothesis)}, one a knob, as another candidate on top of this one has them: of two mechanisms one
     * without the other.
     *
     * @param other has the hypothesis
     * @param x coordinates of the other [1], one a knob. Not modified.
     */
    public double[] alone(Candidate other, double[] x, Candidate with, Hypothesis hypothesis) {
        return extended(x, with, hypothesis, other.values(hypothesis, x));
    }

    /**
     * Coordinates [1], one a knob, with other numbers of what mechanisms stand on, which come first. A new array.
     *
     * @param x coordinates [1], one a knob. Not modified.
     * @param numbers the first of them, as they are to be [1], one a knob of what mechanisms stand on. Not modified.
     */
    public static double[] standing(double[] x, double[] numbers) {
        double[] out = x.clone();
        System.arraycopy(numbers, 0, out, 0, numbers.length);
        return out;
    }

    /**
     * Numbers of a hypothesis, an array with one of each, in its unit.
     *
     * @param hypothesis one that was added
     * @param x coordinates [1], one a knob. Not modified.
     */
    public double[] values(Hypothesis hypothesis, double[] x) {
        return Arrays.stream(positions(hypothesis)).mapToDouble(i -> knobs.get(i).value(x[i])).toArray();
    }

    /**
     * Positions of a hypothesis' numbers among the knobs.
     *
     * @param hypothesis one that was added
     */
    public int[] positions(Hypothesis hypothesis) {
        int from = knobs.size();
        for (int i = added.size() - 1; i >= 0; i--) {
            Hypothesis each = added.get(i);
            from -= each.numbers().size();
            if (each == hypothesis) {
                break;
            }
        }
        int first = from;
        return IntStream.range(0, hypothesis.numbers().size()).map(i -> first + i).toArray();
    }
}
