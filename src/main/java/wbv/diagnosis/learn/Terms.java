package wbv.diagnosis.learn;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.ModelFile;
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
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Window;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.LearnedForce;
import wbv.diagnosis.mechanism.Start;

/** Terms of a law in a link, each with the sizes that its numbers may have in the motion of the link. */
final class Terms {

    /** A memory that is shorter is none at 60 samples a second [s]. */
    private static final double SHORTEST = 0.01;
    /** Knees over the root mean square. */
    private static final double[] KNEES = {0.4, 1, 1.8};
    /** How damping thins with speed: to a limit, and past a crest; bounds from a square root to a force that is gone at twice its crest. */
    private static final double[] THINNING = {1, 2};
    private static final double LEAST_THINNING = 0.3;
    private static final double MOST_THINNING = 6;
    /** Breath: 9 to 27 a minute [Hz] (assumed). */
    private static final double SLOWEST = 0.15;
    private static final double FASTEST = 0.45;
    private static final int MOST_WAVES = 48;
    /** Forces in a table. */
    private static final int TABLED = 6;
    /** How fast a sitter's links move, by which times that are usual for them are scaled to others [rad/s]. */
    private static final double USUAL = 2 * Math.PI * 5;

    private final int link;
    private final String where;
    private final double r;
    private final double v;
    private final double force;
    private final double seconds;
    private final double pace;

    /**
     * @param fitted the linear model beside which the law acts
     * @param motion of its links
     */
    Terms(Evidence evidence, Assembly fitted, Motion motion, int link) {
        this.link = link;
        this.where = evidence.model().links().get(link).name();
        Window window = evidence.fit();
        int last = window.start() + window.length();
        seconds = evidence.recording().elapsed(last);
        double laid = last / evidence.recording().clock().rate();
        int end = Math.min(motion.displacement(link).length, (int) (laid / evidence.excitation().fineStep()));
        r = Math.max(Motion.rms(motion.displacement(link), end), 1e-12);
        v = Math.max(Motion.rms(motion.velocity(link), end), 1e-12);
        pace = evidence.onRig() ? USUAL * r / v : 1;
        force = force(evidence, fitted, Math.hypot(fitted.structure().stiffness()[link] * r, fitted.structure().damping()[link] * v));
    }

    /** By how much slower than a sitter's link it moves [1]. */
    double pace() {
        return pace;
    }

    /** How long the data are that are fitted [s]. */
    double seconds() {
        return seconds;
    }

    /**
     * How large a force in the link may be [N]: what its spring and dashpot carry; where it has none, what moves the masses, or what was
     * measured.
     */
    private double force(Evidence evidence, Assembly fitted, double carried) {
        double moving = Arrays.stream(fitted.structure().mass()).sum() * v * v / r;
        double[] measured = evidence.measured(0);
        return carried > 0 ? carried : moving > 0 ? moving : Math.max(Motion.rms(measured, measured.length), 1e-12);
    }

    private double unit(Shape shape) {
        double size = Math.pow(r, shape.deflection().power()) * Math.pow(v, shape.speed().power());
        return 0.1 * force / size;
    }

    /** @param size of what multiplies it, root mean square; 1 for nothing */
    Hypothesis term(Shape shape, Modulator modulator, double size) {
        double unit = unit(shape) / size;
        return hypothesis(new LearnedTerm(shape, modulator, unit), unit, List.of(), List.of(Start.scaled(unit)));
    }

    Hypothesis knee(Shape of, Law.Side side) {
        double rms = of.equals(Shape.SPEED) ? v : r;
        double unit = unit(of);
        return hypothesis(new LearnedKnee(of, side, Modulator.NONE, unit, rms), unit,
                List.of(new Hypothesis.Number(of.equals(Shape.SPEED) ? "knee_m_per_s" : "knee_m", 0, 0.02 * rms, 6 * rms)),
                Arrays.stream(KNEES).mapToObj(q -> new Start(new double[] {unit, q * rms}, List.of(new int[] {0}))).toList());
    }

    Hypothesis thinning() {
        double unit = unit(Shape.SPEED);
        return hypothesis(new Learned.Thinning(unit, THINNING[0], v), unit,
                List.of(Hypothesis.Number.factor(LEAST_THINNING, MOST_THINNING).named("thinning"),
                        Hypothesis.Number.factor(KNEES[0] / 20 * v, 20 * KNEES[2] * v).named("speed_m_per_s")),
                Arrays.stream(THINNING).boxed().flatMap(n -> Arrays.stream(KNEES)
                        .mapToObj(q -> new Start(new double[] {unit, n, q * v}, List.of(new int[] {0})))).toList());
    }

    Hypothesis memory(Shape of, Shape shape, double[] times) {
        double unit = unit(shape) * unit(of) / unit(Shape.ONE);
        return hypothesis(new LearnedMemory(of, shape, Modulator.NONE, unit, times[0]), unit,
                List.of(new Hypothesis.Number("memory_s", 0, pace * SHORTEST, pace * 40)),
                Arrays.stream(times).mapToObj(time -> new Start(new double[] {unit, time}, List.of(new int[] {0}))).toList());
    }

    /** Forces up to three times the root mean square to either side: nearly all of a motion that is normal. */
    Hypothesis table(Shape of) {
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
        return new Hypothesis(new LearnedForce(), where, words(law), List.of(new Addition.InLink(link, law)),
                Hypothesis.Number.named(LearnedTable.class, numbers),
                List.of(new Start(start, IntStream.rangeClosed(1, TABLED).mapToObj(i -> new int[] {i}).toList())));
    }

    Hypothesis inertance() {
        return new LearnedForce().inertance(link, where, 0.1 * force * r / (v * v));
    }

    Hypothesis course(Shape shape, LearnedCourse.Course course, double[] times) {
        double unit = unit(shape);
        Hypothesis.Number time = course == LearnedCourse.Course.STEP
                ? new Hypothesis.Number("time_s", 0.02 * seconds, 0.02 * seconds, 0.98 * seconds)
                : new Hypothesis.Number("time_s", 0, 0.02 * seconds, 20 * seconds);
        return hypothesis(new LearnedCourse(shape, course, unit, times[0]), unit, List.of(time),
                Arrays.stream(times).mapToObj(at -> new Start(new double[] {unit, at}, List.of(new int[] {0}))).toList());
    }

    /** A sine and a cosine, which make a wave of any phase. */
    Hypothesis wave(Shape shape) {
        double unit = unit(shape);
        LearnedWave law = new LearnedWave(shape, unit, unit, SLOWEST);
        String tail = "_[" + law.unit() + "] of " + words(law);
        // Within half a line of its peak a wave's phase still runs away over the record: quarters of a line are near enough.
        double apart = Math.max(0.5 / seconds, (FASTEST - SLOWEST) / MOST_WAVES);
        List<Start> starts = IntStream.rangeClosed(0, (int) ((FASTEST - SLOWEST) / apart)).mapToObj(i -> new Start(
                new double[] {unit, unit, SLOWEST + i * apart}, List.of(new int[] {0}, new int[] {1}))).toList();
        return new Hypothesis(new LearnedForce(), where, words(law), List.of(new Addition.InLink(link, law)),
                List.of(new Hypothesis.Number("cosine" + tail, unit, -300 * unit, 300 * unit),
                        new Hypothesis.Number("sine" + tail, unit, -300 * unit, 300 * unit),
                        new Hypothesis.Number("frequency_hz", 0.01, 0.5 * SLOWEST, 2 * FASTEST)),
                starts);
    }

    private Hypothesis hypothesis(Learned law, double unit, List<Hypothesis.Number> further, List<Start> starts) {
        List<Hypothesis.Number> numbers = new ArrayList<>(List.of(new Hypothesis.Number(key(law), unit, -300 * unit, 300 * unit)));
        numbers.addAll(further);
        return new Hypothesis(new LearnedForce(), where, words(law), List.of(new Addition.InLink(link, law)), numbers, starts);
    }

    /**
     * A term whose modulator has a limit, to begin with at twice its root mean square.
     *
     * @param unit of its coefficient
     * @param size of the modulator, root mean square
     */
    Hypothesis limited(LearnedTerm law, double unit, double size) {
        return hypothesis(new LearnedLimited(law.shape(), law.modulator(), unit, 2 * size), unit,
                List.of(new Hypothesis.Number("limit_[" + law.modulator().unit() + "]", 0, 0.2 * size, 30 * size)),
                List.of(new Start(new double[] {unit, 2 * size}, List.of(new int[] {0}))));
    }

    /** A term in words: {@code |v|v × load of link 2}. */
    static String words(Learned law) {
        return law.kind() + (law.modulator() instanceof Modulator.None ? "" : " × " + law.modulator());
    }

    private static String key(Learned law) {
        return ModelFile.COEFFICIENT + law.unit() + "] of " + words(law);
    }
}
