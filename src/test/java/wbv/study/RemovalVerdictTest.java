package wbv.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import wbv.pole.RemovalCheck;
import wbv.recording.Channel;
import wbv.signal.CrossSpectrum;
import wbv.signal.Detrend;
import wbv.signal.FrequencyResponse;
import wbv.signal.Segmentation;

/** What is set large is what recordings that took no part have shown, and nothing else. */
class RemovalVerdictTest {

    private static final Channel HEAD = Channel.parse("head.acc.z");

    @Test
    void nothingIsPromisedOfWhatWasNotTried() {
        RemovalVerdict verdict = RemovalVerdict.of(HEAD, List.of());
        assertFalse(verdict.holds());
        assertEquals("Whether head.acc.z can be predicted without its sensor was not tried: no recording with its sensor was held back "
                + "(--check).", RemovalVerdict.sentence(List.of(verdict), 0));
    }

    @Test
    void everyRecordingHasToBearItOut() {
        assertEquals("Head.acc.z can be predicted without its sensor: 10.0 to 20.0 % of its variance is left on 2 recordings that took no "
                + "part.", said(check("a", 0.1, 0.5), check("b", 0.2, 0.5)));
        assertEquals("Head.acc.z cannot be predicted without its sensor: on b 63 % of its variance is left.", said(check("a", 0.1, 0.5),
                check("b", 0.63, 0.9)));
        assertTrue(said(check("a", 0.1, 0.5), check("b", 0.3, 0.2)).contains("mean body, which needs no pole, does as well"));
        assertTrue(said(check("a", Double.NaN, 0.5)).contains("cannot be predicted"));
    }

    private static String said(RemovalCheck... checks) {
        return RemovalVerdict.sentence(List.of(RemovalVerdict.of(HEAD, List.of(checks))), checks.length);
    }

    private static RemovalCheck check(String name, double error, double mean) {
        CrossSpectrum spectra = new CrossSpectrum(new Segmentation(60, 8, 0.5), Detrend.MEAN, 1);
        for (int n = 0; n < 20; n++) {
            spectra.accept(Math.sin(n), Math.cos(n));
        }
        FrequencyResponse any = spectra.response(0, FrequencyResponse.Excited.USUAL);
        return new RemovalCheck(name, HEAD, 0, error, mean, any, any);
    }
}
