package wbv.body.law;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.body.Assembly;
import wbv.body.LawAt;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.body.Spectra;
import wbv.body.Structure;
import wbv.body.number.Modulator;
import wbv.body.number.Shape;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.ModulatorSeries;
import wbv.body.simulate.Simulator;
import wbv.recording.Channel;
import wbv.recording.DataFault;

class LearnedLawTest {

    private static final double RATE = 60;
    private static final Structure CHAIN = new Structure(new int[] {-1, 0}, new int[] {0, 1}, new double[] {60000, 40000},
            new double[] {900, 700}, new double[] {20, 40});

    private static final ModulatorSeries.Links STILL = new ModulatorSeries.Links() {
        @Override
        public double[] load(int link) {
            return new double[0];
        }

        @Override
        public double[] displacement(int link) {
            return new double[0];
        }

        @Override
        public double[] velocity(int link) {
            return new double[0];
        }
    };

    @ParameterizedTest
    @CsvSource({"1, 1", "r, -2", "|v|v, 9", "r^2 v, 12", "|r| sign(v), 2", "r- v, -6", "r+ v, 0", "v+^2, 9", "v-^2, 0", "r v, -6",
        "r^3, -8", "sign(r) |v|, -3", "|r|r |v|v, -36"})
    void aShapeIsTheProductOfItsPowers(String text, double expected) {
        Shape shape = Shape.parse(text);
        assertEquals(expected, shape.of(-2, 3), 1e-6);
        assertEquals(text, shape.toString());
    }

    @ParameterizedTest
    @ValueSource(strings = {"v^4", "r r", "", "v r v", "sin(r)"})
    void whatIsNoShapeIsRefused(String text) {
        assertTrue(assertThrows(IllegalArgumentException.class, () -> Shape.parse(text)).getMessage().contains("is no shape of a law"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"1", "value of head.acc.x", "angle of torso.gyr.y", "lean of head.acc.x from platform.acc.x", "ride over 2.5 s",
        "load of link 2", "deflection of link 1", "negative part of the speed of link 3", "magnitude of the value of head.acc.x"})
    void aModulatorIsReadAsItIsWritten(String text) {
        assertEquals(text, Modulator.parse(text).toString());
    }

    @ParameterizedTest
    @CsvSource({"angle of head.acc.x, no angular rate", "lean of head.acc.x from head.acc.y, not along one axis",
        "load of link 0, count from 1", "ride over soon s, no number", "moon, modulates nothing"})
    void whatModulatesNothingIsRefused(String text, String why) {
        assertTrue(assertThrows(IllegalArgumentException.class, () -> Modulator.parse(text)).getMessage().contains(why));
    }

    /** The library's own laws say the same things in their own words. */
    @Test
    void termsDoWhatTheLibrarysLawsDo() {
        Excitation excitation = excitation(30, 1);
        same(excitation, new QuadraticDamping(4000), new LearnedTerm(Shape.parse("|v|v"), Modulator.NONE, 4000), 1e-9);
        same(excitation, new CubicSpring(3e9), new LearnedTerm(Shape.parse("r^3"), Modulator.NONE, 3e9), 1e-9);
        same(excitation, new StepChange(12, 0.7, 1), new LearnedCourse(Shape.DEFLECTION, LearnedCourse.Course.STEP, -0.3 * 40000, 12),
                1e-3);
        same(excitation, new BumpStop(2e5, 1e-3, Law.Side.EXTENSION),
                new LearnedKnee(Shape.DEFLECTION, Law.Side.EXTENSION, Modulator.NONE, 2e5, 1e-3), 1e-9);
        // A spring and a dashpot in series remember the velocity.
        same(excitation, new MaxwellArm(20000, 0.05), new LearnedMemory(Shape.SPEED, Shape.ONE, Modulator.NONE, 20000 * 0.05, 0.05), 2e-3);
    }

    @Test
    void anInertanceIsMassBetweenTheEndsOfALink() {
        // On the base an inertance b moves a body as if it were heavier by b, but b drives it too: (m + b) q'' + c q' + k q = -m a.
        Structure one = new Structure(new int[] {-1}, new int[] {0}, new double[] {40000}, new double[] {800}, new double[] {50});
        Structure heavier = new Structure(new int[] {-1}, new int[] {0}, new double[] {40000}, new double[] {800}, new double[] {60});
        Excitation excitation = excitation(30, 1);
        Excitation less = excitation(30, 50.0 / 60);
        double[] with = stretch(excitation, one, new LearnedInertance(10));
        double[] expected = stretch(less, heavier, new LearnedInertance(0));
        assertTrue(difference(with, expected) < 1e-9, "" + difference(with, expected));
        // Beside a law that is not linear it runs freely, to the step's own accuracy.
        double[] free = new Simulator(excitation).run(new Assembly(one, List.of(new LawAt(0, new LearnedInertance(10)),
                new LawAt(0, new LearnedTerm(Shape.parse("r^3"), Modulator.NONE, 1e-3))), List.of(), List.of()), false).stretch()[0];
        assertTrue(difference(free, expected) < 0.01, "" + difference(free, expected));
    }

    /** A channel that is a square wave multiplies by that: what a step changes and changes back. */
    @Test
    void aModulatedStiffnessIsThatOfAnotherChannel() {
        double[] half = new double[(int) (30 * RATE)];
        java.util.Arrays.fill(half, 0, half.length / 2, 0.5);
        java.util.Arrays.fill(half, half.length / 2, half.length, -0.5);
        Channel channel = Channel.parse("head.acc.x");
        Excitation excitation = new Excitation(RATE, base(30, 1), Map.of(channel, half));
        double[] with = stretch(excitation, CHAIN, new LearnedTerm(Shape.DEFLECTION, new Modulator.Measured(channel), -24000));
        Structure softer = CHAIN.with(new double[] {60000, 28000, 900, 700, 20, 40});
        double[] expected = stretch(excitation, softer, new StepChange(15, 52000.0 / 28000, 1));
        assertTrue(difference(with, expected) < 0.02, "" + difference(with, expected));
    }

    /** A turn of 4 degrees at 0.7 Hz is read as such from its rate, whatever the sensor's offset. */
    @Test
    void anAngleIsTheIntegralOfItsRate() {
        Channel rate = Channel.parse("torso.gyr.y");
        double[] measured = new double[(int) (60 * RATE)];
        java.util.Arrays.setAll(measured, i -> 0.07 * 2 * Math.PI * 0.7 * Math.cos(2 * Math.PI * 0.7 * i / RATE) + 0.01);
        Excitation excitation = new Excitation(RATE, base(60, 1), Map.of(rate, measured));
        double[] angle = new ModulatorSeries(excitation, STILL).of(new Modulator.Angle(rate));
        int fine = (int) Math.round(1 / (RATE * excitation.fineStep()));
        for (int i = (int) (20 * RATE * fine); i < 40 * RATE * fine; i += 7) {
            assertEquals(0.07 * Math.sin(2 * Math.PI * 0.7 * i / RATE / fine), angle[i], 0.004);
        }
    }

    @Test
    void aLoadIsThatOfTheMotionThatItMakes() {
        Excitation excitation = excitation(20, 1);
        // The load of the upper link, as a force in the lower one: linear, so that the chain's own equations say what must come out.
        Assembly assembly = new Assembly(CHAIN,
                List.of(new LawAt(0, new LearnedTerm(Shape.ONE, new Modulator.OtherLink(Modulator.Of.LOAD, 1), 0.8))), List.of(),
                List.of());
        Simulator.Response response = new Simulator(excitation).run(assembly, false);
        double[] stretch = response.stretch()[1];
        double[] load = Spectra.timesJOmega(excitation.omega(), stretch);
        for (int i = 0; i < load.length; i++) {
            load[i] = 0.8 * (700 * load[i] + 40000 * stretch[i]);
        }
        assertTrue(difference(response.forces()[0], load) < 0.01, "" + difference(response.forces()[0], load));
    }

    @Test
    void aTableHasItsForcesAndStraightLinesBetween() {
        LearnedTable table = new LearnedTable(Shape.DEFLECTION, 0.01, -9, -4, -1, 2, 6, 12);
        double[] at = {-0.05, -0.03, -0.02, -0.015, -0.01, -0.004, 0, 0.005, 0.01, 0.02, 0.025, 0.03, 0.05};
        double[] forces = {-9, -9, -4, -2.5, -1, -0.4, 0, 1, 2, 6, 9, 12, 12};
        for (int i = 0; i < at.length; i++) {
            assertEquals(forces[i], table.series(new double[] {at[i], at[i]}, new double[2], 0, 0, 1e-3, new double[0])[1], 1e-9,
                    "at " + at[i]);
        }
        same(excitation(20, 1), new LearnedTerm(Shape.DEFLECTION, Modulator.NONE, 3000),
                new LearnedTable(Shape.DEFLECTION, 0.1, -900, -600, -300, 300, 600, 900), 1e-9);
    }

    @Test
    void aModelWithALearnedLawReadsAsItWasWritten() {
        Channel head = Channel.parse("head.acc.x");
        Channel platform = Channel.parse("platform.acc.x");
        List<Law> laws = List.of(new LearnedTerm(Shape.parse("r^2 v"), new Modulator.Lean(head, platform), -12.5),
                new LearnedKnee(Shape.SPEED, Law.Side.COMPRESSION, Modulator.NONE, 300, 0.02),
                new LearnedMemory(Shape.parse("v^2"), Shape.DEFLECTION,
                        new Modulator.Ride(2.5), -2e5, 4),
                new LearnedInertance(1.5), new LearnedLimited(Shape.DEFLECTION, new Modulator.Angle(Channel.parse("head.gyr.y")), 4e4, 0.1),
                new LearnedCourse(Shape.SPEED, LearnedCourse.Course.SETTLING, 90, 20),
                new LearnedWave(Shape.DEFLECTION, 1000, -200, 0.25), new LearnedTable(Shape.SPEED, 0.05, -30, -10, -2, 3, 12, 40),
                new LearnedTerm(Shape.parse("sign(v)"),
                        new Modulator.PartOf(Modulator.Part.NEGATIVE, new Modulator.OtherLink(Modulator.Of.LOAD, 1)), 0.3));
        Model model = model(laws);
        assertEquals(model, ModelFile.parse(ModelFile.text(model), "model.json"));
        String wrong = ModelFile.text(model).replace("r^2 v", "r^2 w");
        assertTrue(assertThrows(DataFault.class, () -> ModelFile.parse(wrong, "model.json")).getMessage()
                .contains("laws[0]: 'r^2 w' is no shape of a law"));
        assertTrue(assertThrows(IllegalArgumentException.class,
                () -> model(List.of(new LearnedTerm(Shape.DEFLECTION, new Modulator.OtherLink(Modulator.Of.LOAD, 7), 1))))
                .getMessage().contains("load of link 8; there are 2 links"));
    }

    private static Model model(List<Law> laws) {
        return new Model("learned", Optional.empty(), 'z', new Model.Base("platform", Optional.of(Channel.parse("platform.acc.z"))),
                List.of(new Model.Body("seat", 20, Optional.empty(), List.of(), Optional.empty(), List.of()),
                        new Model.Body("torso", 40, Optional.of(Channel.parse("torso.acc.z")), List.of(), Optional.empty(), List.of())),
                List.of(new Model.Link("platform", "seat", 60000, 900, Optional.empty(), laws, List.of(), List.of()),
                        new Model.Link("seat", "torso", 40000, 700, Optional.empty(), List.of(), List.of(), List.of())));
    }

    private static void same(Excitation excitation, Law known, Law learned, double tolerance) {
        double error = difference(stretch(excitation, CHAIN, learned), stretch(excitation, CHAIN, known));
        assertTrue(error < tolerance, learned + " is not " + known + ": " + error);
    }

    private static double[] stretch(Excitation excitation, Structure structure, Law law) {
        return new Simulator(excitation)
                .run(new Assembly(structure, List.of(new LawAt(structure.links() - 1, law)), List.of(), List.of()), false)
                .stretch()[structure.links() - 1];
    }

    private static double difference(double[] x, double[] y) {
        double error = IntStream.range(2, x.length).mapToDouble(i -> (x[i] - y[i]) * (x[i] - y[i])).sum();
        return Math.sqrt(error / IntStream.range(2, y.length).mapToDouble(i -> y[i] * y[i]).sum());
    }

    private static Excitation excitation(double seconds, double level) {
        return new Excitation(RATE, base(seconds, level), Map.of());
    }

    /** Random to 10 Hz, from rest to rest. */
    private static double[] base(double seconds, double level) {
        Random random = new Random(5);
        double[] out = new double[(int) (seconds * RATE)];
        double slow = 0;
        for (int i = 0; i < out.length; i++) {
            slow += 0.6 * (random.nextGaussian() - slow);
            out[i] = level * 2 * slow * Math.sin(Math.PI * i / out.length);
        }
        return out;
    }
}
