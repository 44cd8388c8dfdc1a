package wbv.diagnosis.learn;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.law.Law;
import wbv.body.law.Learned;
import wbv.body.law.LearnedCourse;
import wbv.body.law.LearnedKnee;
import wbv.body.law.LearnedLimited;
import wbv.body.law.LearnedMemory;
import wbv.body.law.LearnedTable;
import wbv.body.law.LearnedTerm;
import wbv.body.law.LearnedWave;
import wbv.body.number.Modulator;
import wbv.body.number.Shape;
import wbv.body.simulate.ModulatorSeries;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Window;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.LearnedForce;
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
    /** A memory that is shorter is none at 60 samples a second [s]. */
    private static final double SHORTEST = 0.01;
    private static final double[] MOMENTS = {0.02, 0.06, 0.2};
    private static final double[] SECONDS = {0.7, 2.5, 8};
    /** Knees over the root mean square. */
    private static final double[] KNEES = {0.4, 1, 1.8};
    /** How damping thins with speed: to a limit, and past a crest; bounds from a square root to a force that is gone at twice its crest. */
    private static final double[] THINNING = {1, 2};
    private static final double LEAST_THINNING = 0.3;
    private static final double MOST_THINNING = 6;
    /** Memories of the ride [s]. */
    private static final double[] RIDES = {0.7, 2.5, 8};
    /** What settles, in parts of the record. */
    private static final double[] SETTLING = {0.1, 0.3};
    /** Moments at which a step is tried, spread over the record. */
    private static final int STEPS = 20;
    /** How fast a sitter's links move, by which times that are usual for them are scaled to others [rad/s]. */
    private static final double USUAL = 2 * Math.PI * 5;
    /** Breath: 9 to 27 a minute [Hz] (assumed). */
    private static final double SLOWEST = 0.15;
    private static final double FASTEST = 0.45;
    private static final int MOST_WAVES = 48;
    /** Forces in a table. */
    private static final int TABLED = 6;

    private final Evidence evidence;
    private final Assembly fitted;
    private final ModulatorSeries modulators;
    private final int link;
    private final String where;
    private final double r;
    private final double v;
    private final double force;
    private final double seconds;
    /** By how much slower than a sitter it moves. */
    private final double pace;

    /**
     * @param fitted the linear model beside which the law acts
     * @param motion of its links
     * @param modulators of it
     */
    Grammar(Evidence evidence, Assembly fitted, Motion motion, ModulatorSeries modulators, int link) {
        this.evidence = evidence;
        this.fitted = fitted;
        this.modulators = modulators;
        this.link = link;
        this.where = evidence.model().links().get(link).name();
        double step = evidence.excitation().fineStep();
        Window window = evidence.fit();
        seconds = (window.start() + window.length()) / evidence.recording().clock().rate();
        int end = Math.min(motion.displacement(link).length, (int) (seconds / step));
        r = Math.max(Motion.rms(motion.displacement(link), end), 1e-12);
        v = Math.max(Motion.rms(motion.velocity(link), end), 1e-12);
        pace = evidence.onRig() ? USUAL * r / v : 1;
        force = force(Math.hypot(fitted.structure().stiffness()[link] * r, fitted.structure().damping()[link] * v));
    }

    /**
     * How large a force in the link may be [N]: what its spring and dashpot carry; where it has none, what moves the masses, or what was
     * measured.
     */
    private double force(double carried) {
        double moving = Arrays.stream(fitted.structure().mass()).sum() * v * v / r;
        double[] measured = evidence.measured(0);
        return carried > 0 ? carried : moving > 0 ? moving : Math.max(Motion.rms(measured, measured.length), 1e-12);
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
        ALONE.forEach(shape -> all.add(term(shape, Modulator.NONE, 1)));
        for (Shape of : List.of(Shape.DEFLECTION, Shape.SPEED)) {
            for (Law.Side side : Law.Side.values()) {
                all.add(knee(of, side));
            }
        }
        REMEMBERED.forEach(of -> all.add(memory(of, Shape.ONE, scaled(MOMENTS, pace))));
        LEVELS.forEach(of -> BY_LEVEL.forEach(shape -> all.add(memory(of, shape, scaled(SECONDS, pace)))));
        all.add(inertance());
        all.add(thinning());
        for (Modulator modulator : modulators()) {
            double size = size(modulator);
            MODULATED.forEach(shape -> all.add(term(shape, modulator, size)));
        }
        CHANGING.forEach(shape -> {
            all.add(course(shape, LearnedCourse.Course.STEP, steps()));
            all.add(course(shape, LearnedCourse.Course.SETTLING, scaled(SETTLING, seconds)));
            all.add(course(shape, LearnedCourse.Course.GROWING, new double[] {seconds}));
            if (!evidence.onRig()) {   // benches do not breathe
                all.add(wave(shape));
            }
        });
        return all.stream().filter(term -> known.stream().noneMatch(law -> alike(term, law))).toList();
    }

    /** What stands for a law that has no formula. */
    List<Hypothesis> tables() {
        return List.of(table(Shape.DEFLECTION), table(Shape.SPEED));
    }

    /** Whether a hypothesis would only be another coefficient of a term. */
    private static boolean alike(Hypothesis hypothesis, Learned law) {
        return hypothesis.additions().stream()
                .anyMatch(addition -> addition instanceof Hypothesis.Addition.InLink in && in.law() instanceof Learned own
                        && own.getClass() == law.getClass() && own.kind().equals(law.kind()) && own.modulator().equals(law.modulator()));
    }

    private static double[] scaled(double[] times, double factor) {
        return Arrays.stream(times).map(time -> factor * time).toArray();
    }

    private double unit(Shape shape) {
        double size = Math.pow(r, shape.deflection().power()) * Math.pow(v, shape.speed().power());
        return 0.1 * force / size;
    }

    private Hypothesis term(Shape shape, Modulator modulator, double size) {
        double unit = unit(shape) / size;
        return hypothesis(new LearnedTerm(shape, modulator, unit), unit, List.of(), List.of(Hypothesis.Start.scaled(unit)));
    }

    private Hypothesis knee(Shape of, Law.Side side) {
        double rms = of.equals(Shape.SPEED) ? v : r;
        double unit = unit(of);
        return hypothesis(new LearnedKnee(of, side, Modulator.NONE, unit, rms), unit,
                List.of(new Hypothesis.Number(of.equals(Shape.SPEED) ? "knee_m_per_s" : "knee_m", 0, 0.02 * rms, 6 * rms)),
                Arrays.stream(KNEES).mapToObj(q -> new Hypothesis.Start(new double[] {unit, q * rms}, List.of(new int[] {0}))).toList());
    }

    private Hypothesis thinning() {
        double unit = unit(Shape.SPEED);
        return hypothesis(new Learned.Thinning(unit, THINNING[0], v), unit,
                List.of(Hypothesis.Number.factor(LEAST_THINNING, MOST_THINNING).named("thinning"),
                        Hypothesis.Number.factor(KNEES[0] / 20 * v, 20 * KNEES[2] * v).named("speed_m_per_s")),
                Arrays.stream(THINNING).boxed().flatMap(n -> Arrays.stream(KNEES)
                        .mapToObj(q -> new Hypothesis.Start(new double[] {unit, n, q * v}, List.of(new int[] {0})))).toList());
    }

    private Hypothesis memory(Shape of, Shape shape, double[] times) {
        double unit = unit(shape) * unit(of) / unit(Shape.ONE);
        return hypothesis(new LearnedMemory(of, shape, Modulator.NONE, unit, times[0]), unit,
                List.of(new Hypothesis.Number("memory_s", 0, pace * SHORTEST, pace * 40)),
                Arrays.stream(times).mapToObj(time -> new Hypothesis.Start(new double[] {unit, time}, List.of(new int[] {0}))).toList());
    }

    /** Forces up to three times the root mean square to either side: nearly all of a motion that is normal. */
    private Hypothesis table(Shape of) {
        double step = of.equals(Shape.SPEED) ? v : r;
        double unit = 0.1 * force;
        List<Hypothesis.Number> numbers = new ArrayList<>(List.of(Hypothesis.Number.factor(0.999 * step, 1.001 * step)));
        double[] start = new double[TABLED + 1];
        start[0] = step;
        for (int i = 1; i <= TABLED; i++) {
            numbers.add(Hypothesis.Number.sum(unit, -300 * unit, 300 * unit));
            start[i] = unit;
        }
        LearnedTable law = new LearnedTable(of, step, unit, unit, unit, unit, unit, unit);
        return new Hypothesis(new LearnedForce(), where, words(law), List.of(new Hypothesis.Addition.InLink(link, law)),
                Hypothesis.Number.named(LearnedTable.class, numbers),
                List.of(new Hypothesis.Start(start, IntStream.rangeClosed(1, TABLED).mapToObj(i -> new int[] {i}).toList())));
    }

    private Hypothesis inertance() {
        return new LearnedForce().inertance(link, where, 0.1 * force * r / (v * v));
    }

    private Hypothesis course(Shape shape, LearnedCourse.Course course, double[] times) {
        double unit = unit(shape);
        Hypothesis.Number time = course == LearnedCourse.Course.STEP
                ? new Hypothesis.Number("time_s", 0.02 * seconds, 0.02 * seconds, 0.98 * seconds)
                : new Hypothesis.Number("time_s", 0, 0.02 * seconds, 20 * seconds);
        return hypothesis(new LearnedCourse(shape, course, unit, times[0]), unit, List.of(time),
                Arrays.stream(times).mapToObj(at -> new Hypothesis.Start(new double[] {unit, at}, List.of(new int[] {0}))).toList());
    }

    /** A sine and a cosine, which make a wave of any phase. */
    private Hypothesis wave(Shape shape) {
        double unit = unit(shape);
        LearnedWave law = new LearnedWave(shape, unit, unit, SLOWEST);
        String tail = "_[" + law.unit() + "] of " + words(law);
        // Within half a line of its peak a wave's phase still runs away over the record: quarters of a line are near enough.
        double apart = Math.max(0.5 / seconds, (FASTEST - SLOWEST) / MOST_WAVES);
        List<Hypothesis.Start> starts = IntStream.rangeClosed(0, (int) ((FASTEST - SLOWEST) / apart)).mapToObj(i -> new Hypothesis.Start(
                new double[] {unit, unit, SLOWEST + i * apart}, List.of(new int[] {0}, new int[] {1}))).toList();
        return new Hypothesis(new LearnedForce(), where, words(law), List.of(new Hypothesis.Addition.InLink(link, law)),
                List.of(new Hypothesis.Number("cosine" + tail, unit, -300 * unit, 300 * unit),
                        new Hypothesis.Number("sine" + tail, unit, -300 * unit, 300 * unit),
                        new Hypothesis.Number("frequency_hz", 0.01, 0.5 * SLOWEST, 2 * FASTEST)),
                starts);
    }

    private Hypothesis hypothesis(Learned law, double unit, List<Hypothesis.Number> further, List<Hypothesis.Start> starts) {
        List<Hypothesis.Number> numbers = new ArrayList<>(List.of(new Hypothesis.Number(key(law), unit, -300 * unit, 300 * unit)));
        numbers.addAll(further);
        return new Hypothesis(new LearnedForce(), where, words(law), List.of(new Hypothesis.Addition.InLink(link, law)), numbers, starts);
    }

    /** What a term is multiplied by. */
    static Modulator modulator(Hypothesis term) {
        return law(term).modulator();
    }

    private static Learned law(Hypothesis term) {
        return (Learned) ((Hypothesis.Addition.InLink) term.additions().get(0)).law();
    }

    /** A term with a modulator as it is where that has a limit, to begin with at twice its root mean square; empty for any other. */
    Optional<Hypothesis> limited(Hypothesis term) {
        if (!(law(term) instanceof LearnedTerm law) || law.modulator() instanceof Modulator.None) {
            return Optional.empty();
        }
        double size = size(law.modulator());
        double unit = term.numbers().get(0).unit();
        return Optional.of(hypothesis(new LearnedLimited(law.shape(), law.modulator(), unit, 2 * size), unit,
                List.of(new Hypothesis.Number("limit_[" + law.modulator().unit() + "]", 0, 0.2 * size, 30 * size)),
                List.of(new Hypothesis.Start(new double[] {unit, 2 * size}, List.of(new int[] {0})))));
    }

    /** A term in words: {@code |v|v × load of link 2}. */
    static String words(Learned law) {
        return law.kind() + (law.modulator() instanceof Modulator.None ? "" : " × " + law.modulator());
    }

    private static String key(Learned law) {
        return "coefficient_[" + law.unit() + "] of " + words(law);
    }

    private double[] steps() {
        return IntStream.range(1, STEPS).mapToDouble(i -> i * seconds / STEPS).toArray();
    }

    private List<Modulator> modulators() {
        List<Modulator> out = new ArrayList<>();
        for (Channel channel : evidence.recording().channels()) {
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
