package wbv.fmi;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.Recording;

/** Units that cannot be run get one line that says why, and leave nothing unpacked. */
class BadUnitTest {

    private static final Channel BASE = Channel.parse("platform.acc.z");
    private static final Recording RECORDING = new Recording(new Clock(0, 60), Map.of(BASE, new double[240]), Metadata.NONE);

    @TempDir
    private Path folder;

    /** Refused with a line that contains a text and names the file. */
    private void refuses(String said, Path file, Map<String, Channel> inputs) throws IOException {
        long before = BuiltUnit.unpacked();
        DataFault fault = assertThrows(DataFault.class, () -> {
            try (FmuSimulation simulation = FmuSimulation.open(file, RECORDING, inputs, Map.of())) {
                simulation.run(Map.of());
            }
        });
        assertTrue(fault.getMessage().startsWith(file.toString()) && fault.getMessage().contains(said), fault.getMessage());
        assertFalse(fault.getMessage().contains("\n"), fault.getMessage());
        assertEquals(before, BuiltUnit.unpacked());
    }

    private Path described(String xml) throws IOException {
        return BuiltUnit.zipped(folder.resolve("bad.fmu"), Map.of("modelDescription.xml", xml.getBytes(StandardCharsets.UTF_8)));
    }

    private static String car() {
        return BuiltUnit.description(BuiltUnit.QUARTER_CAR, 2, BuiltUnit.STEPS);
    }

    @Test
    void whatIsNoUnit() throws IOException {
        refuses("not a whole zip archive", Files.writeString(folder.resolve("text.fmu"), "t,platform.acc.z\n0,1\n"), Map.of());
        refuses("has no modelDescription.xml", BuiltUnit.zipped(folder.resolve("empty.fmu"), Map.of("readme.txt", new byte[3])), Map.of());
        refuses("lie outside of it: ../../evil",
                BuiltUnit.zipped(folder.resolve("evil.fmu"), Map.of("modelDescription.xml", new byte[0], "../../evil", new byte[3])),
                Map.of());
        byte[] whole = Files.readAllBytes(described(car()));
        refuses("not a whole zip archive", Files.write(folder.resolve("half.fmu"), java.util.Arrays.copyOf(whole, whole.length / 2)),
                Map.of());
    }

    @Test
    void whatIsDescribedWrongly() throws IOException {
        refuses("is of FMI 1.0; export it as FMI 2.0 or 3.0", described(car().replace("fmiVersion=\"2.0\"", "fmiVersion=\"1.0\"")),
                Map.of());
        refuses("begins with <html>", described("<html/>"), Map.of());
        refuses("its modelDescription.xml cannot be read: line ", described(car().substring(0, 600)), Map.of());
        refuses("can neither be simulated nor gives derivatives", described(car().replaceFirst("<CoSimulation[^>]*>", "")), Map.of());
        refuses("no name of a file: '../../bin/unit'", described(car().replace("\"unit\"", "\"../../bin/unit\"")), Map.of());
        refuses("none of its outputs [a, b, c] is named as a channel",
                described(BuiltUnit.description(BuiltUnit.QUARTER_CAR.outputs(BuiltUnit.ordered("a", "", "b", "", "c", "")),
                        2, BuiltUnit.STEPS)),
                Map.of());
        refuses("none of its inputs [road, f1, f2] is named as a channel that was recorded, [platform.acc.z]",
                described(BuiltUnit.description(BuiltUnit.QUARTER_CAR.inputs(BuiltUnit.ordered("road", "", "f1", "", "f2", "")), 2,
                        BuiltUnit.STEPS)),
                Map.of());
        refuses("platform.acc.z is declared in m/s, and platform.acc.z is in m/s²",
                described(car().replace("start=\"0\" unit=\"m/s2\"", "start=\"0\" unit=\"m/s\"")), Map.of());
        refuses("valueReference that is a number", described(car().replace("valueReference=\"101\"", "valueReference=\"x\"")), Map.of());
        refuses("it has no input rod; there are [platform.acc.z, force.suspension, force.seat]", described(car()), Map.of("rod", BASE));
        refuses("two of its outputs are body.acc.z", described(car().replace("axle.acc.z", "body_acc_z")), Map.of());
    }

    /** A document that would read a file of this computer. */
    @Test
    void noExternalEntityIsFollowed() throws IOException {
        Path secret = Files.writeString(folder.resolve("secret"), "the-secret");
        String xml = "<?xml version=\"1.0\"?>\n<!DOCTYPE fmiModelDescription [<!ENTITY x SYSTEM \"" + secret.toUri() + "\">]>\n"
                + car().substring(car().indexOf('\n') + 1).replace("modelName=\"quarter_car\"", "modelName=\"&x;\"");
        refuses("its modelDescription.xml cannot be read", described(xml), Map.of());
    }

    @Test
    void whatHasNoBinaryForThisComputer() throws IOException {
        refuses("it was built for none: export it with its binary", described(car()), Map.of());
        Path other = BuiltUnit.zipped(folder.resolve("other.fmu"),
                Map.of("modelDescription.xml", car().getBytes(StandardCharsets.UTF_8), "binaries/vax64/unit.so", new byte[8]));
        refuses("it was built for vax64", other, Map.of());
        Path damaged = BuiltUnit.zipped(folder.resolve("damaged.fmu"),
                Map.of("modelDescription.xml", car().getBytes(StandardCharsets.UTF_8),
                        "binaries/" + Binary.places(2, "unit").get(0), new byte[64]));
        refuses("cannot be loaded", damaged, Map.of());
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 3})
    void whatFailsSaysWhere(int version) throws IOException {
        refuses("its step failed; it says: the solver found no solution",
                BuiltUnit.build(folder, "step.fmu", BuiltUnit.QUARTER_CAR, version, BuiltUnit.STEPS, "BROKEN_AT=2.0"), Map.of());
        refuses("its initialisation failed; it says: no consistent start values",
                BuiltUnit.build(folder, "start.fmu", BuiltUnit.QUARTER_CAR, version, BuiltUnit.STEPS, "NO_START"), Map.of());
        refuses("its instantiation failed; it says: wrong",
                BuiltUnit.build(folder, "token.fmu", BuiltUnit.QUARTER_CAR, version, BuiltUnit.STEPS, "TOKEN=\"other\""), Map.of());
    }

    /** A stiffness of the wrong sign. */
    @Test
    void whatLeavesAllBoundsSaysWhen() throws IOException {
        double[] moved = new double[240];
        java.util.Arrays.setAll(moved, i -> Math.sin(0.3 * i));
        Recording recording = new Recording(new Clock(0, 60), Map.of(BASE, moved), Metadata.NONE);
        Path file = BuiltUnit.build(folder, "unstable.fmu", BuiltUnit.QUARTER_CAR, 2, BuiltUnit.DERIVATIVES);
        try (FmuSimulation simulation = FmuSimulation.open(file, recording, Map.of(), Map.of())) {
            DataFault fault = assertThrows(DataFault.class, () -> simulation.run(Map.of("tyre.k", -1e8)));
            assertTrue(fault.getMessage().matches(".*unstable.fmu: its outputs leave all bounds [0-9.]+ s after its start"),
                    fault.getMessage());
            assertThrows(DataFault.class, () -> simulation.run(Map.of("tyre", 1.0)));
        }
    }

    @Test
    void aStepThatIsLongerThanASampleIsRefused() throws IOException {
        refuses("steps by 0.05000 s alone, the recording by 0.01667 s", BuiltUnit.build(folder, "slow.fmu", BuiltUnit.QUARTER_CAR, 3,
                java.util.List.of("<CoSimulation fixedInternalStepSize=\"0.05\"/>")), Map.of());
    }
}
