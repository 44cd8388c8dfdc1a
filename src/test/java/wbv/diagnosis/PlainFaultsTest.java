package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.DoubleFunction;
import org.junit.jupiter.api.Test;
import wbv.body.ModelFile;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.mechanism.SensorBias;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;

class PlainFaultsTest {

    private static final Path CASE = Path.of("data/arff/concealed/001");

    /** The faults of a sound recording to whose channels along the axis something was added. */
    private static List<Diagnosis.Named> faults(double everywhere, Map<String, Double> more) throws Exception {
        return faults(everywhere, share -> more);
    }

    /** @param more by the share of the recording that is over */
    private static List<Diagnosis.Named> faults(DoubleFunction<Map<String, Double>> more) throws Exception {
        return faults(0, more);
    }

    private static List<Diagnosis.Named> faults(double everywhere, DoubleFunction<Map<String, Double>> more) throws Exception {
        Recording sound = new RecordingFile(CASE.resolve("recording.csv.gz")).load();
        Map<Channel, double[]> values = new LinkedHashMap<>();
        for (Channel channel : sound.channels()) {
            double added = channel.toString().endsWith("acc.z") ? everywhere : 0;
            double[] read = sound.values(channel).clone();
            Arrays.setAll(read,
                    i -> read[i] + added + more.apply((double) i / read.length).getOrDefault(channel.toString(), 0.0));
            values.put(channel, read);
        }
        Evidence evidence = new Evidence(ModelFile.read(CASE.resolve("model.json")),
                new Recording(sound.clock(), values, sound.metadata()));
        Candidate baseline = Baseline.of(evidence);
        Fitter.State look = new Fitter(evidence).look(baseline, baseline.start(), evidence.fit());
        return new PlainFaults(evidence).in(look, look);
    }

    /** Who is faster at the end than at the start was accelerated on average, and all sensors with him: that is no bias of one. */
    @Test
    void whatAllSensorsShareIsNoBias() throws Exception {
        double alone = faults(0, Map.of("head.acc.z", 0.3)).get(0).parameters().get("bias");
        List<Diagnosis.Named> found = faults(0.02, Map.of("head.acc.z", 0.3));
        assertEquals(List.of("head.acc.z"), found.stream().map(Diagnosis.Named::where).toList());
        assertEquals(0.3, alone, 0.004);
        assertEquals(alone, found.get(0).parameters().get("bias"), 2e-3);
    }

    @Test
    void aBiasOfThePlatformBlamesNoOther() throws Exception {
        assertEquals(List.of(), faults(0, Map.of("platform.acc.z", 0.3)));
    }

    @Test
    void aSoundRecordingHasNone() throws Exception {
        assertEquals(List.of(), faults(0, Map.of()));
    }

    /** A mean over all of the recording is what such a zero never is for long. */
    @Test
    void aZeroThatDriftsIsNoBiasThatStays() throws Exception {
        Diagnosis.Named steady = faults(0, Map.of("head.acc.z", 0.3)).get(0);
        assertEquals(Set.of("bias"), steady.parameters().keySet());
        List<Diagnosis.Named> found = faults(share -> Map.of("head.acc.z", 0.8 * (share - 0.5)));
        assertEquals(List.of("head.acc.z"), found.stream().map(Diagnosis.Named::where).toList());
        assertEquals(0.8, found.get(0).parameters().get("bias_range"), 0.08);
        assertEquals("The zero of the sensor %s drifts", new SensorBias().sentence(found.get(0).parameters().keySet()));
    }
}
