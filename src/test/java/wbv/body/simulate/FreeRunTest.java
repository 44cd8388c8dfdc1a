package wbv.body.simulate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import wbv.body.LawAt;
import wbv.body.Structure;
import wbv.body.law.AsymmetricSpring;
import wbv.body.law.Backlash;
import wbv.body.law.BendingSpring;
import wbv.body.law.BoucWen;
import wbv.body.law.BristleFriction;
import wbv.body.law.BumpStop;
import wbv.body.law.ContactLoss;
import wbv.body.law.CoulombFriction;
import wbv.body.law.CubicSpring;
import wbv.body.law.EngagingFriction;
import wbv.body.law.GasSpring;
import wbv.body.law.JenkinsElement;
import wbv.body.law.Law;
import wbv.body.law.Learned;
import wbv.body.law.LearnedInertance;
import wbv.body.law.LearnedKnee;
import wbv.body.law.LearnedLimited;
import wbv.body.law.LearnedMemory;
import wbv.body.law.LearnedTerm;
import wbv.body.law.LinkMotion;
import wbv.body.law.MaxwellArm;
import wbv.body.law.MuscleReflex;
import wbv.body.law.PolynomialSpring;
import wbv.body.law.ProgressiveSpring;
import wbv.body.law.QuadraticDamping;
import wbv.body.law.QuadraticSpring;
import wbv.body.law.Reflex;
import wbv.body.law.RoundedBacklash;
import wbv.body.law.RoundedContactLoss;
import wbv.body.law.Saturation.GradualSaturation;
import wbv.body.law.Saturation.PartialSaturation;
import wbv.body.law.Saturation.SaturatingSpring;
import wbv.body.law.Settling;
import wbv.body.law.Slider;
import wbv.body.law.SlowDrift;
import wbv.body.law.StepChange;
import wbv.body.number.Modulator;
import wbv.body.number.Numbers;
import wbv.body.number.Shape;

class FreeRunTest {

    private static final Structure CHAIN = new Structure(new int[] {-1, 0, 1}, new int[] {0, 1, 2},
            new double[] {90000, 75000, 20000}, new double[] {1300, 1500, 170}, new double[] {12, 45, 5.5});

    static Stream<Law> laws() {
        return Stream.of(new SaturatingSpring(1e-3), new GradualSaturation(1e-3, 1.3), new PartialSaturation(1e-3, 1.3, 0.4),
                new QuadraticSpring(2e6), new ProgressiveSpring(60000, 1e-3), new GasSpring(0.01),
                new PolynomialSpring(-2e6, 5e9), new EngagingFriction(60, 45, 6e-4, 2), new CubicSpring(-2e9), new CubicSpring(5e9),
                new AsymmetricSpring(0.6), new QuadraticDamping(8000), new CoulombFriction(30, 1e-3),
                new BristleFriction(30, 36, 0.005, 2e5), new BoucWen(0.4, 8e-4), new Slider(0.4, 8e-4), new JenkinsElement(3e4, 8e-4),
                new ContactLoss(60),
                new BumpStop(9e5, 4e-4, Law.Side.COMPRESSION), new Backlash(2e-4), new RoundedBacklash(2e-4, 1e-4, 0.4),
                new BendingSpring(0.6, 2e-4), new RoundedContactLoss(60, 5), new StepChange(1.2, 0.5, 0.7),
                new StepChange.Gradual(1.2, 0.5, 0.7, 0.8),
                new SlowDrift(20, -3, 0.5), new Settling(0.8, 0.4, 0.5), new MaxwellArm(40000, 0.05), new Reflex(20000, 300, 0.06),
                new MuscleReflex(20000, 900, 0.06, 0.05, Law.Side.EXTENSION),
                new MuscleReflex(5000, 2000, 0.04, 0.03, Law.Side.COMPRESSION),
                new MuscleReflex(20000, 900, 0.06, 0.05, Law.Side.BOTH),
                new LearnedTerm(Shape.parse("|v|v"), Modulator.NONE, 8000), new LearnedTerm(Shape.parse("r^2 v"), Modulator.NONE, 2e9),
                new LearnedTerm(Shape.parse("|r| sign(v)"), Modulator.NONE, 3e4),
                new LearnedTerm(Shape.parse("v+^2"), Modulator.NONE, 9000),
                new LearnedLimited(Shape.DEFLECTION, Modulator.NONE, -20000, 0.7),
                new LearnedKnee(Shape.SPEED, Law.Side.EXTENSION, Modulator.NONE, 900, 5e-3),
                new LearnedMemory(Shape.parse("|v|v"), Shape.ONE, Modulator.NONE, 9000, 0.05),
                new LearnedMemory(Shape.parse("v^2"), Shape.DEFLECTION, Modulator.NONE, -2e7, 0.5), new LearnedInertance(3),
                new Learned.Thinning(2000, 1.6, 0.02));
    }

    @ParameterizedTest
    @MethodSource("laws")
    void sensitivitiesEqualCentralDifferencesOfTheRun(Law law) {
        double step = 1 / 240.0;
        double[] base = excitation(720);
        List<LawAt> at = List.of(new LawAt(1, law));
        FreeRun.Run run = new FreeRun(CHAIN, at, step, true).run(base, new double[0][], true);
        double[] linear = CHAIN.values();
        double[] own = Numbers.values((Record) law);
        for (int p = 0; p < linear.length + own.length; p++) {
            double value = p < linear.length ? linear[p] : own[p - linear.length];
            double h = 1e-5 * Math.max(Math.abs(value), 1e-6);
            double[] high = force(law, p, h, base, step);
            double[] low = force(law, p, -h, base, step);
            double error = 0;
            double size = 0;
            for (int j = 0; j < base.length; j++) {
                double slope = (high[j] - low[j]) / (2 * h);
                error += Math.pow(slope - run.slope()[0][p][j], 2);
                size += slope * slope;
            }
            double tolerance = law instanceof CoulombFriction || law instanceof BumpStop || law instanceof ContactLoss
                    || law instanceof StepChange || law instanceof StepChange.Gradual ? 2e-2 : 1e-3;
            assertTrue(Math.sqrt(error) <= tolerance * Math.sqrt(size) + 1e-9 * Math.abs(1 / value),
                    law + " parameter " + p + ": " + Math.sqrt(error / size));
        }
    }

    @org.junit.jupiter.api.Test
    void sensitivitiesHoldWhereModesFallTogether() {
        // A head that only the law holds: two modes at zero, with one direction between them.
        Structure loose = new Structure(new int[] {-1, 0, 1}, new int[] {0, 1, 2}, new double[] {90000, 75000, 0},
                new double[] {1300, 1500, 0}, new double[] {12, 45, 5.5});
        double step = 1 / 240.0;
        double[] base = excitation(720);
        Law law = new MaxwellArm(20000, 0.02);
        FreeRun.Run run = new FreeRun(loose, List.of(new LawAt(2, law)), step, true).run(base, new double[0][], true);
        for (int p : new int[] {0, 4, 8}) {
            double[] values = loose.values();
            double h = 1e-5 * values[p];
            values[p] += h;
            double[] high = new FreeRun(loose.with(values), List.of(new LawAt(2, law)), step, false).run(base, new double[0][], false)
                    .force()[0];
            values[p] -= 2 * h;
            double[] low = new FreeRun(loose.with(values), List.of(new LawAt(2, law)), step, false).run(base, new double[0][], false)
                    .force()[0];
            double error = 0;
            double size = 0;
            for (int j = 0; j < base.length; j++) {
                double slope = (high[j] - low[j]) / (2 * h);
                error += Math.pow(slope - run.slope()[0][p][j], 2);
                size += slope * slope;
            }
            assertTrue(Math.sqrt(error) <= 1e-3 * Math.sqrt(size), "parameter " + p + ": " + Math.sqrt(error / size));
        }
    }

    @ParameterizedTest
    @MethodSource("laws")
    void halvingTheStepChangesLittle(Law law) {
        double[] coarse = new FreeRun(CHAIN, List.of(new LawAt(1, law)), 1 / 480.0, false).run(excitation(960), new double[0][], false)
                .force()[0];
        double[] fine = new FreeRun(CHAIN, List.of(new LawAt(1, law)), 1 / 1920.0, false)
                .run(upsampled(excitation(960), 4), new double[0][], false).force()[0];
        double error = 0;
        double size = 0;
        for (int j = 0; j < 960; j++) {
            error += Math.pow(coarse[j] - fine[4 * j], 2);
            size += fine[4 * j] * fine[4 * j];
        }
        assertTrue(error < 0.0025 * size, law + ": " + Math.sqrt(error / size));
    }

    private static double[] force(Law law, int p, double h, double[] base, double step) {
        double[] linear = CHAIN.values();
        double[] own = Numbers.values((Record) law);
        if (p < linear.length) {
            linear[p] += h;
        } else {
            own[p - linear.length] += h;
        }
        Law shifted = (Law) Numbers.with((Record) law, own);
        return new FreeRun(CHAIN.with(linear), List.of(new LawAt(1, shifted)), step, false).run(base, new double[0][], false).force()[0];
    }

    /** Laws of one link are found together; with one in another link, and one that goes by another link, they still answer each other. */
    @org.junit.jupiter.api.Test
    void lawsThatShareALinkAnswerEachOther() {
        List<LawAt> laws = List.of(new LawAt(1, new Slider(0.1, 2e-4)), new LawAt(0, new CubicSpring(4e9)),
                new LawAt(1, new Slider(0.1, 5e-4)),
                new LawAt(1, new QuadraticDamping(2000)), new LawAt(1,
                        new LearnedTerm(Shape.DEFLECTION, new Modulator.OtherLink(Modulator.Of.DEFLECTION, 2), 3e7)),
                new LawAt(2, new MaxwellArm(9000, 0.03)));
        double step = 1 / 240.0;
        double[] base = excitation(720);
        FreeRun run = new FreeRun(CHAIN, laws, step, true);
        FreeRun.Run whole = run.run(base, new double[0][], true);
        int p = CHAIN.parameters();
        for (int of = 0; of < laws.size(); of++) {
            for (int own = 0; own < Numbers.values((Record) laws.get(of).law()).length; own++, p++) {
                double h = 1e-5 * Numbers.values((Record) laws.get(of).law())[own];
                double[][] high = new FreeRun(CHAIN, with(laws, of, own, h), step, false).run(base, new double[0][], false).force();
                double[][] low = new FreeRun(CHAIN, with(laws, of, own, -h), step, false).run(base, new double[0][], false).force();
                for (int i = 0; i < laws.size(); i++) {
                    double error = 0;
                    double size = 0;
                    for (int j = 0; j < base.length; j++) {
                        double slope = (high[i][j] - low[i][j]) / (2 * h);
                        error += Math.pow(slope - whole.slope()[i][p][j], 2);
                        size += slope * slope;
                    }
                    assertTrue(error <= 1e-4 * size, "force " + i + ", number " + p + ": " + Math.sqrt(error / size));
                }
            }
        }
        // Two halves of a law are the law.
        double[][] halves = new FreeRun(CHAIN, List.of(new LawAt(1, new QuadraticDamping(4000)), new LawAt(1, new QuadraticDamping(4000))),
                step, false).run(base, new double[0][], false).force();
        double[] one = new FreeRun(CHAIN, List.of(new LawAt(1, new QuadraticDamping(8000))), step, false)
                .run(base, new double[0][], false).force()[0];
        for (int j = 0; j < base.length; j++) {
            assertEquals(one[j], halves[0][j] + halves[1][j], 1e-7);
        }
    }

    private static List<LawAt> with(List<LawAt> laws, int law, int own, double h) {
        List<LawAt> out = new java.util.ArrayList<>(laws);
        double[] numbers = Numbers.values((Record) laws.get(law).law());
        numbers[own] += h;
        out.set(law, new LawAt(laws.get(law).link(), (Law) Numbers.with((Record) laws.get(law).law(), numbers)));
        return out;
    }

    private static double[] excitation(int n) {
        double[] a = new double[n];
        Random random = new Random(5);
        double[] phase = random.doubles(40, 0, 2 * Math.PI).toArray();
        for (int j = 0; j < n; j++) {
            double t = j / 240.0;
            for (int k = 0; k < 40; k++) {
                a[j] += 0.3 * Math.cos(2 * Math.PI * (0.5 + 0.25 * k) * t + phase[k]);
            }
        }
        return a;
    }

    private static double[] upsampled(double[] a, int factor) {
        double[] out = new double[factor * (a.length - 1) + 1];
        for (int j = 0; j < out.length; j++) {
            int i = Math.min(j / factor, a.length - 2);
            double share = (double) j / factor - i;
            out[j] = a[i] * (1 - share) + a[i + 1] * share;
        }
        return out;
    }

    /** Far below its knee the progressive spring adds a cubic term, far beyond it a spring of the added stiffness. */
    @org.junit.jupiter.api.Test
    void aProgressiveSpringAddsNothingAtFirstAndAllOfItsStiffnessFarOut() {
        Law law = new ProgressiveSpring(60000, 1e-3);
        assertTrue(Math.abs(at(law, 1e-5)) < 0.01 * 60000 * 1e-5);
        assertEquals(60000, (at(law, 0.2) - at(law, 0.1)) / 0.1, 600);
        assertEquals(-at(law, 3e-3), at(law, -3e-3), 1e-12);
    }

    /** At the start nothing has changed, after τ all but 1/e has, in the end the stiffness is 1 + change times as great. */
    @org.junit.jupiter.api.Test
    void whatSettlesBeginsAtNothingAndEndsAtItsChange() {
        LinkMotion motion = new LinkMotion();
        motion.stiffness = 50000;
        motion.displacement = 1e-3;
        Law law = new Settling(-0.4, 20, 1);
        assertEquals(0, law.force(motion), 1e-12);
        motion.time = 20;
        assertEquals(-0.4 * (1 - Math.exp(-1)) * 50, law.force(motion), 1e-9);
        motion.time = 2000;
        assertEquals(-0.4 * 50, law.force(motion), 1e-9);
    }

    @org.junit.jupiter.api.Test
    void whatIsRoundWithAHardEdgeIsTheSharpLaw() {
        for (double r = -1e-3; r <= 1e-3; r += 1e-4) {
            assertEquals(at(new Backlash(3.5e-4), r), at(new RoundedBacklash(3.5e-4, 1e-9, 0.5), r), 1e-4);
            assertEquals(at(new AsymmetricSpring(0.6), r), at(new BendingSpring(0.6, 1e-9), r), 1e-4);
            assertEquals(at(new ContactLoss(35), r), at(new RoundedContactLoss(35, 1e-6), r), 1e-5);
        }
    }

    private static double at(Law law, double displacement) {
        LinkMotion motion = new LinkMotion();
        motion.stiffness = 90000;
        motion.displacement = displacement;
        return law.force(motion);
    }

    @org.junit.jupiter.api.Test
    void withoutAMassEffectAParallelSpringIsTheSpring() {
        // A Step long past is a stiffer link: the motion must be that of the stiffer linear structure.
        double step = 1 / 240.0;
        double[] base = excitation(720);
        double[] values = CHAIN.values();
        values[1] *= 1.3;
        values[4] *= 1.3;
        Law past = new StepChange(-10, 1.3, 1.3);
        double[] by = new FreeRun(CHAIN, List.of(new LawAt(1, past)), step, false).run(base, new double[0][], false).displacement()[0];
        double[] as = new FreeRun(CHAIN.with(values), List.of(new LawAt(1, new Backlash(0))), step, false)
                .run(base, new double[0][], false).displacement()[0];
        double error = 0;
        double size = 0;
        for (int j = 0; j < by.length; j++) {
            error += Math.pow(by[j] - as[j], 2);
            size += as[j] * as[j];
        }
        assertEquals(0, Math.sqrt(error / size), 5e-3);
    }
}
