package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;
import static wbv.diagnosis.mechanism.Start.fixed;
import static wbv.diagnosis.mechanism.Start.grid;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import wbv.body.law.Settling;
import wbv.body.law.SlowDrift;
import wbv.diagnosis.mechanism.Hypothesis.Number;

/**
 * Stiffness and damping that drift, without end or until they settle, or damping alone. Times go by the link's own period and by the
 * record, see {@link AbruptChange}.
 */
record GradualChange() implements Mechanism {

    /**
     * Periods of the link in which a slow drift settles at least (assumed) [1]: what it loses in the first moments of motion is no drift.
     */
    private static final double SLOWLY = 60;
    /** The most of the record that they may be, and that a drift may take to settle [1]: slower ones are straight lines. */
    private static final double MOST_SLOWLY = 0.3;
    private static final double SLOWEST = 8;
    /** Where a settling time starts, in parts of the record. */
    private static final double[] TIMES = {0.25, 0.6, 1.5};
    /** Unit of time of the law's numbers [s]. */
    private static final double HUNDRED = 100;
    /** How many times as much as stiffness damping changes at most, to either side (assumed) [1]: more is a dashpot that changes alone. */
    private static final double MOST_SHARE = 10;
    private static final String SETTLING = "settling";
    private static final String DASHPOT = "dashpot";
    /** Change of the stiffness that counts as none, where damping changes alone [1]. */
    private static final double NONE = 1e-6;
    private static final double HELD = 1e-9;
    /** Change of a number by which it is looked at to first order, the most that it loses, and the most that it gains [1]. */
    private static final double CHANGE = 0.1;
    private static final double LOSS = -0.97;
    private static final double GAIN = 12;

    @Override
    public Entry entry() {
        return new Entry("drift.slow", Family.DRIFT, "The link %s changed over time");
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        double end = scene.end();
        double slope = HUNDRED / end;   // by as much as itself in the record
        double bend = slope * slope;
        double slowly = Math.min(SLOWLY * link.period(), MOST_SLOWLY * end);
        Number time = factor(slowly, SLOWEST * end);
        Number share = sum(0.2, -MOST_SHARE, MOST_SHARE);
        List<Hypothesis> out = new ArrayList<>(List.of(
                Hypothesis.law(this, link, "", new SlowDrift(CHANGE * slope, 0, 1),
                        List.of(sum(CHANGE * slope, -3 * slope, GAIN * slope), sum(CHANGE * bend, -4 * bend, GAIN * bend), share),
                        List.of(Start.of(new double[] {CHANGE * slope, 0, 1}, new int[] {0}))),
                Hypothesis.law(this, link, SETTLING, new Settling(CHANGE, end / 2, 1), List.of(sum(CHANGE, LOSS, GAIN), time, share),
                        grid(TIMES, part -> Start.of(new double[] {CHANGE, Math.max(slowly, part * end), 1}, new int[] {0})))));
        if (link.ownDamping() > 0) {
            out.add(Hypothesis.law(this, link, DASHPOT, new Settling(NONE, end / 2, CHANGE / NONE),
                    List.of(sum(CHANGE, (1 - HELD) * NONE, (1 + HELD) * NONE), time, sum(CHANGE / NONE, LOSS / NONE, GAIN / NONE)),
                    grid(TIMES, part -> Start.of(new double[] {NONE, Math.max(slowly, part * end), CHANGE / NONE}, new int[] {2}))));
        }
        return out;
    }

    @Override
    public List<Told> told(Hypothesis hypothesis) {
        return hypothesis.form().equals(DASHPOT)
                ? List.of(Told.scaled("damping_change", 2, NONE), Told.plain(hypothesis.numbers().get(1).key(), 1))
                : told(hypothesis.numbers());
    }

    /** One that settles begins as the parabola does: c (1 - e^(-t/τ)) is c t/τ - c t²/(2 τ²) and what is of higher order. */
    @Override
    public Optional<Hypothesis> begunAt(Hypothesis form, double[] found) {
        double time = -found[0] / (2 * found[1]);
        double change = found[0] * time;
        double[] start = form.form().equals(DASHPOT) ? new double[] {NONE, HUNDRED * time, found[2] * change / NONE}
                : new double[] {change, HUNDRED * time, found[2]};
        return Optional.of(form).filter(settling -> !settling.form().isEmpty() && time > 0 && Double.isFinite(time))
                .map(settling -> new Hypothesis(this, settling.where(), settling.form(), settling.additions(), settling.numbers(),
                        List.of(fixed(IntStream.range(0, start.length).mapToDouble(i -> within(settling, i, start[i])).toArray()))));
    }

    private static double within(Hypothesis hypothesis, int number, double value) {
        Number bounds = hypothesis.numbers().get(number);
        return Math.max(bounds.low(), Math.min(bounds.high(), value));
    }

    /** A form that goes nowhere beyond the data, where the other may run away. */
    @Override
    public boolean yieldsTo(Hypothesis rival) {
        return rival.kind() instanceof GradualChange && !rival.form().isEmpty();
    }

    @Override
    public boolean imitatesAt(String key, boolean low) {
        return low && key.equals("settling_s");
    }
}
