package wbv.exposure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;
import wbv.rig.RigSpec;
import wbv.signal.RealDft;

/** Weighted time signals against closed forms, and streams against whole recordings. */
class WeigherTest {

    private static final Weighting[] SOME = {Weighting.WK, Weighting.WD, Weighting.WJ};
    private static final Weighting[] ALL = {Weighting.WK, Weighting.WD, Weighting.WC, Weighting.WE, Weighting.WJ, Weighting.WB,
        Weighting.WM, Weighting.BAND};

    private static double[] weighted(double[] samples, double rate, boolean exact, boolean boxcar, AnalogFilter filter) {
        DoubleStream.Builder values = DoubleStream.builder();
        Weigher weigher = weigher(filter, rate, exact, boxcar, samples, values::add);
        for (double sample : samples) {
            weigher.accept(sample);
        }
        weigher.finish();
        return values.build().toArray();
    }

    private static Weigher weigher(AnalogFilter filter, double rate, boolean exact, boolean boxcar, double[] samples,
            Weigher.Sink sink) {
        double mean = Arrays.stream(samples).filter(Double::isFinite).average().orElse(0);
        return exact ? new ExactWeigher(filter, rate, mean, boxcar, sink) : new StreamWeigher(filter, rate, boxcar, sink);
    }

    private static Vibration vibration(double[] samples, double rate, boolean exact, Weighting weighting) {
        WeightedStatistics[] statistics = new WeightedStatistics[1];
        Weigher weigher = weigher(weighting.filter(), rate, exact, false, samples, value -> statistics[0].accept(value));
        statistics[0] = new WeightedStatistics(rate * weigher.factor());
        for (double sample : samples) {
            weigher.accept(sample);
        }
        weigher.finish();
        return statistics[0].vibration();
    }

    private static double[] sine(double frequency, double rate, int count) {
        double[] samples = new double[count];
        Arrays.setAll(samples, i -> Math.sin(2 * Math.PI * frequency * i / rate));
        return samples;
    }

    /** R.m.s. of the middle of what comes out, over that of a sine. */
    private static double gain(double[] out) {
        double sum = 0;
        int from = out.length / 2;
        int to = out.length - out.length / 10;
        for (int i = from; i < to; i++) {
            sum += out[i] * out[i];
        }
        return Math.sqrt(2 * sum / (to - from));
    }

    /** Within 1 % of the analog weighting from 0.5 to 25 Hz at any rate that has room for it. */
    @ParameterizedTest
    @ValueSource(doubles = {50, 60, 89.3, 100, 117.3, 256, 1000})
    void aStreamFollowsTheAnalogWeighting(double rate) {
        for (Weighting weighting : rate == 60 ? ALL : SOME) {
            for (double frequency : new double[] {0.5, 0.8, 2, 4, 8, 12.5, 16, 20, 22, 25}) {
                if (frequency <= 0.44 * rate) {
                    double exact = weighting.factor(frequency);
                    double found = gain(weighted(sine(frequency, rate, (int) (20 * rate)), rate, false, false, weighting
                            .filter()));
                    assertEquals(exact, found, 0.01 * exact, weighting + " at " + frequency + " Hz");
                }
            }
        }
    }

    /** Recorded data are weighted exactly up to just below half the rate. */
    @ParameterizedTest
    @ValueSource(doubles = {50, 60, 256})
    void aRecordingIsWeightedExactly(double rate) {
        for (Weighting weighting : SOME) {
            for (double frequency : new double[] {0.5, 1, 4, 10, 0.48 * rate}) {
                double exact = weighting.factor(frequency);
                double found = gain(weighted(sine(frequency, rate, (int) (200 * rate)), rate, true, false, weighting.filter()));
                assertEquals(exact, found, 1e-3 * exact, weighting + " at " + frequency + " Hz");
            }
        }
    }

    /** Blocks leave no seams: noise over several of them is what one transform of all of it gives. */
    @Test
    void blocksAreSeamless() {
        double rate = 60;
        double[] noise = new Random(4).doubles(40000, -1, 1).toArray();
        for (int pass = 0; pass < 6; pass++) { // nothing at half the rate itself, where a weighting is cut off
            for (int i = noise.length - 1; i > 0; i--) {
                noise[i] = (noise[i] + noise[i - 1]) / 2;
            }
        }
        double mean = Arrays.stream(noise).average().orElseThrow();
        RealDft dft = new RealDft(RealDft.covering(2 * noise.length));
        double[] padded = Arrays.copyOf(noise, dft.length());
        for (int i = 0; i < noise.length; i++) {
            padded[i] -= mean;
        }
        double[] spectrum = dft.forward(padded);
        double[] h = new double[2];
        for (int k = 0; k < dft.length() / 2; k++) {
            Weighting.WK.filter().response(k * rate / dft.length(), h);
            double re = spectrum[2 * k] * h[0] - spectrum[2 * k + 1] * h[1];
            spectrum[2 * k + 1] = spectrum[2 * k] * h[1] + spectrum[2 * k + 1] * h[0];
            spectrum[2 * k] = re;
        }
        double[] whole = dft.inverse(spectrum);
        double[] found = weighted(noise, rate, true, false, Weighting.WK.filter());
        assertEquals(noise.length * 8, found.length);
        for (int i = 0; i < noise.length; i++) {
            assertEquals(whole[i], found[8 * i], 1e-4, "sample " + i);
        }
    }

    /** A dose is an integral between the samples too: a sine at a quarter of the rate has (3/8 T)^¼. */
    @Test
    void dosesAndPeaksAreThoseBetweenTheSamples() {
        double rate = 60;
        double[] samples = new double[36000];
        Arrays.setAll(samples, i -> Math.sin(Math.PI / 2 * i + Math.PI / 4));
        double factor = Weighting.BAND.factor(15);
        for (boolean exact : new boolean[] {true, false}) {
            Vibration found = vibration(samples, rate, exact, Weighting.BAND);
            assertEquals(factor * Math.pow(0.375 * 600, 0.25), found.vdv(), 2e-3 * found.vdv());
            assertEquals(1.45, found.crestFactor(), 0.07); // of the samples alone: 1; the beginning overshoots
            assertEquals(1, found.mtvvRatio(), 0.01);
        }
    }

    /** The droop of a mean over the sampling period is undone up to 0.4 of the rate. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void theDroopOfIntegratingSensorsIsUndone(boolean exact) {
        double rate = 60;
        for (double frequency : new double[] {1, 5, 10, 16, 20, 24}) {
            double x = Math.PI * frequency / rate;
            double droop = Math.sin(x) / x;
            double[] samples = Arrays.stream(sine(frequency, rate, 12000)).map(value -> droop * value).toArray();
            double factor = Weighting.WK.factor(frequency);
            double tolerance = exact ? 1e-3 : 0.01;
            assertEquals(factor, gain(weighted(samples, rate, exact, true, Weighting.WK.filter())), tolerance * factor, frequency
                    + " Hz");
            assertEquals(droop * factor, gain(weighted(samples, rate, exact, false, Weighting.WK.filter())), tolerance * factor,
                    frequency + " Hz");
        }
    }

    private static void agree(double[] samples, double rate, Weighting weighting, String what) {
        Vibration batch = vibration(samples, rate, true, weighting);
        Vibration stream = vibration(samples, rate, false, weighting);
        assertEquals(batch.rms(), stream.rms(), 0.005 * batch.rms(), what);
        assertEquals(batch.vdv(), stream.vdv(), 0.01 * batch.vdv(), what);
        assertEquals(batch.mtvv(), stream.mtvv(), 0.01 * batch.mtvv(), what);
        assertEquals(batch.seconds(), stream.seconds(), 1e-9, what);
        assertEquals(batch.missing(), stream.missing(), 1e-9, what);
    }

    /** With its hundredth of packets lost. */
    @Test
    void streamsAndRecordingsAgreeOnTheShippedRide() throws Exception {
        Recording ride = new RecordingFile(java.nio.file.Path.of("data/arff/ride-subject1.arff")).load();
        for (SeatAxis axis : SeatAxis.values()) {
            for (String place : new String[] {"seat", "platform", "head"}) {
                Channel channel = Channel.parse(place + ".acc." + axis.letter());
                agree(ride.values(channel), 60, axis.weighting(), channel.toString());
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {60, 100, 256, 1000})
    void streamsAndRecordingsAgreeAtOtherRates(int rate) {
        Recording ride = RigSpec.parse("sitter=one-dof zeta=0.35 f0=5 seconds=60 seed=3 rate=" + rate).recording();
        agree(ride.values(Channel.parse("head.acc.z")), rate, Weighting.WK, rate + " Hz");
        agree(ride.values(Channel.parse("platform.acc.z")), rate, Weighting.WD, rate + " Hz");
    }

    /** Gravity on the axis changes nothing. */
    @Test
    void gravityAndBiasAreNoVibration() {
        double rate = 60;
        DoubleUnaryOperator shaking = i -> Math.sin(2 * Math.PI * 4 * i / rate);
        double[] free = new double[6000];
        double[] specific = new double[6000];
        Arrays.setAll(free, i -> shaking.applyAsDouble(i));
        Arrays.setAll(specific, i -> 9.81 + shaking.applyAsDouble(i));
        for (boolean exact : new boolean[] {true, false}) {
            Vibration one = vibration(free, rate, exact, Weighting.WK);
            Vibration other = vibration(specific, rate, exact, Weighting.WK);
            assertEquals(one.rms(), other.rms(), 1e-6);
            assertEquals(one.vdv(), other.vdv(), 1e-6);
            assertEquals(one.peak(), other.peak(), 1e-6);
        }
    }

    /** A long hole is neither vibration nor time, and makes no shock. */
    @Test
    void missingTimeIsNotCounted() {
        double rate = 100;
        double[] samples = sine(5, rate, 20000);
        for (int i = 0; i < samples.length; i++) {
            samples[i] += 9.81;
        }
        Arrays.fill(samples, 8000, 10000, Double.NaN);
        for (boolean exact : new boolean[] {true, false}) {
            Vibration found = vibration(samples, rate, exact, Weighting.WK);
            assertEquals(180, found.seconds(), 1e-9);
            assertEquals(20, found.missing(), 1e-9);
            double level = Weighting.WK.factor(5) / Math.sqrt(2);
            assertEquals(level, found.rms(), 0.01 * level);
            assertTrue(found.crestFactor() < 1.7, "crest factor " + found.crestFactor());
        }
    }

    /**
     * The scatter of the blocks tells how sure the mean is. Of {@code y_n = a y_(n-1) + e_n}, Gaussian, the squares correlate as
     * a^2k, so that the r.m.s. of N values scatters by {@code √((1 + a²) / (1 - a²) / (2N))} of itself.
     */
    @Test
    void theScatterOfBlocksTellsHowSureTheMeanIs() {
        double a = 0.8;
        int count = 36000;
        double said = 0;
        int rides = 40;
        for (int seed = 0; seed < rides; seed++) {
            Random random = new Random(seed);
            WeightedStatistics statistics = new WeightedStatistics(60);
            double value = random.nextGaussian() / Math.sqrt(1 - a * a);
            for (int i = 0; i < count; i++) {
                statistics.accept(value);
                value = a * value + random.nextGaussian();
            }
            said += statistics.vibration().deviation() / rides;
        }
        // Sixty blocks give a standard deviation to 9 %, forty times as many to 1.5 %.
        assertEquals(Math.sqrt((1 + a * a) / (1 - a * a) / (2 * count)), said, 0.06 * said);
    }
}
