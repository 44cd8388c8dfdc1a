package wbv.diagnosis.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.diagnosis.Bench;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Recording;

/** Which numbers of a model may be wrong. */
class BaselineTest {

    private static final Channel FORCE = Channel.parse("mass.force.z");
    private static final Channel POSITION = Channel.parse("mass.pos.z");

    /** Where a spring holds what a force pushes, its offset shows in nothing; a body that nothing holds it drives away. */
    @ParameterizedTest
    @CsvSource({"8000, false", "0, true"})
    void offsetOfAForceIsFreeWhereNothingHoldsWhatItPushes(double stiffness, boolean free) {
        double[] noise = new Random(3).doubles(2000, -1, 1).toArray();
        Recording recording = new Recording(new Clock(0, 200), Map.of(FORCE, noise, POSITION, noise), Metadata.NONE);
        Evidence evidence = new Evidence(Bench.oscillator(2, stiffness, 25, POSITION), recording);
        List<String> names = Baseline.of(evidence).knobs().stream().map(Knob::name).toList();
        assertEquals(free, names.contains("mass.force.z offset_N"), names.toString());
    }
}
