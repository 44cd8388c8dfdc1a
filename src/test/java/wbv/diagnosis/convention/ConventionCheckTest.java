package wbv.diagnosis.convention;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import wbv.body.Model;
import wbv.diagnosis.convention.MeantRides.Extra;
import wbv.diagnosis.convention.MeantRides.Ride;
import wbv.recording.Channel;
import wbv.recording.DataFault;

/** Conventions that are amiss, and what looks a little like them, in simulated people and benches over seeds. */
class ConventionCheckTest {

    private static final double GRAVITY = 9.80665;
    private static final long[] SEEDS = {11, 12, 13};
    /** By how much what users give is off, in the logarithm. */
    private static final double OFF = 0.3;

    private record Case(String name, String said, Ride asRead, Ride meant) {}

    private static Stream<Case> amiss(long seed) {
        Ride person = MeantRides.person(seed, OFF, Extra.NONE);
        Ride bench = MeantRides.bench(seed, OFF, Extra.NONE);
        Ride pushed = MeantRides.pushed(seed, OFF, "pos", Extra.NONE);
        return Stream.of(
                new Case("a head's sensor upside down", "head.acc.z is of the other sign", person.times("head.acc.z", -1), person),
                new Case("a seat's sensor upside down", "seat.acc.z is of the other sign", person.times("seat.acc.z", -1), person),
                new Case("a base's sensor upside down", "platform.acc.z is of the other sign", person.times("platform.acc.z", -1), person),
                new Case("a trunk in g", "trunk.acc.z reads 0.102 times", person.times("trunk.acc.z", 1 / GRAVITY), person),
                new Case("a head in g, upside down", "head.acc.z reads 0.102 times what the model makes of it and is of the other sign",
                        person.times("head.acc.z", -1 / GRAVITY), person),
                new Case("a base in mm/s²", "platform.acc.z reads 1000 times", person.times("platform.acc.z", 1000), person),
                new Case("trunk and head exchanged", "trunk.acc.z and head.acc.z have", person.exchanged("trunk.acc.z", "head.acc.z"),
                        person),
                new Case("a person's masses in g", "the model's masses look to be in g", person.of(scaled(person.model(), 1, 1, 1000)),
                        person),
                new Case("a person's links in N/mm", "the model's stiffnesses and dampings look to be in N/mm",
                        person.of(scaled(person.model(), 1e-3, 1e-3, 1)), person),
                new Case("a load upside down", "load.acc.z is of the other sign", bench.times("load.acc.z", -1), bench),
                new Case("a frame in g", "frame.acc.z reads 0.102 times", bench.times("frame.acc.z", 1 / GRAVITY), bench),
                new Case("a table in mm/s²", "platform.acc.z reads 1000 times", bench.times("platform.acc.z", 1000), bench),
                new Case("a bench's stiffness in N/mm", "the model's stiffnesses look to be in N/mm",
                        bench.of(scaled(bench.model(), 1e-3, 1, 1)), bench),
                new Case("frame and load exchanged", "frame.acc.z and load.acc.z have", bench.exchanged("frame.acc.z", "load.acc.z"),
                        bench),
                new Case("a place in mm", "mass.pos.z reads 1000 times", pushed.times("mass.pos.z", 1000), pushed),
                new Case("a force in kN", "mass.force.z reads 0.001 times", pushed.times("mass.force.z", 1e-3), pushed),
                new Case("a force in kN, of the other sign", "mass.force.z reads 0.001 times what the model makes of it and is of",
                        pushed.times("mass.force.z", -1e-3), pushed));
    }

    /** What drove a simulation is as it was when the model was fitted to that, whatever it says: only the outputs are in question. */
    @Test
    void whatDroveASimulationIsNotInQuestion() {
        for (long seed : SEEDS) {
            Ride person = MeantRides.person(seed, OFF, Extra.NONE);
            Ride base = person.times("platform.acc.z", -1);
            Ride head = person.times("head.acc.z", -1);
            assertTrue(ConventionCheck.of(base.model(), base.recording(), true, false).map(Meant::sentence)
                    .filter(said -> said.contains("platform")).isEmpty());
            assertTrue(ConventionCheck.of(head.model(), head.recording(), true, false).isPresent());
        }
    }

    private static Model scaled(Model model, double stiffness, double damping, double mass) {
        return new Convention.InUnits("numbers", stiffness, damping, mass, "another unit").read(model);
    }

    static Stream<Arguments> seeds() {
        return Arrays.stream(SEEDS).mapToObj(Arguments::of);
    }

    @ParameterizedTest
    @MethodSource("seeds")
    @Tag("slow")
    void whatIsAmissIsFoundAndReadAsItIsMeant(long seed) {
        amiss(seed).forEach(each -> {
            String where = seed + ", " + each.name();
            Meant meant = asked(each.asRead()).orElseThrow(() -> new AssertionError(where + ": nothing was asked"));
            assertTrue(meant.sentence().startsWith(each.said()), where + ": " + meant.sentence());
            each.meant().recording().channels().forEach(channel -> assertArrayEquals(each.meant().recording().values(channel),
                    meant.recording().values(channel), 1e-9 * 1000, where));
            Model model = meant.model().apply(each.asRead().model());
            assertArrayEquals(each.meant().model().assembly().structure().values(), model.assembly().structure().values(), 1e-6, where);
            assertEquals(Optional.empty(), ConventionCheck.of(model, meant.recording(), true, true).map(Meant::sentence), where);
        });
    }

    private static Stream<Case> twice(long seed) {
        Ride person = MeantRides.person(seed, OFF, Extra.NONE);
        Ride bench = MeantRides.bench(seed, OFF, Extra.NONE);
        Ride pushed = MeantRides.pushed(seed, OFF, "pos", Extra.NONE);
        return Stream.of(
                new Case("a bench's links in N/mm, its sensors exchanged", "", bench.exchanged("frame.acc.z", "load.acc.z")
                        .of(scaled(bench.model(), 1e-3, 1e-3, 1)), bench),
                new Case("a person's masses in g, trunk and head exchanged", "", person.exchanged("trunk.acc.z", "head.acc.z")
                        .of(scaled(person.model(), 1, 1, 1000)), person),
                new Case("a person's links in N/mm, base and seat exchanged", "", person.exchanged("platform.acc.z", "seat.acc.z")
                        .of(scaled(person.model(), 1e-3, 1e-3, 1)), person),
                new Case("a bench's table upside down, its stiffness in N/mm", "", bench.times("platform.acc.z", -1)
                        .of(scaled(bench.model(), 1e-3, 1, 1)), bench),
                new Case("a force in kN, stiffness in N/mm", "", pushed.times("mass.force.z", 1e-3)
                        .of(scaled(pushed.model(), 1e-3, 1, 1)), pushed));
    }

    /** Of two that hide each other neither agrees alone. */
    @ParameterizedTest
    @MethodSource("seeds")
    @Tag("slow")
    void whatIsAmissTwiceIsFound(long seed) {
        twice(seed).forEach(each -> {
            String where = seed + ", " + each.name();
            Ride read = each.asRead();
            StringBuilder said = new StringBuilder();
            for (Optional<Meant> meant = asked(read); meant.isPresent(); meant = asked(read)) {
                read = new Ride(meant.get().model().apply(read.model()), meant.get().recording());
                said.append(meant.get().sentence()).append('\n');
            }
            Ride found = read;
            each.meant().recording().channels().forEach(channel -> assertArrayEquals(each.meant().recording().values(channel),
                    found.recording().values(channel), 1e-6, where + ": " + said));
            assertArrayEquals(each.meant().model().assembly().structure().values(), found.model().assembly().structure().values(), 1e-6,
                    where + ": " + said);
        });
    }

    private static Optional<Meant> asked(Ride ride) {
        return ConventionCheck.of(ride.model(), ride.recording(), true, true);
    }

    record Named(String name, Ride ride) {}

    static Stream<Named> asRead(long seed) {
        List<Extra> laws = List.of(Extra.NONE, (r, v) -> r < -0.001 ? 8e5 * (r + 0.001) : 0, (r, v) -> r > 0.0005 ? 3e6 * (r - 0.0005) : 0,
                (r, v) -> Math.abs(r) < 0.0008 ? -68e3 * r : -68e3 * 0.0008 * Math.signum(r), (r, v) -> 60 * Math.tanh(v / 0.002),
                (r, v) -> 3e11 * r * r * r, (r, v) -> v > 0 ? 1500 * v : 0);
        List<Extra> small = List.of(Extra.NONE, (r, v) -> r < -0.0005 ? 8e4 * (r + 0.0005) : 0, (r, v) -> Math.abs(r) < 0.001
                ? -7800 * r : -7.8 * Math.signum(r), (r, v) -> 4 * Math.tanh(v / 0.002), (r, v) -> 3e9 * r * r * r);
        Ride person = MeantRides.person(seed, OFF, Extra.NONE);
        Ride bench = MeantRides.bench(seed, OFF, Extra.NONE);
        Channel head = Channel.parse("head.acc.z");
        Channel load = Channel.parse("load.acc.z");
        UnaryOperator<double[]> late = x -> shifted(x, 2);
        return Stream.of(laws.stream().map(law -> new Named("person, law " + laws.indexOf(law), MeantRides.person(seed, OFF, law))),
                small.stream().map(law -> new Named("bench, law " + small.indexOf(law), MeantRides.bench(seed, OFF, law))),
                small.stream().map(law -> new Named("pushed, law " + small.indexOf(law), MeantRides.pushed(seed, OFF, "pos", law))),
                Stream.of(new Named("person, numbers off by three", MeantRides.person(seed, 1.1, Extra.NONE)),
                        new Named("bench, numbers off by three", MeantRides.bench(seed, 1.1, Extra.NONE)),
                        new Named("pushed, numbers off by three", MeantRides.pushed(seed, 1.1, "acc", Extra.NONE)),
                        new Named("a gain of 0.8", person.times("head.acc.z", 0.8)), new Named("a gain of 3", bench.times("load.acc.z", 3)),
                        new Named("a late head", person.reading(head, late)), new Named("a late load", bench.reading(load, late)),
                        new Named("a clipped head", person.reading(head, x -> Arrays.stream(x).map(a -> Math.max(-1, Math.min(1, a)))
                                .toArray())),
                        new Named("a load without a sign", bench.reading(load, x -> Arrays.stream(x).map(Math::abs).toArray())),
                        new Named("a noisy head", person.reading(head, x -> noisy(x, 3, seed)))))
                .flatMap(each -> each);
    }

    private static double[] shifted(double[] x, int by) {
        double[] out = new double[x.length];
        System.arraycopy(x, 0, out, by, x.length - by);
        return out;
    }

    private static double[] noisy(double[] x, double size, long seed) {
        Random random = new Random(seed);
        return Arrays.stream(x).map(value -> value + size * random.nextGaussian()).toArray();
    }

    /** Other laws, other numbers and other faults are none of sign, unit or name. */
    @ParameterizedTest
    @MethodSource("seeds")
    @Tag("slow")
    void nothingElseIsAsked(long seed) {
        asRead(seed).forEach(each -> assertEquals(Optional.empty(), asked(each.ride()).map(Meant::sentence), seed + ", " + each.name()));
    }

    @ParameterizedTest
    @MethodSource("seeds")
    void aSensorThatCarriesNothingIsLeftOut(long seed) {
        Ride person = MeantRides.person(seed, OFF, Extra.NONE);
        Meant meant = asked(person.reading(Channel.parse("head.acc.z"), x -> noisy(new double[x.length], 0.3, seed))).orElseThrow();
        assertTrue(meant.sentence().startsWith("head.acc.z carries nothing of the motion"), meant.sentence());
        assertEquals(List.of("seat.acc.z", "trunk.acc.z"),
                meant.model().apply(person.model()).outputs().stream().map(Channel::toString).toList());
    }

    @Test
    void aBenchWhoseInputCarriesNothingIsRefused() {
        Ride bench = MeantRides.bench(5, OFF, Extra.NONE);
        Ride silent = bench.reading(Channel.parse("platform.acc.z"), x -> noisy(new double[x.length], 0.5, 50));
        String said = assertThrows(DataFault.class, () -> asked(silent)).getMessage();
        assertEquals("no more of what the model's sensors measured goes with platform.acc.z than chance gives: is it the right input, "
                + "connected, and on the same clock?", said);
    }

    /** A force of one size goes with no speed that has lost its sign, but what the model makes of it does. */
    @ParameterizedTest
    @MethodSource("seeds")
    void aSpeedWithoutASignUnderABinarySequenceIsNotRefused(long seed) {
        assertEquals(Optional.empty(), asked(MeantRides.switched(seed)).map(Meant::sentence));
    }

    /** What its user said of the units is not doubted; a sign is. */
    @Test
    void unitsThatWereSaidAreNotAskedFor() {
        Ride pushed = MeantRides.pushed(3, OFF, "pos", Extra.NONE);
        Ride large = pushed.times("mass.pos.z", 1000);
        assertEquals(Optional.empty(), ConventionCheck.of(large.model(), large.recording(), false, true).map(Meant::sentence));
        Ride turned = pushed.times("mass.pos.z", -1);
        assertTrue(ConventionCheck.of(turned.model(), turned.recording(), false, true).isPresent());
    }
}
