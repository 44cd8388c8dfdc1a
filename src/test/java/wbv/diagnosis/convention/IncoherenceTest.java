package wbv.diagnosis.convention;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.diagnosis.convention.MeantRides.Extra;
import wbv.diagnosis.convention.MeantRides.Ride;
import wbv.recording.Channel;

/** What no linear model explains, in simulated people over seeds. */
class IncoherenceTest {

    private static final Channel HEAD = Channel.parse("head.acc.z");
    private static final Channel TRUNK = Channel.parse("trunk.acc.z");
    private static final Convention.Misread TURNED = new Convention.Misread(HEAD, -1, "");

    private static double rms(double[] x) {
        return Math.sqrt(Arrays.stream(x).map(value -> value * value).average().orElseThrow());
    }

    private static double least(Ride ride, Convention convention, Channel output) {
        return new Incoherence(ride.model(), ride.recording()).least(convention, List.of(output));
    }

    @ParameterizedTest
    @ValueSource(longs = {11, 12, 13, 14, 15, 16, 17, 18})
    void isWhatWasAddedToALinearModel(long seed) {
        Ride clean = MeantRides.person(seed, 0.3, Extra.NONE);
        assertEquals(0, least(clean, TURNED, HEAD), 0, "of a linear person");
        Random random = new Random(seed);
        Ride half = clean.reading(HEAD, x -> {
            double size = rms(x);
            return Arrays.stream(x).map(value -> value + size * random.nextGaussian()).toArray();
        });
        double least = least(half, TURNED, HEAD);
        assertTrue(least > 0.3 && least <= 0.5, "half is noise: " + least);
        assertEquals(0, least(half, TURNED, TRUNK), 0, "of the other sensor");
        assertEquals(least, least(half, new Convention.Exchanged(HEAD, TRUNK), TRUNK), 0, "the name is the trunk's, the noise the head's");
    }

    /** Each frequency counts as the output has it: what was asked of two channels says nothing of the same the other way round. */
    @ParameterizedTest
    @ValueSource(longs = {11, 12, 13})
    void isNotWhatItIsTheOtherWayRound(long seed) {
        Random random = new Random(seed);
        Ride noisy = MeantRides.person(seed, 0.3, Extra.NONE)
                .reading(HEAD, x -> Arrays.stream(x).map(value -> value + rms(x) * random.nextGaussian()).toArray());
        Channel base = noisy.model().excitations().get(0);
        Convention exchanged = new Convention.Exchanged(base, HEAD);
        Incoherence asked = new Incoherence(noisy.model(), noisy.recording());
        double first = asked.least(TURNED, List.of(HEAD));
        assertEquals(least(noisy, exchanged, HEAD), asked.least(exchanged, List.of(HEAD)), 0);
        assertNotEquals(first, asked.least(exchanged, List.of(HEAD)), 0.01);
    }

    /** The load swings on for half a second or more, segments are of two and a half. */
    @ParameterizedTest
    @ValueSource(longs = {11, 12, 13, 14, 15, 16, 17, 18, 23, 25, 26})
    void isNotWhatRingsOnBeyondASegment(long seed) {
        Ride bench = MeantRides.bench(seed, 0.3, Extra.NONE);
        Channel load = Channel.parse("load.acc.z");
        assertEquals(0, least(bench, new Convention.Misread(load, -1, ""), load), 0);
    }

    @ParameterizedTest
    @ValueSource(longs = {11, 12})
    void isNotToldOfWhatIsLost(long seed) {
        Ride lost = MeantRides.person(seed, 0.3, Extra.NONE).reading(HEAD, x -> {
            double[] noise = new Random(seed).doubles(x.length).toArray();
            noise[x.length / 2] = Double.NaN;
            return noise;
        });
        assertEquals(0, least(lost, TURNED, HEAD), 0);
    }
}
