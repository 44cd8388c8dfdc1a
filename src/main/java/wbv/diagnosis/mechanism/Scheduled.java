package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import java.util.stream.IntStream;
import wbv.body.law.Law;
import wbv.body.law.ScheduledFriction;
import wbv.body.law.ScheduledLink;
import wbv.body.number.Modulator;

/**
 * A link's stiffness, damping or friction that goes by a measured channel which is no input of the model: the position of a roller, a
 * coil's voltage, a temperature. A polynomial of the first to the fourth degree over the channel's range, no more of it than the channel's
 * levels tell.
 */
record Scheduled(What what) implements Mechanism {

    /** What goes by the channel. */
    enum What { STIFFNESS, DAMPING, FRICTION }

    private static final Map<Integer, String> FORMS = Map.of(1, "straight", 2, "parabola", 3, "cubic", 4, "free");
    private static final String HOLD = "Hold what the channel measures at three levels, one after the other, and record each: the number "
            + "must be another at each, and the same at each again.";
    /** Change of a link's own number by which it is looked at to first order, and the largest [1]. */
    private static final double CHANGE = 0.1;
    private static final double MOST = 30;

    @Override
    public Entry entry() {
        return switch (what) {
            case STIFFNESS -> new Entry("stiffness.scheduled", Family.SPRING, "The stiffness of %s goes by a measured channel", HOLD);
            case DAMPING -> new Entry("damping.scheduled", Family.LOSS, "The damping of %s goes by a measured channel", HOLD);
            case FRICTION -> new Entry("friction.scheduled", Family.LOSS, "There is friction in %s that goes by a measured channel", HOLD);
        };
    }

    /** What of the link goes by the channel its word says. */
    @Override
    public Map<String, String> form(Hypothesis found, Map<String, Double> numbers, DoubleSupplier speed) {
        return Map.of();
    }

    /** It goes by a channel that was measured. */
    @Override
    public Together together() {
        return Together.TWO;
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        List<Hypothesis> out = new ArrayList<>();
        boolean own = what == What.STIFFNESS ? link.own() > 0 : what == What.DAMPING ? link.ownDamping() > 0 : scene.onRig();
        for (Scene.Schedule schedule : own ? scene.schedules() : List.<Scene.Schedule>of()) {
            FORMS.keySet().stream().filter(degree -> degree < schedule.levels()).sorted()
                    .forEach(degree -> out.add(of(link, schedule.level(), degree)));
        }
        return out;
    }

    private Hypothesis of(Scene.Link link, Modulator.Level by, int degree) {
        String form = FORMS.get(degree) + " over " + by.channel();
        if (what == What.FRICTION) {
            double f = link.force();
            double v = link.speed();
            List<Hypothesis.Number> numbers = new ArrayList<>(List.of(sum(0.3 * f, 0, 10 * f)));
            numbers.addAll(polynomial(degree, 0.3 * f, 10 * f));
            numbers.add(factor(DryFriction.STUCK * v, 3 * v));
            List<Start> starts = new ArrayList<>();
            for (double slope : new double[] {-0.8, 0.8}) {
                for (double transition : new double[] {1e-4, 0.02, 0.15}) {
                    starts.add(Start.of(new double[] {f, slope * f, 0, 0, 0, transition * v}, new int[] {0, 1}));
                }
            }
            return Hypothesis.law(this, link, form, new ScheduledFriction(by, f, 0, 0, 0, 0, v), numbers, starts);
        }
        double[] sizes = new double[4];
        Arrays.fill(sizes, 0, degree, CHANGE);
        Law law = new ScheduledLink(what == What.STIFFNESS ? ScheduledLink.Of.STIFFNESS : ScheduledLink.Of.DAMPING, by, sizes[0], sizes[1],
                sizes[2], sizes[3]);
        return Hypothesis.law(this, link, form, law, polynomial(degree, CHANGE, MOST),
                List.of(new Start(sizes, IntStream.range(0, degree).mapToObj(i -> new int[] {i}).toList())));
    }

    /** Coefficients up to a degree; those beyond are held at nothing. */
    private static List<Hypothesis.Number> polynomial(int degree, double unit, double most) {
        return IntStream.rangeClosed(1, 4)
                .mapToObj(power -> power <= degree ? sum(unit, -most, most) : sum(unit, -1e-9 * unit, 1e-9 * unit)).toList();
    }

    /**
     * What it is at the ends of the range and, where that is more than a straight line, between them: of a link's own number by how much it
     * changes.
     */
    @Override
    public List<Told> told(Hypothesis hypothesis) {
        Modulator.Level by = (Modulator.Level) ((Addition.InLink) hypothesis.additions().get(0)).law().modulator();
        int first = what == What.FRICTION ? 1 : 0;
        String key = what == What.FRICTION ? "friction_N" : what == What.STIFFNESS ? "stiffness_change" : "damping_change";
        int degree = FORMS.keySet().stream().filter(each -> hypothesis.form().startsWith(FORMS.get(each))).findFirst().orElseThrow();
        double[] points = IntStream.rangeClosed(0, degree).mapToDouble(i -> 2.0 * i / degree - 1).toArray();
        List<Told> out = new ArrayList<>();
        for (double u : points) {
            if (u != 0 || what == What.FRICTION) {
                int[] of = IntStream.range(0, first + degree).toArray();
                double[] weights = IntStream.range(0, first + degree).mapToDouble(i -> Math.pow(u, i + 1 - first)).toArray();
                out.add(new Told(key + " at " + amount(by, u), of, weights, Told.Kind.SUM,
                        x -> IntStream.range(0, x.length).mapToDouble(i -> weights[i] * x[i]).sum()));
            }
        }
        if (what == What.FRICTION) {
            out.add(Told.plain("transition_m_per_s", 5));
        }
        return Collections.unmodifiableList(out);
    }

    private static String amount(Modulator.Level by, double u) {
        return new BigDecimal(by.shown(u)).round(new MathContext(3)).stripTrailingZeros().toPlainString().replace('-', '−') + " "
                + by.shownUnit() + " of " + by.channel();
    }

    @Override
    public Optional<String> against(Mechanism rival) {
        return rival.family() == Family.SENSOR ? Optional.empty() : Optional.of(HOLD);
    }

    /** The simpler form. */
    @Override
    public boolean yieldsTo(Hypothesis rival) {
        return rival.kind().equals(this);
    }
}
