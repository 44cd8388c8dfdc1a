package wbv.diagnosis.learn;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.law.Law;
import wbv.body.law.Learned;
import wbv.body.law.LearnedCourse;
import wbv.body.law.LearnedTerm;
import wbv.body.number.Modulator;
import wbv.body.number.Shape;
import wbv.body.simulate.ModulatorSeries;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/**
 * The terms of which a law that no library holds is made: products of powers of a link's deflection and speed, knees, damping that speed
 * thins, one memory or an inertance, each alone or multiplied by another channel, the ride's level, another link's load or a course in
 * time. Every term enters linearly, so that a score test ranks them at the price of one product of spectra each.
 */
final class Grammar {

    /** Shapes that stand alone; r and v themselves are the model's. */
    private static final List<Shape> ALONE = shapes("|r|", "r^2", "|r|r", "r^3", "sign(r)", "r+", "r+^2", "r-^2", "|v|", "v^2", "|v|v",
            "v^3", "sign(v)", "v+", "v+^2",
            "v-^2", "r v", "|r| v", "r^2 v", "r |v|", "r v^2", "r |v|v", "|r| |v|v", "r^2 |v|v", "r+ v", "r- v", "r+ v+", "r- v+",
            "r sign(v)", "|r| sign(v)", "r^2 sign(v)", "r+ sign(v)", "r- sign(v)", "sign(r) |v|", "sign(r) v^2", "|r| |v|", "r^2 |v|");
    /** Shapes that something else multiplies. */
    private static final List<Shape> MODULATED = shapes("1", "r", "v", "|r|r", "r^3", "|v|v", "sign(v)", "|r|");
    /** Shapes that come and go by the clock. */
    private static final List<Shape> CHANGING = shapes("r", "v", "|v|v", "sign(v)");
    /** What is remembered for a moment, and what of the motion's level for seconds, with the shapes that this multiplies. */
    private static final List<Shape> REMEMBERED = shapes("r", "v", "|r|r", "r^3", "|v|v", "v^3", "sign(v)", "|r| v", "r |v|");
    private static final List<Shape> LEVELS = shapes("|r|", "r^2", "|v|", "v^2");
    private static final List<Shape> BY_LEVEL = shapes("r", "v", "|v|v", "sign(v)");
    private static final double[] MOMENTS = {0.02, 0.06, 0.2};
    private static final double[] SECONDS = {0.7, 2.5, 8};
    /** Memories of the ride [s]. */
    private static final double[] RIDES = {0.7, 2.5, 8};
    /** What settles, in parts of the record. */
    private static final double[] SETTLING = {0.1, 0.3};
    /** Moments at which a step is tried, spread over the record. */
    private static final int STEPS = 20;

    private final Evidence evidence;
    private final ModulatorSeries modulators;
    private final int link;
    private final Terms terms;

    /**
     * @param fitted the linear model beside which the law acts
     * @param motion of its links
     * @param modulators of it
     */
    Grammar(Evidence evidence, Assembly fitted, Motion motion, ModulatorSeries modulators, int link) {
        this.evidence = evidence;
        this.modulators = modulators;
        this.link = link;
        this.terms = new Terms(evidence, fitted, motion, link);
    }

    private static List<Shape> shapes(String... texts) {
        return Arrays.stream(texts).map(Shape::parse).toList();
    }

    /**
     * Every term that is not in a law already.
     *
     * @param known terms of the law so far
     */
    List<Hypothesis> terms(List<Learned> known) {
        List<Hypothesis> all = new ArrayList<>();
        ALONE.forEach(shape -> all.add(terms.term(shape, Modulator.NONE, 1)));
        for (Shape of : List.of(Shape.DEFLECTION, Shape.SPEED)) {
            for (Law.Side side : Law.Side.values()) {
                all.add(terms.knee(of, side));
            }
        }
        REMEMBERED.forEach(of -> all.add(terms.memory(of, Shape.ONE, scaled(MOMENTS, terms.pace()))));
        LEVELS.forEach(of -> BY_LEVEL.forEach(shape -> all.add(terms.memory(of, shape, scaled(SECONDS, terms.pace())))));
        all.add(terms.inertance());
        all.add(terms.thinning());
        for (Modulator modulator : modulators()) {
            double size = size(modulator);
            MODULATED.forEach(shape -> all.add(terms.term(shape, modulator, size)));
        }
        CHANGING.forEach(shape -> {
            all.add(terms.course(shape, LearnedCourse.Course.STEP, steps()));
            all.add(terms.course(shape, LearnedCourse.Course.SETTLING, scaled(SETTLING, terms.seconds())));
            all.add(terms.course(shape, LearnedCourse.Course.GROWING, new double[] {terms.seconds()}));
            if (!evidence.onRig()) {   // benches do not breathe
                all.add(terms.wave(shape));
            }
        });
        return all.stream().filter(term -> known.stream().noneMatch(law -> alike(term, law))).toList();
    }

    /** What stands for a law that has no formula. */
    List<Hypothesis> tables() {
        return List.of(terms.table(Shape.DEFLECTION), terms.table(Shape.SPEED));
    }

    /** Whether a hypothesis would only be another coefficient of a term. */
    private static boolean alike(Hypothesis hypothesis, Learned law) {
        return hypothesis.additions().stream()
                .anyMatch(addition -> addition instanceof Addition.InLink in && in.law() instanceof Learned own
                        && own.getClass() == law.getClass() && own.kind().equals(law.kind()) && own.modulator().equals(law.modulator()));
    }

    private static double[] scaled(double[] times, double factor) {
        return Arrays.stream(times).map(time -> factor * time).toArray();
    }

    /** What a term is multiplied by. */
    static Modulator modulator(Hypothesis term) {
        return law(term).modulator();
    }

    private static Learned law(Hypothesis term) {
        return (Learned) ((Addition.InLink) term.additions().get(0)).law();
    }

    /** A term with a modulator as it is where that has a limit; empty for any other. */
    Optional<Hypothesis> limited(Hypothesis term) {
        return law(term) instanceof LearnedTerm law && !(law.modulator() instanceof Modulator.None)
                ? Optional.of(terms.limited(law, term.numbers().get(0).unit(), size(law.modulator())))
                : Optional.empty();
    }

    private double[] steps() {
        return IntStream.range(1, STEPS).mapToDouble(i -> i * terms.seconds() / STEPS).toArray();
    }

    private List<Modulator> modulators() {
        List<Modulator> out = new ArrayList<>();
        Set<Channel> unmeasured = evidence.beside();
        for (Channel channel : evidence.recording().channels().stream().filter(each -> !unmeasured.contains(each)).toList()) {
            boolean across = channel.axis() != evidence.model().axis();
            if (across && channel.quantity() == Quantity.ACCELERATION) {
                out.add(new Modulator.Measured(channel));
                evidence.model().base().sensor().map(base -> new Channel(base.location(), Quantity.ACCELERATION, channel.axis()))
                        .filter(base -> !base.equals(channel) && evidence.recording().has(base))
                        .ifPresent(base -> out.add(new Modulator.Lean(channel, base)));
            } else if (channel.quantity() == Quantity.ANGULAR_RATE) {
                out.add(new Modulator.Measured(channel));
                out.add(new Modulator.Angle(channel));
            }
        }
        if (!evidence.onRig()) {
            DoubleStream.of(RIDES).forEach(time -> out.add(new Modulator.Ride(time)));
        }
        IntStream.range(0, evidence.model().links().size()).filter(l -> l != link)
                .forEach(l -> Arrays.stream(Modulator.Of.values()).forEach(of -> out.add(new Modulator.OtherLink(of, l))));
        out.addAll(out.stream().filter(modulator -> !(modulator instanceof Modulator.Ride))
                .flatMap(modulator -> Arrays.stream(Modulator.Part.values()).map(part -> (Modulator) new Modulator.PartOf(part, modulator)))
                .toList());
        return out;
    }

    /** How large a modulator is, root mean square. */
    private double size(Modulator modulator) {
        double[] series = modulators.of(modulator);
        return Math.max(Motion.rms(series, series.length), 1e-12);
    }
}
