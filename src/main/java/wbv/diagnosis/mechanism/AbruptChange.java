package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;
import static wbv.diagnosis.mechanism.Start.fixed;
import static wbv.diagnosis.mechanism.Start.grid;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import wbv.body.law.StepChange;
import wbv.diagnosis.mechanism.Hypothesis.Number;

/**
 * Stiffness and damping that change at a moment. Times go by the link's own period and by the record: what takes a sitter a second takes a
 * bench at 500 Hz a hundredth of one.
 */
record AbruptChange() implements Mechanism {

    /** At most so many moments at which a link may change are tried, and at least so many. */
    private static final int MOST_MOMENTS = 60;
    private static final int LEAST_MOMENTS = 16;
    /** Periods between two of them (assumed) [1]: what changes half as far away is found from either. */
    private static final double APART = 12.5;
    /** Periods before the first of them, which show what was before it (assumed) [1], and the most of the record that they may be. */
    private static final double BEFORE = 25;
    private static final double MOST_BEFORE = 0.125;
    /** Part of that time that the moment found may be nearer to the beginning, and to the end. */
    private static final double NEARER = 0.8;
    private static final double NEAREST = 0.6;
    /** Periods in which what changes has changed (assumed) [1], and the most of the record that they may be. */
    private static final double CHANGING = 5;
    private static final double MOST_CHANGING = 0.025;
    /**
     * How long a change may take, and from where that is found, in times of this (assumed) [1]: half a period to the sixty that a slow
     * drift takes at least.
     */
    private static final double SHORTEST = 0.1;
    private static final double LONGEST = 12;
    private static final double[] LONG = {1, 4};
    /** Part by which spring and dashpot change, either for itself, as it is looked at to first order. */
    private static final double SIZE = 0.1;

    @Override
    public Entry entry() {
        return new Entry("drift.step", Family.DRIFT, "The link %s changed at one moment");
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        double end = scene.end();
        double before = Math.min(BEFORE * link.period(), MOST_BEFORE * end);
        double apart = Math.min(Math.max(APART * link.period(), end / MOST_MOMENTS), end / LEAST_MOMENTS);
        double changing = Math.min(CHANGING * link.period(), MOST_CHANGING * end);
        List<Start> moments = new ArrayList<>();
        for (double t = before; t < end - NEARER * before; t += apart) {
            // A fit that is not led there starts from a link that all but goes.
            moments.add(new Start(new double[] {t, 0.1, 0.1}, new double[] {t, SIZE, SIZE}, List.of(new int[] {1}, new int[] {2})));
        }
        return List.of(Hypothesis.law(this, link, "", new StepChange(end / 2, 1.1, 1.1),
                List.of(sum(changing, NEARER * before, end - NEAREST * before), sum(0.1, 0.05, 6).about(1), sum(0.1, 0.05, 6).about(1)),
                moments));
    }

    /** One that takes some time: less than a slow drift does, which has no moment. */
    @Override
    public Optional<Hypothesis> further(Hypothesis plain, double[] found) {
        Number moment = plain.numbers().get(0);
        return Optional.of(plain.additions().get(0)).filter(Addition.InLink.class::isInstance).map(Addition.InLink.class::cast)
                .filter(in -> in.law() instanceof StepChange)
                .map(in -> new Hypothesis(this, plain.where(), "gradual",
                        List.of(new Addition.InLink(in.link(),
                                new StepChange.Gradual(found[0], found[1], found[2], LONG[0] * moment.unit()))),
                        Stream.concat(plain.numbers().stream(),
                                Stream.of(factor(SHORTEST * moment.unit(), LONGEST * moment.unit()).named("duration_s"))).toList(),
                        grid(LONG, part -> fixed(found[0], found[1], found[2], part * moment.unit()))));
    }

    @Override
    public String sentence(Set<String> keys) {
        return keys.contains("duration_s") ? "The link %s changed within a short time" : entry().sentence();
    }

    @Override
    public Doubt doubt(String key) {
        return key.equals("time_s") ? Doubt.MOMENT : Doubt.SHARE;
    }
}
