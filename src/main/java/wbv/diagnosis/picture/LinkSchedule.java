package wbv.diagnosis.picture;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import wbv.body.law.Law;
import wbv.body.law.LinkMotion;
import wbv.body.law.ScheduledFriction;
import wbv.body.law.ScheduledLink;
import wbv.body.number.Modulator;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.learn.LatentForce;
import wbv.diagnosis.learn.LinkScale;

/**
 * What of a link goes by a measured channel, over that channel: stiffness, damping or friction by least squares of the latent force among
 * moments of about one level.
 */
final class LinkSchedule {

    private static final int LEVELS = 12;
    private static final int CURVE = 101;

    private final String where;
    private final LatentForce latent;
    private final Modulator.Level by;
    private final double[] series;
    private final LinkScale scale;

    /** @param modulator by which it goes, a {@link Modulator.Level} */
    LinkSchedule(Evidence evidence, LatentForce latent, String where, Modulator modulator, LinkScale scale) {
        this.where = where;
        this.latent = latent;
        this.by = (Modulator.Level) modulator;
        this.series = evidence.series(by.channel());
        this.scale = scale;
    }

    /** Of a link with a stiffness and a damping of its own [N/m, N s/m]. */
    Portrait of(ScheduledLink law, double stiffness, double damping) {
        boolean spring = law.of() == ScheduledLink.Of.STIFFNESS;
        double[] moves = spring ? latent.displacement() : latent.velocity();
        double own = spring ? stiffness : damping;
        LinkMotion unit = new LinkMotion();
        unit.stiffness = 1;
        unit.damping = 1;
        unit.displacement = 1;
        unit.velocity = 1;
        return portrait(law, unit, i -> own * moves[i], Portrait.Scale.of(spring ? "Stiffness change" : "Damping change", "%"), 100);
    }

    Portrait of(ScheduledFriction law) {
        double[] speed = latent.velocity();
        LinkMotion sliding = new LinkMotion();
        sliding.velocity = Double.POSITIVE_INFINITY;
        return portrait(law, sliding, i -> Math.tanh(speed[i] / law.transition()), Portrait.Scale.of("Friction", scale.force()), 1);
    }

    /**
     * @param unit  motion at which the law's force is the number that is shown
     * @param basis force by sample where that number is 1
     * @param times from the number to what is shown
     */
    private Portrait portrait(Law law, LinkMotion unit, IntToDoubleFunction basis, Portrait.Scale number, double times) {
        double[] force = latent.force();
        Integer[] sorted = IntStream.range(0, force.length).filter(latent::known).boxed()
                .sorted(Comparator.comparingDouble(i -> series[i])).toArray(Integer[]::new);
        double[] level = new double[LEVELS];
        double[] value = new double[LEVELS];
        double[] deviation = new double[LEVELS];
        for (int b = 0; b < LEVELS; b++) {
            int[] samples = Arrays.stream(sorted, b * sorted.length / LEVELS, (b + 1) * sorted.length / LEVELS).mapToInt(i -> i).toArray();
            double square = Arrays.stream(samples).mapToDouble(i -> Math.pow(basis.applyAsDouble(i), 2)).sum();
            double found = Arrays.stream(samples).mapToDouble(i -> force[i] * basis.applyAsDouble(i)).sum() / square;
            double left = Arrays.stream(samples).mapToDouble(i -> Math.pow(force[i] - found * basis.applyAsDouble(i), 2)).sum();
            level[b] = by.shownTimes() * Arrays.stream(samples).mapToDouble(i -> series[i]).average().orElse(Double.NaN);
            value[b] = times * found;
            deviation[b] = times * Math.sqrt(left / Math.max(1, LinkHistory.INDEPENDENT * samples.length - 1) / square);
        }
        double[] place = IntStream.range(0, CURVE).mapToDouble(i -> 2.0 * i / (CURVE - 1) - 1).toArray();
        double[] curve = Arrays.stream(place).map(u -> {
            unit.modulation = u;
            return times * law.force(unit);
        }).toArray();
        return new Portrait(number.label() + " in " + where + " over " + by.channel(), Portrait.Scale.of("" + by.channel(), by.shownUnit()),
                number,
                List.of(new Portrait.Trail("among samples of a level", Portrait.Kind.MEAN, level, value, deviation),
                        Portrait.Trail.law("law found", Arrays.stream(place).map(by::shown).toArray(), curve)),
                "From what the link must carry for model and recording to agree, with nothing assumed of how it goes by the channel.");
    }
}
