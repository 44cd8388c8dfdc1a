package wbv.pole;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.apache.commons.math3.stat.regression.SimpleRegression;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import wbv.filter.model.Bounds;
import wbv.identify.Pole;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.rig.RigSpec;

/**
 * Sensor removal on a small part of the rig: trained on three subjects, tried on the fourth. The long proof is {@link
 * RemovalProof}.
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class SensorRemovalTest {

    private static final Channel HEAD = Channel.parse("head.acc.z");
    private static final Channel SEAT = Channel.parse("seat.acc.z");
    private static final List<String> LEVELS = List.of("0.5", "0.9", "1.6");

    private PoleTraining.Result result;
    private Recording stranger;

    @BeforeAll
    void train() {
        Layout layout = Layout.along('z', "platform", "seat", List.of("head"), rig(1, "0.9", 5).channels());
        PoleTraining training = new PoleTraining(layout, new PoleWindows(20, 5, 4));
        for (int subject = 1; subject <= 3; subject++) {
            for (String level : LEVELS) {
                training.add(training.examine(subject + " at " + level, rig(subject, level, 45)));
            }
        }
        result = training.finish();
        stranger = rig(4, "1.1", 60);
    }

    private static Recording rig(int subject, String level, int seconds) {
        return RigSpec.parse("subject=" + subject + " excitation=random:z:0.5-12:" + level + " seconds=" + seconds
                + " seed=" + (10 * subject
                        + level.length() + seconds)
                + " channels=platform.acc.x,platform.acc.z,platform.gyr.y,seat.acc.z,head.acc.z")
                .recording();
    }

    @Test
    void theHeadOfAStrangerIsPredictedWithoutItsSensor() {
        SensorRemoval.Prediction prediction = new SensorRemoval(result.trained()).predict("stranger", without(stranger, HEAD));
        RemovalCheck check = RemovalCheck.of(result.trained(), "stranger", stranger, prediction).get(0);
        assertEquals(0, prediction.lost());
        assertTrue(check.error() < 0.1, "variance not predicted: " + check.error());
        assertTrue(check.error() < check.meanError(), check.error() + " against the mean body's " + check.meanError());
        assertEquals(0, check.frequencyOff().orElseThrow(), 0.5);
        assertEquals(0, check.magnitudeOff().orElseThrow(), 0.2);
    }

    @Test
    void theMainClusterFollowsTheSofteningArc() {
        // Softening is f ∝ a^-0.18 and keeps damping ratios: per subject, ln f over ln a is a line of that slope.
        PlaceClusters seat = result.places().get(0);
        SimpleRegression line = new SimpleRegression();
        int windowsPerTrial = 6;
        for (int i = 0; i < seat.poles().size(); i++) {
            int trial = seat.window()[i] / windowsPerTrial;
            if (seat.dbscan()[i] == seat.largest() && trial / LEVELS.size() == 0) {
                line.addData(Math.log(Double.parseDouble(LEVELS.get(trial % LEVELS.size()))), Math.log(seat.poles().get(i)
                        .frequency()));
            }
        }
        assertTrue(line.getN() >= 10, "poles of subject 1 in the cluster: " + line.getN());
        assertEquals(-0.18, line.getSlope(), 0.04);
    }

    @Test
    void boundsHoldTheBodyThatTheyWereTrainedOnAndReachTheEstimator() {
        TrainedPoles trained = result.trained();
        Pole seen = trained.typical();
        Chord frequency = trained.chord(HEAD, seen, Bounds.Attribute.FREQUENCY);
        assertTrue(frequency.lower() < trained.bodies().get(HEAD).frequency() * 1.1 && frequency.upper() > trained.bodies()
                .get(HEAD).frequency() * 0.9);
        SensorRemoval.Prediction prediction = new SensorRemoval(trained).predict("stranger", stranger);
        SensorRemoval.Body body = prediction.bodies().get(HEAD);
        SensorRemoval.Seen last = prediction.seen().get(prediction.seen().size() - 1);
        for (int k = (int) last.sample() + 1; k < stranger.length(); k++) {
            Chord frequencies = last.bounds().get(HEAD).get(0);
            assertTrue(body.frequency()[k] > frequencies.lower() && body.frequency()[k] < frequencies.upper(),
                    k + ": " + body.frequency()[k]);
        }
        assertEquals(last.bounds().get(HEAD).get(1).middle(), body.damping()[stranger.length() - 1], 1e-3);
    }

    /** Resonance and what is let through above it are two things: with a share of the damping against rest, the peak is right. */
    @Test
    void theBoundedBodyHasThePeakOfTheHeadAndItsMotion() {
        SensorRemoval.Prediction prediction = new SensorRemoval(result.trained()).predict("stranger", stranger);
        double[] u = stranger.values(Channel.parse("platform.acc.z"));
        int settled = 1500;
        TransmissibilityPeak truth = TransmissibilityPeak.of(TransmissibilityPeak.response(u, stranger.values(HEAD), settled, 60))
                .orElseThrow();
        TransmissibilityPeak said = TransmissibilityPeak
                .of(TransmissibilityPeak.response(u, prediction.bodies().get(HEAD).motion(), settled, 60)).orElseThrow();
        assertEquals(truth.magnitude(), said.magnitude(), 0.1);
        assertEquals(truth.frequency(), said.frequency(), 0.4);
        assertTrue(RemovalCheck.error(stranger.values(HEAD), prediction.bodies().get(HEAD).motion(), settled) < 0.05);
    }

    @Test
    void aRunThatIsWrittenAndTakenUpGoesOnAsTheOriginalAndForeseesWhatItWillSay() throws Exception {
        RemovalRun original = new RemovalRun(result.trained(), "stranger", 60);
        RemovalRun copy = original;
        List<Channel> channels = result.trained().layout().inputs();
        double[] u = new double[channels.size()];
        for (int k = 0; k < 2400; k++) {
            for (int i = 0; i < u.length; i++) {
                u[i] = stranger.values(channels.get(i))[k];
            }
            if (k == 1700) {
                java.io.ByteArrayOutputStream bytes = new java.io.ByteArrayOutputStream();
                try (java.io.ObjectOutputStream out = new java.io.ObjectOutputStream(bytes)) {
                    out.writeObject(original);
                }
                copy = (RemovalRun) new java.io.ObjectInputStream(new java.io.ByteArrayInputStream(bytes.toByteArray())).readObject();
            }
            double foreseen = original.foresee(0, u);
            boolean retunes = original.samples() >= 1200 && (original.samples() - 1200) % 300 == 0;
            original.step(u, stranger.values(SEAT)[k]);
            if (!retunes) {
                assertEquals(original.motion(0), foreseen, 1e-9 * (1 + Math.abs(foreseen)), "sample " + k);
            }
            if (copy != original) {
                copy.step(u, stranger.values(SEAT)[k]);
                assertEquals(original.motion(0), copy.motion(0));
                assertEquals(original.body(0).prediction(), copy.body(0).prediction());
            }
        }
        assertTrue(original.seen() > 3);
    }

    @Test
    void aResponseThatGrowsIsRefusedOnReading(@TempDir Path folder) throws IOException {
        String text = PolygonFile.text(result.trained(), Map.of());
        int at = text.indexOf("\"a_ascending\" : [");
        for (String first : List.of("-1.0", "1e300")) {
            int begin = text.indexOf('[', at) + 1;
            Path file = Files.writeString(folder.resolve("p.json"),
                    text.substring(0, begin) + " " + first + text.substring(text.indexOf(',', begin)));
            DataFault fault = assertThrows(DataFault.class, () -> PolygonFile.read(file));
            assertTrue(fault.getMessage().contains("p.json") && fault.getMessage().contains("no body's response"), fault.getMessage());
        }
    }

    @Test
    void nothingLaterThanASampleIsUsedForIt() {
        double[] cut = stranger.values(SEAT).clone();
        Arrays.fill(cut, 2400, cut.length, 0.5);
        double[] whole = new SensorRemoval(result.trained()).predict("a", stranger).motion().get(HEAD);
        double[] broken = new SensorRemoval(result.trained()).predict("b", with(stranger, SEAT, cut)).motion().get(HEAD);
        assertEquals(0, mismatch(whole, broken, 0, 2400));
    }

    @Test
    void aChannelThatDiesMidwayHoldsTheLastPoleAndIsCounted() {
        double[] dead = stranger.values(SEAT).clone();
        Arrays.fill(dead, 1800, dead.length, Double.NaN);
        SensorRemoval.Prediction prediction = new SensorRemoval(result.trained()).predict("dead", with(stranger, SEAT, dead));
        assertTrue(prediction.lost() >= 4, "windows lost: " + prediction.lost());
        assertTrue(RemovalCheck.of(result.trained(), "dead", stranger, prediction).get(0).error() < 0.15);
    }

    @Test
    void aGapOfTenSecondsCostsItsWindowsAlone() {
        double[] gap = stranger.values(Channel.parse("platform.acc.z")).clone();
        Arrays.fill(gap, 600, 1200, Double.NaN);
        SensorRemoval.Prediction prediction = new SensorRemoval(result.trained())
                .predict("gap", with(stranger, Channel.parse("platform.acc.z"), gap));
        assertTrue(prediction.lost() > 0 && !prediction.seen().isEmpty());
        assertTrue(Arrays.stream(prediction.motion().get(HEAD)).allMatch(Double::isFinite));
        assertTrue(RemovalCheck.error(stranger.values(HEAD), prediction.motion().get(HEAD), 2400) < 0.15);
    }

    @Test
    void withoutExcitationThePopulationStandsInAndItIsSaid() {
        Map<Channel, double[]> still = new LinkedHashMap<>();
        stranger.channels().forEach(channel -> still.put(channel, new double[3000]));
        SensorRemoval.Prediction prediction = new SensorRemoval(result.trained()).predict("still", new Recording(stranger.clock(),
                still,
                stranger.metadata()));
        assertTrue(prediction.seen().isEmpty());
        assertTrue(prediction.lost() > 0);
        assertEquals(0, Arrays.stream(prediction.motion().get(HEAD)).map(Math::abs).max().orElseThrow());
    }

    @Test
    void theFileKeepsEverythingDigitForDigit(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("polygons.json");
        String text = PolygonFile.text(result.trained(), Map.of("made", "here"));
        Files.writeString(file, text);
        assertEquals(text, PolygonFile.text(PolygonFile.read(file), Map.of("made", "here")));
    }

    @Test
    void filesThatAreNoneAreFaultsThatNameTheFile(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("p.json");
        for (String text : List.of("{", "{}", "{\"wbv\": {\"version\": 1}}", PolygonFile.text(result.trained(), Map.of())
                .replace("\"head.acc.z\"", "\"head\""),
                PolygonFile.text(result.trained(), Map.of()).replaceFirst("\"y\" : \"imaginary\"", "\"y\" : \"colour\""))) {
            Files.writeString(file, text);
            DataFault fault = assertThrows(DataFault.class, () -> PolygonFile.read(file), text.substring(0, Math.min(40,
                    text.length())));
            assertTrue(fault.getMessage().contains("p.json") && fault.getMessage().lines().count() == 1, fault.getMessage());
        }
        assertThrows(DataFault.class, () -> PolygonFile.read(folder.resolve("none.json")));
    }

    @Test
    void polygonsOfOtherChannelsAreRefused() {
        DataFault fault = assertThrows(DataFault.class, () -> new SensorRemoval(result.trained()).predict("ride.csv",
                without(stranger, SEAT)));
        assertTrue(fault.getMessage().startsWith("ride.csv") && fault.getMessage().contains("seat.acc.z"), fault.getMessage());
    }

    @Test
    void tooLittleToLearnFromIsAFault() {
        PoleTraining training = new PoleTraining(result.trained().layout(), new PoleWindows(20, 5, 4));
        assertThrows(DataFault.class, training::finish);
        training.add(training.examine("short", rig(1, "0.9", 22)));
        assertThrows(DataFault.class, training::finish);
    }

    private static Recording without(Recording recording, Channel channel) {
        Map<Channel, double[]> values = new LinkedHashMap<>();
        recording.channels().stream().filter(each -> !each.equals(channel)).forEach(each -> values.put(each,
                recording.values(each)));
        return new Recording(recording.clock(), values, recording.metadata());
    }

    private static Recording with(Recording recording, Channel channel, double[] samples) {
        Map<Channel, double[]> values = new LinkedHashMap<>();
        recording.channels().forEach(each -> values.put(each, each.equals(channel) ? samples : recording.values(each)));
        return new Recording(recording.clock(), values, recording.metadata());
    }

    private static double mismatch(double[] a, double[] b, int from, int to) {
        double largest = 0;
        for (int k = from; k < to; k++) {
            largest = Math.max(largest, Math.abs(a[k] - b[k]));
        }
        return largest;
    }
}
