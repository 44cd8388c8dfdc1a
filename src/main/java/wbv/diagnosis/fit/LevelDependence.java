package wbv.diagnosis.fit;

import java.util.Arrays;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import wbv.diagnosis.measured.Coherence;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/**
 * How the level of a force follows that of the motion from block to block: that of everything does which the ride causes. A ride need not
 * have levels for it: what narrow bands make of noise, a body on its cushion foremost, swells and fades by itself.
 *
 * @param slope in logarithms: 0 not at all, 1 in proportion; infinite where other motion of the recording explains the force
 * @param doubt standard deviation of the slope [1]; infinite where the motion has one level or is short
 * @param least what it may be at least [1] while the motion is small, where what does not follow shows beside what does
 */
public record LevelDependence(double slope, double doubt, double least) {

    private static final double FOLLOWING = 0.5;
    /**
     * Between what causes of their own follow by and what laws of a link do [1]: of concealed ones on platforms and roads 52 forces had
     * -0.26 to 0.34, 92 laws 0.37 to 3.0, of which one less than this.
     */
    private static final double INDEPENDENT = 0.4;
    private static final double PROPORTION = 1;
    /**
     * Length of a block [s]: longer than a body on a cushion remembers, shorter than its motion swells. Of 102 forces and laws on
     * roads, with blocks of 0.5 and of 2 s, slopes agree within two of their doubts in 101, and the shortest leave the least doubt: 0.11,
     * with 1 and 2 s 0.16 and 0.20.
     */
    private static final double BLOCK = 0.5;
    private static final int FEWEST = 5;
    /** Part of its mean power below which a motion counts as rest [1]. */
    private static final double REST = 1e-6;
    /** Steps of a fit: an effort. */
    private static final int ROUNDS = 30;
    /** Bound of slopes [1], so that a fit of a few blocks ends: as high as the steepest law was found. */
    private static final double LARGEST = 3;
    /** Standard deviations that a normal deviate passes once in a thousand times [1]. */
    private static final double EXCLUDED = 3.1;
    /**
     * Part of its power [1] that goes with a series from which on a force is taken to answer to it. Of the forces of 39 people who sat
     * still on a platform or a road, simulated, 0 to 0.21 went with the base, nothing sure of 24; of those of a mass that no sensor saw,
     * 0.45 to 0.92 of eight in nine.
     */
    static final double COHERENT = 0.35;

    /**
     * @param force spectrum at the window's lines [N]
     * @param telling the same, each line weighed by what it tells of the force's level
     * @param noise part of the power of that, on average, that is noise
     * @param motion power of what moves where the force acts, of any unit, by sample of the recording
     */
    static LevelDependence of(Evidence evidence, Window window, double[] force, double[] telling, double noise, double[] motion) {
        if (answers(evidence, window, window.series(force))) {
            return new LevelDependence(Double.POSITIVE_INFINITY, 0, Double.POSITIVE_INFINITY);
        }
        double[] series = window.series(telling);
        int block = (int) (BLOCK * evidence.recording().clock().rate());
        // Where nothing was measured no force shows; at both ends the taper hides it.
        int[] starts = IntStream.range(1, window.length() / block - 1).map(b -> b * block)
                .filter(start -> measured(evidence, window.start() + start, block)).toArray();
        double[] moved = sums(starts, block, i -> motion[window.start() + i]);
        double[] power = sums(starts, block, i -> series[i] * series[i]);
        double hidden = noise * Arrays.stream(power).average().orElse(0);
        double middle = Arrays.stream(moved).sorted().skip(moved.length / 2).findFirst().orElse(0);
        int[] quiet = IntStream.range(0, moved.length).filter(b -> moved[b] < middle).toArray();
        LevelDependence small = following(Arrays.stream(quiet).mapToDouble(b -> power[b]).toArray(),
                Arrays.stream(quiet).mapToDouble(b -> moved[b]).toArray(), hidden);
        LevelDependence all = following(power, moved, hidden);
        return new LevelDependence(all.slope(), all.doubt(), Math.min(all.least(), small.least()));
    }

    /** What a slope and its doubt exclude; a doubt of more than 1 excludes nothing that occurs. */
    private static LevelDependence of(double slope, double doubt) {
        return new LevelDependence(slope, doubt, slope - EXCLUDED * Math.min(doubt, 1));
    }

    private static double[] sums(int[] starts, int block, IntToDoubleFunction sample) {
        return Arrays.stream(starts).mapToDouble(from -> IntStream.range(from, from + block).mapToDouble(sample).sum()).toArray();
    }

    private static boolean measured(Evidence evidence, int from, int length) {
        return IntStream.range(0, evidence.outputs().size()).anyMatch(o -> {
            boolean[] valid = evidence.valid(o);
            return 2 * IntStream.range(from, from + length).filter(i -> valid[i]).count() > length;
        });
    }

    /**
     * The power p of a force by block as noise and A m^s of the motion's power m: a generalised linear model of gamma distributed powers,
     * their dispersion as found (McCullagh and Nelder 1989, chapter 8), by Fisher scoring.
     *
     * @param power of the force by block, noise included, of any unit
     * @param motion its power by block, of any unit
     * @param noise in the force's power
     */
    static LevelDependence following(double[] power, double[] motion, double noise) {
        double rest = REST * Arrays.stream(motion).average().orElse(0);
        double[] x = Arrays.stream(motion).map(m -> Math.log(m + rest)).toArray();
        double middle = Arrays.stream(x).average().orElse(0);
        double level = Math.log(Math.max(Arrays.stream(power).average().orElse(0) - noise, noise / LARGEST));
        double slope = 0;
        double doubt = Double.POSITIVE_INFINITY;
        for (int round = 0; round < ROUNDS && power.length >= FEWEST; round++) {
            double aa = 0;
            double ab = 0;
            double bb = 0;
            double a = 0;
            double b = 0;
            double square = 0;
            for (int i = 0; i < x.length; i++) {
                double own = Math.exp(level + slope * (x[i] - middle));
                double by = own / (own + noise);
                double left = power[i] / (own + noise) - 1;
                aa += by * by;
                ab += by * by * (x[i] - middle);
                bb += by * by * (x[i] - middle) * (x[i] - middle);
                a += by * left;
                b += by * left * (x[i] - middle);
                square += left * left;
            }
            double told = bb - ab * ab / aa;
            double step = told > 0 ? (b - a * ab / aa) / told : 0;
            double next = Math.max(-LARGEST, Math.min(LARGEST, slope + Math.max(-1, Math.min(1, step))));
            level += Math.max(-1, Math.min(1, (a - ab * (next - slope)) / aa));
            slope = next;
            doubt = Math.sqrt(square / (x.length - 2) / told);
        }
        // Motion of one level tells nothing, nor do a few blocks: then only the size speaks.
        return doubt < Double.POSITIVE_INFINITY ? of(slope, doubt) : of(0, Double.POSITIVE_INFINITY);
    }

    /** Whether any other channel of the recording explains a good part of the force: then something couples it in, and nobody pushes. */
    private static boolean answers(Evidence evidence, Window window, double[] force) {
        return evidence.recording().channels().stream().anyMatch(channel -> {
            boolean along = channel.axis() == evidence.model().axis() && channel.quantity() == Quantity.ACCELERATION;
            // Motion along the model's own axis answers the force itself.
            return !along && channel.quantity() != Quantity.QUATERNION && channel.quantity() != Quantity.MAGNETIC_FIELD
                    && with(evidence, channel, window, force) > COHERENT;
        });
    }

    /**
     * Share of a force's power that goes with what moves the base, 0 to 1; 0 where that is not sure.
     *
     * @param force by sample of the window [N]. Not modified.
     */
    static double withBase(Evidence evidence, Window window, double[] force) {
        return evidence.model().base().sensor().map(sensor -> with(evidence, sensor, window, force)).orElse(0.0);
    }

    private static double with(Evidence evidence, Channel channel, Window window, double[] force) {
        double[] series = Arrays.copyOfRange(evidence.series(channel), window.start(), window.start() + force.length);
        Coherence found = Coherence.of(evidence.recording().clock().rate(), series, force, Coherence.Weight.OUTPUT);
        return found.isSure() ? found.share() : 0;
    }

    /** Whether the force is an answer to other motion that was measured. */
    boolean isAnswer() {
        return slope == Double.POSITIVE_INFINITY;
    }

    /** Whether the motion has levels enough to tell. */
    public boolean isTold() {
        return doubt < FOLLOWING;
    }

    /** Whether it is not ruled out that it hardly follows: beside what the ride causes there may be what it does not. */
    boolean mayBeWeak() {
        return least < FOLLOWING;
    }

    /** Whether it is known not to follow by as much as half. */
    public boolean isSteady() {
        return slope + 2 * doubt < FOLLOWING;
    }

    /** Whether it hardly follows, and not in proportion. */
    boolean isWeak() {
        return slope < INDEPENDENT && slope + 2 * doubt < PROPORTION;
    }

    /** Whether it is known not to follow in proportion, nor by as much as half beside what the ride may cause. */
    boolean mayStandAlone() {
        return slope + 2 * doubt < PROPORTION && mayBeWeak();
    }

    /** Whether it is known to follow hardly at all. */
    boolean isSurelyWeak() {
        return Math.abs(slope) + doubt < INDEPENDENT;
    }
}
