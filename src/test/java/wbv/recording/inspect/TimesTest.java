package wbv.recording.inspect;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.recording.Clock;
import wbv.recording.format.Samples;

/** The clock that is inferred from times, and what is said about them, against times made with known faults. */
class TimesTest {

    /** Times of samples, each rounded to six significant digits as the practice recordings have them. */
    private static double[] sixDigits(int[] samples, double rate) {
        return Arrays.stream(samples).mapToDouble(i -> six(i / rate)).toArray();
    }

    private static double six(double time) {
        double unit = 1e-9;
        while (time >= 1e6 * unit) {
            unit *= 10;
        }
        double perUnit = Math.rint(1 / unit);
        return unit < 1 ? Math.rint(time * perUnit) / perUnit : Math.rint(time / unit) * unit;
    }

    private static double[] times(int count, IntToDoubleFunction time) {
        return IntStream.range(0, count).mapToDouble(time).toArray();
    }

    private static int[] all(int count) {
        return IntStream.range(0, count).toArray();
    }

    private static int[] without(int count, int... lost) {
        return IntStream.range(0, count).filter(i -> Arrays.binarySearch(lost, i) < 0).toArray();
    }

    private static void assertHealthy(Inspection inspection) {
        assertEquals(List.of(), inspection.findings());
    }

    @Test
    void sixMatchesTheDecimalRounding() {
        for (double time : new double[] {0, 0.016666666, 9.999994, 12.34567891, 999.99949, 1234.5678, 99999.94, 123456.7}) {
            assertEquals(Samples.significant(time, 6), six(time), 1e-12 * time);
        }
    }

    @ParameterizedTest
    @CsvSource({"60, 432000", "60, 1300000", "50, 360000", "100, 720000", "128, 900000", "1000, 1200000"})
    void timesRoundedToSixDigitsKeepTheirClockForHours(double rate, int count) {
        Inspection inspection = Samples.inspect(sixDigits(all(count), rate));
        assertEquals(new Clock(0, rate), inspection.clock());
        assertEquals(count, inspection.samples());
        assertHealthy(inspection);
    }

    @Test
    void gapsAreCountedHoweverCoarselyTimesAreRounded() {
        int[] lost = {100, 5000, 5001, 5002, 200_000, 300_000, 300_001, 430_000};
        Inspection inspection = Samples.inspect(sixDigits(without(432_000, lost), 60));
        Finding.Gap gap = Samples.find(inspection, Finding.Gap.class).orElseThrow();
        assertEquals(lost.length, gap.missing());
        assertEquals(5, gap.count());
        assertEquals(432_000, inspection.samples());
        assertEquals(60, inspection.clock().rate());
        assertEquals(1, inspection.findings().size(), () -> inspection.findings().toString());
    }

    @ParameterizedTest
    @CsvSource({"100, 2", "50, 2", "1000, 3", "10, 1", "200, 3"})
    void aStepThatIsWrittenExactlyShowsEveryLostRow(double rate, int decimals) {
        double unit = Math.pow(10, decimals);
        Inspection inspection = Samples
                .inspect(Arrays.stream(without(40_000, 50, 5000, 30_000)).mapToDouble(i -> Math.rint(unit * i / rate) / unit).toArray());
        assertEquals(3, Samples.find(inspection, Finding.Gap.class).orElseThrow().missing());
        assertEquals(new Clock(0, rate), inspection.clock());
        assertEquals(40_000, inspection.samples());
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void aThirdOfTheRowsMayBeLost(long seed) {
        Random random = new Random(seed);
        int[] kept = IntStream.range(0, 20_000).filter(i -> i == 0 || i == 19_999 || random.nextDouble() > 0.33).toArray();
        Inspection inspection = Samples.inspect(Arrays.stream(kept).mapToDouble(i -> 1e-6 * Math.rint(1e6 * i / 60)).toArray());
        assertEquals(20_000 - kept.length, Samples.find(inspection, Finding.Gap.class).orElseThrow().missing());
        assertEquals(20_000, inspection.samples());
        assertEquals(60, inspection.clock().rate(), 1e-6);
    }

    @Test
    void anOddRateIsMeasured() {
        Inspection inspection = Samples.inspect(times(100_000, i -> 5 + i * 0.00852161));
        assertEquals(1 / 0.00852161, inspection.clock().rate(), 1e-6);
        assertEquals(5, inspection.clock().start(), 1e-9);
        assertHealthy(inspection);
    }

    @Test
    void millisecondsSinceTheEpochAreGoodTimes() {
        Inspection inspection = Samples.inspect(times(30_000, i -> 1_630_000_000.0 + Math.rint(1000.0 * i / 60) / 1000));
        assertEquals(60, inspection.clock().rate(), 1e-6);
        assertEquals(1_630_000_000.0, inspection.clock().start(), 1e-3);
        assertHealthy(inspection);
    }

    @Test
    void aClockThatDriftsIsMeasuredAndItsDriftReported() {
        double rate = 100 * (1 + 200e-6);
        Inspection inspection = Samples.inspect(times(360_000, i -> Math.rint(1e6 * i / rate) / 1e6), i -> Math.sin(0.7 * i),
                OptionalDouble.of(100));
        Finding.Drift drift = Samples.find(inspection, Finding.Drift.class).orElseThrow();
        assertEquals(200, drift.ppm(), 0.01);
        assertEquals(Severity.NOTE, drift.severity());
        assertEquals(rate, inspection.clock().rate(), 1e-6);
    }

    @Test
    void theStatedRateIsTakenWhereItMisplacesNothing() {
        Inspection dot = Samples.inspect(times(382, i -> i * 16_667e-6), i -> Math.sin(0.7 * i), OptionalDouble.of(60));
        assertEquals(new Clock(0, 60), dot.clock());
        assertHealthy(dot);
    }

    @Test
    void aStatedRateThatIsWrongIsNotBelieved() {
        Inspection inspection = Samples.inspect(times(5000, i -> i / 117.0), i -> Math.sin(0.7 * i), OptionalDouble.of(100));
        assertEquals(117, inspection.clock().rate(), 1e-9);
        assertEquals(Severity.WARNING, Samples.find(inspection, Finding.Drift.class).orElseThrow().severity());
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.05, 0.1, 0.2, 0.3})
    void realJitterIsFoundAndIsNoGap(double share) {
        Random random = new Random(5);
        double[] times = times(20_000, i -> i / 60.0 + share / 60 * random.nextGaussian());
        Arrays.sort(times);
        Inspection inspection = Samples.inspect(times);
        Finding.Jitter jitter = Samples.find(inspection, Finding.Jitter.class).orElseThrow();
        assertTrue(jitter.interpolated());
        assertEquals(share, jitter.rms() * 60, 0.25 * share);
        assertEquals(60, inspection.clock().rate(), 0.01);
        assertEquals(20_000, inspection.samples(), 2);
        assertFalse(Samples.find(inspection, Finding.Gap.class).isPresent(), () -> inspection.findings().toString());
    }

    @Test
    void burstsOfRowsWithOneTimeAreJitterAndNoDuplicates() {
        Inspection inspection = Samples.inspect(times(20_000, i -> 0.04 * (i / 4)));
        assertTrue(inspection.timing().irregular());
        assertEquals(100, inspection.clock().rate(), 0.05);
        assertFalse(Samples.find(inspection, Finding.Gap.class).isPresent(), () -> inspection.findings().toString());
        assertFalse(Samples.find(inspection, Finding.DuplicateTimes.class).isPresent(), () -> inspection.findings().toString());
    }

    @Test
    void duplicatesAreCountedAndNamed() {
        double[] times = times(1000, i -> (i < 500 ? i : i < 700 ? i - 1 : i - 2) / 60.0);
        Inspection inspection = Samples.inspect(times);
        assertEquals(new Finding.DuplicateTimes(2, 502), Samples.find(inspection, Finding.DuplicateTimes.class).orElseThrow());
        assertEquals(998, inspection.samples());
        assertEquals(1, inspection.findings().size(), () -> inspection.findings().toString());
    }

    @ParameterizedTest
    @ValueSource(ints = {6, 60, 600, 6000})
    void aDuplicateIsFoundWhereTimesGainADigit(int at) {
        double[] times = times(8000, i -> Math.rint(1e6 * (i <= at ? i : i - 1) / 60) / 1e6);
        Inspection inspection = Samples.inspect(times);
        assertEquals(new Finding.DuplicateTimes(1, at + 3), Samples.find(inspection, Finding.DuplicateTimes.class).orElseThrow());
        assertEquals(7999, inspection.samples());
        assertEquals(1, inspection.findings().size(), () -> inspection.findings().toString());
    }

    @Test
    void everyRowTwiceIsDuplicates() {
        Inspection inspection = Samples.inspect(times(2000, i -> (i / 2) / 60.0), i -> Math.sin(Math.floor(i / 2)),
                OptionalDouble.empty());
        assertEquals(1000, Samples.find(inspection, Finding.DuplicateTimes.class).orElseThrow().count());
        assertEquals(60, inspection.clock().rate(), 1e-9);
        assertEquals(1000, inspection.samples());
    }

    @Test
    void oneStepBackIsNamed() {
        double[] times = times(1000, i -> i == 600 ? 1.0 : i / 60.0);
        Inspection inspection = Samples.inspect(times);
        assertEquals(new Finding.TimeBackwards(1, 602, 1.0), Samples.find(inspection, Finding.TimeBackwards.class).orElseThrow());
        assertEquals(1000, inspection.samples());
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 600, 998})
    void oneTimeFarAheadIsOutOfOrderAndNoGap(int wrong) {
        Inspection inspection = Samples.inspect(times(1000, i -> i == wrong ? 1e9 : i / 60.0));
        assertEquals(new Finding.TimeBackwards(1, wrong + 2, 1e9),
                Samples.find(inspection, Finding.TimeBackwards.class).orElseThrow());
        assertEquals(wrong == 0 ? 999 : 1000, inspection.samples());
        assertEquals(60, inspection.clock().rate(), 1e-9);
    }

    @Test
    void aRateThatChangesIsTwoClocks() {
        double[] times = times(4000, i -> i < 2000 ? i / 60.0 : 2000 / 60.0 + (i - 2000) / 100.0);
        Finding.TwoClocks two = Samples.find(Samples.inspect(times), Finding.TwoClocks.class).orElseThrow();
        assertTrue(two.how().contains("60") && two.how().contains("100"), two.how());
        assertEquals(2002, two.line(), 256);
    }

    @Test
    void twoOrThreeRowsAreARecording() {
        assertEquals(new Clock(0, 50), Samples.inspect(new double[] {0, 0.02}).clock());
        assertEquals(new Clock(0, 50), Samples.inspect(new double[] {0, 0.02, 0.04}).clock());
        assertEquals(4, Samples.inspect(new double[] {0, 0.02, 0.06}).samples());
    }
}
