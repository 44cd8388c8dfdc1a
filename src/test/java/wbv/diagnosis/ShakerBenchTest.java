package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.function.DoubleBinaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.Recording;

/** A mass of 0.5 kg on a shaker whose acceleration is measured, simulated here with code of its own. */
class ShakerBenchTest {

    private static final Channel TABLE = Channel.parse("table.acc.z");
    private static final Channel MASS = Channel.parse("mass.acc.z");
    private static final double KILOGRAMS = 0.5;
    private static final double RATIO = 0.03;

    /** A sixth more stiffness at the usual deflection; the search goes astray at times, as of one seed here, where it finds a stop. */
    @Tag("slow")
    @Test
    void aCubicSpringIsNamedOfThreeSecondsAtAThousandHertz() {
        double cubic = 1e12;
        List<String> astray = new ArrayList<>();
        for (long seed = 1; seed <= 4; seed++) {
            Diagnosis d = diagnosed(model(80, "\"rig\""), bench(80, 1000, 3, cubic, seed));
            assertEquals(Model.Subject.RIG, d.model().subject());
            if (d.missing().stream().map(n -> n.mechanism() + " at " + n.where()).toList()
                    .equals(List.of("stiffness.hardening at table-mass"))) {
                // Nothing measures a force: the mass is held, and k3 is known as well as the mass is, which is given right here.
                assertEquals(cubic, d.missing().get(0).parameters().get("k3_N_per_m3"), 0.1 * cubic, d.sentence());
            } else {
                astray.add(seed + ": " + d.sentence());
            }
        }
        assertTrue(astray.size() <= 1, astray.toString());
    }

    /** Springs that engineers have, each written here as nothing of the library is, and a number by which it is known. */
    static Stream<Arguments> springs() {
        double k = stiffness(80);
        double c = damping(80);
        double usual = 1.45e-4;   // deflection, root mean square, of the spring alone [m]
        double column = 8 * usual;
        double bend = 0.3 * usual;
        return Stream.of(
                Arguments.of("contact.loss", "preload_N", 1.5 * k * usual,
                        (DoubleBinaryOperator) (r, v) -> Math.min(1.5 * k * usual, k * r + c * v)),
                Arguments.of("stiffness.hardening", "column_m", column,
                        (DoubleBinaryOperator) (r, v) -> c * v + k * column / 1.4 * (1 - Math.pow(column / (column + r), 1.4))),
                Arguments.of("stiffness.hardening", "knee_m", usual,
                        (DoubleBinaryOperator) (r, v) -> c * v + k * r + 1.5 * k * (r - r / (1 + r / usual * r / usual))),
                Arguments.of("stiffness.softening", "kept_share", 0.4,
                        (DoubleBinaryOperator) (r, v) -> c * v + 0.4 * k * r + 0.6 * k * usual * Math.tanh(r / usual)),
                Arguments.of("stiffness.asymmetric", "compression_ratio", 0.7,
                        (DoubleBinaryOperator) (r, v) -> c * v + k * r + 0.35 * k * (r - Math.hypot(r, bend) + bend)));
    }

    @Tag("slow")
    @ParameterizedTest
    @MethodSource("springs")
    void aSpringIsNamedWithItsNumber(String mechanism, String key, double value, DoubleBinaryOperator link) {
        Diagnosis d = diagnosed(model(80, "\"rig\""), bench(80, 4000, 3, link, 21));
        assertEquals(List.of(mechanism + " at table-mass"), d.missing().stream().map(n -> n.mechanism() + " at " + n.where()).toList(),
                d.sentence());
        assertEquals(value, d.missing().get(0).parameters().get(key), 0.1 * value, d.sentence());
    }

    /** 240 periods, and 2600 in 2.6 s. */
    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"80, 1000, 3, 5", "80, 1000, 3, 6", "80, 1000, 3, 7", "80, 1000, 3, 8", "1000, 8000, 2.6, 9"})
    void nothingIsNamedWhereNothingIsConcealed(double resonance, double rate, double seconds, long seed) {
        Diagnosis d = diagnosed(model(resonance, "\"rig\""), bench(resonance, rate, seconds, 0, seed));
        assertEquals(List.of(), d.missing(), d.sentence());
        assertTrue(d.verdict().isQuiet(), d.sentence());
    }

    @Test
    void undeclaredItIsTakenForAPerson() {
        Model model = model(80, "null");
        assertTrue(model.guess().orElseThrow().contains("person"), model.guess().toString());
        DataFault fault = assertThrows(DataFault.class, () -> diagnosed(model, bench(80, 1000, 3, 0, 1)));
        assertTrue(fault.getMessage().contains("at least 15 s"), fault.getMessage());
    }

    @Test
    void tooShortIsToldInPeriods() {
        DataFault fault = assertThrows(DataFault.class, () -> diagnosed(model(3, "\"rig\""), bench(80, 1000, 3, 0, 1)));
        assertTrue(fault.getMessage().contains("10 periods") && fault.getMessage().contains("3.51 s"), fault.getMessage());
    }

    @Test
    void whatIsDeclaredIsKept() {
        Model model = model(80, "\"rig\"");
        assertEquals(Optional.of(Model.Subject.RIG), model.declared());
        assertEquals(model, ModelFile.parse(ModelFile.text(model), "again"));
        assertEquals(model, model.seenBy(List.of(MASS)));
        assertEquals(Optional.empty(), model.guess());
    }

    @ParameterizedTest
    @CsvSource(delimiter = ';', value = {
        "\"subject\": \"person\", \"base\": {\"name\": \"ground\", \"sensor\": null}; \"inputs\": [{\"body\": \"mass\", \"sensor\": "
                + "\"mass.force.z\"}], ; mass.force.z",
        "\"subject\": \"seat\", \"base\": {\"name\": \"ground\", \"sensor\": \"table.acc.z\"}; ; person, rig"})
    void whatCannotBeIsToldInOneLine(String head, String inputs, String told) {
        DataFault fault = assertThrows(DataFault.class, () -> ModelFile.parse("{\"name\": \"bench\", " + head + ", "
                + Optional.ofNullable(inputs).orElse("")
                + "\"bodies\": [{\"name\": \"mass\", \"mass_kg\": 1, \"sensor\": \"mass.acc.z\"}], \"links\": [{\"from\": \"ground\", "
                + "\"to\": \"mass\", \"stiffness_N_per_m\": 1000, \"damping_Ns_per_m\": 1}]}", "model.json"));
        assertTrue(fault.getMessage().contains("subject") && fault.getMessage().contains(told) && fault.getMessage().lines().count() == 1,
                fault.getMessage());
    }

    private static Diagnosis diagnosed(Model model, Recording recording) {
        return Diagnoser.diagnose(new Question(model, recording, Optional.empty(), OptionalDouble.empty()), (step, share) -> {});
    }

    private static double stiffness(double resonance) {
        return KILOGRAMS * Math.pow(2 * Math.PI * resonance, 2);
    }

    private static double damping(double resonance) {
        return 2 * RATIO * KILOGRAMS * 2 * Math.PI * resonance;
    }

    /** A tenth too soft, and a fifth too little damped. */
    private static Model model(double resonance, String subject) {
        return ModelFile.parse("{\"name\": \"shaker\", \"subject\": " + subject
                + ", \"base\": {\"name\": \"table\", \"sensor\": \"table.acc.z\"}, "
                + "\"bodies\": [{\"name\": \"mass\", \"mass_kg\": " + KILOGRAMS
                + ", \"sensor\": \"mass.acc.z\"}], \"links\": [{\"from\": \"table\", \"to\": \"mass\", "
                + "\"stiffness_N_per_m\": " + 0.9 * stiffness(resonance) + ", \"damping_Ns_per_m\": " + 0.8 * damping(resonance) + "}]}",
                "shaker");
    }

    private static Recording bench(double resonance, double rate, double seconds, double cubic, long seed) {
        double k = stiffness(resonance);
        double c = damping(resonance);
        return bench(resonance, rate, seconds, (r, v) -> k * r + c * v + cubic * r * r * r, seed);
    }

    /**
     * A hundred tones up to two and a half times the resonance, Runge and Kutta's fourth order at twenty steps a sample, 0.2 % noise on the
     * mass.
     *
     * @param link its force by deflection and speed [N]
     */
    private static Recording bench(double resonance, double rate, double seconds, DoubleBinaryOperator link, long seed) {
        int n = (int) (seconds * rate);
        Random random = new Random(seed);
        double[] phase = random.doubles(100, 0, 2 * Math.PI).toArray();
        double[] table = new double[n];
        double[] mass = new double[n];
        DoubleBinaryOperator pull = (r, v) -> -link.applyAsDouble(r, v) / KILOGRAMS;
        int fine = 20;
        double h = 1 / rate / fine;
        double r = 0;
        double v = 0;
        double square = 0;
        for (int j = 0; j < n; j++) {
            table[j] = shaken(j / rate, resonance, phase);
            mass[j] = pull.applyAsDouble(r, v);
            square += mass[j] * mass[j] / n;
            for (int i = 0; i < fine; i++) {
                double t = j / rate + i * h;
                double one = shaken(t, resonance, phase);
                double two = shaken(t + h / 2, resonance, phase);
                double three = shaken(t + h, resonance, phase);
                double a1 = pull.applyAsDouble(r, v) - one;
                double r2 = r + h / 2 * v;
                double v2 = v + h / 2 * a1;
                double a2 = pull.applyAsDouble(r2, v2) - two;
                double r3 = r + h / 2 * v2;
                double v3 = v + h / 2 * a2;
                double a3 = pull.applyAsDouble(r3, v3) - two;
                double r4 = r + h * v3;
                double v4 = v + h * a3;
                double a4 = pull.applyAsDouble(r4, v4) - three;
                r += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
                v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
            }
        }
        for (int j = 0; j < n; j++) {
            mass[j] += 0.002 * Math.sqrt(square) * random.nextGaussian();
        }
        Map<Channel, double[]> channels = new LinkedHashMap<>();
        channels.put(TABLE, table);
        channels.put(MASS, mass);
        return new Recording(new Clock(0, rate), channels, Metadata.NONE);
    }

    private static double shaken(double t, double resonance, double[] phase) {
        double sum = 0;
        for (int i = 0; i < phase.length; i++) {
            sum += 1.4 * Math.sin(2 * Math.PI * resonance * (0.0625 + 0.02437 * i) * t + phase[i]);
        }
        return Math.min(1, 20 * t) * sum;
    }
}
