package wbv.body.simulate;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.body.SensorFilter;
import wbv.body.law.Law;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.Recording;
import wbv.signal.RealDft;

class RollOffTest {

    private static final Channel BASE = Channel.parse("platform.acc.z");
    private static final Channel SEAT = Channel.parse("seat.acc.z");
    private static final double RATE = 60;
    private static final int SAMPLES = 6000;

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void aFilterThatAllSensorsHaveIsRead(long seed) {
        Random random = new Random(seed);
        SensorFilter filter = RollOff.read(recording(filtered(noise(random)), filtered(noise(random))), BASE);
        for (double relative : new double[] {0.3, 0.36, 0.4, 0.43, 0.46}) {
            assertEquals(gain(relative), filter.at(relative), 0.15, "at " + relative);
        }
    }

    /** An excitation a hundred times the noise that ends where a filter might begin: what the sensors share is none of their noise. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void theEndOfAnExcitationIsNoFilter(long seed) {
        Random random = new Random(seed);
        double[] ride = filtered(noise(random));
        SensorFilter filter = RollOff.read(recording(sum(ride, noise(random)), sum(ride, noise(random))), BASE);
        for (double relative : new double[] {0.38, 0.42, 0.46}) {
            assertTrue(filter.at(relative) > 0.8, relative + ": " + filter.at(relative));
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void aFilterIsReadBesideAnExcitation(long seed) {
        Random random = new Random(seed);
        double[] ride = filtered(noise(random));
        SensorFilter filter = RollOff.read(recording(filtered(sum(ride, noise(random))), filtered(sum(ride, noise(random)))), BASE);
        for (double relative : new double[] {0.36, 0.4, 0.43, 0.46}) {
            assertEquals(gain(relative), filter.at(relative), 0.15, "at " + relative);
        }
    }

    private static double[] sum(double[] ride, double[] noise) {
        double[] out = new double[ride.length];
        Arrays.setAll(out, i -> 100 * ride[i] + noise[i]);
        return out;
    }

    /** A sensor that reads nothing and a record too short to tell say nothing of a filter. */
    @Test
    void whatTellsNothingIsNotAsked() {
        Random random = new Random(6);
        SensorFilter filter = RollOff.read(recording(filtered(noise(random)), new double[SAMPLES]), BASE);
        assertEquals(gain(0.46), filter.at(0.46), 0.15);
        SensorFilter brief = RollOff.read(recording(new double[100], new double[100]), BASE);
        assertEquals(1, brief.at(0.46));
    }

    /**
     * The law makes what no sensor's filter has seen, and the ride ends below it: by itself the base looks as if its sensor rolled off.
     */
    @Test
    void aSimulationGoesByTheModelAndWhatMovesItAlone() {
        Random random = new Random(7);
        double[] ride = filtered(noise(random));
        Recording whole = recording(filtered(sum(ride, noise(random))), filtered(sum(ride, noise(random))));
        Recording alone = whole.with(Map.of(BASE, whole.values(BASE)));
        Model model = stiffening();
        double[][] simulated = new Simulator(Excitation.asDeclared(model, whole, SAMPLES)).outputs(model.assembly());
        assertArrayEquals(simulated, new Simulator(Excitation.asDeclared(model, alone, SAMPLES)).outputs(model.assembly()));
        Model told = model.behind(RollOff.of(model, whole));
        Model read = ModelFile.parse(ModelFile.text(told), "model.json");
        assertEquals(told, read);
        double[][] compared = new Simulator(Excitation.of(model, whole, SAMPLES)).outputs(model.assembly());
        assertArrayEquals(compared, new Simulator(Excitation.asDeclared(read, alone, SAMPLES)).outputs(read.assembly()),
                "as it was compared with what was recorded");
        assertFalse(Arrays.equals(simulated[0], compared[0]), "there is a filter");
        Model apart = model.behind(Optional.of(new SensorFilter(List.of(0.1, 0.2), List.of(1.0, 0.5))));
        assertEquals(apart.base().filter(), RollOff.of(apart, whole), "what the model says goes before what the noise shows");
    }

    @Test
    void aFilterThatIsNoneIsRefused() {
        String text = ModelFile.text(stiffening());
        for (String amiss : List.of("{\"of_rate\": [0.4, 0.3], \"gain\": [1, 1]}", "{\"of_rate\": [0.4], \"gain\": [1, 0]}",
                "{\"of_rate\": [], \"gain\": []}", "{\"of_rate\": [24], \"gain\": [0.5]}", "{\"of_rate\": [0.4], \"gain\": [-1]}")) {
            String with = text.replace("\"sensor\" : \"platform.acc.z\"", "\"sensor\": \"platform.acc.z\", \"anti_alias\": " + amiss);
            String told = assertThrows(DataFault.class, () -> ModelFile.parse(with, "model.json")).getMessage();
            assertTrue(told.startsWith("model.json: base: anti_alias: "), told);
        }
    }

    private static Model stiffening() {
        Model.Body seat = new Model.Body("seat", 40, Optional.of(SEAT), List.of(), Optional.empty(), List.of());
        Model.Link link = new Model.Link("platform", "seat", 4e4, 600, Optional.empty(), List.of(Law.stiffening(5e9)), List.of());
        return new Model("a hard seat", Optional.empty(), 'z', new Model.Base("platform", Optional.of(BASE)), List.of(seat), List.of(link));
    }

    /** Closed form: flat up to 0.38 of the rate, then down to nothing at half of it. */
    private static double gain(double relative) {
        return relative < 0.38 ? 1 : Math.cos((relative - 0.38) / 0.12 * Math.PI / 2);
    }

    private static double[] noise(Random random) {
        return random.doubles(SAMPLES, -0.1, 0.1).toArray();
    }

    private static double[] filtered(double[] x) {
        RealDft dft = new RealDft(x.length);
        double[] spectrum = dft.forward(x);
        for (int k = 0; 2 * k + 1 < spectrum.length; k++) {
            double by = gain((double) k / x.length);
            spectrum[2 * k] *= by;
            spectrum[2 * k + 1] *= by;
        }
        return dft.inverse(spectrum);
    }

    private static Recording recording(double[] base, double[] seat) {
        Map<Channel, double[]> channels = new LinkedHashMap<>();
        channels.put(BASE, base);
        channels.put(SEAT, seat);
        return new Recording(new Clock(0, RATE), channels, Metadata.NONE);
    }
}
