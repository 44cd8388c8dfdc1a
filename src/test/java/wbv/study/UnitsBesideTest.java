package wbv.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.recording.Channel;
import wbv.signal.CrossSpectrum;
import wbv.signal.Detrend;
import wbv.signal.FrequencyResponse;
import wbv.signal.Segmentation;

/** One sensor in g beside others in m/s². */
class UnitsBesideTest {

    private static final double RATE = 50;
    private static final Channel RAIL = Channel.parse("rail.acc.y");

    /** A body of 3 Hz and a damping ratio of 0.3 on a rail that is shaken at random, times a factor. */
    private static FrequencyResponse response(double factor) {
        CrossSpectrum spectra = new CrossSpectrum(new Segmentation(RATE, 256, 0.5), Detrend.MEAN, 1);
        Random random = new Random(12);
        double omega = 2 * Math.PI * 3;
        double r = 0;
        double v = 0;
        double slow = 0;
        for (int i = 0; i < 20_000; i++) {
            slow = 0.6 * slow + random.nextGaussian();
            for (int k = 0; k < 10; k++) {
                v += (-slow - 2 * 0.3 * omega * v - omega * omega * r) / RATE / 10;
                r += v / RATE / 10;
            }
            spectra.accept(slow, new double[] {factor * (-2 * 0.3 * omega * v - omega * omega * r)});
        }
        return spectra.response(0, FrequencyResponse.Excited.USUAL);
    }

    @ParameterizedTest
    @CsvSource({"0.102, true", "9.81, true", "1, false", "0.3, false", "0.02, false"})
    void whatMovesANinthOfItsBaseWhereAllMovesAlikeIsInG(double factor, boolean told) {
        assertEquals(told, FoldedFindings.units(RAIL, Channel.parse("cart.acc.y"), response(factor)).isPresent());
    }

    @Test
    void theChannelIsNamedAndNoOtherAxisOrQuantityAsked() {
        FrequencyResponse h = response(0.102);
        String message = FoldedFindings.units(RAIL, Channel.parse("cart.acc.y"), h).orElseThrow().message();
        assertTrue(message.startsWith("cart.acc.y moves 0.1") && message.endsWith("looks to be in g; state the unit"), message);
        assertTrue(FoldedFindings.units(RAIL, Channel.parse("cart.acc.z"), h).isEmpty());
        assertTrue(FoldedFindings.units(RAIL, Channel.parse("cart.gyr.y"), h).isEmpty());
    }
}
