package wbv.recording.inspect;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.recording.Channel;
import wbv.recording.Metadata;
import wbv.recording.Quantity;

/** Each finding is made on a sensor with that fault, and none on a healthy one. */
class FindingsTest {

    private static final int ROWS = 6000;
    private static final double NOISE = 0.02;

    private static List<Channel> sensor(String acceleration) {
        List<Channel> channels = new ArrayList<>();
        for (String quantity : new String[] {acceleration, "gyr"}) {
            for (char axis : "xyz".toCharArray()) {
                channels.add(Channel.parse("seat." + quantity + "." + axis));
            }
        }
        return channels;
    }

    /** A sensor on a shaker: noise everywhere, a sweep from 1 to 9 Hz while its amplitude grows 25-fold in z. */
    private static Inspection inspect(String acceleration, double[] standing, UnaryOperator<double[]> fault, long seed) {
        Random random = new Random(seed);
        List<Channel> channels = sensor(acceleration);
        Inspector inspector = new Inspector("test", channels, Metadata.NONE, Optional.empty());
        double phase = 0;
        for (int i = 0; i < ROWS; i++) {
            phase += 2 * Math.PI * (1 + 8.0 * i / ROWS) / 60;
            double[] row = new double[7];
            row[0] = i / 60.0;
            for (int j = 1; j < 7; j++) {
                row[j] = (j < 4 ? standing[j - 1] + NOISE * random.nextGaussian() : 0.01 * random.nextGaussian());
            }
            row[3] += (0.1 + 2.4 * i / ROWS) * Math.sin(phase);
            inspector.accept(fault.apply(row), i + 2);
        }
        return inspector.finish();
    }

    private static Inspection inspect(UnaryOperator<double[]> fault) {
        return inspect("acc", new double[3], fault, 1);
    }

    private static int index(double[] row) {
        return (int) Math.round(row[0] * 60);
    }

    private static void assertOnly(Inspection inspection, Finding... findings) {
        assertEquals(List.of(findings), inspection.findings());
    }

    private static <F extends Finding> F only(Inspection inspection, Class<F> type) {
        assertEquals(1, inspection.findings().size(), () -> inspection.findings().toString());
        return type.cast(inspection.findings().get(0));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
    void aHealthySensorHasNoFinding(long seed) {
        assertOnly(inspect("acc", new double[3], row -> row, seed));
        assertOnly(inspect("acc", new double[] {0.05, -0.3, 0.1}, row -> row, seed));
        assertOnly(inspect("accg", new double[] {1.2, -0.8, 9.7}, row -> row, seed));
    }

    @Test
    void aDeadSensorHasAFindingForEveryChannel() {
        Inspection inspection = inspect(row -> new double[] {row[0], 0, 0, 0, 0, 0, 0});
        assertEquals(6, inspection.findings().size(), () -> inspection.findings().toString());
        assertTrue(inspection.findings().stream().allMatch(f -> f.message().endsWith("is 0 throughout")));
    }

    @Test
    void summariesAreTheMoments() {
        Inspection inspection = inspect("acc", new double[] {1, 0, 0}, row -> row, 1);
        Summary x = inspection.summaries().get(Channel.parse("seat.acc.x"));
        assertEquals(ROWS, x.count());
        assertEquals(1, x.mean(), 4 * NOISE / Math.sqrt(ROWS));
        assertEquals(NOISE, x.rms(), 0.05 * NOISE);
        assertTrue(x.min() < 1 && x.max() > 1 && x.max() < 1 + 5 * NOISE);
    }

    @ParameterizedTest
    @CsvSource({"0, 0, 9.81", "0, 0, -9.81", "9.5, 1.5, 0.5", "-0.95, 0.14, 8.5"})
    void gravityLeftInIsNamed(double x, double y, double z) {
        Inspection inspection = inspect("acc", new double[] {x, y, z}, row -> row, 2);
        assertEquals(Math.sqrt(x * x + y * y + z * z), only(inspection, Finding.GravityLeftIn.class).magnitude(), 0.1);
    }

    @Test
    void gravityMissingIsNamed() {
        only(inspect("accg", new double[] {0.1, 0, 0.2}, row -> row, 2), Finding.GravityMissing.class);
    }

    @ParameterizedTest
    @CsvSource({"acc, -27.5, -26.5, -42", "acc, 0, 4, 0", "accg, 0, 0, 19.6", "accg, 3, 0, 3"})
    void grossBiasIsNamed(String quantity, double x, double y, double z) {
        Finding.GrossBias bias = only(inspect(quantity, new double[] {x, y, z}, row -> row, 3), Finding.GrossBias.class);
        assertEquals(x, bias.x(), 0.05);
        assertEquals(y, bias.y(), 0.05);
        assertEquals(z, bias.z(), 0.1);
    }

    @Test
    void unitsThatCannotBeAreNamed() {
        UnaryOperator<double[]> inG = row -> scaled(row, 1, 4, 1 / 9.80665);
        UnaryOperator<double[]> inMilliG = row -> scaled(row, 1, 4, 1000 / 9.80665);
        UnaryOperator<double[]> inDegrees = row -> scaled(row, 4, 7, 180 / Math.PI * 40);
        double[] rest = {0, 0, 9.80665};
        assertTrue(only(inspect("accg", rest, inG, 4), Finding.ImplausibleUnit.class).likely().startsWith("g "));
        assertTrue(only(inspect("accg", rest, inMilliG, 4), Finding.ImplausibleUnit.class).likely().startsWith("mg "));
        assertTrue(only(inspect("acc", rest, inMilliG, 4), Finding.ImplausibleUnit.class).likely().startsWith("mg "));
        UnaryOperator<double[]> inMillimetres = row -> scaled(row, 1, 4, 1000);
        for (String quantity : List.of("acc", "accg")) {
            assertEquals("mg or cm/s² read as m/s²", only(inspect(quantity, rest, inMilliG, 4), Finding.ImplausibleUnit.class).likely());
            assertEquals("mm/s² read as m/s²", only(inspect(quantity, rest, inMillimetres, 4), Finding.ImplausibleUnit.class).likely());
        }
        assertTrue(only(inspect("acc", new double[3], inDegrees, 4), Finding.ImplausibleUnit.class).likely().startsWith("deg/s"));
    }

    /** Of motion alone nothing tells which: a thousandth of a metre or of a g. */
    @Test
    void allUnitsThatMayBeAreNamed() {
        UnaryOperator<double[]> great = row -> scaled(row, 1, 4, 2000);
        assertEquals("mm/s², cm/s² or mg read as m/s²",
                only(inspect("acc", new double[3], great, 4), Finding.ImplausibleUnit.class).likely());
        UnaryOperator<double[]> counts = row -> scaled(row, 1, 4, 1e6);
        assertEquals("counts of a sensor read as m/s²",
                only(inspect("acc", new double[3], counts, 4), Finding.ImplausibleUnit.class).likely());
    }

    private static double[] scaled(double[] row, int from, int to, double factor) {
        for (int j = from; j < to; j++) {
            row[j] *= factor;
        }
        return row;
    }

    @Test
    void aStuckChannelIsNamed() {
        Inspection inspection = inspect(row -> {
            row[2] = index(row) >= 1000 && index(row) < 1040 ? 0.125 : row[2];
            return row;
        });
        assertOnly(inspection, new Finding.Stuck(Channel.parse("seat.acc.y"), 0.125, 40, 1002, ROWS));
    }

    @Test
    void aChannelThatNeverMovesIsNamed() {
        Inspection inspection = inspect(row -> {
            row[2] = 0;
            return row;
        });
        assertOnly(inspection, new Finding.Stuck(Channel.parse("seat.acc.y"), 0, ROWS, 2, ROWS));
    }

    @Test
    void rowsOfZerosAreCounted() {
        Inspection inspection = inspect(row -> index(row) == 700 || index(row) == 900 ? new double[] {row[0], 0, 0, 0, 0, 0, 0} : row);
        assertOnly(inspection, new Finding.ZeroRows("seat", 2, 702, false));
    }

    @Test
    void zerosAtTheBeginningAreANoteOnly() {
        Inspection inspection = inspect(row -> index(row) < 5 ? new double[] {row[0], 0, 0, 0, 0, 0, 0} : row);
        assertEquals(Severity.NOTE, only(inspection, Finding.ZeroRows.class).severity());
    }

    @Test
    void aClippedChannelIsNamed() {
        Inspection inspection = inspect(row -> {
            row[3] = Math.max(-1, Math.min(1, row[3]));
            return row;
        });
        assertEquals(2, inspection.findings().size(), () -> inspection.findings().toString());
        for (Finding finding : inspection.findings()) {
            Finding.Clipped clipped = (Finding.Clipped) finding;
            assertEquals(Channel.parse("seat.acc.z"), clipped.channel());
            assertEquals(1, Math.abs(clipped.value()));
            assertTrue(clipped.count() > 50, finding.message());
        }
    }

    /** A slow swing written coarsely stays at its top for some samples at every turn; that is no clipping. */
    @Test
    void aSlowSwingIsNotClipped() {
        Channel position = Channel.parse("seat.pos.z");
        Inspector inspector = new Inspector("test", List.of(position), Metadata.NONE, Optional.empty());
        for (int i = 0; i < ROWS; i++) {
            inspector.accept(new double[] {i / 100.0, Math.rint(1e4 * Math.sin(2 * Math.PI * 0.1 * i / 100)) / 1e4}, i + 2);
        }
        assertOnly(inspector.finish());
    }

    @Test
    void aVoltageThatSwitchesIsNeitherStuckNorClipped() {
        Inspector inspector = new Inspector("test", List.of(Channel.parse("motor.force.x")), Metadata.NONE, Optional.empty());
        Random random = new Random(10);
        double value = 1;
        for (int i = 0; i < ROWS; i++) {
            value = random.nextInt(15) == 0 ? -value : value;
            inspector.accept(new double[] {i / 50.0, value}, i + 2);
        }
        assertOnly(inspector.finish());
    }

    @Test
    void anOrientationMayStandStillForASecond() {
        Channel real = Channel.parse("seat.quat.w");
        Inspector inspector = new Inspector("test", List.of(real), Metadata.NONE, Optional.empty());
        for (int i = 0; i < ROWS; i++) {
            inspector.accept(new double[] {i / 100.0, i < 3000 ? 0.5 : 0.6 + 1e-4 * Math.sin(i)}, i + 2);
        }
        assertOnly(inspector.finish());
    }

    @Test
    void glitchWordsAreCounted() {
        Inspection inspection = inspect(row -> {
            row[5] = index(row) % 1500 == 777 ? -0.5465 : row[5];
            return row;
        });
        Finding.Spikes spikes = only(inspection, Finding.Spikes.class);
        assertEquals(Channel.parse("seat.gyr.y"), spikes.channel());
        assertEquals(4, spikes.count());
        assertEquals(779, spikes.line());
    }

    @Test
    void missingSamplesAreCountedByChannel() {
        Inspection inspection = inspect(row -> {
            row[1] = index(row) % 10 == 3 ? Double.NaN : row[1];
            row[6] = Double.NaN;
            return row;
        });
        assertEquals(List.of(new Finding.Missing(List.of(Channel.parse("seat.gyr.z")), ROWS, ROWS),
                new Finding.Missing(List.of(Channel.parse("seat.acc.x")), ROWS / 10, ROWS)), inspection.findings());
        assertEquals(Severity.FAULT, inspection.findings().get(0).severity());
    }

    @Test
    void everyFindingSaysItInOneLine() {
        Channel z = Channel.parse("head.acc.z");
        List<Finding> all = List.of(new Finding.Gap(2, 3, 0.1, 5, 9), new Finding.DroppedPackets(1, 1, 0.1, 0.1, 5, 0),
                new Finding.Jitter(1e-3, 1e-2, true), new Finding.Drift(100, 100.01), new Finding.DuplicateTimes(1, 4),
                new Finding.TimeBackwards(1, 4, 2), new Finding.TwoClocks(4, 2, "time starts again"),
                new Finding.Missing(List.of(z), 1, 9),
                new Finding.Stuck(z, 1, 30, 4, 90), new Finding.ZeroRows("head", 2, 7, false), new Finding.PassedOver(1),
                new Finding.Clipped(z, 20, 9, 5), new Finding.GravityLeftIn("head", 9.8), new Finding.GravityMissing("head", 0.1),
                new Finding.GrossBias("head", Quantity.ACCELERATION, 1, 2, 3, 3.7),
                new Finding.ImplausibleUnit("head", Quantity.ANGULAR_RATE, 40, "rad/s", "deg/s read as rad/s"),
                new Finding.Spikes(z, 1, 4, 8));
        for (Finding finding : all) {
            assertFalse(finding.message().isBlank() || finding.message().contains("\n"), finding.message());
            assertFalse(finding.advice().isBlank() || finding.advice().contains("\n"), finding.advice());
        }
        assertEquals(Finding.class.getPermittedSubclasses().length, all.size());
    }
}
